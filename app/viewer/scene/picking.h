/// The thing under the pointer, and the points inside a line drawn around them. Plain mathematics:
/// examines every point once, and only those triangles that a line of sight may meet.
#pragma once

#include <span>
#include <vector>

#include "camera.h"
#include "mesh_index.h"
#include "run/selection.h"
#include "spiraling_edge/run/pivot_replay.h"

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

}  // namespace se::view
