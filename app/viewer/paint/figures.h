/// Whole pictures of a decision and of a mesh, for programs without a window.
#pragma once

#include <span>
#include <string>

#include "scene/picture.h"
#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/stepper/params.h"

namespace se::view {

/// A decision as a file of SVG: the dial of its pivot, if it has one, its address and its sentence.
/// `width`: pixels. Its style holds for this picture alone, also in a page with others.
std::string decisionSvg(const PointSet& points, const Params& params, const DecisionState& state,
                        float width);

/// A mesh in the light theme, `size` pixels wide and high, without perspective, seen from the
/// direction `toEye` with z up; inner sides have the color of what is rejected. Requires size > 0,
/// a direction that is not 0, and finite corners.
Picture meshPicture(std::span<const Vec3> positions, std::span<const Triangle> triangles, int size,
                    const Vec3& toEye);

}  // namespace se::view
