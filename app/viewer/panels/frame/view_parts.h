/// Overlays of the scene. Each reports its rectangle, so that the next one avoids it.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "layout/overlays.h"
#include "panel_state/view_tools.h"
#include "panels/panel.h"
#include "scene/camera.h"

namespace se::view {

/// Legend of the marks, in a corner where it covers nothing of `taken` and leaves the pivot's
/// surroundings visible; nothing if there is none.
std::optional<Rect> drawLegend(const PanelContext& context, std::span<const Rect> taken);

/// Legend of the mesh colors, if they have a meaning.
std::optional<Rect> drawColorBar(const PanelContext& context, std::span<const Rect> taken);

/// The pointer, in pixels of the window.
inline glm::vec2 pointerInWindow() {
    const ImVec2 mouse = ImGui::GetMousePos();
    return {mouse.x, mouse.y};
}

/// Draws a box or a lasso with the left button while the tool for a piece is on. True while it
/// takes the mouse. To be called right after the scene's own item.
bool handlePieceTool(const PanelContext& context);
/// A box or a lasso follows the pointer. When the button is released: its corners, in pixels of the
/// view; none if it encloses nothing.
std::optional<std::vector<glm::vec2>> followLine(const PanelContext& context, EnclosingLine& line);
/// The box or the lasso, while it is drawn.
void drawEnclosingLine(const PanelContext& context, const EnclosingLine& line);

/// Drags a point while the panel What if is open. True while it takes the mouse. To be called right
/// after the scene's own item.
bool handleMoveTool(const PanelContext& context);
/// The way of the point that is being dragged, and where its verdict turns.
void drawMoveWay(const PanelContext& context);

/// A sentence that lies in a view.
struct PlateText {
    ImFont* font = nullptr;
    std::vector<std::string> lines;
    std::string place;  ///< A small line below the others; empty: none.
    Color bar;          ///< At the left side.
    Color ink;
};
/// The plate of a sentence, in the lower left corner of the view.
Rect drawPlate(const PanelContext& context, const PlateText& text);

/// Labels, where there is room for them beside `taken`.
void drawLabels(const PanelContext& context, std::span<const Rect> taken);

/// Projection of the scene to the screen, in pixels of the window: for overlays.
class ScreenProjection {
  public:
    explicit ScreenProjection(const PanelContext& context);

    /// Empty if the point is behind the eye.
    std::optional<glm::vec2> at(const glm::vec3& place) const;
    /// Length on the screen of a short line of that length, in view units, at `place`; 0 behind the
    /// eye.
    float pixels(const glm::vec3& place, float length) const;
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

/// The camera of the view.
inline CameraMatrices cameraOf(const PanelContext& context) {
    const glm::vec2& size = context.rects.view.size;
    return context.camera().matrices(size.x / size.y);
}

// The parts of the strip below the view.

/// The area of the bars of a strip: `top` below its upper edge, with a margin on both sides. Test
/// scripts find it as "strip run".
Rect beginStrip(const PanelContext& context, const char* name, const Rect& strip, float height,
                float top);
void drawRunStrip(const PanelContext& context, const Rect& area);

}  // namespace se::view
