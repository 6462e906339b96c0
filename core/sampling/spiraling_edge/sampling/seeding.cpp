/// The first particles: corners, then the curves on the walls divided evenly, then the area, one
/// particle for each equal share of it along a Z-curve. The count follows from area and lengths, or
/// the spacing from the count. O(crossings log crossings).
#include <algorithm>
#include <cmath>
#include <string>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/geometry/z_curve.h"
#include "spiraling_edge/sampling/particles.h"
#include "spiraling_edge/sampling/sampler.h"

namespace se::sampling {
namespace {

Error cancelled() { return Error{"sampling was cancelled"}; }

std::uint8_t facesAt(const Field& field, const Vec3& x) {
    unsigned faces = kInterior;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        if (x[i] == field.high[i]) faces |= 1U << axis;
        if (x[i] == field.low[i]) faces |= 8U << axis;
    }
    return withCornerBit(static_cast<std::uint8_t>(faces));
}

/// A curve on a wall with its length up to every place, in target spacings.
struct Measured {
    WallCurve curve;
    std::vector<double> reached;
    double length() const { return reached.back(); }
};

Measured measure(const Surface& surface, WallCurve curve) {
    Measured measured{std::move(curve), {0.0}};
    const auto& line = measured.curve.line;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double spacing = surface.relativeSpacing(0.5 * (line[i - 1] + line[i]));
        measured.reached.push_back(measured.length() + lengthOf(line[i] - line[i - 1]) / spacing);
    }
    return measured;
}

/// The measures of the surface before the first particle.
struct Extent {
    std::vector<Crossing> crossings;  ///< Areas in squares of the target spacing.
    std::vector<Measured> curves;
    std::vector<Vec3> corners;
    double area = 0.0;
    double length = 0.0;
};

/// False if cancelled.
bool followCurvature(Surface& surface, unsigned threads, const Progress& progress,
                     std::vector<Crossing>& crossings) {
    if (!surface.followsCurvature()) return true;
    std::vector<double> bend(crossings.size());
    const auto look = [&](std::size_t i) { bend[i] = surface.curvature(crossings[i].position); };
    if (!forEachWithProgress(bend.size(), threads, kPerThread, partOf(progress, 0.0, 0.5), look))
        return false;
    double area = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        area += crossings[i].area;
        sum += crossings[i].area * bend[i];
    }
    surface.setMeanCurvature(sum / area);
    const auto spread = [&](std::size_t i) {
        const double spacing = surface.relativeSpacing(crossings[i].position);
        crossings[i].area /= spacing * spacing;
    };
    return forEachWithProgress(crossings.size(), threads, kPerThread, partOf(progress, 0.5, 1.0),
                               spread);
}

std::vector<Vec3> cornersOf(const std::vector<Measured>& curves) {
    std::vector<Vec3> corners;
    for (const Measured& m : curves) {
        if (m.curve.closed()) continue;
        for (const Vec3& end : {m.curve.line.front(), m.curve.line.back()}) {
            if (!isAmong(end, corners)) corners.push_back(end);
        }
    }
    return corners;
}

Result<Extent> explore(Surface& surface, unsigned threads, const Progress& progress) {
    Extent extent;
    Result<std::vector<Crossing>> crossings =
        findCrossings(surface, threads, partOf(progress, 0.0, 0.7));
    if (!crossings) return crossings.error();
    extent.crossings = std::move(crossings.value());
    if (extent.crossings.empty()) {
        return Error{"there is no surface of the value " + sixDigits(surface.field().isovalue) +
                     " in the box; choose another isovalue or box"};
    }
    if (!followCurvature(surface, threads, partOf(progress, 0.7, 1.0), extent.crossings))
        return cancelled();
    for (WallCurve& curve : findWallCurves(surface))
        extent.curves.push_back(measure(surface, std::move(curve)));
    extent.corners = cornersOf(extent.curves);
    for (const Crossing& c : extent.crossings) extent.area += c.area;
    for (const Measured& m : extent.curves) extent.length += m.length();
    return extent;
}

// Among equilateral triangles a point on a wall covers half of what one inside covers, and one in a
// square corner a quarter. The L / h points on the walls, including corners, hence replace L / 2 h
// inside: count = A / (kHexagonal h^2) + L / 2 h + corners / 4.
double countFor(const Extent& extent, double spacing) {
    return extent.area / (kHexagonal * spacing * spacing) + 0.5 * extent.length / spacing +
           0.25 * static_cast<double>(extent.corners.size());
}
/// The spacing that gives `count`; zero if there is none.
double spacingFor(const Extent& extent, std::size_t count) {
    const double a = extent.area / kHexagonal;
    const double b = 0.5 * extent.length;
    const double c = 0.25 * static_cast<double>(extent.corners.size()) - static_cast<double>(count);
    if (c >= 0.0) return 0.0;
    return 2.0 * a / (std::sqrt(b * b - 4.0 * a * c) - b);
}

/// `owed` is the rounding error of the curves before, so that the total number is right.
void addAlong(const Surface& surface, const Measured& m, double spacing, double& owed,
              Particles& particles) {
    const std::vector<Vec3>& line = m.curve.line;
    const bool closed = m.curve.closed();
    // Loops shorter than half a spacing are specks that no triangle fits into.
    if (closed && m.length() < 0.5 * spacing) return;
    const double wanted = m.length() / spacing + owed;
    const int count = static_cast<int>(std::max(std::round(wanted), closed ? 3.0 : 1.0));
    owed = wanted - count;
    const HeldAxes held = heldBy(m.curve.face);
    std::size_t i = 1;
    for (int piece = closed ? 0 : 1; piece < count; ++piece) {
        const double at = m.length() * piece / count;
        while (m.reached[i] < at && i + 1 < line.size()) ++i;
        const double length = m.reached[i] - m.reached[i - 1];
        const double share = length > 0.0 ? (at - m.reached[i - 1]) / length : 0.0;
        const Vec3 x = line[i - 1] + share * (line[i] - line[i - 1]);
        const auto settled = surface.settle(x, held, spacing);
        if (settled) particles.add(surface, *settled, facesAt(surface.field(), *settled), spacing);
    }
}

/// Distance queries to the curves on the walls.
class NearWalls {
  public:
    NearWalls(const Extent& extent, const Field& field, double spacing)
        : step_(0.25 * spacing), grid_(field.low, field.high, 2.0 * step_) {
        for (const Measured& m : extent.curves) {
            for (std::size_t i = 1; i < m.curve.line.size(); ++i)
                addBetween(m.curve.line[i - 1], m.curve.line[i]);
        }
    }
    bool within(const Vec3& x, double distance) const {
        bool found = false;
        grid_.near(x, [&](Index p) { found = found || lengthOf(place_[p] - x) < distance; });
        return found;
    }

  private:
    void addBetween(const Vec3& from, const Vec3& to) {
        const int pieces = static_cast<int>(lengthOf(to - from) / step_) + 1;
        for (int i = 1; i <= pieces; ++i) {
            place_.push_back(from + static_cast<double>(i) / pieces * (to - from));
            grid_.add(place_.back());
        }
    }

    double step_;
    CellGrid grid_;
    std::vector<Vec3> place_;
};

/// A random place around a crossing, in the patch that it represents.
Vec3 around(const Surface& surface, const Vec3& x, SplitMix& random) {
    const Vec3 cell = surface.cell();
    const double reach = 0.5 * std::max({cell.x, cell.y, cell.z});
    const Vec3 jump = reach * random.inBox(Vec3(-1.0), Vec3(1.0));
    const Vec3 n = surface.field().normal(x);
    const Vec3 aside =
        glm::clamp(x + jump - glm::dot(jump, n) * n, surface.field().low, surface.field().high);
    const auto settled = surface.settle(aside, 0, reach);
    return settled ? *settled : x;
}

/// Adds one particle per share of the area along a Z-curve: roughly even, and exactly so over large
/// distances. False if cancelled.
bool addInside(const Surface& surface, const Extent& extent, double spacing, std::size_t count,
               std::uint64_t seed, const Progress& progress, Particles& particles) {
    const NearWalls walls(extent, surface.field(), spacing);
    std::vector<Vec3> place;
    std::vector<double> area;
    double total = 0.0;
    for (const Crossing& c : extent.crossings) {
        const double own = spacing * surface.relativeSpacing(c.position);
        if (walls.within(c.position, 0.5 * own)) continue;
        place.push_back(c.position);
        area.push_back(c.area);
        total += c.area;
    }
    SplitMix random(seed);
    const double each = total / static_cast<double>(count);
    double next = random.unit() * each;
    double passed = 0.0;
    std::size_t made = 0;
    constexpr std::size_t kBetween = 4096;
    for (const Index i : zCurveOrder(place)) {
        passed += area[i];
        for (; next < passed && made < count; ++made, next += each) {
            const double share = static_cast<double>(made) / static_cast<double>(count);
            if (made % kBetween == 0 && progress && !progress(share)) return false;
            particles.add(surface, around(surface, place[i], random), kInterior, spacing);
        }
    }
    return true;
}

Status check(const Field& field, const SamplerOptions& options) {
    const Vec3 sides = field.high - field.low;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(sides[axis] > 0.0 && std::isfinite(sides[axis])))
            return Error{"the box must have a length above 0 along every axis"};
    }
    if (options.count == 0 && !(options.spacing > 0.0 && std::isfinite(options.spacing)))
        return Error{"the spacing must be a number above 0"};
    if (options.count > kMaxParticles)
        return Error{"more than " + std::to_string(kMaxParticles) + " particles cannot be made"};
    if (!(options.curvature >= 0.0 && options.curvature <= 100.0))
        return Error{"the influence of the curvature must lie in 0 .. 100"};
    return success();
}

}  // namespace

void Particles::add(const Surface& surface, const Vec3& x, std::uint8_t faces, double flatSpacing) {
    position.push_back(x);
    normal.push_back(surface.field().normal(x));
    type.push_back(faces);
    spacing.push_back(flatSpacing * surface.relativeSpacing(x));
    drift.emplace_back(0.0);
}

Result<Start> scatter(Surface& surface, const SamplerOptions& options, const Progress& progress) {
    if (const Status checked = check(surface.field(), options); !checked) return checked.error();
    const Result<Extent> explored = explore(surface, options.threads, partOf(progress, 0.0, 0.5));
    if (!explored) return explored.error();
    const Extent& extent = explored.value();
    Start start;
    if (options.count > 0) {
        start.count = options.count;
        start.spacing = spacingFor(extent, options.count);
    } else {
        start.spacing = options.spacing;
        const double count = countFor(extent, options.spacing);
        if (!(count <= static_cast<double>(kMaxParticles)))
            return Error{"the spacing is too small: it would take more than " +
                         std::to_string(kMaxParticles) + " particles"};
        start.count = static_cast<std::size_t>(std::max(std::round(count), 1.0));
    }
    Particles& particles = start.particles;
    if (start.spacing > 0.0) {
        for (const Vec3& x : extent.corners)
            particles.add(surface, x, facesAt(surface.field(), x), start.spacing);
        double owed = 0.0;
        for (const Measured& m : extent.curves)
            addAlong(surface, m, start.spacing, owed, particles);
    }
    particles.onWalls = particles.size();
    if (start.spacing == 0.0 || particles.onWalls >= start.count) {
        return Error{std::to_string(start.count) + " particles are too few: the walls alone need " +
                     std::to_string(std::max(particles.onWalls, extent.corners.size()))};
    }
    if (!addInside(surface, extent, start.spacing, start.count - particles.onWalls, options.seed,
                   partOf(progress, 0.5, 1.0), particles))
        return cancelled();
    return start;
}

}  // namespace se::sampling
