#include "layout.h"

#include <algorithm>
#include <cmath>

namespace se::view {

namespace {

constexpr float kMenu = 1.56F;
constexpr float kTransport = 2.7F;
constexpr float kStatus = 1.7F;
constexpr float kNarration = 3.6F;
constexpr float kRunStrip = 4.2F;
constexpr float kStageStrip = 3.3F;
/// Below these the window is narrow, or low.
constexpr float kNarrowBelow = 58.0F;
constexpr float kLowBelow = 36.0F;
/// From these on the dial stands by itself: below, the panels under it would be too short.
constexpr float kDialFrom = 75.0F;
constexpr float kDialRoom = 30.0F;

}  // namespace

Layout computeLayout(glm::vec2 size, float em) {
    const glm::vec2 ems = size / em;
    Layout l;
    l.narrow = ems.x < kNarrowBelow;
    l.stageStrip = ems.y >= kLowBelow;
    const auto px = [em](float length) { return std::round(length * em); };
    const float left = l.narrow ? 0.0F : px(std::clamp(0.225F * ems.x, 15.0F, 22.0F));
    const float right = px(l.narrow ? std::clamp(0.42F * ems.x, 12.0F, 20.0F)
                                    : std::clamp(0.24F * ems.x, 17.0F, 26.0F));
    const float drawer = px(kRunStrip + (l.stageStrip ? kStageStrip : 0.0F));
    const float narration = px(l.stageStrip ? kNarration : 0.9F * kNarration);
    float y = 0.0F;
    const auto row = [&](float height) {
        const Rect r{{0.0F, y}, {size.x, height}};
        y += height;
        return r;
    };
    l.menu = row(px(kMenu));
    l.transport = row(px(kTransport));
    const float bottom = size.y - px(kStatus) - drawer;
    const float middle = std::max(0.0F, bottom - y);
    l.left = {{0.0F, y}, {left, middle}};
    l.dialApart = !l.narrow && ems.x >= kDialFrom && middle >= px(kDialRoom);
    const float dial = l.dialApart ? std::min(right + px(1.0F), 0.45F * middle) : 0.0F;
    l.dial = {{size.x - right, y}, {right, dial}};
    l.right = {{size.x - right, y + dial}, {right, middle - dial}};
    const float viewWidth = std::max(0.0F, size.x - left - right);
    l.view = {{left, y}, {viewWidth, std::max(0.0F, middle - narration)}};
    l.narration = {{left, y + l.view.size.y}, {viewWidth, std::min(narration, middle)}};
    y = bottom;
    l.drawer = row(drawer);
    l.status = row(px(kStatus));
    return l;
}

}  // namespace se::view
