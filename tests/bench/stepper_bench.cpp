// Time of a run, with and without a log of its events. Baseline in the same process: one sort of
// every point's neighbors by angle, the least work of any such algorithm.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <string>

#include "io_bench.h"
#include "memory.h"
#include "neighbors_bench.h"
#include "shapes.h"
#include "spiraling_edge/base/stop_watch.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/stepper/rules.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se::bench {
namespace {

constexpr std::size_t kCount = 43000;  // as many as in the paper's lobster

PointFile load(const std::string& name) {
    if (name == "sphere") return sphere(kCount);
    if (name == "torus") return torus(kCount);
    if (name == "shuffled") return shuffled(sphere(kCount));
    if (name == "sphere_1M") return sphere(1'000'000);
    if (name == "shuffled_1M") return shuffled(sphere(1'000'000));
    if (name == "sphere_5M") return sphere(5'000'000);
    if (name == "shuffled_5M") return shuffled(sphere(5'000'000));
#ifdef SPIRALING_EDGE_SHARED_DATA
    auto file =
        readPoints(std::filesystem::path(SPIRALING_EDGE_SHARED_DATA "/points/table1_lobster.ply"));
    if (file) return std::move(file.value());
#endif
    return {};
}

const PointFile& fileOf(const std::string& name) {
    static std::map<std::string, PointFile> files;
    const auto [place, isNew] = files.try_emplace(name);
    if (isNew) place->second = load(name);
    return place->second;
}

/// Points with neighbor lists; empty if there is no such input here.
const PointSet& pointsOf(const std::string& name) {
    static std::map<std::string, PointSet> sets;
    const auto [place, isNew] = sets.try_emplace(name);
    if (isNew && !fileOf(name).position.empty()) {
        auto prepared = prepare(fileOf(name), {});
        if (prepared) place->second = std::move(prepared.value().points);
    }
    return place->second;
}

bool skipIfAbsent(benchmark::State& bench, const PointSet& points) {
    if (points.empty()) bench.SkipWithError("no such input here");
    return points.empty();
}

void countPoints(benchmark::State& bench, const PointSet& points) {
    bench.SetItemsProcessed(bench.iterations() * static_cast<std::int64_t>(points.size()));
}

void sortNeighborsOnce(benchmark::State& bench, const std::string& name) {
    const PointSet& points = pointsOf(name);
    if (skipIfAbsent(bench, points)) return;
    std::vector<std::pair<double, Index>> ring;
    for (auto _ : bench) {
        double sum = 0.0;
        for (Index p = 0; p < points.size(); ++p) {
            const auto list = points.neighbors[p];
            if (list.empty()) continue;
            const Vec3& origin = points.position[p];
            const Frame frame = makeFrame(origin, points.normal[p], points.position[list[0]]);
            ring.clear();
            for (const Index q : list)
                ring.emplace_back(angleOf(frame, points.position[q] - origin).key, q);
            std::sort(ring.begin(), ring.end());
            sum += ring.back().first;
        }
        benchmark::DoNotOptimize(sum);
    }
    countPoints(bench, points);
}

void triangulateBy(benchmark::State& bench, const std::string& name, const Params& params) {
    const PointSet& points = pointsOf(name);
    if (skipIfAbsent(bench, points)) return;
    std::size_t triangles = 0;
    for (auto _ : bench) {
        Stepper stepper(points, params);
        stepper.run();
        triangles = stepper.state().triangles.size();
        benchmark::DoNotOptimize(triangles);
    }
    bench.counters["triangles"] = static_cast<double>(triangles);
    countPoints(bench, points);
}

void triangulate(benchmark::State& bench, const std::string& name, const std::string& rules) {
    triangulateBy(bench, name, paramsByName(rules).value_or(Params{}));
}

/// The paper's rules but for one ("onsphere=kept"): such runs take the logging code path.
void triangulateOtherwise(benchmark::State& bench, const std::string& name,
                          const std::string& rule) {
    Params params;
    const Result<RuleValue> value = ruleValueFromText(rule);
    if (!value || !applyRuleValues({&value.value(), 1}, params))
        return bench.SkipWithError("no such rule");
    triangulateBy(bench, name, params);
}

/// As triangulate(), but with the run that renumbers scattered points; and its memory.
void reconstructAtOnce(benchmark::State& bench, const std::string& name) {
    const PointSet& points = pointsOf(name);
    if (skipIfAbsent(bench, points)) return;
    std::size_t beyond = 0;
    for (auto _ : bench) {
        const std::size_t before = heldBytes();
        forgetPeak();
        const Reconstruction made = reconstruct(points, Params{});
        beyond = peakBytes() - before - made.state.triangles.size() * sizeof(Triangle);
    }
    bench.counters["MB_beyond_mesh"] = static_cast<double>(beyond) / 1e6;
    countPoints(bench, points);
}

/// Moves in a run that was seen once: to the previous pivot, or to any.
void goBack(benchmark::State& bench, const std::string& name, const std::string& rules,
            bool anywhere) {
    const PointSet& points = pointsOf(name);
    if (skipIfAbsent(bench, points)) return;
    Timeline timeline(points, *paramsByName(rules));
    timeline.seek(std::numeric_limits<std::uint32_t>::max());
    const std::uint32_t pivots = timeline.farthest();
    std::uint32_t place = pivots / 2;
    double longest = 0.0;
    for (auto _ : bench) {
        place = anywhere ? (place * 7919U + 104729U) % pivots : std::max(1U, place) - 1;
        StopWatch watch;
        timeline.seek(place);
        longest = std::max(longest, watch.lap());
    }
    bench.counters["pivots"] = pivots;
    bench.counters["ms_longest"] = 1e3 * longest;
    bench.counters["MB_keyframes"] = static_cast<double>(timeline.keyframeBytes()) / 1e6;
}

/// `keep`: all events stay in memory; else those of a pivot are dropped when it is complete.
void triangulateWithLog(benchmark::State& bench, const std::string& name, bool keep) {
    const PointSet& points = pointsOf(name);
    if (skipIfAbsent(bench, points)) return;
    std::size_t events = 0;
    for (auto _ : bench) {
        EventLog log;
        Stepper stepper(points, Params{}, &log);
        events = 0;
        stepper.runUntil([&](const State&) {
            if (keep) return false;
            events += log.events().size();
            log.clear();
            return false;
        });
        events += log.events().size();
    }
    bench.counters["events"] = static_cast<double>(events);
    countPoints(bench, points);
}

void registerAll(const std::string& name) {
    const auto add = [&](const std::string& what, auto function, auto... arguments) {
        const std::string title = what + "/" + name;
        benchmark::RegisterBenchmark(
            title.c_str(), [=](benchmark::State& bench) { function(bench, name, arguments...); })
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.3);
    };
    add("baseline_sort", sortNeighborsOnce);
    add("reconstruct", reconstructAtOnce);
    for (const std::string_view rules : paramSetNames())
        add("triangulate_" + std::string(rules), triangulate, std::string(rules));
    // On scans no point lies exactly on a sphere: the same mesh, so that only the code path
    // differs.
    add("triangulate_paper_onsphere_kept", triangulateOtherwise, std::string("onsphere=kept"));
    add("triangulate_log_cleared", triangulateWithLog, false);
    add("triangulate_log_kept", triangulateWithLog, true);
    registerNeighbors(name, [name]() -> const PointFile& { return fileOf(name); });
}

/// Not run unless requested: preparing the points alone takes seconds.
void registerLarge(const std::string& name) {
    benchmark::RegisterBenchmark(("large/reconstruct/" + name).c_str(),
                                 [=](benchmark::State& bench) { reconstructAtOnce(bench, name); })
        ->Unit(benchmark::kMillisecond);
    for (const std::string rules : {"paper", "robust"}) {
        for (const bool anywhere : {false, true}) {
            const std::string title = "large/seek_" + std::string(anywhere ? "any" : "previous");
            benchmark::RegisterBenchmark(
                (title + "_" + rules + "/" + name).c_str(),
                [=](benchmark::State& bench) { goBack(bench, name, rules, anywhere); })
                ->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace
}  // namespace se::bench

int main(int argc, char** argv) {
    for (const char* name : {"sphere", "torus", "shuffled", "lobster"}) {
        se::bench::registerAll(name);
    }
    benchmark::Initialize(&argc, argv);
    if (!benchmark::GetBenchmarkFilter().empty()) {
        for (const char* name : {"sphere_1M", "shuffled_1M", "sphere_5M", "shuffled_5M"}) {
            se::bench::registerLarge(name);
        }
        se::bench::registerIo();
    }
    argc = se::bench::registerNeighborsOfFiles(argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
