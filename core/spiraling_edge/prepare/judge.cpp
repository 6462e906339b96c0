#include "spiraling_edge/prepare/judge.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/median.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/geometry/loop_shape.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/facing.h"
#include "spiraling_edge/prepare/given_normals.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/prepare/normals.h"
#include "spiraling_edge/prepare/piece.h"
#include "spiraling_edge/prepare/rim.h"
#include "spiraling_edge/prepare/scan_lines.h"
#include "spiraling_edge/prepare/strays.h"

namespace se {
namespace {

/// Shares of the work.
constexpr double kListsDone = 0.4;
constexpr double kMeasuredDone = 0.5;
constexpr double kPreparedDone = 0.8;

/// Parts of the points are joined by mutual neighbors within this many spacings of both.
constexpr double kJoined = 2.0;

/// The points that are usable but for some, and their lists.
Status findSurroundings(const PointFile& file, const std::vector<bool>& without, unsigned threads,
                        const Progress& progress, Intake& intake) {
    intake.present.clear();
    for (const Aside aside : intake.placed.aside) {
        const std::size_t p = intake.present.size();
        intake.present.push_back(aside == Aside::No && (without.empty() || !without[p]));
    }
    Result<NeighborLists> lists =
        nearestPoints(file.position, intake.present, KNearest{}.k, threads, progress);
    if (!lists) return lists.error();
    intake.nearest = std::move(lists.value());
    return success();
}

/// Measures the given normals, and turns those that are flipped; empty if none is, or if the
/// normals do not fit.
std::vector<Vec3> rightNormals(const PointFile& file, unsigned threads, Intake& intake,
                               InputFacts& facts) {
    if (!file.hasNormals()) return {};
    facts.hasNormals = !lacksNormals(file.normal, intake.present);
    for (Index p = 0; p < file.normal.size() && facts.hasNormals; ++p) {
        if (intake.present[p] && !hasDirection(file.normal[p])) ++facts.completedNormals;
    }
    intake.normal = unitNormals(file.normal);
    std::vector<Vec3> normal = intake.normal;
    averageOverCopies(intake.placed, normal);
    const GivenNormals given{file.position, normal, intake.present, intake.nearest};
    intake.fit = fitOf(given, threads);
    facts.normalsFit = normalsFit(intake.fit);
    facts.nearNormals = intake.fit.near;
    facts.measuredNormals = intake.fit.places;
    facts.normalDegrees = std::acos(intake.fit.medianCosine) * 180.0 / std::numbers::pi;
    if (!facts.normalsFit) return {};
    const Sides sides = sidesOf(given);
    for (Index p = 0; p < normal.size(); ++p) {
        if (!sides.flipped[p]) continue;
        normal[p] = -normal[p];
        ++facts.flippedNormals;
    }
    if (facts.flippedNormals == 0) return {};
    return normal;
}

/// The pieces of points, by lists in either direction: the number of each point's piece.
std::vector<Index> piecesOf(const Intake& around, std::size_t& count) {
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
void turnAsInRun(const Intake& around, const PointSet& run, PointSet& points) {
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

// ---- spacing, twins, parts ----------------------------------------------------------------------

/// A twin's nearest point is nearer than this share of the distance to the fourth nearest.
constexpr double kTwinShare = 0.25;

/// The nearest point of a twin; else kNone. `nearest`: the nearest points of p, in order. Points
/// whose normals oppose are the two sides of a thin plate; `normal` may be empty.
Index twinOf(std::span<const Vec3> position, std::span<const Vec3> normal, Index p,
             std::span<const Index> nearest) {
    if (nearest.size() < 4) return kNone;
    if (!normal.empty() && glm::dot(normal[p], normal[nearest[0]]) < 0.0) return kNone;
    const bool isTwin = glm::distance(position[p], position[nearest[0]]) <
                        kTwinShare * glm::distance(position[p], position[nearest[3]]);
    return isTwin ? nearest[0] : kNone;
}

double distanceBetween(const PointFile& file, Index p, Index q) {
    return glm::distance(file.position[p], file.position[q]);
}

/// The distance to the n-th nearest point, or to the last of fewer.
double distanceTo(const PointFile& file, const Intake& around, Index p, std::size_t n) {
    const std::span<const Index> list = around.nearest[p];
    return list.empty() ? 0.0 : distanceBetween(file, p, list[std::min(n, list.size()) - 1]);
}

/// Parts of at least three points that are no strays, connected by mutual neighbors within kJoined
/// spacings.
std::size_t countPieces(const PointFile& file, const Intake& around, const std::vector<bool>& stray,
                        const MeshJudge& judge) {
    const auto n = static_cast<Index>(around.present.size());
    DisjointSets sets(n);
    for (Index p = 0; p < n; ++p) {
        for (const Index q : around.nearest[p]) {
            const std::span<const Index> back = around.nearest[q];
            const double reach = kJoined * std::min(judge.spacing[p], judge.spacing[q]);
            if (q > p && !stray[p] && !stray[q] &&
                std::find(back.begin(), back.end(), p) != back.end() &&
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
void measure(const PointFile& file, const Intake& around, const std::vector<bool>& stray,
             MeshJudge& judge) {
    const auto n = static_cast<Index>(around.present.size());
    InputFacts& facts = judge.facts;
    const auto lines = scanLinesOf(file.position, around.present, around.nearest);
    if (lines && lines->across > lines->along) {
        facts.along = lines->along;
        facts.across = lines->across;
    }
    judge.spacing.assign(n, 0.0);
    judge.reach.assign(n, 0.0);
    judge.twin.assign(n, kNone);
    for (Index p = 0; p < n; ++p) {
        if (!around.present[p]) continue;
        judge.spacing[p] = std::max(facts.across, distanceTo(file, around, p, 3));
        judge.reach[p] = std::max(facts.across, distanceTo(file, around, p, 12));
        judge.twin[p] = twinOf(file.position, file.normal, p, around.nearest[p]);
        if (judge.twin[p] != kNone) ++facts.twins;
    }
    if (facts.across == 0.0) facts.pieces = countPieces(file, around, stray, judge);
}

/// Measures the box and the nearest distances of the points that are no strays.
void measureExtent(const PointFile& file, const Intake& around, const std::vector<bool>& stray,
                   InputFacts& facts) {
    std::vector<double> nearest;
    std::optional<Box> box;
    for (Index p = 0; p < stray.size(); ++p) {
        if (!around.present[p] || stray[p]) continue;
        if (!box) box.emplace(file.position[p]);
        box->add(file.position[p]);
        ++facts.measured;
        if (around.nearest[p].empty()) continue;
        const bool twin = twinOf(file.position, file.normal, p, around.nearest[p]) != kNone;
        nearest.push_back(distanceTo(file, around, p, twin ? 2 : 1));
    }
    if (box) {
        facts.low = box->low;
        facts.high = box->high;
    }
    if (nearest.empty()) return;
    const auto [least, most] = std::minmax_element(nearest.begin(), nearest.end());
    facts.nearestLeast = *least;
    facts.nearestMost = *most;
    facts.nearestMean =
        std::accumulate(nearest.begin(), nearest.end(), 0.0) / static_cast<double>(nearest.size());
    facts.nearestMedian = medianOf(nearest);
}

// ---- the intake ---------------------------------------------------------------------------------

/// Points with the normals of the judge, and lists; noise and strays are set aside.
Result<Prepared> preparedFor(const PointFile& file, const PrepareOptions& options,
                             const std::vector<bool>& stray, const InputFacts& facts,
                             const Progress& progress) {
    PrepareOptions own;
    own.neighbors.threads = options.neighbors.threads;
    own.neighbors.recompute = true;
    own.setNoiseAside = true;
    own.normals = facts.normalsFit ? NormalSource::AsGiven : NormalSource::Derived;
    own.walls = options.walls;
    for (Index p = 0; p < stray.size(); ++p) {
        if (stray[p]) own.leaveOut.push_back(p);
    }
    return prepare(file, own, progress);
}

/// Takes the numbers that preparing has found.
void takeReport(const PrepareReport& report, InputFacts& facts) {
    facts.aside = report.aside;
    // Strays were given to the preparation as points to leave out.
    std::swap(facts.aside[static_cast<std::size_t>(Aside::Stray)],
              facts.aside[static_cast<std::size_t>(Aside::LeftOut)]);
    facts.aside[static_cast<std::size_t>(Aside::No)] = facts.points - report.countAside();
    facts.unscaledNormals = report.unscaledNormals;
    facts.averagedNormals = report.averagedNormals;
    if (facts.hasNormals) return;
    facts.sideParts = report.derived.normalComponents;
    facts.unknownSides = report.derived.unknownSides;
}

/// The points as a judge has them: prepared with their given normals, where these fit, the flipped
/// ones turned (`right`, unless none is). Where points are set aside as noise, the others get the
/// mean normals of prepare(): a single one follows the noise. Adds the numbers that preparing has
/// found to the facts.
Result<PointSet> pointsFor(const PointFile& file, const PrepareOptions& options,
                           std::vector<Vec3> right, const std::vector<bool>& stray,
                           InputFacts& facts, const Progress& progress) {
    // Lists by normals that contradict each other would end at the borders of patches.
    const bool turned = !right.empty();
    PointFile agreeing;
    if (turned) {
        agreeing = file;
        agreeing.normal = std::move(right);
    }
    Result<Prepared> prepared =
        preparedFor(turned ? agreeing : file, options, stray, facts, progress);
    if (!prepared) return prepared.error();
    takeReport(prepared.value().report, facts);
    PointSet points = std::move(prepared.value().points);
    for (Aside& aside : points.aside) {
        if (aside == Aside::LeftOut) aside = Aside::Stray;
    }
    return points;
}

/// Measures the distances of the points that are no noise.
Status measureWithoutNoise(const PointFile& file, const std::vector<bool>& stray, unsigned threads,
                           const Intake& intake, MeshJudge& judge) {
    if (judge.facts.count(Aside::Noise) == 0) {
        measure(file, intake, stray, judge);
        return success();
    }
    std::vector<bool> noise(judge.points.size(), false);
    for (Index p = 0; p < noise.size(); ++p) noise[p] = judge.points.aside[p] == Aside::Noise;
    Intake kept;
    kept.placed = intake.placed;
    if (Status found = findSurroundings(file, noise, threads, {}, kept); !found) return found;
    measure(file, kept, stray, judge);
    return success();
}

/// Lists that go across right-angled edges, where no surface ends; of points that lie in lines
/// those of some that are as far apart as the lines, since lists of all would end at each line.
Status findWideLists(const InputFacts& facts, unsigned threads, PointSet& points) {
    std::vector<bool> usable(points.size(), true);
    if (facts.across > 0.0) usable = pointsIn(points.position, {{}, kThinnedLines * facts.across});
    for (Index p = 0; p < usable.size(); ++p) usable[p] = usable[p] && !points.isAside(p);
    NeighborOptions options;
    options.opposingCosine = kSheetsCosine;
    options.threads = threads;
    points.neighbors = {};  // At once, they would take as much memory again.
    Result<NeighborLists> lists = findNeighbors(points.position, points.normal, usable, options);
    if (!lists) return lists.error();
    points.neighbors = std::move(lists.value());
    return success();
}

/// Finds where the surface of the points ends. Their lists are not needed any more then.
Status findOpenings(unsigned threads, const Progress& progress, MeshJudge& judge) {
    PointSet& points = judge.points;
    if (const Status found = findWideLists(judge.facts, threads, points); !found)
        return found.error();
    Result<Rim> rim =
        findRim(points.position, points.normal, points.neighbors, points.type, threads, progress);
    if (!rim) return rim.error();
    judge.openings = std::move(rim.value().chains);
    judge.facts.openings = judge.openings.size();
    points.neighbors = {};
    freeList(points.rim);
    return success();
}

/// An intake, and its judge, which lacks only the openings.
struct Measured {
    Intake intake;
    std::shared_ptr<MeshJudge> judge = std::make_shared<MeshJudge>();
};

Result<Measured> measured(const PointFile& file, const PrepareOptions& options, const PointSet* run,
                          const Progress& progress) {
    if (const Status status = checkColumns(file); !status) return status.error();
    const unsigned threads = options.neighbors.threads;
    Measured result;
    Intake& intake = result.intake;
    MeshJudge& judge = *result.judge;
    intake.placed = placedPoints(file.position, file.farValues);
    if (const Status found =
            findSurroundings(file, {}, threads, partOf(progress, 0.0, kListsDone), intake);
        !found)
        return found.error();
    judge.facts.points = file.position.size();
    std::vector<Vec3> right = rightNormals(file, threads, intake, judge.facts);
    const std::vector<bool> stray =
        strayPoints(file.position, intake.present, intake.nearest, threads);
    measureExtent(file, intake, stray, judge.facts);
    Result<PointSet> points = pointsFor(file, options, std::move(right), stray, judge.facts,
                                        partOf(progress, kMeasuredDone, kPreparedDone));
    if (!points) return points.error();
    judge.points = std::move(points.value());
    if (const Status done = measureWithoutNoise(file, stray, threads, intake, judge); !done)
        return done.error();
    const bool named = options.normals != NormalSource::AsGiven || options.scanner;
    if (run != nullptr && named) turnAsInRun(intake, *run, judge.points);
    return result;
}

Result<std::shared_ptr<MeshJudge>> judged(const PointFile& file, const PrepareOptions& options,
                                          const PointSet* run, const Progress& progress) {
    std::shared_ptr<MeshJudge> judge;
    {
        // The intake takes as much memory as the points.
        Result<Measured> result = measured(file, options, run, progress);
        if (!result) return result.error();
        judge = std::move(result.value().judge);
    }
    if (const Status found =
            findOpenings(options.neighbors.threads, partOf(progress, kPreparedDone, 1.0), *judge);
        !found)
        return found.error();
    return judge;
}

/// Leaves out the openings that the user wants closed.
void dropOpeningsToClose(const Params& params, MeshJudge& judge) {
    if (!params.limitsHoles()) return;
    std::erase_if(judge.openings, [&](const std::vector<Index>& chain) {
        const LoopShape shape = shapeOfLoop(judge.points.position, judge.points.normal, chain);
        return params.isWithinHoleLimits(shape.width(), chain.size());
    });
}

}  // namespace

Result<Intake> takeIn(const PointFile& file, const Progress& progress) {
    Result<Measured> result = measured(file, {}, nullptr, progress);
    if (!result) return result.error();
    auto& [intake, judge] = result.value();
    if (const Status found = findOpenings(0, partOf(progress, kPreparedDone, 1.0), *judge); !found)
        return found.error();
    intake.judge = std::move(judge);
    return std::move(intake);
}

Result<std::shared_ptr<const MeshJudge>> judgeOfRun(const PointFile& file,
                                                    const PrepareOptions& options,
                                                    const Params& params, const PointSet& run,
                                                    const Progress& progress) {
    assert(run.size() == file.position.size());
    auto judge = judged(file, options, &run, progress);
    if (!judge) return judge.error();
    dropOpeningsToClose(params, *judge.value());
    return std::shared_ptr<const MeshJudge>(std::move(judge.value()));
}

Result<std::shared_ptr<const MeshJudge>> judgeFor(const PointFile& file, unsigned threads) {
    PrepareOptions options;
    options.neighbors.threads = threads;
    auto judge = judged(file, options, nullptr, {});
    if (!judge) return judge.error();
    return std::shared_ptr<const MeshJudge>(std::move(judge.value()));
}

PointSet ownPoints(const PointFile& mesh) {
    PointSet points;
    points.position = mesh.position;
    points.normal = mesh.normal;
    points.type = mesh.type;
    return points;
}

}  // namespace se
