/// What is under the pointer. Plain mathematics: looks once at every point, and only at those
/// triangles that a line of sight may meet.
#pragma once

#include <optional>
#include <span>

#include "camera.h"
#include "mesh_index.h"
#include "run/picture.h"
#include "run/selection.h"

namespace se::view {

/// The point nearest to the eye among those drawn within `radius` pixels of `pixel`; kNone if there
/// is none. Points that face the eye win over those that do not.
Index pickPoint(const Model& model, const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                float radius);

/// The same among some points.
Index pickAmong(const Model& model, std::span<const Index> points, const CameraMatrices& camera,
                glm::vec2 size, glm::vec2 pixel, float radius);

/// What can be picked: what is drawn.
struct PickScene {
    const Model& model;
    bool points = true;
    std::span<const Triangle> triangles{};
    /// Of a list that begins with `triangles`; null: all triangles are looked at.
    const MeshIndex* index = nullptr;
    std::span<const RingPath> rings{};
};

/// Where the pointer is. `radius`: how many pixels one may miss by.
struct PickPlace {
    CameraMatrices camera;
    glm::vec2 size{1.0F};
    glm::vec2 pixel{0.0F};
    float radius = 8.0F;
};

struct Pick {
    Selection what;
    glm::vec3 place{0.0F};  ///< View space.
};

/// The foremost thing under the pointer: a point if one is near, else an edge of the mesh or a
/// ring, else a triangle. Nothing that is behind the front surface is found.
Pick pick(const PickScene& scene, const PickPlace& at);

}  // namespace se::view
