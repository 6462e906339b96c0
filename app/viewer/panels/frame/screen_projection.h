/// The scene as it stands on the screen, in pixels of the window: for what is drawn over it.
#pragma once

#include <optional>
#include <vector>

#include "layout/labels.h"
#include "panels/panel.h"

namespace se::view {

class Sight {
  public:
    explicit Sight(const PanelContext& context);

    /// Nothing if it is behind the eye.
    std::optional<glm::vec2> at(const glm::vec3& place) const;
    /// The marks of the pivot, its ends, what is under test and what is selected.
    std::vector<LabelMark> marks() const;
    /// The points that the decisions of the pivot are about, also where no mark is drawn.
    std::vector<LabelMark> surroundings() const;
    /// Everything that is drawn, apart from the finished mesh and the cloud.
    Clutter clutter() const;

  private:
    const PanelContext& context_;
    const Rect& view_;
    CameraMatrices camera_;
};

}  // namespace se::view
