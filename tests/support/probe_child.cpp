// SPDX-License-Identifier: MIT
#include "probe_child.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

namespace test {

namespace {

/// Shared memory outside of the numbers that the probe expects.
class Memory {
public:
    explicit Memory(const std::string &bytes) {
        const int made = memfd_create("probe", MFD_CLOEXEC);
        m_fd = fcntl(made, F_DUPFD_CLOEXEC, 10);
        close(made);
        if (m_fd < 0 ||
            pwrite(m_fd, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
            throw std::runtime_error("no shared memory");
    }

    ~Memory() { close(m_fd); }

    Memory(const Memory &) = delete;
    Memory &operator=(const Memory &) = delete;
    Memory(Memory &&) = delete;
    Memory &operator=(Memory &&) = delete;

    int fd() const { return m_fd; }

    std::string read(std::size_t size) const {
        std::string bytes(size, '\0');
        if (pread(m_fd, bytes.data(), size, 0) != static_cast<ssize_t>(size))
            throw std::runtime_error("the shared memory cannot be read");
        return bytes;
    }

private:
    int m_fd = -1;
};

class WorkingFolder {
public:
    WorkingFolder() {
        m_path = (std::filesystem::temp_directory_path() / "probe-XXXXXX").string();
        if (mkdtemp(m_path.data()) == nullptr)
            throw std::runtime_error("no temporary folder");
    }

    ~WorkingFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }

    WorkingFolder(const WorkingFolder &) = delete;
    WorkingFolder &operator=(const WorkingFolder &) = delete;
    WorkingFolder(WorkingFolder &&) = delete;
    WorkingFolder &operator=(WorkingFolder &&) = delete;

    const std::string &path() const { return m_path; }

private:
    std::string m_path;
};

/// In the child: only calls that are safe after fork().
[[noreturn]] void become(const char *executable, const char *folder, int questions, int answers) {
    constexpr int kNotStarted = 126;
    const int nowhere = open("/dev/null", O_RDWR);
    const bool ready = chdir(folder) == 0 && dup2(nowhere, STDIN_FILENO) >= 0 &&
                       dup2(nowhere, STDOUT_FILENO) >= 0 && dup2(nowhere, STDERR_FILENO) >= 0 &&
                       dup2(questions, 3) == 3 && dup2(answers, 4) == 4;
    if (!ready)
        _exit(kNotStarted);
    alarm(20);
    execl(executable, executable, nullptr);
    _exit(kNotStarted);
}

} // namespace

ProbeRun runProbe(const std::string &executable, const protocol::RequestGroup &group) {
    return runProbe(executable, group, protocol::encode(group));
}

ProbeRun runProbe(const std::string &executable, const protocol::RequestGroup &group,
                  const std::string &questions) {
    const protocol::SlotLayout layout = protocol::slotLayout(group);
    std::string slots(layout.size, '\0');
    protocol::clearSlots(layout, slots.data());
    const Memory in(questions);
    const Memory out(slots);
    const WorkingFolder folder;
    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error("no process");
    if (child == 0)
        become(executable.c_str(), folder.path().c_str(), in.fd(), out.fd());
    int status = 0;
    if (waitpid(child, &status, 0) != child)
        throw std::runtime_error("the process is lost");
    ProbeRun run;
    if (WIFEXITED(status))
        run.exitCode = WEXITSTATUS(status);
    else
        run.signalNumber = WTERMSIG(status);
    slots = out.read(layout.size);
    for (std::size_t i = 0; i < group.requests.size(); ++i)
        run.responses.push_back(protocol::readSlot(layout, group, i, slots.data()));
    return run;
}

protocol::File sceneFile(const std::string &objects, const std::string &integrator,
                         const std::string &name) {
    return {name, R"(<scene><integrator type=")" + integrator +
                      R"("/><camera type="perspective"/>)" + objects + "</scene>"};
}

protocol::Request sceneRequest(protocol::Op op, std::vector<float> values, std::uint32_t index) {
    protocol::Request request;
    request.op = op;
    request.text = "scene.xml";
    request.index = index;
    request.values = std::move(values);
    return request;
}

std::vector<float> askOne(const std::string &executable, const protocol::File &scene,
                          const protocol::Request &request,
                          const std::vector<protocol::File> &more) {
    protocol::RequestGroup group{more, {request}};
    group.files.push_back(scene);
    const ProbeRun run = runProbe(executable, group);
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.responses[0].state, protocol::State::Done) << run.responses[0].message;
    std::vector<float> values = run.responses[0].values;
    values.resize(request.resultSize());
    return values;
}

protocol::File ceilingObj(const std::string &name) {
    return {name, "v -1 -0.5 2\nv 1 -0.5 2\nv 1 0.5 2\nv -1 0.5 2\n"
                  "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                  "f 1/1 3/3 2/2\nf 1/1 4/4 3/3\n"};
}

} // namespace test
