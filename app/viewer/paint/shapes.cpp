#include "shapes.h"

namespace se::view {

namespace {

void drawSquare(Painter& painter, glm::vec2 c, float half, const Ink& ink) {
    painter.polygon({c + glm::vec2(-half, -half), c + glm::vec2(half, -half),
                     c + glm::vec2(half, half), c + glm::vec2(-half, half)},
                    ink);
}

void drawDiamond(Painter& painter, glm::vec2 c, float reach, const Ink& ink) {
    painter.polygon({c - glm::vec2(reach, 0.0F), c - glm::vec2(0.0F, reach),
                     c + glm::vec2(reach, 0.0F), c + glm::vec2(0.0F, reach)},
                    ink);
}

/// A triangle that points right, or left if `r` is below 0.
void drawPointer(Painter& painter, glm::vec2 c, float r, const Ink& ink) {
    painter.polygon({c + glm::vec2(r, 0.0F), c + glm::vec2(-0.5F, 0.866F) * r,
                     c + glm::vec2(-0.5F, -0.866F) * r},
                    ink);
}

void drawCross(Painter& painter, glm::vec2 c, glm::vec2 way, const Ink& ink) {
    const glm::vec2 across(-way.y, way.x);
    painter.line(c - way, c + way, ink);
    painter.line(c - across, c + across, ink);
}

}  // namespace

void drawShape(Painter& painter, glm::vec2 center, float size, Shape shape, const Ink& ink,
               float halo) {
    const float r = 0.5F * size;
    const float stroke = std::max(1.0F, 0.3F * r);
    const Ink area = ink.line(2.0F * halo);
    const auto line = [&](float width) { return ink.line(width + 2.0F * halo); };
    switch (shape) {
        case Shape::Hidden:
            return;
        case Shape::Dot:
        case Shape::Disc:
            return painter.circle(center, r, area);
        case Shape::Circle:
            return painter.circle(center, r - 0.5F * stroke, line(stroke));
        case Shape::Square:
            return drawSquare(painter, center, 0.82F * r, area);
        case Shape::OpenSquare:
            return drawSquare(painter, center, 0.82F * r - 0.5F * stroke, line(stroke));
        case Shape::Diamond:
            return drawDiamond(painter, center, r, area);
        case Shape::OpenDiamond:
            return drawDiamond(painter, center, r - 0.7F * stroke, line(stroke));
        case Shape::RingedDisc:
            painter.circle(center, 0.9F * r, line(0.2F * r));
            return painter.circle(center, 0.55F * r, area);
        case Shape::Forward:
            return drawPointer(painter, center, r, area);
        case Shape::Back:
            return drawPointer(painter, center, -r, area);
        case Shape::Cross:
            return drawCross(painter, center, glm::vec2(0.62F * r),
                             line(2.0F * std::max(0.8F, 0.2F * r)));
        case Shape::Plus:
            return drawCross(painter, center, {r, 0.0F}, line(2.0F * std::max(0.7F, 0.16F * r)));
    }
}

void drawActiveRing(Painter& painter, glm::vec2 left, float em, const Ink& ink) {
    painter.line(left + glm::vec2(0.1F, 0.0F) * em, left + glm::vec2(1.5F, 0.0F) * em,
                 ink.line(0.2F * em));
}

void drawWaitingRing(Painter& painter, glm::vec2 left, float em, const Ink& ink) {
    for (const float x : {0.06F, 0.66F, 1.26F})
        painter.line(left + glm::vec2(x, 0.0F) * em, left + glm::vec2(x + 0.28F, 0.0F) * em,
                     ink.line(0.12F * em));
}

}  // namespace se::view
