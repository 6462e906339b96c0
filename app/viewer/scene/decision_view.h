/// The view that shows a decision best: along the normal where angles in the tangent plane decide,
/// along the surface where heights above it do.
#pragma once

#include <optional>
#include <span>

#include "camera.h"
#include "run/model.h"
#include "spiraling_edge/run/pivot_replay.h"

namespace se::view {

enum class ViewWay : std::uint8_t { AlongNormal, AlongSurface };

/// The decision that the camera follows: it moves where one of these changes.
struct FollowedDecision {
    std::uint32_t generation = 0;  ///< Of the input.
    Index pivot = kNone;
    ViewWay way = ViewWay::AlongNormal;
    friend bool operator==(const FollowedDecision&, const FollowedDecision&) = default;
};

/// Whether another sheet of the surface lies above or below the pivot, among its listed neighbors.
bool hasCloseSheets(const Model& model, Index pivot);
/// The way to look at the decision of the picture: along the surface at the stages `hole` and
/// `convex`, and where sheets are close.
ViewWay viewWayOf(const Model& model, const DecisionState& picture);

/// Looks at the decision of the picture and frames its points, and the sphere under test: from that
/// direction, if there is one; else along the normal of the pivot, or along the surface from the
/// side where no triangle of `finished` hides them, or from the nearer one. No effect without a
/// pivot and a point under test.
void lookAtDecision(const Model& model, const DecisionState& picture,
                    std::span<const Triangle> finished, const ViewPart& part, Camera& camera,
                    const std::optional<glm::vec3>& from = {});

}  // namespace se::view
