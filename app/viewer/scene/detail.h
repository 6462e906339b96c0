/// Detail that has room on the screen, from the distance of the points there.
#pragma once

#include <algorithm>
#include <cmath>

#include "camera.h"

namespace se::view {

/// Pixels from which marks of single points are shown, and from which they have full strength.
inline constexpr float kMarksFrom = 10.0F;
inline constexpr float kMarksFull = 20.0F;
/// Pixels below which shapes of points cannot be told apart.
inline constexpr float kShapesFrom = 10.0F;

/// Distance of the points in pixels of a view of `height`, at the near side of the middle of the
/// scene. `spacing`: their distance in view units.
inline float spacingInPixels(const CameraMatrices& camera, float height, float spacing) {
    const float depth =
        camera.orthographic ? 1.0F : std::max(0.01F, glm::length(camera.eye) - 0.7F);
    return 0.5F * height * camera.projection[1][1] * spacing / depth;
}

/// Strength, from 0 to 1, of marks on the mesh where points are that many pixels apart: closer
/// together they would cover it, and make patterns.
inline float markStrength(float pixels) {
    const float share = std::clamp((pixels - kMarksFrom) / (kMarksFull - kMarksFrom), 0.0F, 1.0F);
    return share * share * (3.0F - 2.0F * share);
}

/// Whether points that many pixels apart are drawn as solid dots with depth, instead of shapes.
inline bool drawnSolid(float pixels) { return pixels < kShapesFrom; }

}  // namespace se::view
