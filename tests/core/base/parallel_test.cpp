#include "spiraling_edge/base/parallel.h"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <new>
#include <stdexcept>

#include "support/clouds.h"
#include "support/scarce_memory.h"

using namespace se;
using namespace se::test;

TEST_CASE("parallel: an exception of any thread reaches the caller, once all have ended") {
    for (const std::size_t bad : {0U, 500U, 999U}) {
        CAPTURE(bad);
        std::atomic<std::size_t> ended = 0;
        const auto work = [&](std::size_t from, std::size_t to) {
            if (from <= bad && bad < to) throw std::runtime_error("piece");
            ++ended;
        };
        CHECK_THROWS_WITH_AS(forRanges(1000, 4, 1, work), "piece", std::runtime_error);
        CHECK(ended == 3);
    }
}

TEST_CASE("parallel: of several exceptions the caller gets that of the first piece") {
    const auto all = [](std::size_t from, std::size_t) {
        throw std::out_of_range(std::to_string(from));
    };
    CHECK_THROWS_WITH(forRanges(1000, 4, 1, all), "0");
    const auto others = [](std::size_t from, std::size_t) {
        if (from > 0) throw std::out_of_range(std::to_string(from));
    };
    CHECK_THROWS_WITH(forRanges(1000, 4, 1, others), "250");
}

TEST_CASE("parallel: each task is done once, whatever the number of threads") {
    for (const unsigned threads : {1U, 2U, 7U}) {
        CAPTURE(threads);
        std::array<std::atomic<int>, 5> done{};
        forEachTask(done.size(), threads, [&](std::size_t i) { ++done[i]; });
        for (const auto& each : done) CHECK(each == 1);
        forEachTask(0, threads, [&](std::size_t i) { ++done[i]; });
        runTasks(
            threads, [&] { ++done[0]; }, [&] { ++done[1]; });
        CHECK(done[0] == 2);
        CHECK(done[1] == 2);
        CHECK_THROWS_WITH(runTasks(
                              threads, [] {}, [] { throw std::runtime_error("task"); }),
                          "task");
    }
}

TEST_CASE("parallel: neighbors are searched by threads without memory: the caller gets bad_alloc") {
    const PointFile file = closedFamilies(30.0)[0].sample(1);
    PrepareOptions options;
    options.neighbors = reach(12);
    options.neighbors.threads = 2;
    const ScarceMemory scarce;
    CHECK_THROWS_AS((void)prepare(file, options), std::bad_alloc);
}
