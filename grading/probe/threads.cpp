// SPDX-License-Identifier: MIT
#include <probe/probe.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace probe {

namespace {

constexpr std::uint32_t kMostThreads = 16;

/// Rows `begin` to `end` of a request, for one thread.
protocol::Request rowsOf(const protocol::Request &request, std::size_t rowSize, std::size_t begin,
                         std::size_t end) {
    protocol::Request part = request;
    const auto at = [&](std::size_t row) {
        return request.values.begin() + static_cast<std::ptrdiff_t>(row * rowSize);
    };
    part.values.assign(at(begin), at(end));
    return part;
}

} // namespace

Values answerOnThreads(const protocol::Request &request, std::size_t rowSize, std::uint32_t threads,
                       const std::function<Values(const protocol::Request &)> &answer) {
    const std::size_t rows = request.values.size() / rowSize;
    const std::size_t count = std::min<std::size_t>(std::min(threads, kMostThreads), rows);
    if (count <= 1)
        return answer(request);
    std::vector<protocol::Request> parts;
    for (std::size_t i = 0; i < count; ++i)
        parts.push_back(rowsOf(request, rowSize, rows * i / count, rows * (i + 1) / count));
    std::vector<Values> answers(count);
    std::vector<std::exception_ptr> failures(count);
    std::atomic<std::size_t> waiting{count};
    std::vector<std::thread> running;
    for (std::size_t i = 0; i < count; ++i)
        running.emplace_back([&, i] {
            --waiting;
            while (waiting > 0) // so that all are at work at the same time
                std::this_thread::yield();
            try {
                answers[i] = answer(parts[i]);
            } catch (...) {
                failures[i] = std::current_exception();
            }
        });
    for (std::thread &thread : running)
        thread.join();
    Values values;
    for (std::size_t i = 0; i < count; ++i) {
        if (failures[i] != nullptr)
            std::rethrow_exception(failures[i]);
        values.insert(values.end(), answers[i].begin(), answers[i].end());
    }
    return values;
}

} // namespace probe
