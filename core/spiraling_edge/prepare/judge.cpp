#include "spiraling_edge/prepare/judge.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/facing.h"
#include "spiraling_edge/prepare/given_normals.h"

namespace se {
namespace {

/// Shares of the work.
constexpr double kListsDone = 0.4;
constexpr double kMeasuredDone = 0.5;

/// Finite points without their copies, and the 12 nearest of each.
struct Surroundings {
    std::vector<bool> present;
    NeighborLists nearest;
};

Result<Surroundings> surroundingsOf(const PointFile& file, unsigned threads,
                                    const Progress& progress) {
    Surroundings around;
    for (const Fitness fitness : fitnessOf(file.position))
        around.present.push_back(fitness == Fitness::Usable);
    NeighborOptions nearest;
    nearest.dropOpposingNormals = false;
    nearest.threads = threads;
    Result<NeighborLists> lists =
        findNeighbors(file.position, {}, around.present, nearest, progress);
    if (!lists) return lists.error();
    around.nearest = std::move(lists.value());
    return around;
}

/// Measures the given normals, and turns those that are flipped; empty if they do not fit.
std::vector<Vec3> rightNormals(const PointFile& file, const Surroundings& around, unsigned threads,
                               MeshJudge& judge) {
    if (!file.hasNormals()) return {};
    std::vector<Vec3> normal = unitNormals(file.normal);
    const GivenNormals given{file.position, normal, around.present, around.nearest};
    const NormalFit fit = fitOf(given, threads);
    judge.fit = normalsFit(fit);
    if (!judge.fit) {
        judge.unfitDegrees = std::acos(fit.medianCosine) * 180.0 / std::numbers::pi;
        return {};
    }
    const Sides sides = sidesOf(given);
    if (sidesAgree(sides)) return normal;
    for (Index p = 0; p < normal.size(); ++p) {
        if (!sides.flipped[p]) continue;
        normal[p] = -normal[p];
        ++judge.flipped;
    }
    return normal;
}

/// The pieces of points, by lists in either direction: the number of each point's piece.
std::vector<Index> piecesOf(const Surroundings& around, std::size_t& count) {
    const auto n = static_cast<Index>(around.present.size());
    DisjointSets sets(n);
    for (Index p = 0; p < n; ++p) {
        for (const Index q : around.nearest[p]) sets.unite(p, q);
    }
    std::vector<Index> piece(n, kNone);
    count = 0;
    for (Index p = 0; p < n; ++p) {
        // The name of a set is its least member.
        piece[p] = sets.find(p) == p ? static_cast<Index>(count++) : piece[sets.find(p)];
    }
    return piece;
}

/// Turns pieces that face otherwise than in the run, unless their shape says that they face
/// outward.
void turnAsInRun(const Surroundings& around, const PointSet& run, PointSet& points) {
    std::size_t count = 0;
    std::vector<Index> piece = piecesOf(around, count);
    std::vector<std::ptrdiff_t> along(count, 0);
    for (Index p = 0; p < points.size(); ++p) {
        if (!around.present[p] || points.normal[p] == Vec3(0.0)) {
            piece[p] = kNone;
            continue;
        }
        along[piece[p]] += glm::dot(points.normal[p], run.normal[p]) < 0.0 ? -1 : 1;
    }
    const std::vector<FacingVote> votes = votesOutward(
        {points.position, points.normal, piece, count, std::vector<bool>(points.size(), true)});
    for (Index p = 0; p < points.size(); ++p) {
        if (piece[p] == kNone || along[piece[p]] >= 0) continue;
        const FacingVote& vote = votes[piece[p]];
        if (!vote.isKnown() || vote.isInward()) points.normal[p] = -points.normal[p];
    }
}

Result<MeshJudge> judged(const PointFile& file, const PrepareOptions& options, const PointSet* run,
                         const Progress& progress) {
    if (const Status status = checkColumns(file); !status) return status.error();
    const unsigned threads = options.neighbors.threads;
    const Result<Surroundings> around =
        surroundingsOf(file, threads, partOf(progress, 0.0, kListsDone));
    if (!around) return around.error();
    MeshJudge judge;
    const std::vector<Vec3> given = rightNormals(file, around.value(), threads, judge);
    PrepareOptions own;
    own.neighbors.threads = threads;
    own.neighbors.recompute = true;
    own.setNoiseAside = true;
    own.normals = judge.fit ? NormalSource::AsGiven : NormalSource::Derived;
    own.walls = options.walls;
    Result<Prepared> prepared = prepare(file, own, partOf(progress, kMeasuredDone, 1.0));
    if (!prepared) return prepared.error();
    PointSet& points = prepared.value().points;
    judge.noise.assign(points.size(), false);
    for (Index p = 0; p < points.size(); ++p) {
        const bool usable = around.value().present[p] && points.normal[p] != Vec3(0.0);
        if (!usable || !points.setAside[p]) continue;
        judge.noise[p] = true;
        points.setAside[p] = false;
    }
    // Where the file has no normal, the one that prepare() completed stays.
    for (Index p = 0; p < given.size(); ++p) {
        if (given[p] != Vec3(0.0)) points.normal[p] = given[p];
    }
    const bool named = options.normals != NormalSource::AsGiven || options.scanner;
    if (run != nullptr && named) turnAsInRun(around.value(), *run, points);
    points.neighbors = {};
    points.rim = {};
    judge.points = std::make_shared<const PointSet>(std::move(points));
    return judge;
}

}  // namespace

std::shared_ptr<const PointSet> MeshJudge::forRun(const PointSet& run,
                                                  std::span<const Index> leaveOut) const {
    auto judge = std::make_shared<PointSet>(*points);
    for (std::size_t p = 0; p < run.setAside.size(); ++p) {
        if (run.setAside[p] && noise[p]) judge->setAside[p] = true;
    }
    for (const Index p : leaveOut) judge->setAside[p] = false;
    return judge;
}

std::string departureText(const MeshJudge& judge) {
    if (judge.unfitDegrees > 0.0) {
        return "by derived normals: the given ones are " +
               std::to_string(std::lround(judge.unfitDegrees)) +
               " degrees off the surface (median)";
    }
    if (judge.flipped == 0) return {};
    return judge.flipped == 1
               ? "by the given normals, but for 1 that points against those around it"
               : "by the given normals, but for " + std::to_string(judge.flipped) +
                     " that point against those around them";
}

Result<MeshJudge> judgeFor(const PointFile& file, const PrepareOptions& options,
                           const PointSet& run, const Progress& progress) {
    assert(run.size() == file.position.size());
    return judged(file, options, &run, progress);
}

Result<MeshJudge> judgeFor(const PointFile& file, const std::optional<WallBox>& walls,
                           unsigned threads, const Progress& progress) {
    PrepareOptions options;
    options.walls = walls;
    options.neighbors.threads = threads;
    return judged(file, options, nullptr, progress);
}

}  // namespace se
