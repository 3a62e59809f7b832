// SPDX-License-Identifier: MIT
//
// A probe that answers honestly or cheats: the name of the first file of the group it is asked says
// which. An honest answer to a sample u is 2 u. What it gets that it should not have is printed as
// a line that starts with GOT.
#include <protocol/request.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <map>
#include <random>
#include <string>

namespace {

constexpr int kQuestions = 3;
constexpr int kAnswers = 4;

struct Exam {
    protocol::RequestGroup group;
    protocol::SlotLayout layout;
    char *answers = nullptr;

    void answer(std::size_t request, float factor = 2) const {
        protocol::Response response;
        response.state = protocol::State::Done;
        for (const float value : group.requests[request].values)
            response.values.push_back(factor * value);
        protocol::writeSlot(layout, request, response, answers);
    }

    void answerAll() const {
        for (std::size_t i = 0; i < group.requests.size(); ++i)
            answer(i);
    }
};

void answersAll(const Exam &exam) {
    exam.answerAll();
}

void answersFirst(const Exam &exam) {
    exam.answer(0);
}

void answersAndRests(const Exam &exam) {
    exam.answerAll();
    ::pause();
}

void keepsChanging(const Exam &exam) {
    for (;;) {
        exam.answer(0, 2);
        exam.answer(0, 3);
    }
}

void claimsToHavePassed(const Exam &) {
    std::puts("[  PASSED  ] 100 tests.\n{\"score\": 100}");
    std::fflush(stdout);
    ::_exit(0);
}

/// A state without an answer: what the grader filled the memory with must not read as one.
void claimsToBeDone(const Exam &exam) {
    const protocol::State done = protocol::State::Done;
    for (const std::size_t offset : exam.layout.offsets)
        std::memcpy(exam.answers + offset, &done, sizeof done);
}

void throws(const Exam &exam) {
    protocol::Response response;
    response.state = protocol::State::Threw;
    response.message = std::string(100'000, 'x');
    protocol::writeSlot(exam.layout, 0, response, exam.answers);
}

void writesNoise(const Exam &exam) {
    std::mt19937 random(1);
    for (std::size_t i = 0; i < exam.layout.size; ++i)
        exam.answers[i] = static_cast<char>(random());
}

void attacksMemory(const Exam &exam) {
    exam.answerAll();
    for (const int memory : {kQuestions, kAnswers}) {
        struct stat status {};

        ::fstat(memory, &status);
        if (::ftruncate(memory, 0) == 0 || ::ftruncate(memory, 2 * status.st_size) == 0)
            std::puts("GOT another size");
        if (::fcntl(memory, F_ADD_SEALS, F_SEAL_WRITE) == 0)
            std::puts("GOT another seal");
        if (::fallocate(memory, 0, 0, 2 * status.st_size) == 0)
            std::puts("GOT more memory");
    }
    if (::pwrite(kQuestions, "x", 1, 0) > 0)
        std::puts("GOT other questions");
    if (::mmap(nullptr, 1, PROT_WRITE, MAP_SHARED, kQuestions, 0) != MAP_FAILED)
        std::puts("GOT writable questions");
    if (::pwrite(kAnswers, "x", 1, static_cast<off_t>(exam.layout.size) + 100'000) > 0)
        std::puts("GOT answers beyond the end");
}

void listsDescriptors(const Exam &) {
    for (int fd = 0; fd < 1024; ++fd) {
        if (::fcntl(fd, F_GETFD) >= 0)
            std::printf("%d ", fd);
    }
}

void spins(const Exam &) {
    for (volatile bool ever = true; ever;) {
    }
}

const std::map<std::string, void (*)(const Exam &)> kModes = {
    {"answers_all", answersAll},
    {"answers_and_rests", answersAndRests},
    {"answers_first", answersFirst},
    {"attacks_memory", attacksMemory},
    {"claims_to_be_done", claimsToBeDone},
    {"claims_to_have_passed", claimsToHavePassed},
    {"keeps_changing", keepsChanging},
    {"lists_descriptors", listsDescriptors},
    {"spins", spins},
    {"throws", throws},
    {"writes_noise", writesNoise},
};

} // namespace

int main() {
    struct stat status {};

    ::fstat(kQuestions, &status);
    const auto size = static_cast<std::size_t>(status.st_size);
    const void *questions = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, kQuestions, 0);
    if (questions == MAP_FAILED)
        return 1;
    Exam exam;
    exam.group = protocol::decode(static_cast<const char *>(questions), size);
    exam.layout = protocol::slotLayout(exam.group);
    if (exam.layout.size > 0) {
        void *answers =
            ::mmap(nullptr, exam.layout.size, PROT_READ | PROT_WRITE, MAP_SHARED, kAnswers, 0);
        if (answers == MAP_FAILED)
            return 2;
        exam.answers = static_cast<char *>(answers);
    }
    kModes.at(exam.group.files.at(0).name)(exam);
    return 0;
}
