// Shapes of points, as shaders/point.frag draws them by their distances, and labels.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "layout/overlays.h"
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
/// Size of letters and of the part above the baseline, as shares of the height of a line.
constexpr float kLetters = 0.826F;
constexpr float kBaseline = 0.8F;

/// The outline of a shape, and whether it is filled or a line.
struct ShapeOutline {
    std::string data;
    float width = 0.0F;  ///< Of the line; 0: filled.
};

std::string circleData(glm::vec2 at, float r) {
    std::string data = "M";
    appendPlace(data, at - glm::vec2(r, 0.0F));
    const std::string size = fmt::format("{0:.3g} {0:.3g} 0 1 1 ", r);
    data += "a" + size + fmt::format("{:.3g} 0", 2.0F * r);
    return data + "a" + size + fmt::format("{:.3g} 0z", -2.0F * r);
}

std::string polygonData(glm::vec2 at, std::initializer_list<glm::vec2> corners) {
    std::string data = "M";
    bool first = true;
    for (const glm::vec2& corner : corners) {
        if (!std::exchange(first, false)) data += 'L';
        appendPlace(data, at + corner);
    }
    return data + 'z';
}

std::string crossData(glm::vec2 at, glm::vec2 a, glm::vec2 b) {
    std::string data;
    for (const glm::vec2& way : {a, b}) {
        data += 'M';
        appendPlace(data, at - way);
        data += 'L';
        appendPlace(data, at + way);
    }
    return data;
}

std::vector<ShapeOutline> outlinesOf(Shape shape, glm::vec2 at, float r) {
    const float stroke = std::max(1.0F, 0.3F * r);
    const float side = 0.82F * r;
    const float thin = side - 0.5F * stroke;
    const float slim = r - 0.7F * stroke;
    switch (shape) {
        case Shape::Hidden:
            return {};
        case Shape::Dot:
        case Shape::Disc:
            return {{circleData(at, r)}};
        case Shape::Circle:
            return {{circleData(at, r - 0.5F * stroke), stroke}};
        case Shape::Square:
            return {
                {polygonData(at, {{-side, -side}, {side, -side}, {side, side}, {-side, side}})}};
        case Shape::OpenSquare:
            return {{polygonData(at, {{-thin, -thin}, {thin, -thin}, {thin, thin}, {-thin, thin}}),
                     stroke}};
        case Shape::Diamond:
            return {{polygonData(at, {{-r, 0.0F}, {0.0F, -r}, {r, 0.0F}, {0.0F, r}})}};
        case Shape::OpenDiamond:
            return {{polygonData(at, {{-slim, 0.0F}, {0.0F, -slim}, {slim, 0.0F}, {0.0F, slim}}),
                     stroke}};
        case Shape::RingedDisc:
            return {{circleData(at, 0.9F * r), 0.2F * r}, {circleData(at, 0.55F * r)}};
        case Shape::Forward:
            return {
                {polygonData(at, {{r, 0.0F}, {-0.5F * r, 0.866F * r}, {-0.5F * r, -0.866F * r}})}};
        case Shape::Back:
            return {
                {polygonData(at, {{-r, 0.0F}, {0.5F * r, 0.866F * r}, {0.5F * r, -0.866F * r}})}};
        case Shape::Cross:
            return {{crossData(at, {0.62F * r, 0.62F * r}, {0.62F * r, -0.62F * r}),
                     2.0F * std::max(0.8F, 0.2F * r)}};
        case Shape::Plus:
            return {{crossData(at, {r, 0.0F}, {0.0F, r}), 2.0F * std::max(0.7F, 0.16F * r)}};
    }
    return {};
}

std::string attributesOf(SvgCanvas& canvas, const ShapeOutline& outline, const ColorPair& color,
                         float alpha) {
    if (outline.width > 0.0F)
        return strokeOf(canvas, color, alpha, outline.width) + " fill=\"none\"";
    return fillOf(canvas, color, alpha) + " stroke=\"none\"";
}

std::string pointOf(Index point) {
    return point == kNone ? std::string() : fmt::format(" data-point=\"{}\"", point);
}

void drawShape(SvgCanvas& canvas, Shape shape, glm::vec3 at, float r, const ColorPair& color,
               float alpha, Index point) {
    for (const ShapeOutline& each : outlinesOf(shape, glm::vec2(at), r)) {
        canvas.add("<path" + pointOf(point) + attributesOf(canvas, each, color, alpha) + " d=\"" +
                   each.data + "\"/>");
    }
}

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
    ColorPair color = SvgCanvas::colors(style, other);
    if (solid) {
        color.color = solidColor(canvas, color.color, in.background, p, alpha);
        color.other = solidColor(canvas, color.other, canvas.background().other, p, alpha);
    }
    drawShape(canvas, solid ? Shape::Disc : style.shape, *at, 0.5F * size, color,
              solid ? 1.0F : std::round(20.0F * alpha) / 20.0F, static_cast<Index>(p));
}

/// Draws a single mark with a ring of the background around it.
void drawMark(SvgCanvas& canvas, std::size_t i) {
    const Sprite& sprite = canvas.in().list.sprites[i];
    const Sprite* other = canvas.counterpart(&DrawList::sprites, i);
    const auto at = canvas.screen().at(sprite.position);
    if (!at) return;
    const float r = 0.5F * sprite.style.size * canvas.em() * canvas.markZoom();
    for (const ShapeOutline& each : outlinesOf(sprite.style.shape, glm::vec2(*at), r)) {
        canvas.add("<path" +
                   strokeOf(canvas, canvas.background(), kRingAlpha * sprite.style.color.a,
                            each.width + 2.0F * kRing) +
                   " fill=\"none\" d=\"" + each.data + "\"/>");
    }
    const ColorPair color{sprite.style.color,
                          other != nullptr ? other->style.color : sprite.style.color};
    drawShape(canvas, sprite.style.shape, *at, r, color, sprite.style.color.a,
              canvas.pointAt(sprite.position));
}

void drawLabel(SvgCanvas& canvas, const DrawnLabel& drawn) {
    const Label& label = canvas.in().list.labels[drawn.index];
    const ColorPair color =
        SvgCanvas::colors(label, canvas.counterpart(&DrawList::labels, drawn.index));
    const Rect& plate = drawn.plate;
    canvas.add(
        fmt::format("<rect{} x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                    "rx=\"{:.1f}\"/>",
                    fillOf(canvas, canvas.background(), kPlateAlpha), plate.min.x, plate.min.y,
                    plate.size.x, plate.size.y, 0.2F * canvas.em()));
    const float width = plate.size.x - 2.0F * (drawn.text.x - plate.min.x);
    canvas.add(fmt::format(
        "<text{}{} x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" "
        "textLength=\"{:.1f}\" lengthAdjust=\"spacingAndGlyphs\">{}</text>",
        fillOf(canvas, color, label.color.a), label.strong ? " font-weight=\"600\"" : "",
        drawn.text.x, drawn.text.y + kBaseline * drawn.size, kLetters * drawn.size, width,
        escapedXml(label.text)));
}

}  // namespace

void drawSvgPoints(SvgCanvas& canvas) {
    const DrawList& list = canvas.in().list;
    const std::size_t count = canvas.in().model.place.size();
    if (!list.cloudVisible || list.cloudStyleOf.size() != count) return;
    const float marks = list.meshVisible ? markStrength(canvas.dots()) : 1.0F;
    canvas.beginGroup("points");
    for (std::size_t p = 0; p < count; ++p) drawPoint(canvas, p, marks);
    canvas.endGroup();
}

void drawSvgShape(SvgCanvas& canvas, Shape shape, glm::vec2 at, float r, const ColorPair& color,
                  Index point) {
    drawShape(canvas, shape, glm::vec3(at, 0.0F), r, color, 1.0F, point);
}

void drawSvgMarks(SvgCanvas& canvas) {
    canvas.beginGroup("marks");
    for (std::size_t i = 0; i < canvas.in().list.sprites.size(); ++i) drawMark(canvas, i);
    canvas.endGroup();
}

void drawSvgLabels(SvgCanvas& canvas) {
    canvas.beginGroup("labels");
    for (const DrawnLabel& each : canvas.in().labels) {
        if (!each.leader) continue;
        const Label& label = canvas.in().list.labels[each.index];
        const glm::vec2 end = nearestIn(each.plate, each.at);
        std::string data = "M";
        appendPlace(data, each.at);
        data += 'L';
        appendPlace(data, end);
        canvas.addPath(
            strokeOf(canvas,
                     SvgCanvas::colors(label, canvas.counterpart(&DrawList::labels, each.index)),
                     kLeaderAlpha, std::max(1.0F, kLeaderEms * canvas.em())),
            data);
    }
    for (const DrawnLabel& each : canvas.in().labels) drawLabel(canvas, each);
    canvas.endGroup();
}

}  // namespace se::view
