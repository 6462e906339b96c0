#include "screen_painter.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace se::view {

void ScreenPainter::line(glm::vec2 from, glm::vec2 to, const Ink& ink) {
    const float length = glm::distance(from, to);
    const glm::vec2 end = length > 0.0F ? (0.5F * ink.width / length) * (to - from) : glm::vec2(0);
    list_.AddLine(toVec2(from - end), toVec2(to + end), toU32(ink.color), ink.width);
}

void ScreenPainter::polygon(std::initializer_list<glm::vec2> corners, const Ink& ink) {
    for (const glm::vec2& corner : corners) list_.PathLineTo(toVec2(corner));
    if (ink.width > 0.0F) return list_.PathStroke(toU32(ink.color), ImDrawFlags_Closed, ink.width);
    list_.PathFillConvex(toU32(ink.color));
}

void ScreenPainter::box(glm::vec2 low, glm::vec2 high, const Ink& ink, float round) {
    if (ink.width > 0.0F)
        return list_.AddRect(toVec2(low), toVec2(high), toU32(ink.color), round, 0, ink.width);
    list_.AddRectFilled(toVec2(low), toVec2(high), toU32(ink.color), round);
}

void ScreenPainter::circle(glm::vec2 center, float radius, const Ink& ink) {
    if (ink.width > 0.0F)
        return list_.AddCircle(toVec2(center), radius, toU32(ink.color), 0, ink.width);
    list_.AddCircleFilled(toVec2(center), radius, toU32(ink.color));
}

void ScreenPainter::arc(glm::vec2 center, float radius, double from, double to, const Ink& ink) {
    // In parts of at most half a turn: only those are convex.
    for (double a = from; a < to - 1e-6; a += 180.0) {
        const double b = std::min(a + 180.0, to);
        if (ink.width <= 0.0F) list_.PathLineTo(toVec2(center));
        list_.PathArcTo(toVec2(center), radius, static_cast<float>(-glm::radians(b)),
                        static_cast<float>(-glm::radians(a)));
        ink.width > 0.0F ? list_.PathStroke(toU32(ink.color), 0, ink.width)
                         : list_.PathFillConvex(toU32(ink.color));
    }
}

void ScreenPainter::text(glm::vec2 at, const std::string& words, const Ink& ink, const Type& type) {
    if (type.align != Align::Left) {
        const float width = textSize(words, type).x;
        at.x -= type.align == Align::Right ? width : 0.5F * width;
    }
    list_.AddText(fontOf(type.face), type.size, toVec2(at), toU32(ink.color), words.c_str());
}

glm::vec2 ScreenPainter::textSize(const std::string& words, const Type& type) const {
    const ImVec2 size = fontOf(type.face)->CalcTextSizeA(type.size, 1e9F, 0.0F, words.c_str());
    return {size.x, size.y};
}

ImFont* ScreenPainter::fontOf(Typeface face) const {
    switch (face) {
        case Typeface::Text:
            return fonts_.text;
        case Typeface::Strong:
            return fonts_.strong;
        case Typeface::Small:
            return fonts_.small;
        case Typeface::Caption:
            return fonts_.caption;
    }
    return fonts_.text;
}

}  // namespace se::view
