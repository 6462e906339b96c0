/// The built-in scalar fields: formulas with their gradients, one row each in the table at the end.
/// A new shape is a value, a gradient and a row.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/geometry/implicit_surfaces.h"
#include "spiraling_edge/sampling/field.h"

namespace se {
namespace {

// ---- planes and quadrics ----

double planeValue(const Vec3& x) { return x.z; }
Vec3 planeGradient(const Vec3& /*x*/) { return {0.0, 0.0, 1.0}; }

double monkeySaddleValue(const Vec3& x) { return x.z - x.x * (x.x * x.x - 3.0 * x.y * x.y); }
Vec3 monkeySaddleGradient(const Vec3& x) {
    return {3.0 * (x.y * x.y - x.x * x.x), 6.0 * x.x * x.y, 1.0};
}

constexpr double kWaist = 0.25;
double oneSheetValue(const Vec3& x) { return x.x * x.x + x.y * x.y - x.z * x.z - kWaist; }
double twoSheetsValue(const Vec3& x) { return x.x * x.x + x.y * x.y - x.z * x.z + kWaist; }
Vec3 coneGradient(const Vec3& x) { return {2.0 * x.x, 2.0 * x.y, -2.0 * x.z}; }

/// The hyperboloid of Table 1: minus 4 (y - 1)^2 + 2 (x - z)^2 - 2 (x + z - 3)^2 + 1, the function
/// on the authors' page on their particles, after Wilhelms and Van Gelder.
double hyperboloidValue(const Vec3& x) {
    const double across = x.x - x.z;
    const double along = x.x + x.z - 3.0;
    const double up = x.y - 1.0;
    return 2.0 * along * along - 2.0 * across * across - 4.0 * up * up - 1.0;
}
Vec3 hyperboloidGradient(const Vec3& x) {
    const double across = 4.0 * (x.x - x.z);
    const double along = 4.0 * (x.x + x.z - 3.0);
    return {along - across, -8.0 * (x.y - 1.0), along + across};
}

// ---- densities ----

/// Samples along a side of the authors' grid; the orbital is in its center.
constexpr double kHydrogenGrid = 64.0;
constexpr double kHydrogenMiddle = 0.5 * (kHydrogenGrid - 1.0);
constexpr double kBohrRadius = 1.5;  ///< In grid steps.
/// Scales values to those of volumes clamped to 1, such as the one distributed with VTK.
constexpr double kHydrogenScale = 0.00231;

/// Probability density of the 3d orbital with m = 0: (3 z^2 - r^2)^2 exp(-2 r / 3 a).
double hydrogenValue(const Vec3& x) {
    const Vec3 v = x - kHydrogenMiddle;
    const double lobes = 2.0 * v.z * v.z - v.x * v.x - v.y * v.y;
    const double r = std::sqrt(glm::dot(v, v));
    return kHydrogenScale * lobes * lobes * std::exp(-2.0 * r / (3.0 * kBohrRadius));
}
Vec3 hydrogenGradient(const Vec3& x) {
    const Vec3 v = x - kHydrogenMiddle;
    const double lobes = 2.0 * v.z * v.z - v.x * v.x - v.y * v.y;
    const double r = std::max(std::sqrt(glm::dot(v, v)), 1e-9);
    const double decay = 2.0 / (3.0 * kBohrRadius);
    const double scale = kHydrogenScale * lobes * std::exp(-decay * r);
    const Vec3 ofLobes = Vec3(-4.0, -4.0, 8.0) * v;
    return scale * (ofLobes - lobes * decay / r * v);
}

/// A burst on the ground: pressure rises outward to a steep front and falls to zero there. Inside
/// the front it never drops to the isovalue, so that the surface is the front alone; lower
/// isovalues are later, larger shells.
constexpr double kFront = 31.36;
constexpr double kFrontWidth = 1.2;
constexpr double kRestPressure = 0.2;
const Vec3 kFlattened(1.0, 1.0, 1.0 / 0.9);

struct Blast {
    double pressure, slope;  ///< Along the scaled radius.
};
Blast blastAt(double radius) {
    const double s = radius / kFront;
    const double inside = kRestPressure + (1.0 - kRestPressure) * s * s * s;
    const double front = 1.0 / (1.0 + std::exp((radius - kFront) / kFrontWidth));
    const double rise = 3.0 * (1.0 - kRestPressure) * s * s / kFront;
    return {inside * front, rise * front - inside * front * (1.0 - front) / kFrontWidth};
}
double blastValue(const Vec3& x) {
    const Vec3 v = kFlattened * x;
    return blastAt(std::sqrt(glm::dot(v, v))).pressure;
}
Vec3 blastGradient(const Vec3& x) {
    const Vec3 v = kFlattened * x;
    const double radius = std::max(std::sqrt(glm::dot(v, v)), 1e-9);
    return blastAt(radius).slope / radius * kFlattened * v;
}

/// Blobs after Blinn (1982): a sum of bell curves.
struct Ball {
    Vec3 center;
    double radius;
};
const std::array kBalls{Ball{{-0.55, 0.0, 0.0}, 0.6}, Ball{{0.45, 0.25, 0.1}, 0.55},
                        Ball{{0.1, -0.6, 0.35}, 0.4}, Ball{{0.2, 0.5, -0.65}, 0.4},
                        Ball{{1.0, -0.75, -0.4}, 0.3}};
double bell(const Vec3& d, double radius) {
    return std::exp(-2.0 * glm::dot(d, d) / (radius * radius));
}
double metaballsValue(const Vec3& x) {
    double sum = 0.0;
    for (const Ball& ball : kBalls) sum += bell(x - ball.center, ball.radius);
    return sum;
}
Vec3 metaballsGradient(const Vec3& x) {
    Vec3 sum(0.0);
    for (const Ball& ball : kBalls) {
        const Vec3 d = x - ball.center;
        sum -= 4.0 / (ball.radius * ball.radius) * bell(d, ball.radius) * d;
    }
    return sum;
}

// ---- the table ----

Shape distanceLike(std::string_view id, std::string_view title, const ImplicitSurface& s) {
    return {id, title, s.value, s.gradient, s.low, s.high, 0.0, Outside::HigherValues};
}

std::array<Shape, 13> makeShapes() {
    constexpr Outside kLower = Outside::LowerValues;
    constexpr Outside kHigher = Outside::HigherValues;
    return {
        distanceLike("sphere", "Sphere of radius 1", unitSphere()),
        distanceLike("torus", "Torus, tube 0.4 around a circle of radius 1", torus()),
        distanceLike("two-tori", "Two linked tori, their gap 0.2 wide", linkedTori()),
        distanceLike("genus-2", "Two tori melted into one surface of genus 2", doubleTorus()),
        distanceLike("gyroid", "Gyroid, cut by all six walls", gyroid()),
        {"plane", "Plane z = 0, cut by four walls", planeValue, planeGradient, Vec3(-1.0),
         Vec3(1.0), 0.0, kHigher},
        {"monkey-saddle", "Monkey saddle z = x^3 - 3 x y^2, cut by walls", monkeySaddleValue,
         monkeySaddleGradient, Vec3(-1.0), Vec3(1.0), 0.0, kHigher},
        {"hyperboloid-one-sheet", "Hyperboloid of one sheet, cut by walls", oneSheetValue,
         coneGradient, Vec3(-1.5, -1.5, -1.0), Vec3(1.5, 1.5, 1.0), 0.0, kHigher},
        {"hyperboloid-two-sheets", "Hyperboloid of two sheets, cut by walls", twoSheetsValue,
         coneGradient, Vec3(-1.5), Vec3(1.5), 0.0, kHigher},
        {"hyperboloid", "The hyperboloid of Table 1, two sheets in a flat box", hyperboloidValue,
         hyperboloidGradient, Vec3(0.0), Vec3(3.0, 2.0, 3.0), 0.0, kLower},
        {"hydrogen", "Hydrogen, 3d orbital: two lobes and a ring", hydrogenValue, hydrogenGradient,
         Vec3(0.0), Vec3(kHydrogenGrid - 1.0), 20.0 / 255.0, kLower},
        {"blast-wave", "Blast wave: a quarter dome cut by two walls", blastValue, blastGradient,
         Vec3(0.0, -40.0, 0.0), Vec3(40.0), 0.15, kLower},
        {"metaballs", "Five blobs that run into each other", metaballsValue, metaballsGradient,
         Vec3(-1.5), Vec3(1.7, 1.5, 1.5), 0.25, kLower},
    };
}

}  // namespace

std::span<const Shape> shapes() {
    static const auto table = makeShapes();
    return table;
}

const Shape* findShape(std::string_view id) {
    return rowWhere(shapes(), [id](const Shape& shape) { return shape.id == id; });
}

Field fieldOf(const Shape& shape) {
    constexpr double kCellsAlongLongestSide = 96.0;
    const Vec3 sides = shape.high - shape.low;
    const double cell = std::max({sides.x, sides.y, sides.z}) / kCellsAlongLongestSide;
    Field field{shape.value,    shape.gradient, shape.low, shape.high,
                shape.isovalue, shape.outside,  {}};
    field.cells = glm::ivec3(glm::ceil(sides / cell - 1e-9));
    return field;
}

Field inBox(Field field, const Vec3& low, const Vec3& high) {
    assert(low.x < high.x && low.y < high.y && low.z < high.z);
    constexpr double kMaxCells = 1024.0;
    const Vec3 cell = (field.high - field.low) / Vec3(field.cells);
    field.cells =
        glm::ivec3(glm::clamp(glm::ceil((high - low) / cell - 1e-9), Vec3(16.0), Vec3(kMaxCells)));
    field.low = low;
    field.high = high;
    return field;
}

Vec3 Field::normal(const Vec3& x) const {
    const Vec3 g = gradient(x);
    const double length = std::sqrt(glm::dot(g, g));
    if (!(length > 0.0)) return Vec3(0.0);
    return (outside == Outside::LowerValues ? -1.0 : 1.0) / length * g;
}

}  // namespace se
