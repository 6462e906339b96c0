/// Checks of normals against each other: flipped parts of a component (sheet_checks.cpp), and
/// closed components whose normals point inward at all six extremes.
#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "spiraling_edge/doctor/checks.h"

namespace se {

std::optional<Finding> findFlippedNormals(const ExaminedFile& examined) {
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        if (examined.sides.flipped[p]) points.push_back(p);
    }
    const std::string text =
        countText(points.size(), "point") + " whose normal points against those around it";
    return findingAt(std::move(points), Severity::Warning, text);
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

}  // namespace

std::optional<Finding> findInsideOut(const ExaminedFile& examined) {
    const std::map<Index, Extent> extents = extentsOf(examined);
    // Fewer points than those of an icosahedron may enclose nothing.
    constexpr std::size_t kLeast = 12;
    std::vector<bool> insideOut(examined.size(), false);
    std::size_t count = 0;
    for (const auto& [name, extent] : extents) {
        if (extent.points < kLeast || extent.cut || !extent.looksIn()) continue;
        // Within another component it is a cavity, and correct.
        const bool cavity =
            std::any_of(extents.begin(), extents.end(),
                        [&e = extent](const auto& other) { return e.isWithin(other.second); });
        if (cavity) continue;
        insideOut[name] = true;
        ++count;
    }
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        const Index component = examined.sides.component[p];
        if (component != kNone && insideOut[component]) points.push_back(p);
    }
    const std::string text = countText(points.size(), "point") + " in " +
                             countText(count, "component") + " whose normals all point inwards";
    return findingAt(std::move(points), Severity::Warning, text);
}

}  // namespace se
