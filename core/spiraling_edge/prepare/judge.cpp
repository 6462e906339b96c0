#include "spiraling_edge/prepare/judge.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/median.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/loop_shape.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/facing.h"
#include "spiraling_edge/prepare/given_normals.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/prepare/normals.h"
#include "spiraling_edge/prepare/rim.h"
#include "spiraling_edge/prepare/scan_lines.h"
#include "spiraling_edge/prepare/strays.h"
#include "spiraling_edge/prepare/twins.h"

namespace se {
namespace {

/// Shares of the work.
constexpr double kListsDone = 0.4;
constexpr double kMeasuredDone = 0.5;
constexpr double kPreparedDone = 0.8;

/// Parts of the points are joined by mutual neighbors within this many spacings of both.
constexpr double kJoined = 2.0;

/// Finite points without their copies, and the 12 nearest of each.
struct Surroundings {
    std::vector<bool> present;
    NeighborLists nearest;
};

/// Those of the points without some, if any.
Result<Surroundings> surroundingsOf(const PointFile& file, const std::vector<bool>& without,
                                    unsigned threads, const Progress& progress) {
    Surroundings around;
    for (const Fitness fitness : fitnessOf(file.position)) {
        const std::size_t p = around.present.size();
        around.present.push_back(fitness == Fitness::Usable && (without.empty() || !without[p]));
    }
    Result<NeighborLists> lists =
        nearestPoints(file.position, around.present, KNearest{}.k, threads, progress);
    if (!lists) return lists.error();
    around.nearest = std::move(lists.value());
    return around;
}

/// Measures the given normals, and turns those that are flipped; empty if they do not fit.
std::vector<Vec3> rightNormals(const PointFile& file, const Surroundings& around, unsigned threads,
                               MeshJudge& judge) {
    if (!file.hasNormals()) return {};
    std::vector<Vec3> normal = unitNormals(file.normal);
    averageOverCopies(file.position, normal);
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

// ---- spacing, twins, parts
// -----------------------------------------------------------------------

double distanceBetween(const PointFile& file, Index p, Index q) {
    return glm::distance(file.position[p], file.position[q]);
}

/// The distance to the n-th nearest point, or to the last of fewer.
double distanceTo(const PointFile& file, const Surroundings& around, Index p, std::size_t n) {
    const std::span<const Index> list = around.nearest[p];
    return list.empty() ? 0.0 : distanceBetween(file, p, list[std::min(n, list.size()) - 1]);
}

/// Parts of at least three points, connected by mutual neighbors within kJoined spacings.
std::size_t countPieces(const PointFile& file, const Surroundings& around, const MeshJudge& judge) {
    const auto n = static_cast<Index>(around.present.size());
    DisjointSets sets(n);
    for (Index p = 0; p < n; ++p) {
        for (const Index q : around.nearest[p]) {
            const std::span<const Index> back = around.nearest[q];
            const double reach = kJoined * std::min(judge.spacing[p], judge.spacing[q]);
            if (q > p && std::find(back.begin(), back.end(), p) != back.end() &&
                distanceBetween(file, p, q) <= reach)
                sets.unite(p, q);
        }
    }
    std::vector<Index> size(n, 0);
    for (Index p = 0; p < n; ++p) ++size[sets.find(p)];
    return static_cast<std::size_t>(
        std::count_if(size.begin(), size.end(), [](Index count) { return count >= 3; }));
}

/// Measures the distances of the points.
void measure(const PointFile& file, const Surroundings& around, MeshJudge& judge) {
    const auto n = static_cast<Index>(around.present.size());
    const auto scan = scanLinesOf(file.position, around.present, around.nearest);
    const double lines = scan ? scan->across : 0.0;
    judge.spacing.assign(n, 0.0);
    judge.reach.assign(n, 0.0);
    judge.twin.assign(n, kNone);
    for (Index p = 0; p < n; ++p) {
        if (!around.present[p]) continue;
        judge.spacing[p] = std::max(lines, distanceTo(file, around, p, 3));
        judge.reach[p] = std::max(lines, distanceTo(file, around, p, 12));
        judge.twin[p] = twinOf(file.position, p, around.nearest[p]);
    }
    if (lines == 0.0) judge.pieces = countPieces(file, around, judge);
}

// ---- the judge ----------------------------------------------------------------------------------

using Judge = Result<std::shared_ptr<const MeshJudge>>;

/// Points with the normals of the judge, and lists; noise and strays are set aside.
Result<Prepared> preparedFor(const PointFile& file, const PrepareOptions& options,
                             const MeshJudge& judge, const Progress& progress) {
    PrepareOptions own;
    own.neighbors.threads = options.neighbors.threads;
    own.neighbors.recompute = true;
    own.setNoiseAside = true;
    own.normals = judge.fit ? NormalSource::AsGiven : NormalSource::Derived;
    own.walls = options.walls;
    for (Index p = 0; p < judge.stray.size(); ++p) {
        if (judge.stray[p]) own.leaveOut.push_back(p);
    }
    return prepare(file, own, progress);
}

Judge judged(const PointFile& file, const PrepareOptions& options, const PointSet* run,
             const Progress& progress) {
    if (const Status status = checkColumns(file); !status) return status.error();
    const unsigned threads = options.neighbors.threads;
    const Result<Surroundings> around =
        surroundingsOf(file, {}, threads, partOf(progress, 0.0, kListsDone));
    if (!around) return around.error();
    auto judge = std::make_shared<MeshJudge>();
    const std::vector<Vec3> given = rightNormals(file, around.value(), threads, *judge);
    judge->stray =
        strayPoints(file.position, around.value().present, around.value().nearest, threads);
    // Lists by normals that contradict each other would end at the borders of patches.
    PointFile agreeing;
    if (judge->flipped > 0) {
        agreeing = file;
        agreeing.normal = given;
    }
    Result<Prepared> prepared = preparedFor(judge->flipped > 0 ? agreeing : file, options, *judge,
                                            partOf(progress, kMeasuredDone, kPreparedDone));
    if (!prepared) return prepared.error();
    PointSet& points = prepared.value().points;
    judge->noise.assign(points.size(), false);
    for (Index p = 0; p < points.size(); ++p) {
        judge->noise[p] = points.setAside[p] && around.value().present[p] && !judge->stray[p] &&
                          points.normal[p] != Vec3(0.0);
    }
    if (std::find(judge->noise.begin(), judge->noise.end(), true) == judge->noise.end()) {
        measure(file, around.value(), *judge);
    } else {
        const Result<Surroundings> kept = surroundingsOf(file, judge->noise, threads, {});
        if (!kept) return kept.error();
        measure(file, kept.value(), *judge);
    }
    // Where the file has no normal, the one that prepare() completed stays.
    for (Index p = 0; p < given.size(); ++p) {
        if (given[p] != Vec3(0.0)) points.normal[p] = given[p];
    }
    const bool named = options.normals != NormalSource::AsGiven || options.scanner;
    if (run != nullptr && named) turnAsInRun(around.value(), *run, points);
    Result<Rim> rim = findRim(points.position, points.normal, points.neighbors, points.type,
                              threads, partOf(progress, kPreparedDone, 1.0));
    if (!rim) return rim.error();
    judge->openings = std::move(rim.value().chains);
    points.neighbors = {};
    points.rim = {};
    judge->points = std::move(points);
    return std::shared_ptr<const MeshJudge>(std::move(judge));
}

}  // namespace

Judge judgeFor(const PointFile& file, const PrepareOptions& options, const PointSet& run,
               const Progress& progress) {
    assert(run.size() == file.position.size());
    return judged(file, options, &run, progress);
}

Judge judgeFor(const PointFile& file, const std::optional<WallBox>& walls, unsigned threads,
               const Progress& progress) {
    PrepareOptions options;
    options.walls = walls;
    options.neighbors.threads = threads;
    return judged(file, options, nullptr, progress);
}

std::shared_ptr<const MeshJudge> withoutOpeningsToClose(std::shared_ptr<const MeshJudge> judge,
                                                        const Params& params) {
    if (!params.limitsHoles()) return judge;
    auto fewer = std::make_shared<MeshJudge>(*judge);
    std::erase_if(fewer->openings, [&](const std::vector<Index>& chain) {
        const LoopShape shape = shapeOfLoop(judge->points.position, judge->points.normal, chain);
        return params.isWithinHoleLimits(shape.width(), chain.size());
    });
    return fewer;
}

}  // namespace se
