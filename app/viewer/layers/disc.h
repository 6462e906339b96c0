/// The disc of a tangent plane, in view space, on which several layers draw angles.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "layer.h"
#include "run/strings.h"
#include "spiraling_edge/run/reading.h"

namespace se::view {

/// The frame of §6.1 at a point: angle 0 toward first, counterclockwise about the normal.
struct Disc {
    glm::vec3 origin{0.0F};
    glm::vec3 normal{0.0F};
    glm::vec3 zero{0.0F};
    glm::vec3 quarter{0.0F};

    glm::vec3 at(double degrees, float radius) const {
        const float angle = glm::radians(static_cast<float>(degrees));
        return origin + radius * (std::cos(angle) * zero + std::sin(angle) * quarter);
    }
    /// The foot of a position on the plane.
    glm::vec3 foot(const glm::vec3& place) const {
        return place - normal * glm::dot(place - origin, normal);
    }
};

/// The disc at `point` with angle 0 toward `first`; empty if `first` is directly above it.
std::optional<Disc> discAt(const LayerInput& in, Index point, Index first);
/// The disc of the pivot.
std::optional<Disc> pivotDisc(const LayerInput& in);
/// Radius of discs.
inline float discRadius(const LayerInput& in) { return 0.62F * in.model.spacing; }

/// The color of the result of a test: that of points that are kept, or that of refused ones.
const Color& verdictColor(Verdict verdict, const Palette& palette);
/// Labels a place with the words of a verdict.
void addVerdict(Verdict verdict, const glm::vec3& at, const Palette& palette, DrawList& out);

/// An arc on a disc, from one angle to another in degrees, at most a full turn.
struct Arc {
    double from = 0.0;
    double to = 0.0;
    float radius = 0.0F;
};
void addArc(const Disc& disc, const Arc& arc, const Color& color, float width, DrawList& out);
void addDashedArc(const Disc& disc, const Arc& arc, const Color& color, float width, DrawList& out);
void addSectorSheet(const Disc& disc, const Arc& arc, const Color& color, DrawList& out);

/// A corner of the edge ring: the free angle at `point`, from `before` counterclockwise to `after`.
struct RingCorner {
    Index before = kNone;
    Index point = kNone;
    Index after = kNone;
    bool concave = false;
};

/// Draws a corner: filled where the ring is concave, hollow where it is convex (§6.1, Figs. 4 and
/// 5).
void addCorner(const LayerInput& in, const RingCorner& corner, DrawList& out);

/// The parts of a triangle's surface that lie on a sphere, as short segments.
std::vector<std::pair<glm::vec3, glm::vec3>> sphereCut(const Sphere& sphere,
                                                       const std::array<glm::vec3, 3>& corners);

/// The angle of a position on a disc, in [0, 360).
double degreesOn(const Disc& disc, const glm::vec3& place);

/// A triangle that is not made, and its parts that lie on finished triangles.
struct Overlap {
    std::vector<std::vector<glm::vec3>> parts;  ///< Convex, in the plane of the triangle.
    std::vector<Triangle> covered;              ///< Those finished triangles.
    float share = 0.0F;                         ///< Of its area; slivers do not count.
    glm::vec3 middle{0.0F};                     ///< Of the parts.
};

Overlap overlapOf(const LayerInput& in, const Disc& disc, const Triangle& wouldBe);

/// Draws the parts, filled and hatched in the color of errors.
void addOverlap(const LayerInput& in, const Overlap& overlap, DrawList& out);

}  // namespace se::view
