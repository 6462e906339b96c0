#include "spiraling_edge/mesh/mesh_verdict.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/mesh/mesh_judge.h"
#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

/// A point in no triangle is covered within this many spacings of the mesh.
constexpr double kCovering = 0.5;

std::size_t totalOf(std::span<const ClassTotal> totals, std::string_view name) {
    return totals[static_cast<std::size_t>(findFailureClass(name) - failureClasses().data())].total;
}

/// Loops of a mesh, sorted by what they are for the points.
struct Loops {
    std::vector<bool> on;          ///< Per point: on a loop.
    std::vector<bool> besideHole;  ///< Per point: on a loop where the points do not end.
    std::size_t holeEdges = 0;
};
/// A loop is an opening if the surface ends there, and half of its points are on rims or walls.
/// Without a judge the first has to do.
Loops loopsOf(const MeshJudge* judge, std::span<const MeshFailure> failures, std::size_t points) {
    Loops loops{std::vector<bool>(points, false), std::vector<bool>(points, false)};
    const std::vector<bool> onRim = judge == nullptr ? std::vector<bool>{} : endsOf(*judge);
    for (const MeshFailure& each : failures) {
        if (!isLoop(each)) continue;
        const std::size_t count =
            countWhere(each.points, [&](Index p) { return judge == nullptr || onRim[p]; });
        const bool hole = each.kind->fault || 2 * count < each.points.size();
        if (hole) loops.holeEdges += each.edges.size();
        for (const Index p : each.points) {
            loops.on[p] = true;
            if (hole) loops.besideHole[p] = true;
        }
    }
    return loops;
}

/// The number of openings that the mesh covers: most of their points in triangles are on no loop.
/// Marks all their points.
std::size_t closedOpenings(const MeshJudge& judge, const std::vector<bool>& onLoop,
                           const std::vector<bool>& used, std::vector<bool>& amiss) {
    std::size_t closed = 0;
    for (const std::vector<Index>& chain : judge.openings) {
        std::ptrdiff_t inside = 0;
        for (const Index p : chain) {
            if (used[p]) inside += onLoop[p] ? -1 : 1;
        }
        if (inside <= 0) continue;
        ++closed;
        for (const Index p : chain) amiss[p] = true;
    }
    return closed;
}

/// Counts strays and noise in no triangle, the points that a mesh should have, and those of them
/// that are not covered, which it marks.
void countPoints(const MeshJudge& judge, const std::vector<bool>& besideHole,
                 std::span<const double> distance, const std::vector<bool>& used,
                 MeshVerdict& verdict, std::vector<bool>& amiss) {
    for (Index p = 0; p < used.size(); ++p) {
        const Aside aside = judge.points.asideOf(p);
        if (isUnusable(aside)) continue;
        const bool stray = aside == Aside::Stray;
        const bool noise = aside == Aside::Noise;
        if (stray && !used[p]) ++verdict.strays;
        if (noise && !used[p]) ++verdict.noise;
        if (stray || noise || judge.spacing.empty()) continue;
        ++verdict.toCover;
        const bool covered = used[p] ? !besideHole[p] : distance[p] <= kCovering * judge.spacing[p];
        verdict.uncovered += covered ? 0 : 1;
        amiss[p] = amiss[p] || !covered;
    }
}

/// Per point: at a fault, listed or not.
std::vector<bool> pointsAtFaults(const MeshInspection& inspection) {
    std::vector<bool> at = inspection.atFault;
    for (const MeshFailure& each : inspection.failures) {
        if (!each.kind->fault) continue;
        for (const Index p : each.points) at[p] = true;
    }
    return at;
}

/// Number of places at which each class is the worst.
std::vector<std::size_t> worstClasses(std::span<const MeshFailure> failures,
                                      std::span<const FaultPlace> places) {
    std::vector<std::size_t> count(failureClasses().size(), 0);
    for (const FaultPlace& place : places) {
        const FailureClass* worst = failures[place.faults.front()].kind;
        ++count[static_cast<std::size_t>(worst - failureClasses().data())];
    }
    return count;
}

constexpr VerdictCount kCounts[] = {
    {"points_lost",
     "point lost",
     "points lost",
     [](const MeshVerdict& v) { return v.lost; },
     {"lost_points", "isolated_points"}},
    {"extra_pieces", "piece torn off", "pieces torn off",
     [](const MeshVerdict& v) { return v.extraPieces(); }},
    {"hole_edges",
     "edge of a hole",
     "edges of holes",
     [](const MeshVerdict& v) { return v.holeEdges; },
     {"holes"}},
    {"openings_closed", "opening of the scan closed", "openings of the scan closed",
     [](const MeshVerdict& v) { return v.closed; }},
    {"triangles_against_normals",
     "triangle against the normals",
     "triangles against the normals",
     [](const MeshVerdict& v) { return v.against; },
     {"flipped_triangles"}},
    {"pieces_facing_in",
     "piece facing in",
     "pieces facing in",
     [](const MeshVerdict& v) { return v.facingIn; },
     {"inward_pieces"}},
    {"points_not_covered", "point not covered", "points not covered",
     [](const MeshVerdict& v) { return v.uncovered; }},
};

/// Adds what only a judge knows, and marks points.
void judgePoints(const MeshJudge& judge, const Loops& loops, std::span<const double> distance,
                 const std::vector<bool>& used, MeshVerdict& verdict, std::vector<bool>& amiss) {
    verdict.piecesOfPoints = judge.facts.pieces;
    verdict.openings = judge.openings.size();
    verdict.closed = closedOpenings(judge, loops.on, used, amiss);
    if (judge.facts.normalsFit) verdict.against = totalOf(verdict.totals, "flipped_triangles");
    countPoints(judge, loops.besideHole, distance, used, verdict, amiss);
}

}  // namespace

MeshVerdict verdictOn(const PointSet& points, std::span<const Triangle> triangles,
                      const MeshInspection& inspection, std::span<const FaultPlace> places) {
    const std::vector<bool> used = usedPoints(points.size(), triangles);
    const std::vector<double> distance = distancesFromMesh(points, triangles);
    MeshVerdict verdict;
    verdict.totals = inspection.totals;
    verdict.placesOf = worstClasses(inspection.failures, places);
    verdict.places = places.size();
    const auto isFault = [](const MeshFailure& each) { return each.kind->fault; };
    verdict.allPlaces = isExact(inspection.totals) &&
                        countWhere(inspection.failures, isFault) == faultCount(inspection.totals);
    verdict.triangles = triangles.size();
    verdict.points = points.size();
    verdict.usedPoints = inspection.report.usedPoints;
    verdict.lost =
        totalOf(verdict.totals, "lost_points") + totalOf(verdict.totals, "isolated_points");
    verdict.twins = inspection.twins;
    verdict.pieces = inspection.report.components;
    const Loops loops = loopsOf(points.judge.get(), inspection.failures, points.size());
    verdict.holeEdges = loops.holeEdges;
    verdict.facingIn = totalOf(verdict.totals, "inward_pieces");
    verdict.fidelity = fidelityFrom(distance);
    std::vector<bool> amiss = pointsAtFaults(inspection);
    if (points.judge) judgePoints(*points.judge, loops, distance, used, verdict, amiss);
    verdict.amiss = static_cast<std::size_t>(std::count(amiss.begin(), amiss.end(), true));
    return verdict;
}

JudgedMesh judgeMesh(const PointSet& points, std::span<const Triangle> triangles) {
    JudgedMesh judged{inspectWithTotals(points, triangles), {}, {}};
    judged.places = faultPlaces(points, judged.inspection.failures, judged.inspection.meanEdge);
    judged.verdict = verdictOn(points, triangles, judged.inspection, judged.places);
    return judged;
}

std::span<const VerdictCount> verdictCounts() { return kCounts; }

bool isCounted(const FailureClass& kind) {
    return rowWhere(kCounts, [&](const VerdictCount& count) {
               return isAmong(kind.name, count.classes);
           }) != nullptr;
}

bool isSounder(const MeshVerdict& mesh, const MeshVerdict& other) {
    const auto rankOf = [](const MeshVerdict& each) {
        return std::tuple(each.triangles == 0 || each.stopped, !each.isSound(), each.amiss);
    };
    return rankOf(mesh) < rankOf(other);
}

bool isBetter(const MeshVerdict& mesh, const MeshVerdict& other) {
    if (isSounder(mesh, other)) return true;
    if (isSounder(other, mesh)) return false;
    return std::tuple(mesh.extraPieces(), mesh.fidelity.meanDistance) <
           std::tuple(other.extraPieces(), other.fidelity.meanDistance);
}

std::string placesText(const MeshVerdict& verdict) {
    return counted(verdict.places, "place") + (verdict.allPlaces ? "" : " or more");
}

std::string headlineOf(const MeshVerdict& verdict) {
    if (verdict.stopped) return "stopped: too many triangles";
    if (verdict.isSound()) return "sound";
    if (verdict.triangles == 0) return "not sound: no triangle";
    if (verdict.places == 0) return "no fault found, but the search ended early";
    std::vector<std::size_t> classes;
    for (std::size_t i = 0; i < verdict.placesOf.size(); ++i) {
        if (verdict.placesOf[i] > 0) classes.push_back(i);
    }
    std::stable_sort(classes.begin(), classes.end(), [](std::size_t a, std::size_t b) {
        return failureClasses()[a].severity < failureClasses()[b].severity;
    });
    constexpr std::size_t kNamedClasses = 3;
    std::string text = placesText(verdict);
    std::size_t others = verdict.places;
    const VerdictCount& lost = *findNamed(kCounts, "points_lost");
    bool namesLost = false;
    for (std::size_t i = 0; i < std::min(classes.size(), kNamedClasses); ++i) {
        const FailureClass& kind = failureClasses()[classes[i]];
        const std::size_t count = verdict.placesOf[classes[i]];
        others -= count;
        namesLost |= isAmong(kind.name, lost.classes);
        text += (i == 0 ? ": " : ", ") + std::to_string(count) + " of " + nounFor(kind, 2);
    }
    if (others > 0) text += ", " + counted(others, "other");
    if (verdict.lost > 0 && !namesLost) text += "; " + counted(verdict.lost, "point") + " lost";
    return text;
}

}  // namespace se
