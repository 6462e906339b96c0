/// The thing under the pointer, and the points inside a line drawn around them. Plain mathematics:
/// examines every point once, and only those triangles that a line of sight may meet.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "camera.h"
#include "draw_list.h"
#include "mesh_index.h"
#include "run/model.h"
#include "run/selection.h"

namespace se::view {

/// The point closest to the eye among those of `points` that are drawn within `radius` pixels of
/// `pixel`; kNone if there is none. Points that face the eye win over those that do not.
Index pickAmong(const Model& model, std::span<const Index> points, const CameraMatrices& camera,
                glm::vec2 size, glm::vec2 pixel, float radius);

/// The points whose positions in a view of `size` pixels are inside the closed line through `path`,
/// and that face the eye; ascending. Where the line crosses itself, what is enclosed twice is
/// outside. A line of fewer than three corners encloses nothing.
std::vector<Index> pointsWithin(const Model& model, const CameraMatrices& camera, glm::vec2 size,
                                std::span<const glm::vec2> path);

/// As pointsWithin(), with those that face away.
std::vector<Index> pointsInside(const Model& model, const CameraMatrices& camera, glm::vec2 size,
                                std::span<const glm::vec2> path);

/// Things that can be picked: those that are drawn.
struct PickScene {
    const Model& model;
    bool points = true;
    std::span<const Triangle> triangles{};
    /// Index of a list that begins with `triangles`; null: all triangles are examined.
    const MeshIndex* index = nullptr;
    std::span<const RingPath> rings{};
};

/// Position of the pointer. `radius`: tolerance in pixels.
struct PickPoint {
    CameraMatrices camera;
    glm::vec2 size{1.0F};
    glm::vec2 pixel{0.0F};
    float radius = 8.0F;
};

struct Pick {
    Selection what;
    glm::vec3 place{0.0F};  ///< View space.
};

/// The foremost thing under the pointer: a point if one is close, otherwise an edge of the mesh or
/// a ring, otherwise a triangle. Nothing behind the front surface is found.
Pick pick(const PickScene& scene, const PickPoint& at);

// Places for a point that is dragged on the screen. Plain mathematics.

/// The place under `pixel`, in a view of `size` pixels, in the plane through `origin` with that
/// unit normal. Empty if the line of sight meets it nowhere before the eye, or at less than 6
/// degrees, where a pixel is a long way.
std::optional<glm::vec3> placeInPlane(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                                      const glm::vec3& origin, const glm::vec3& normal);

/// The place nearest to the line of sight of `pixel` on the line through `origin` with that unit
/// direction. Empty if the two are closer to parallel than 6 degrees.
std::optional<glm::vec3> placeOnLine(const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                                     const glm::vec3& origin, const glm::vec3& direction);

/// `value` in steps of a power of ten of at most a ten-thousandth of `length`, so that a dragged
/// place is written with few digits. Requires length > 0.
double roundedTo(double value, double length);

// Triangles that hide a decision from the eye: in front of its points. They are drawn as ghosts.

/// The place of the points of a decision: a sphere about the pivot.
DecisionPlace decisionPlace(const Model& model, Index pivot, std::span<const Index> points);

/// Radius of the place in a view of `height` pixels.
float pixelRadius(const CameraMatrices& camera, const DecisionPlace& place, float height);

/// Whether a triangle outside of the place hides one of its points. O(triangles).
bool isHidden(const Model& model, std::span<const Triangle> triangles, const CameraMatrices& camera,
              const DecisionPlace& place);

}  // namespace se::view
