#include "rail_icons.h"

#include <algorithm>
#include <array>
#include <span>

namespace se::view {

namespace {

/// Draws in a square of -1 to 1.
class Pen {
  public:
    Pen(ImDrawList* list, ImVec2 center, float size, ImU32 color)
        : list_(list), center_(center), half_(0.5F * size), color_(color) {}

    ImVec2 at(float x, float y) const { return {center_.x + half_ * x, center_.y + half_ * y}; }
    void line(std::initializer_list<ImVec2> corners, bool closed = false) const {
        for (const ImVec2& each : corners) list_->PathLineTo(at(each.x, each.y));
        list_->PathStroke(color_, closed ? ImDrawFlags_Closed : 0, width());
    }
    void circle(float x, float y, float r) const {
        list_->AddCircle(at(x, y), half_ * r, color_, 0, width());
    }
    void dot(float x, float y, float r) const {
        list_->AddCircleFilled(at(x, y), half_ * r, color_);
    }
    void arc(float x, float y, float r, float from, float to) const {
        list_->PathArcTo(at(x, y), half_ * r, from, to);
        list_->PathStroke(color_, 0, width());
    }

  private:
    float width() const { return std::max(1.25F, 0.18F * half_); }

    ImDrawList* list_;
    ImVec2 center_;
    float half_;
    ImU32 color_;
};

/// A pivot with the ends of its sector.
void drawStep(const Pen& pen) {
    pen.circle(0.0F, 0.0F, 1.0F);
    pen.line({{-0.5F, 0.87F}, {0.0F, 0.0F}, {1.0F, 0.0F}});
    pen.dot(0.0F, 0.0F, 0.25F);
}

void drawWhy(const Pen& pen) {
    pen.arc(0.0F, -0.45F, 0.5F, -3.14F, 1.2F);
    pen.line({{0.18F, 0.02F}, {0.0F, 0.2F}, {0.0F, 0.4F}});
    pen.dot(0.0F, 0.85F, 0.16F);
}

void drawFaults(const Pen& pen) {
    pen.line({{0.0F, -0.9F}, {1.0F, 0.85F}, {-1.0F, 0.85F}}, true);
    pen.line({{0.0F, -0.25F}, {0.0F, 0.3F}});
    pen.dot(0.0F, 0.57F, 0.13F);
}

void drawFind(const Pen& pen) {
    pen.circle(-0.2F, -0.2F, 0.65F);
    pen.line({{0.3F, 0.3F}, {0.95F, 0.95F}});
}

/// Sliders.
void drawChange(const Pen& pen) {
    constexpr std::array kKnobs = {-0.4F, 0.45F, -0.05F};
    for (std::size_t i = 0; i < kKnobs.size(); ++i) {
        const float y = -0.7F + 0.7F * static_cast<float>(i);
        pen.line({{-1.0F, y}, {1.0F, y}});
        pen.dot(kKnobs[i], y, 0.28F);
    }
}

/// Points, as a scan has them.
void drawInput(const Pen& pen) {
    for (const auto& [x, y] : std::to_array<std::pair<float, float>>({{-0.8F, 0.3F},
                                                                      {-0.5F, -0.4F},
                                                                      {0.05F, -0.8F},
                                                                      {0.0F, 0.05F},
                                                                      {-0.2F, 0.8F},
                                                                      {0.5F, 0.55F},
                                                                      {0.7F, -0.3F}}))
        pen.dot(x, y, 0.19F);
}

/// An open book.
void drawLesson(const Pen& pen) {
    pen.line({{0.0F, -0.6F}, {-1.0F, -0.8F}, {-1.0F, 0.6F}, {0.0F, 0.8F}}, true);
    pen.line({{0.0F, -0.6F}, {1.0F, -0.8F}, {1.0F, 0.6F}, {0.0F, 0.8F}}, true);
}

/// By Task.
constexpr std::array<void (*)(const Pen&), kTaskCount> kDraw = {
    drawStep, drawWhy, drawFaults, drawFind, drawChange, drawInput, drawLesson};

}  // namespace

void drawRailIcon(ImDrawList* list, Task task, ImVec2 center, float size, ImU32 color) {
    kDraw[static_cast<std::size_t>(task)](Pen(list, center, size, color));
}

}  // namespace se::view
