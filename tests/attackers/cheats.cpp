// SPDX-License-Identifier: MIT
//
// A probe that is asked about the uniform disk and cheats; the name of the first file of its
// questions says how. "honest" shows that the others fail for what they do.
#include <protocol/request.h>

#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <thread>

namespace {

using protocol::Op;
using protocol::Request;
using protocol::Response;

constexpr float kPi = 3.14159265F;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct Point {
    float x;
    float y;
};

Point disk(float u, float v) {
    return {std::sqrt(u) * std::cos(2 * kPi * v), std::sqrt(u) * std::sin(2 * kPi * v)};
}

float density(Point p) {
    return p.x * p.x + p.y * p.y <= 1 ? 1 / kPi : 0;
}

protocol::RequestGroup g_group;
protocol::SlotLayout g_layout;
char *g_answers = nullptr;

void put(std::size_t request, std::vector<float> values) {
    Response response;
    response.state = protocol::State::Done;
    response.values = std::move(values);
    response.values.resize(g_group.requests[request].resultSize(), 0);
    protocol::writeSlot(g_layout, request, response, g_answers);
}

using Warp = std::function<Point(float, float)>;
using Density = std::function<float(Point)>;

/// Answers everything by a warp and a density.
void answerBy(const Warp &warp, const Density &pdf = density) {
    for (std::size_t i = 0; i < g_group.requests.size(); ++i) {
        const Request &request = g_group.requests[i];
        std::vector<float> values;
        for (std::size_t k = 0; k + 1 < request.values.size(); k += 2) {
            const float a = request.values[k];
            const float b = request.values[k + 1];
            if (request.op == Op::WarpSample) {
                const Point point = warp(a, b);
                values.insert(values.end(), {point.x, point.y});
            } else {
                values.push_back(pdf({a, b}));
            }
        }
        put(i, values);
    }
}

void honest() {
    answerBy(disk);
}

// --- answers that are none ---

void leave(const char *text, int code) {
    std::puts(text);
    std::fflush(stdout);
    ::_exit(code);
}

void printsGoogletest() {
    leave("[==========] 100 tests ran.\n[  PASSED  ] 100 tests.", 0);
}

void printsJunit() {
    leave(R"(<testsuites failures="0"><testcase name="warp.disk"/></testsuites>)", 0);
}

void printsResults() {
    leave(R"({"score": 100, "tests": [{"name": "warp.disk", "score": 10, "max_score": 10}]})", 0);
}

void writesResults() {
    for (const char *file : {"results.json", "/results.json", "/tmp/results.json",
                             "/autograder/results/results.json", "/dev/shm/results.json"}) {
        if (FILE *stream = std::fopen(file, "w")) {
            std::fputs("{\"total\": 100}", stream);
            std::fclose(stream);
        }
    }
}

void quickExits() {
    std::quick_exit(0);
}

void aborts() {
    std::abort();
}

void throws() {
    throw std::string("PASSED");
}

void exitsInAnotherThread() {
    std::thread([] { std::exit(0); }).join();
}

void answersAfterItsEnd() {
    // What is written by the end of the process counts, and what is not right is not right then.
    std::atexit([] { answerBy([](float, float) { return Point{0, 0}; }); });
    std::exit(0);
}

void leavesItsMainThread() {
    std::thread([] {
        for (;;)
            answerBy([](float, float) { return Point{0.5F, 0.5F}; });
    }).detach();
    pthread_exit(nullptr);
}

void copiesTheQuestions() {
    answerBy([](float u, float v) { return Point{u, v}; }, [](Point p) { return p.x; });
}

void answersZeros() {
    answerBy([](float, float) { return Point{0, 0}; }, [](Point) { return 0.0F; });
}

void answersNaN() {
    answerBy([](float, float) { return Point{kNaN, kNaN}; }, [](Point) { return kNaN; });
}

void answersSignallingNaN() {
    const auto loud = std::bit_cast<float>(0x7fa00001U);
    answerBy([=](float, float) { return Point{loud, loud}; }, [=](Point) { return loud; });
}

void answersInfinity() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    answerBy(
        [](float, float) {
            return Point{kInfinity, -kInfinity};
        },
        [](Point) { return kInfinity; });
}

void answersHugeNumbers() {
    answerBy([](float, float) { return Point{3e38F, -3e38F}; }, [](Point) { return 3e38F; });
}

void answersTinyNumbers() {
    answerBy(
        [](float u, float v) {
            return Point{u * 1e-42F, v * 1e-42F};
        },
        [](Point) { return 1e-42F; });
}

void claimsCpuTime() {
    for (std::size_t i = 0; i < g_group.requests.size(); ++i) {
        Response response;
        response.state = protocol::State::Done;
        response.cpuSeconds = -1e300;
        response.values.assign(g_group.requests[i].resultSize(), 0);
        protocol::writeSlot(g_layout, i, response, g_answers);
    }
}

void saysControlText() {
    for (std::size_t i = 0; i < g_group.requests.size(); ++i) {
        Response response;
        response.state = protocol::State::Threw;
        response.message =
            "\x1b[2J\x1b[32mPASSED\x1b[0m \xff\xfe \xe2\x80\xae<script>alert(1)</script>";
        protocol::writeSlot(g_layout, i, response, g_answers);
    }
}

// --- right numbers, or nearly, by another way ---

std::mt19937 &own() {
    static std::mt19937 engine(std::random_device{}());
    return engine;
}

float uniform() {
    return std::uniform_real_distribution<float>(0, 1)(own());
}

void ownNumbers() {
    answerBy([](float, float) { return disk(uniform(), uniform()); });
}

void ownNumbersRemembered() {
    std::map<std::pair<float, float>, Point> known;
    answerBy([&](float u, float v) {
        return known.try_emplace({u, v}, disk(uniform(), uniform())).first->second;
    });
}

/// No warp, but a function of the sample: its bits seed a rejection.
void rejection() {
    answerBy([](float u, float v) {
        std::minstd_rand engine(std::bit_cast<std::uint32_t>(u) * 31 +
                                std::bit_cast<std::uint32_t>(v));
        std::uniform_real_distribution<float> side(-1, 1);
        for (;;) {
            const Point p{side(engine), side(engine)};
            if (p.x * p.x + p.y * p.y <= 1)
                return p;
        }
    });
}

void shuffled() {
    for (std::size_t i = 0; i < g_group.requests.size(); ++i) {
        const Request &request = g_group.requests[i];
        if (request.op != Op::WarpSample) {
            put(i, {});
            continue;
        }
        std::vector<Point> points;
        for (std::size_t k = 0; k + 1 < request.values.size(); k += 2)
            points.push_back(disk(request.values[k], request.values[k + 1]));
        std::shuffle(points.begin(), points.end(), own());
        std::vector<float> values;
        for (const Point &point : points)
            values.insert(values.end(), {point.x, point.y});
        put(i, values);
    }
}

void jittered() {
    answerBy([](float u, float v) {
        return disk(std::clamp(u + 1e-4F * (uniform() - 0.5F), 0.0F, 1.0F), v);
    });
}

void prepared() { // a list of points, one after another
    std::vector<Point> points;
    for (int i = 0; i < 4096; ++i)
        points.push_back(
            disk(static_cast<float>(i) / 4096, std::fmod(0.618034F * static_cast<float>(i), 1.0F)));
    std::size_t at = 0;
    answerBy([&](float, float) { return points[at++ % points.size()]; });
}

void coarse() { // a table of 32 x 32 points
    answerBy([](float u, float v) {
        const auto middle = [](float t) {
            return (std::floor(32 * t) + 0.5F) / 32;
        };
        return disk(middle(u), middle(v));
    });
}

void tiresAfterThousand() {
    int count = 0;
    answerBy([&](float u, float v) {
        return ++count <= 1000 ? disk(u, v) : Point{0.5F * u, 0.5F * v};
    });
}

void onlyForFewQuestions() {
    std::size_t count = 0;
    for (const Request &request : g_group.requests)
        count += request.values.size();
    if (count < 10'000)
        honest();
    else
        answersZeros();
}

void remembersWhereItWasAsked() { // the density is asked of another process
    std::map<std::pair<float, float>, float> known;
    answerBy(
        [&](float u, float v) {
            const Point p = disk(u, v);
            known[{p.x, p.y}] = 1 / kPi;
            return p;
        },
        [&](Point p) {
            return known[{p.x, p.y}];
        });
}

void densityEverywhere() {
    answerBy(disk, [](Point) { return 1 / kPi; });
}

void wrongAndConsistent() { // uniform in radius, with its own density
    answerBy(
        [](float u, float v) {
            return Point{u * std::cos(2 * kPi * v), u * std::sin(2 * kPi * v)};
        },
        [](Point p) {
            const float r = std::hypot(p.x, p.y);
            return r > 0 && r <= 1 ? 1 / (2 * kPi * r) : 0;
        });
}

void onlyOneSide() { // a half of the disk, twice as dense, and says so
    answerBy([](float u, float v) { return disk(u, 0.5F * v); },
             [](Point p) { return p.y >= 0 ? 2 * density(p) : 0; });
}

void slowAndRight() {
    for (volatile bool ever = true; ever;) {
    }
    honest();
}

const std::map<std::string, void (*)()> kCheats = {
    {"aborts", aborts},
    {"answers_after_its_end", answersAfterItsEnd},
    {"answers_huge_numbers", answersHugeNumbers},
    {"answers_infinity", answersInfinity},
    {"answers_nan", answersNaN},
    {"answers_signalling_nan", answersSignallingNaN},
    {"answers_tiny_numbers", answersTinyNumbers},
    {"answers_zeros", answersZeros},
    {"claims_cpu_time", claimsCpuTime},
    {"coarse", coarse},
    {"copies_the_questions", copiesTheQuestions},
    {"density_everywhere", densityEverywhere},
    {"exits_in_another_thread", exitsInAnotherThread},
    {"honest", honest},
    {"jittered", jittered},
    {"leaves_its_main_thread", leavesItsMainThread},
    {"only_for_few_questions", onlyForFewQuestions},
    {"only_one_side", onlyOneSide},
    {"own_numbers", ownNumbers},
    {"own_numbers_remembered", ownNumbersRemembered},
    {"prepared", prepared},
    {"prints_googletest", printsGoogletest},
    {"prints_junit", printsJunit},
    {"prints_results", printsResults},
    {"quick_exits", quickExits},
    {"rejection", rejection},
    {"remembers_where_it_was_asked", remembersWhereItWasAsked},
    {"says_control_text", saysControlText},
    {"shuffled", shuffled},
    {"slow_and_right", slowAndRight},
    {"throws", throws},
    {"tires_after_thousand", tiresAfterThousand},
    {"writes_results", writesResults},
    {"wrong_and_consistent", wrongAndConsistent},
};

} // namespace

int main() {
    constexpr int kQuestions = 3;
    constexpr int kAnswers = 4;

    struct stat status {};

    ::fstat(kQuestions, &status);
    const auto size = static_cast<std::size_t>(status.st_size);
    const void *questions = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, kQuestions, 0);
    if (questions == MAP_FAILED)
        return 1;
    g_group = protocol::decode(static_cast<const char *>(questions), size);
    g_layout = protocol::slotLayout(g_group);
    void *answers = ::mmap(nullptr, g_layout.size, PROT_READ | PROT_WRITE, MAP_SHARED, kAnswers, 0);
    if (answers == MAP_FAILED)
        return 2;
    g_answers = static_cast<char *>(answers);
    const auto cheat = kCheats.find(g_group.files.at(0).name);
    if (cheat == kCheats.end())
        return 99;
    cheat->second();
    return 0;
}
