// Points and single marks.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "paint/shapes.h"
#include "scene/detail.h"
#include "svg_canvas.h"

namespace se::view {

namespace {

// Those of render/surface.cpp.
constexpr float kMarkBias = 0.12F;
constexpr float kSolidDots = 0.8F;
constexpr float kLeastAlpha = 0.02F;
/// Ring around a mark in the color of the background: pixels beyond the mark, and opacity.
constexpr float kRing = 1.1F;
constexpr float kRingAlpha = 0.75F;

/// The color of a dot too small for a shape: opaque, lit as the mesh is (shaders/cloud.vert).
Color solidColor(const SvgCanvas& canvas, const Color& color, const Color& background,
                 std::size_t p, float alpha) {
    const Model& model = canvas.in().model;
    const ScreenSpace& screen = canvas.screen();
    const glm::vec3 toEye = screen.toEye(model.place[p]);
    const glm::vec3 normal = model.normal[p];
    const glm::vec3 key =
        glm::normalize(0.75F * toEye + 0.75F * screen.up() - 0.65F * screen.right());
    const float light = glm::dot(glm::dot(toEye, normal) < 0.0F ? -normal : normal, key);
    const float shade = 0.62F + 0.38F * std::max(light, 0.0F);
    const Color lit{color.r * shade, color.g * shade, color.b * shade, 1.0F};
    return mix(background, lit, 0.7F * alpha).withAlpha(1.0F);
}

float fadeOf(const SvgCanvas& canvas, std::size_t p) {
    const Model& model = canvas.in().model;
    const float facing = glm::dot(canvas.screen().toEye(model.place[p]), model.normal[p]);
    const float share = std::clamp((facing + 0.25F) / 0.4F, 0.0F, 1.0F);
    return 0.3F + 0.7F * share * share * (3.0F - 2.0F * share);
}

void drawPoint(SvgCanvas& canvas, std::size_t p, float marks) {
    const FrameShapes& in = canvas.in();
    const std::uint8_t which = in.list.cloudStyleOf[p];
    const PointStyle& style = in.list.cloudStyles.styles[which];
    const PointStyle* other = in.other != nullptr ? &in.other->cloudStyles.styles[which] : nullptr;
    const float strength = style.color.a * (style.onMesh ? marks : 1.0F);
    if (style.shape == Shape::Hidden || strength < kLeastAlpha) return;
    const auto at = canvas.screen().at(in.model.place[p], kMarkBias * in.model.spacing);
    if (!at || !Rect{{0.0F, 0.0F}, in.size}.contains(glm::vec2(*at))) return;
    if (canvas.depth().hides(*at)) return;
    const bool solid = drawnSolid(canvas.dots());
    const float zoom = std::clamp(canvas.dots() / in.em / 1.5F, 0.45F, 1.35F);
    const float size = solid ? std::max(2.0F, kSolidDots * canvas.dots())
                             : std::max(1.5F, style.size * in.em * zoom);
    const float alpha = strength * fadeOf(canvas, p);
    Ink ink = SvgCanvas::colors(style, other).withAlpha(std::round(20.0F * alpha) / 20.0F);
    if (solid) {
        const Ink background = canvas.ink(&Palette::background);
        ink = {solidColor(canvas, ink.color, background.color, p, alpha),
               solidColor(canvas, ink.other, background.other, p, alpha)};
    }
    canvas.setPoint(static_cast<Index>(p));
    drawShape(canvas, glm::vec2(*at), size, solid ? Shape::Disc : style.shape, ink);
}

/// Draws a single mark with a ring of the background around it.
void drawMark(SvgCanvas& canvas, std::size_t i) {
    const Sprite& sprite = canvas.in().list.sprites[i];
    const Sprite* other = canvas.counterpart(&DrawList::sprites, i);
    const auto at = canvas.screen().at(sprite.position);
    if (!at) return;
    const PointStyle& style = sprite.style;
    const float size = style.size * canvas.em() * canvas.markZoom();
    drawShape(canvas, glm::vec2(*at), size, style.shape,
              canvas.ink(&Palette::background, kRingAlpha * style.color.a), kRing);
    canvas.setPoint(canvas.pointAt(sprite.position));
    drawShape(canvas, glm::vec2(*at), size, style.shape,
              SvgCanvas::colors(style, other != nullptr ? &other->style : nullptr));
    canvas.setPoint(kNone);
}

}  // namespace

void drawSvgPoints(SvgCanvas& canvas) {
    const DrawList& list = canvas.in().list;
    const std::size_t count = canvas.in().model.place.size();
    if (!list.cloudVisible || list.cloudStyleOf.size() != count) return;
    const float marks = list.meshVisible ? markStrength(canvas.dots()) : 1.0F;
    canvas.beginGroup("points");
    for (std::size_t p = 0; p < count; ++p) drawPoint(canvas, p, marks);
    canvas.setPoint(kNone);
    canvas.endGroup();
}

void drawSvgMarks(SvgCanvas& canvas) {
    canvas.beginGroup("marks");
    for (std::size_t i = 0; i < canvas.in().list.sprites.size(); ++i) drawMark(canvas, i);
    canvas.endGroup();
}

}  // namespace se::view
