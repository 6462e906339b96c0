/// The rule of the camera: how much of the view its subject fills, and the side from which a model
/// is seen. The subject is in the middle of the part of the view that nothing covers.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "camera.h"
#include "run/model.h"
#include "spiraling_edge/run/pivot_replay.h"

namespace se::view {

/// Shares of the height of the view, or of its width where that limits, that subjects fill.
inline constexpr float kDecisionShare = 2.0F / 3.0F;
inline constexpr float kModelShare = 0.8F;
inline constexpr float kFaultShare = 0.5F;

/// Positions without those far outside of the rest along an axis: at most one in a hundred at each
/// end, farther out than half the extent of the others.
std::vector<glm::vec3> withoutFar(std::span<const glm::vec3> places);

/// Fills a share of the view with positions, or with a ball of radius `least` around them where
/// they need less room. The direction stays.
void framePlaces(std::vector<glm::vec3> places, float least, const ViewPart& part, float share,
                 Camera& camera);
/// All of a model. The direction stays.
void frameModel(const Model& model, const ViewPart& part, Camera& camera);
/// All of a model, broadside and upright: the eye looks along its least extent, from above but not
/// too steeply. Of the two sides it shows the one that more points face. A model as thick as wide
/// is seen from the front, right and above.
void showBroadside(const Model& model, const ViewPart& part, Camera& camera);
/// A fault, finding or difference: its points, straight from the side to which most of them face;
/// no farther away than the model. No effect without points that can be drawn.
void frameFault(const Model& model, std::span<const Index> points, const ViewPart& part,
                Camera& camera);
/// Points chosen by the user, with their neighbors, not from within. Requires at least one.
void frameSelected(const Model& model, std::span<const Index> points, const ViewPart& part,
                   Camera& camera);

/// True if a position is seen in that part of the view.
bool isInView(const glm::vec3& place, const ViewPart& part, const Camera& camera);
/// Brings a position to the middle of that part, and turns to the outer side of the surface there.
void centerPlace(const glm::vec3& place, const glm::vec3& normal, const ViewPart& part,
                 Camera& camera);

// The view that shows a decision best: along the normal where angles in the tangent plane decide,
// along the surface where heights above it do.

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
