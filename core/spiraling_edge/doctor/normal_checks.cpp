/// Checks of normals: one by one, and against each other. Flipped ones are found without a global
/// orientation: sheets are connected sets of points whose normals agree; two sheets contradict each
/// other where they continue in one plane with opposite normals. Where the contradictions are more
/// than noise can explain, the smaller sheet counts as flipped. Closed components are inside out if
/// their normals point inward at all six extremes. O(points times list).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "spiraling_edge/base/disjoint_sets.h"
#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/prepare/facing.h"
#include "spiraling_edge/prepare/normals.h"
#include "spiraling_edge/prepare/orientation.h"

namespace se {

std::optional<Finding> findNoNormals(const ExaminedFile& examined) {
    if (examined.file.hasNormals() || examined.size() == 0) return std::nullopt;
    std::string text = "the file has no normals";
    std::vector<Vec3> normal = estimateNormals(examined.file.position, examined.nearest).value();
    const OrientationReport sides =
        orientNormals(examined.file.position, examined.nearest, normal).value();
    if (sides.unknownSides > 0)
        text += "; " + unknownSidesText(sides.unknownSides, sides.components);
    return Finding{nullptr, Severity::Warning, examined.size(), {}, std::move(text)};
}

std::optional<Finding> findZeroNormals(const ExaminedFile& examined) {
    const std::vector<Vec3>& normal = examined.file.normal;
    auto points = pointsWhere(
        normal.size(), [&](Index p) { return examined.present[p] && !hasDirection(normal[p]); });
    const bool all = lacksNormals(normal, examined.present);
    return findingAt(std::move(points), Severity::Warning,
                     std::string("with a normal that is zero, NaN or infinite: ") +
                         (all ? "most, so all normals are derived from the positions"
                              : "derived, on the side of those about it"));
}

std::optional<Finding> findUnscaledNormals(const ExaminedFile& examined) {
    auto points = pointsWhere(examined.file.normal.size(), [&](Index p) {
        Vec3 normal = examined.file.normal[p];
        return scaleToUnit(normal);
    });
    return findingAt(std::move(points), Severity::Warning,
                     "off from unit length by more than a thousandth", "normal");
}

std::optional<Finding> findCloseSheets(const ExaminedFile& examined) {
    if (!examined.file.hasNormals()) return std::nullopt;
    auto points = pointsWhere(examined.size(), [&](Index p) {
        if (!examined.hasSide(p) || examined.nearest[p].empty()) return false;
        const Index q = examined.nearest[p].front();
        return examined.hasSide(q) && normalsOppose(examined.side(p), examined.side(q));
    });
    // Many shapes have thin parts. If every second point has its nearest on another sheet, the
    // spacing does not fit the set as a whole.
    const bool everywhere = 2 * points.size() >= examined.presentCount;
    return findingAt(std::move(points), everywhere ? Severity::Warning : Severity::Note,
                     "with the nearest other on a sheet that faces away");
}

namespace {

// ---- sheets -------------------------------------------------------------------------------------

/// True if p and q lie in one smooth sheet, regardless of the sign of their normals: each within 30
/// degrees of the other's tangent plane, and the planes within 45 degrees of each other.
bool inOneSheet(const ExaminedFile& examined, Index p, Index q) {
    if (!examined.hasSide(p) || !examined.hasSide(q)) return false;
    const Vec3& a = examined.normal[p];
    const Vec3& b = examined.normal[q];
    const Vec3 offset = examined.file.position[q] - examined.file.position[p];
    constexpr double kFlat = 0.5;
    constexpr double kParallel = 0.70710678118654752;
    const double reach = kFlat * glm::length(offset);
    return std::abs(glm::dot(offset, a)) <= reach && std::abs(glm::dot(offset, b)) <= reach &&
           std::abs(glm::dot(a, b)) >= kParallel;
}

/// Points in one sheet whose normals agree.
DisjointSets sheetsOf(const ExaminedFile& examined) {
    DisjointSets sheets(examined.size());
    for (Index p = 0; p < examined.size(); ++p) {
        for (const Index q : examined.nearest[p]) {
            if (inOneSheet(examined, p, q) &&
                !normalsOppose(examined.normal[p], examined.normal[q]))
                sheets.unite(p, q);
        }
    }
    return sheets;
}

// ---- contradictions -----------------------------------------------------------------------------

/// Unit direction from p to q in projection along the normal of p; zero exactly above and below.
Vec3 directionInPlane(const ExaminedFile& examined, Index p, Index q) {
    Vec3 d = examined.file.position[q] - examined.file.position[p];
    d -= glm::dot(d, examined.normal[p]) * examined.normal[p];
    const double length = glm::length(d);
    return length > 0.0 ? d / length : Vec3(0.0);
}

/// True if q lies less than 45 degrees above or below p. Else it is not in the same sheet, though
/// its normal may agree by chance.
bool isBeside(const ExaminedFile& examined, Index p, Index q) {
    const Vec3 offset = examined.file.position[q] - examined.file.position[p];
    constexpr double kSteep = 0.70710678118654752;
    return std::abs(glm::dot(offset, examined.normal[p])) < kSteep * glm::length(offset);
}

/// Neighbors in the sheet of p with an opposing normal, where p has no agreeing neighbor within 60
/// degrees of their direction. If they were on a second sheet, that of p would continue beside
/// them.
void contradictions(const ExaminedFile& examined, Index p, std::vector<Index>& opposing) {
    opposing.clear();
    std::vector<Vec3> agreeing;
    for (const Index q : examined.nearest[p]) {
        if (!examined.hasSide(q)) continue;
        if (!normalsOppose(examined.normal[p], examined.normal[q])) {
            if (isBeside(examined, p, q)) agreeing.push_back(directionInPlane(examined, p, q));
        } else if (inOneSheet(examined, p, q)) {
            opposing.push_back(q);
        }
    }
    constexpr double kBeside = 0.5;
    const auto goesOn = [&](Index q) {
        const Vec3 direction = directionInPlane(examined, p, q);
        return std::any_of(agreeing.begin(), agreeing.end(),
                           [&](const Vec3& a) { return glm::dot(a, direction) > kBeside; });
    };
    opposing.erase(std::remove_if(opposing.begin(), opposing.end(), goesOn), opposing.end());
}

/// Number of contradictions of two sheets, by their least points.
using Conflicts = std::map<std::pair<Index, Index>, std::size_t>;

Conflicts conflictsBetween(const ExaminedFile& examined, DisjointSets& sheets) {
    Conflicts conflicts;
    std::vector<Index> opposing;
    for (Index p = 0; p < examined.size(); ++p) {
        if (!examined.hasSide(p)) continue;
        contradictions(examined, p, opposing);
        for (const Index q : opposing) {
            const std::pair<Index, Index> pair = std::minmax({sheets.find(p), sheets.find(q)});
            if (pair.first != pair.second) ++conflicts[pair];
        }
    }
    return conflicts;
}

/// True if a patch of `patch` points with `pairs` contradictions must be flipped. Along a straight
/// rim each step contradicts in six pairs, and a patch of m points has a rim of 2.3 root m steps at
/// least, even if half of it is the rim of the surface: 14 root m. A single flipped point
/// contradicts in 12. Noise and thin parts contradict in places. Long strips have short rims, hence
/// the bound above.
bool isEvidence(std::size_t pairs, std::size_t patch) {
    const double wanted = std::clamp(4.0 * std::sqrt(static_cast<double>(patch)), 8.0, 40.0);
    return static_cast<double>(pairs) >= wanted;
}

/// The sheets that contradict each other with evidence, in both directions.
using OpposingSheets = std::map<Index, std::vector<Index>>;

OpposingSheets findOpposingSheets(const ExaminedFile& examined, DisjointSets& sheets,
                                  const std::vector<std::size_t>& size) {
    OpposingSheets opposingSheets;
    for (const auto& [pair, count] : conflictsBetween(examined, sheets)) {
        if (!isEvidence(count, std::min(size[pair.first], size[pair.second]))) continue;
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

}  // namespace

Sides sidesOf(const ExaminedFile& examined) {
    const Index n = examined.size();
    Sides sides{std::vector<Index>(n, kNone), std::vector<bool>(n, false)};
    if (!examined.file.hasNormals()) return sides;
    DisjointSets sheets = sheetsOf(examined);
    std::vector<std::size_t> size(n, 0);  // by the least point
    for (Index p = 0; p < n; ++p) {
        if (examined.hasSide(p)) ++size[sheets.find(p)];
    }
    const OpposingSheets opposingSheets = findOpposingSheets(examined, sheets, size);
    const std::map<Index, bool> flipped = flippedAmong(opposingSheets, size);
    for (Index p = 0; p < n; ++p) {
        const auto sheet = flipped.find(sheets.find(p));
        sides.flipped[p] = sheet != flipped.end() && sheet->second;
    }
    for (const auto& [sheet, others] : opposingSheets) {
        for (const Index other : others) sheets.unite(sheet, other);
    }
    for (Index p = 0; p < n; ++p) {
        if (examined.hasSide(p)) sides.component[p] = sheets.find(p);
    }
    return sides;
}

std::optional<Finding> findFlippedNormals(const ExaminedFile& examined) {
    auto points = pointsWhere(examined.size(), [&](Index p) { return examined.sides.flipped[p]; });
    return findingAt(std::move(points), Severity::Warning,
                     "whose normal points against those around it");
}

// ---- inside out ---------------------------------------------------------------------------------

namespace {

/// The extremes of a component along each axis, in both directions.
struct Extent {
    struct Extreme {
        double reach = -std::numeric_limits<double>::infinity();
        double out =
            0.0;  ///< Component of the normal there along that direction; the largest in a tie.
    };
    std::array<Extreme, 6> extreme;  ///< +x, -x, +y, ...
    std::size_t points = 0;
    bool cut = false;  ///< It ends at walls.

    void add(const Vec3& x, const Vec3& normal) {
        ++points;
        for (std::size_t i = 0; i < extreme.size(); ++i) {
            const auto axis = static_cast<Vec3::length_type>(i / 2);
            const double sign = i % 2 == 0 ? 1.0 : -1.0;
            const double reach = sign * x[axis];
            const double out = sign * normal[axis];
            Extreme& e = extreme[i];
            if (reach < e.reach) continue;
            e.out = reach > e.reach ? out : std::max(e.out, out);
            e.reach = reach;
        }
    }
    /// The normals of a closed surface point outward at its extremes. Here none of them does.
    bool looksIn() const {
        constexpr double kIn = -0.5;
        return std::all_of(extreme.begin(), extreme.end(),
                           [](const Extreme& e) { return e.out < kIn; });
    }
    bool isWithin(const Extent& o) const {
        for (std::size_t i = 0; i < extreme.size(); ++i) {
            if (!(extreme[i].reach < o.extreme[i].reach)) return false;
        }
        return true;
    }
};

std::map<Index, Extent> extentsOf(const ExaminedFile& examined) {
    std::map<Index, Extent> extents;
    const Sides& sides = examined.sides;
    for (Index p = 0; p < examined.size(); ++p) {
        if (sides.component[p] == kNone) continue;
        Extent& extent = extents[sides.component[p]];
        extent.add(examined.file.position[p], examined.side(p));
        if (examined.file.hasTypes() && isBoundary(examined.file.type[p])) extent.cut = true;
    }
    return extents;
}

/// Number of these components whose side their shape does not tell: open sheets.
std::size_t unknownAmong(const ExaminedFile& examined, const std::vector<Index>& names) {
    std::vector<Index> number(examined.size(), kNone);  // by name
    for (std::size_t i = 0; i < names.size(); ++i) number[names[i]] = static_cast<Index>(i);
    std::vector<Vec3> normal(examined.size(), Vec3(0.0));
    std::vector<Index> component(examined.size(), kNone);
    for (Index p = 0; p < examined.size(); ++p) {
        if (examined.sides.component[p] == kNone) continue;
        component[p] = number[examined.sides.component[p]];
        normal[p] = examined.side(p);
    }
    const auto votes = votesOutward({examined.file.position, normal, component, names.size(),
                                     std::vector<bool>(examined.size(), true)});
    return static_cast<std::size_t>(std::count_if(
        votes.begin(), votes.end(), [](const FacingVote& vote) { return !vote.isKnown(); }));
}

}  // namespace

std::optional<Finding> findInsideOut(const ExaminedFile& examined) {
    const std::map<Index, Extent> extents = extentsOf(examined);
    // Fewer points than those of an icosahedron may enclose nothing.
    constexpr std::size_t kLeast = 12;
    std::vector<bool> insideOut(examined.size(), false);
    std::size_t count = 0;
    std::vector<Index> others;
    for (const auto& [name, extent] : extents) {
        if (extent.points < kLeast || extent.cut) continue;
        if (!extent.looksIn()) {
            others.push_back(name);
            continue;
        }
        // Within another component it is a cavity, and correct.
        const bool cavity =
            std::any_of(extents.begin(), extents.end(),
                        [&e = extent](const auto& other) { return e.isWithin(other.second); });
        if (cavity) continue;
        insideOut[name] = true;
        ++count;
    }
    auto points = pointsWhere(examined.size(), [&](Index p) {
        const Index component = examined.sides.component[p];
        return component != kNone && insideOut[component];
    });
    std::string text = "in " + countText(count, "component") + " whose normals all point inwards";
    const std::size_t unknown = count > 0 ? unknownAmong(examined, others) : 0;
    if (unknown > 0) text += "; " + unknownSidesText(unknown, others.size() + count);
    return findingAt(std::move(points), Severity::Warning, text);
}

}  // namespace se
