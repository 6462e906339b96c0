/// Fit by angles at planar places. Sides without a global orientation: sheets are connected sets of
/// points whose normals agree; two sheets contradict each other where they continue in one plane
/// with opposite normals. Where the contradictions are more than noise can explain, the smaller
/// sheet counts as flipped; then single points against nearly all beside them, which are found at
/// edges, too. O(points times list).
#include "spiraling_edge/prepare/given_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/base/median.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/prepare/normals.h"

namespace se {
namespace {

constexpr std::size_t kMeasuredPerThread = 1024;
/// Over or under a tangent plane, as a share of the distance between two points.
constexpr double kClearHeight = 0.1;

/// True if the neighbors of p, seen along `normal`, leave no gap over 90 degrees: the points are of
/// a surface there, not of its edges alone.
bool goesRound(const GivenNormals& given, Index p, const Vec3& normal) {
    const std::span<const Index> list = given.nearest[p];
    return std::all_of(list.begin(), list.end(), [&](Index q) {
        const Vec3 left = glm::cross(normal, given.position[q] - given.position[p]);
        const Vec3 ahead = glm::cross(left, normal);
        return std::any_of(list.begin(), list.end(), [&](Index next) {
            const Vec3 d = given.position[next] - given.position[p];
            return glm::dot(d, left) > 0.0 && glm::dot(d, ahead) >= 0.0;
        });
    });
}

/// Absolute cosine between the normal of p and the plane normal there; 2 where the place is not
/// planar, or has no normal.
double cosineAt(const GivenNormals& given, Index p) {
    constexpr double kNoPlace = 2.0;
    if (!given.hasNormal(p)) return kNoPlace;
    const PlaneFit plane = planeAt(given.position, p, given.nearest[p]);
    const double sum = plane.variance[0] + plane.variance[1] + plane.variance[2];
    const bool planar = plane.variance[0] < kFitLimits.thickness * sum &&
                        plane.variance[1] > kFitLimits.width * plane.variance[2] &&
                        goesRound(given, p, plane.normal);
    return planar ? std::abs(glm::dot(plane.normal, given.normal[p])) : kNoPlace;
}

}  // namespace

std::vector<Vec3> unitNormals(std::vector<Vec3> normal) {
    for (Vec3& n : normal) {
        if (hasDirection(n)) {
            scaleToUnit(n);
        } else {
            n = Vec3(0.0);
        }
    }
    return normal;
}

std::size_t averageOverCopies(const PlacedPoints& placed, std::vector<Vec3>& normal) {
    const auto& [aside, original] = placed;
    std::map<Index, std::vector<Vec3>> directions;  // of points with copies, each direction once
    for (Index p = 0; p < normal.size(); ++p) {
        if (aside[p] != Aside::Copy) continue;
        std::vector<Vec3>& list = directions[original[p]];
        if (list.empty()) addDirection(list, normal[original[p]]);
        addDirection(list, normal[p]);
    }
    std::size_t averaged = 0;
    for (const auto& [p, list] : directions) {
        if (list.size() > 1) normal[p] = meanOfDirections(list, averaged);
    }
    return averaged;
}

NormalFit fitOf(const GivenNormals& given, unsigned threads) {
    std::vector<double> cosines(given.size());
    forEachItem(cosines.size(), threads, kMeasuredPerThread,
                [&](std::size_t p) { cosines[p] = cosineAt(given, static_cast<Index>(p)); });
    NormalFit fit;
    for (Index p = 0; p < given.size(); ++p) fit.normals += given.hasNormal(p) ? 1U : 0U;
    for (Index p = 0; p < given.size(); ++p) {
        if (cosines[p] < kFitLimits.nearCosine) fit.off.push_back(p);
    }
    std::erase_if(cosines, [](double cosine) { return cosine > 1.5; });
    fit.places = cosines.size();
    if (cosines.empty()) return fit;
    fit.medianCosine = std::min(medianOf(cosines), 1.0);
    fit.leastTenth = std::min(quantileOf(cosines, 0.1), 1.0);
    fit.mostTenth = std::min(quantileOf(cosines, 0.9), 1.0);
    fit.near = fit.places - fit.off.size();
    return fit;
}

bool normalsFit(const NormalFit& fit) {
    if (fit.normals == 0) return false;
    const double least = kFitLimits.leastShare * static_cast<double>(fit.normals);
    if (fit.places < kFitLimits.leastPlaces || static_cast<double>(fit.places) < least) return true;
    if (fit.places < kFitLimits.fewPlaces) return fit.medianCosine >= kFitLimits.fewCosine;
    return fit.medianCosine >= kFitLimits.medianCosine &&
           static_cast<double>(fit.near) >= kFitLimits.nearShare * static_cast<double>(fit.places);
}

namespace {

// ---- sheets -------------------------------------------------------------------------------------

/// True if p and q lie in each other's tangent plane, up to an angle with this sine, and these have
/// at least this cosine; regardless of the sign of their normals.
bool areInPlane(const GivenNormals& given, Index p, Index q, double sine, double cosine) {
    const Vec3& a = given.normal[p];
    const Vec3& b = given.normal[q];
    const Vec3 offset = given.position[q] - given.position[p];
    const double reach = sine * glm::length(offset);
    return std::abs(glm::dot(offset, a)) <= reach && std::abs(glm::dot(offset, b)) <= reach &&
           std::abs(glm::dot(a, b)) >= cosine;
}

/// True if p and q lie in one smooth sheet: each within 30 degrees of the other's tangent plane,
/// and the planes within 45 degrees of each other.
bool inOneSheet(const GivenNormals& given, Index p, Index q) {
    return given.hasNormal(p) && given.hasNormal(q) &&
           areInPlane(given, p, q, 0.5, 0.70710678118654752);
}

/// Points in one sheet whose normals agree.
DisjointSets sheetsOf(const GivenNormals& given) {
    DisjointSets sheets(given.size());
    for (Index p = 0; p < given.size(); ++p) {
        for (const Index q : given.nearest[p]) {
            if (inOneSheet(given, p, q) &&
                !normalsOppose(given.normal[p], given.normal[q], kRightAngle))
                sheets.unite(p, q);
        }
    }
    return sheets;
}

// ---- contradictions -----------------------------------------------------------------------------

/// Unit direction from p to q in projection along the normal of p; zero exactly above and below.
Vec3 directionInPlane(const GivenNormals& given, Index p, Index q) {
    Vec3 d = given.position[q] - given.position[p];
    d -= glm::dot(d, given.normal[p]) * given.normal[p];
    const double length = glm::length(d);
    return length > 0.0 ? d / length : Vec3(0.0);
}

/// True if q lies less than 45 degrees above or below p. Else it is not in the same sheet, though
/// its normal may agree by chance.
bool isBeside(const GivenNormals& given, Index p, Index q) {
    const Vec3 offset = given.position[q] - given.position[p];
    constexpr double kSteep = 0.70710678118654752;
    return std::abs(glm::dot(offset, given.normal[p])) < kSteep * glm::length(offset);
}

/// Neighbors in the sheet of p with an opposing normal, where p has no agreeing neighbor within 60
/// degrees of their direction. If they were on a second sheet, that of p would continue beside
/// them.
void contradictions(const GivenNormals& given, Index p, std::vector<Index>& opposing) {
    opposing.clear();
    std::vector<Vec3> agreeing;
    for (const Index q : given.nearest[p]) {
        if (!given.hasNormal(q)) continue;
        if (!normalsOppose(given.normal[p], given.normal[q], kRightAngle)) {
            if (isBeside(given, p, q)) agreeing.push_back(directionInPlane(given, p, q));
        } else if (inOneSheet(given, p, q)) {
            opposing.push_back(q);
        }
    }
    constexpr double kBeside = 0.5;
    const auto goesOn = [&](Index q) {
        const Vec3 direction = directionInPlane(given, p, q);
        return std::any_of(agreeing.begin(), agreeing.end(),
                           [&](const Vec3& a) { return glm::dot(a, direction) > kBeside; });
    };
    opposing.erase(std::remove_if(opposing.begin(), opposing.end(), goesOn), opposing.end());
}

/// Number of contradictions of two sheets, and of those in one plane.
struct Conflict {
    std::size_t pairs = 0;
    std::size_t flat = 0;
    std::ptrdiff_t facing = 0;  ///< Pairs that face each other, less those that face away.

    /// Neighbors in one flipped sheet lie over each other as often as under.
    bool isOfTwoSheets() const {
        constexpr double kNearlyAll = 0.8;
        return static_cast<double>(std::abs(facing)) > kNearlyAll * static_cast<double>(pairs);
    }
};
/// 1 if each of two points lies over the other's tangent plane, as in a slot; -1 if under, as the
/// sides of a plate; 0 if neither is clear. Where a flipped sheet bends, one lies over and one
/// under.
int facingOf(const GivenNormals& given, Index p, Index q) {
    const Vec3 offset = given.position[q] - given.position[p];
    const double height = glm::dot(offset, given.normal[p] - given.normal[q]);
    const double least = kClearHeight * glm::length(offset);
    return height > least ? 1 : height < -least ? -1 : 0;
}

/// By the least points of the sheets.
using Conflicts = std::map<std::pair<Index, Index>, Conflict>;

Conflicts conflictsBetween(const GivenNormals& given, DisjointSets& sheets) {
    Conflicts conflicts;
    std::vector<Index> opposing;
    for (Index p = 0; p < given.size(); ++p) {
        if (!given.hasNormal(p)) continue;
        contradictions(given, p, opposing);
        for (const Index q : opposing) {
            const std::pair<Index, Index> pair = std::minmax({sheets.find(p), sheets.find(q)});
            if (pair.first == pair.second) continue;
            Conflict& conflict = conflicts[pair];
            ++conflict.pairs;
            // Within 10 degrees: no bend, and no part that is thin.
            conflict.flat += areInPlane(given, p, q, 0.17, 0.95) ? 1U : 0U;
            conflict.facing += facingOf(given, p, q);
        }
    }
    return conflicts;
}

/// True if a patch of `patch` points with these contradictions must be flipped. Along a straight
/// rim each step contradicts in six pairs, and a patch of m points has a rim of 2.3 root m steps at
/// least, even if half of it is the rim of the surface: 14 root m. A single flipped point
/// contradicts in 12, beside the edge of a part in 5 of one plane. Noise and thin parts contradict
/// in places. Long strips have short rims, hence the bound above.
bool isEvidence(const Conflict& conflict, std::size_t patch) {
    if (conflict.isOfTwoSheets()) return false;
    constexpr std::size_t kBesideEdge = 5;
    const double wanted = std::clamp(4.0 * std::sqrt(static_cast<double>(patch)), 8.0, 40.0);
    return static_cast<double>(conflict.pairs) >= wanted ||
           (patch == 1 && conflict.flat >= kBesideEdge);
}

/// The sheets that contradict each other with evidence, in both directions.
using OpposingSheets = std::map<Index, std::vector<Index>>;

OpposingSheets findOpposingSheets(const GivenNormals& given, DisjointSets& sheets,
                                  const std::vector<std::size_t>& size) {
    OpposingSheets opposingSheets;
    for (const auto& [pair, conflict] : conflictsBetween(given, sheets)) {
        if (!isEvidence(conflict, std::min(size[pair.first], size[pair.second]))) continue;
        opposingSheets[pair.first].push_back(pair.second);
        opposingSheets[pair.second].push_back(pair.first);
    }
    return opposingSheets;
}

/// Decides among sheets that contradict each other: the largest counts as right, those that
/// contradict it as flipped, those that contradict these as right, and so on.
std::map<Index, bool> flippedAmong(const OpposingSheets& opposingSheets,
                                   const std::vector<std::size_t>& size) {
    std::vector<Index> bySize;
    for (const auto& entry : opposingSheets) bySize.push_back(entry.first);
    std::sort(bySize.begin(), bySize.end(),
              [&](Index a, Index b) { return size[a] != size[b] ? size[a] > size[b] : a < b; });
    std::map<Index, bool> flipped;
    for (const Index first : bySize) {
        if (!flipped.emplace(first, false).second) continue;
        std::vector<Index> reached{first};
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const bool here = flipped.at(reached[i]);
            for (const Index next : opposingSheets.at(reached[i])) {
                if (flipped.emplace(next, !here).second) reached.push_back(next);
            }
        }
    }
    return flipped;
}

// ---- single points ------------------------------------------------------------------------------

/// Bounds of votes on single points, chosen on eight shared sets with normals turned at random, and
/// judged on twelve others (docs/doctor.md).
struct SingleLimits {
    double steep = 0.70710678118654752;  ///< 45 degrees over or under a point: none beside it.
    double clear = 0.5;                  ///< 60 degrees: nearer to a right angle is no vote.
    std::size_t least = 6;               ///< Points against it,
    double agreeing = 0.1;               ///< and at most this share of them agree,
    double apart = 0.5;                  ///< and less than this share lie on another sheet.
};
constexpr SingleLimits kSingle{};

/// Neighbors of a point by their votes on its side.
struct SideVotes {
    Index opponent = kNone;  ///< The nearest one against it whose list has it, too.
    std::size_t against = 0;
    std::size_t agreeing = 0;
    std::size_t over = 0;   ///< Each over the other's tangent plane, as in a slot,
    std::size_t under = 0;  ///< or under it, as on a plate.

    /// Counts a neighbor in the unit direction `along`; `a` is the normal of the point, `b` that of
    /// the neighbor. One is mirrored halfway between them (orientation.h), which holds at edges,
    /// where no plane goes on.
    void add(const Vec3& along, const Vec3& a, const Vec3& b) {
        const double rise = glm::dot(along, a);
        const double back = -glm::dot(along, b);
        if (std::max(std::abs(rise), std::abs(back)) > kSingle.steep) return;
        const double cosine = glm::dot(a - 2.0 * rise * along, b);
        if (std::abs(cosine) < kSingle.clear) return;
        ++(cosine < 0.0 ? against : agreeing);
        over += std::min(rise, back) > kClearHeight ? 1U : 0U;
        under += std::max(rise, back) < -kClearHeight ? 1U : 0U;
    }
    /// Nearly all points beside it have the opposite side, and it is none of a second sheet, and no
    /// stray, which no list has.
    bool areAgainst() const {
        const auto all = static_cast<double>(against);
        return opponent != kNone && against >= kSingle.least &&
               static_cast<double>(agreeing) <= kSingle.agreeing * all &&
               static_cast<double>(std::max(over, under)) < kSingle.apart * all;
    }
};

SideVotes votesOn(const GivenNormals& given, const std::vector<bool>& flipped, Index p) {
    const auto side = [&](Index q) { return flipped[q] ? -given.normal[q] : given.normal[q]; };
    const auto lists = [&](Index q) {
        const std::span<const Index> list = given.nearest[q];
        return std::find(list.begin(), list.end(), p) != list.end();
    };
    SideVotes votes;
    for (const Index q : given.nearest[p]) {
        const Vec3 offset = given.position[q] - given.position[p];
        const double length = glm::length(offset);
        if (!given.hasNormal(q) || !(length > 0.0)) continue;
        const std::size_t before = votes.against;
        votes.add(offset / length, side(p), side(q));
        if (votes.opponent == kNone && votes.against > before && lists(q)) votes.opponent = q;
    }
    return votes;
}

/// Flips single points that the sheets leave undecided, and unites them with their opponents.
/// Repeats up to four rounds, since each changes the votes of neighbors; all points of a round are
/// judged by the sides before it.
void flipSinglePoints(const GivenNormals& given, std::vector<bool>& flipped, DisjointSets& sheets) {
    constexpr int kRounds = 4;
    std::vector<Index> found;
    for (int round = 0; round < kRounds; ++round) {
        found.clear();
        for (Index p = 0; p < given.size(); ++p) {
            if (!given.hasNormal(p)) continue;
            const SideVotes votes = votesOn(given, flipped, p);
            if (!votes.areAgainst()) continue;
            found.push_back(p);
            sheets.unite(p, votes.opponent);
        }
        if (found.empty()) return;
        for (const Index p : found) flipped[p] = !flipped[p];
    }
}

}  // namespace

Sides sidesOf(const GivenNormals& given) {
    const Index n = given.size();
    Sides sides{std::vector<Index>(n, kNone), std::vector<bool>(n, false)};
    DisjointSets sheets = sheetsOf(given);
    std::vector<std::size_t> size(n, 0);  // by the least point
    for (Index p = 0; p < n; ++p) {
        if (given.hasNormal(p)) ++size[sheets.find(p)];
    }
    const OpposingSheets opposingSheets = findOpposingSheets(given, sheets, size);
    const std::map<Index, bool> flipped = flippedAmong(opposingSheets, size);
    for (Index p = 0; p < n; ++p) {
        const auto sheet = flipped.find(sheets.find(p));
        sides.flipped[p] = sheet != flipped.end() && sheet->second;
    }
    flipSinglePoints(given, sides.flipped, sheets);
    for (const auto& [sheet, others] : opposingSheets) {
        for (const Index other : others) sheets.unite(sheet, other);
    }
    for (Index p = 0; p < n; ++p) {
        if (given.hasNormal(p)) sides.component[p] = sheets.find(p);
    }
    return sides;
}

}  // namespace se
