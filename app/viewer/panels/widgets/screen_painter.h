/// Drawing on the screen, by Dear ImGui.
#pragma once

#include "paint/painter.h"
#include "widgets.h"

namespace se::view {

/// Draws into the current window, over what is there.
class ScreenPainter : public Painter {
  public:
    explicit ScreenPainter(const PanelContext& context)
        : Painter(context.palette, context.palette, context.em),
          fonts_(context.fonts),
          list_(*ImGui::GetWindowDrawList()) {}

    using Painter::box;
    void line(glm::vec2 from, glm::vec2 to, const Ink& ink) override;
    void polygon(std::initializer_list<glm::vec2> corners, const Ink& ink) override;
    void box(glm::vec2 low, glm::vec2 high, const Ink& ink, float round = 0.0F) override;
    void circle(glm::vec2 center, float radius, const Ink& ink) override;
    void arc(glm::vec2 center, float radius, double from, double to, const Ink& ink) override;
    void text(glm::vec2 at, const std::string& words, const Ink& ink, const Type& type) override;
    glm::vec2 textSize(const std::string& words, const Type& type) const override;

  private:
    ImFont* fontOf(Typeface face) const;

    const Fonts& fonts_;
    ImDrawList& list_;
};

}  // namespace se::view
