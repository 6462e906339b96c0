#include "neighbors_bench.h"

#include <benchmark/benchmark.h>

#include <array>
#include <filesystem>
#include <memory>
#include <nanoflann.hpp>

#include "spiraling_edge/prepare/prepare.h"

namespace se::bench {
namespace {

constexpr std::size_t kNearest = 12;

/// Points in the form that nanoflann requires.
struct Cloud {
    const std::vector<Vec3>& position;

    // NOLINTBEGIN(readability-identifier-naming): names that nanoflann calls
    std::size_t kdtree_get_point_count() const { return position.size(); }
    double kdtree_get_pt(Index i, std::size_t axis) const {
        return position[i][static_cast<Vec3::length_type>(axis)];
    }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
        return false;  // nanoflann computes it
    }
    // NOLINTEND(readability-identifier-naming)
};

/// The lists of nanoflann without what ours promise: ties are in any order, the point itself is
/// listed, and normals are not compared.
NeighborLists listsOfNanoflann(const std::vector<Vec3>& position) {
    using Metric = nanoflann::L2_Simple_Adaptor<double, Cloud, double, Index>;
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, 3, Index>;
    const Cloud cloud{position};
    const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    NeighborLists lists;
    std::array<Index, kNearest + 1> found;
    std::array<double, kNearest + 1> distance;
    for (const Vec3& p : position) {
        const std::size_t count = tree.knnSearch(&p.x, found.size(), found.data(), distance.data());
        lists.append({found.data(), count});
    }
    return lists;
}

NeighborLists ownLists(const PointFile& points) {
    const std::vector<bool> usable(points.position.size(), true);
    NeighborOptions options;
    options.reach = KNearest{kNearest};
    options.dropOpposingNormals = !points.normal.empty();
    options.threads = 1;
    auto lists = findNeighbors(points.position, points.normal, usable, options);
    return lists ? std::move(lists.value()) : NeighborLists{};
}

template <typename Find>
void measure(benchmark::State& bench, const PointFile& points, Find&& find) {
    if (points.position.empty()) return bench.SkipWithError("no such input here");
    for (auto _ : bench) {
        const NeighborLists lists = find();
        benchmark::DoNotOptimize(lists.ids.data());
    }
    const auto count = static_cast<double>(points.position.size());
    bench.counters["per_million_points"] = benchmark::Counter(
        count * 1e-6, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

void registerNeighbors(const std::string& name, const std::function<const PointFile&()>& points) {
    const auto add = [&](const std::string& title, auto find) {
        benchmark::RegisterBenchmark((title + "/" + name).c_str(),
                                     [points, find](benchmark::State& bench) {
                                         const PointFile& file = points();
                                         measure(bench, file, [&] { return find(file); });
                                     })
            ->Unit(benchmark::kMillisecond)
            ->MinTime(0.3);
    };
    add("baseline_neighbors",
        [](const PointFile& file) { return listsOfNanoflann(file.position); });
    add("neighbors", [](const PointFile& file) { return ownLists(file); });
}

int registerNeighborsOfFiles(int argc, char** argv) {
    int kept = 1;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        Result<PointFile> file = argument[0] == '-' ? Error{"an option"} : readPoints(argument);
        if (!file) {
            argv[kept++] = argv[i];
            continue;
        }
        const auto points = std::make_shared<PointFile>(std::move(file.value()));
        registerNeighbors(std::filesystem::path(argument).stem().string(),
                          [points]() -> const PointFile& { return *points; });
    }
    return kept;
}

}  // namespace se::bench
