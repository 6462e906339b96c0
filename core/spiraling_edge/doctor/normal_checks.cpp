/// Checks of normals: one by one, and against each other. Those that are flipped are found by
/// sidesOf() (given_normals.h). Closed components are inside out if their normals point inward at
/// all six extremes. O(points times list).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/prepare/facing.h"
#include "spiraling_edge/prepare/normals.h"

namespace se {

std::optional<Finding> findNoNormals(const ExaminedFile& examined) {
    if (examined.file.hasNormals() || examined.size() == 0) return std::nullopt;
    std::string text = "the file has no normals";
    const InputFacts& facts = examined.intake.judge->facts;
    if (facts.unknownSides > 0)
        text += "; " + unknownSidesText(facts.unknownSides, facts.sideParts);
    return Finding{nullptr, Severity::Warning, examined.size(), {}, std::move(text)};
}

std::optional<Finding> findZeroNormals(const ExaminedFile& examined) {
    const std::vector<Vec3>& normal = examined.file.normal;
    auto points = pointsWhere(
        normal.size(), [&](Index p) { return examined.present()[p] && !hasDirection(normal[p]); });
    const bool all = lacksNormals(normal, examined.present());
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
    if (!examined.normalsNear) return std::nullopt;
    auto points = pointsWhere(examined.size(), [&](Index p) {
        if (!examined.hasSide(p) || examined.nearest()[p].empty()) return false;
        const Index q = examined.nearest()[p].front();
        if (examined.isOff(p) || examined.isOff(q)) return false;
        // Across the edge of a box normals are perpendicular.
        constexpr double kAway = -0.5;
        return examined.hasSide(q) && glm::dot(examined.side(p), examined.side(q)) < kAway;
    });
    // Many shapes have thin parts. If every second point has its nearest on another sheet, the
    // spacing does not fit the set as a whole.
    const bool everywhere = 2 * points.size() >= examined.presentCount;
    return findingAt(std::move(points), everywhere ? Severity::Warning : Severity::Note,
                     "with the nearest other on a sheet that faces away");
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
    return countWhere(votes, [](const FacingVote& vote) { return !vote.isKnown(); });
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
    std::string text = "in " + counted(count, "component") + " whose normals mostly point inwards";
    const std::size_t unknown = count > 0 ? unknownAmong(examined, others) : 0;
    if (unknown > 0) text += "; " + unknownSidesText(unknown, others.size() + count);
    return findingAt(std::move(points), Severity::Warning, text);
}

}  // namespace se
