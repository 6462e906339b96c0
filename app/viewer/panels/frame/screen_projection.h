/// Projection of the scene to the screen, in pixels of the window: for overlays.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "layout/labels.h"
#include "panels/panel.h"
#include "scene/camera.h"

namespace se::view {

class ScreenProjection {
  public:
    explicit ScreenProjection(const PanelContext& context);

    /// Empty if the point is behind the eye.
    std::optional<glm::vec2> at(const glm::vec3& place) const;
    /// The marks of the pivot, its ends, the point under test and the selection.
    std::vector<LabelMark> marks() const;
    /// The points that the decisions of the pivot involve, also those without a mark.
    std::vector<LabelMark> neighborhood() const;
    /// Everything that is drawn, apart from the finished mesh and the cloud.
    OccupancyGrid occupancy() const;

  private:
    const PanelContext& context_;
    const Rect& view_;
    CameraMatrices camera_;
};

}  // namespace se::view
