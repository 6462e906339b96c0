/// Boxes that several panels draw alike: dialogs, plates over the view, the view itself.
#pragma once

#include <optional>

#include "widgets.h"

namespace se::view {

inline void fill(ImDrawList* list, const Rect& rect, const Color& color, float rounding = 0.0F) {
    list->AddRectFilled(toVec2(rect.min), toVec2(rect.max()), toU32(color), rounding);
}

/// Places the next window in the middle of the screen: `ems` large, if it fits with a margin. Its
/// size in pixels.
glm::vec2 placeDialog(const PanelContext& context, glm::vec2 ems, glm::vec2 margin = {2.0F, 2.0F});
/// Begins a dialog placed by placeDialog(). ImGui::End() must follow in any case.
bool beginDialog(const char* title, bool* open, int extraFlags = 0);

/// Begins a window without frame over the view: `top` em below its upper edge, otherwise in the
/// middle; at most `width` em wide, otherwise as wide as its content. ImGui::End() must follow.
bool beginOverView(const PanelContext& context, const char* name, std::optional<float> top,
                   std::optional<float> width);

/// Begins the window of a view; false if nothing of it is visible. ImGui::End() must follow.
bool beginView(const PanelContext& context, const char* name);
/// The item that takes the mouse in all of the view, but not where an earlier item is.
void offerView(const PanelContext& context);
/// The rendered picture of the view.
void drawViewPicture(const PanelContext& context);

}  // namespace se::view
