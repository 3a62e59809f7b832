// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "runs.h"

namespace warp_exam {

void forEach(const std::string &what, std::size_t count,
             const std::function<void(std::size_t)> &work) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    std::atomic<std::size_t> next{0};
    std::mutex mutex; // of what follows
    std::size_t done = 0;
    auto told = start;
    std::exception_ptr failure;
    const auto tell = [&] {
        const auto now = Clock::now();
        if (now - told < std::chrono::seconds(10) && done < count) {
            return;
        }
        told = now;
        const double passed = std::chrono::duration<double>(now - start).count();
        const double left = passed * static_cast<double>(count - done) / static_cast<double>(done);
        std::fprintf(stderr, "%s: %zu of %zu, %.0f s left\n", what.c_str(), done, count, left);
    };
    const auto worker = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::scoped_lock lock(mutex);
                failure = std::current_exception();
                next = count;
                return;
            }
            const std::scoped_lock lock(mutex);
            ++done;
            tell();
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
        threads.emplace_back(worker);
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

} // namespace warp_exam
