// Sheets, spheres and lines. Parts of lines that triangles hide are cut off, or drawn faintly, as
// by the renderer.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "paint/shapes.h"
#include "scene/camera.h"
#include "svg_frame.h"

namespace se::view {

namespace {

/// Pixels between two looks at what hides a line.
constexpr float kLook = 2.5F;
/// Below this opacity nothing is drawn.
constexpr float kInvisible = 0.01F;

/// A part of a line, as shares of it.
struct LinePart {
    float from = 0.0F;
    float to = 1.0F;
    bool hidden = false;
};

/// The parts of a line that triangles hide, and those that they do not.
std::vector<LinePart> partsOf(SvgCanvas& canvas, const glm::vec3& a, const glm::vec3& b) {
    const int count =
        std::clamp(static_cast<int>(glm::distance(glm::vec2(a), glm::vec2(b)) / kLook), 1, 2000);
    std::vector<LinePart> parts;
    for (int i = 0; i < count; ++i) {
        const float from = static_cast<float>(i) / static_cast<float>(count);
        const float to = static_cast<float>(i + 1) / static_cast<float>(count);
        const bool hidden = canvas.depth().hides(glm::mix(a, b, 0.5F * (from + to)));
        if (!parts.empty() && parts.back().hidden == hidden) {
            parts.back().to = to;
        } else {
            parts.push_back({from, to, hidden});
        }
    }
    return parts;
}

/// Dashes that fit the length, with half a dash at either end.
std::string dashesOf(float dash, float length) {
    if (!(dash > 0.0F) || length <= 1.5F * dash) return {};
    const float periods = std::max(1.0F, std::floor(length / (2.0F * dash) + 0.5F));
    const float period = length / periods;
    return fmt::format(" stroke-dasharray=\"{:.2g}\" stroke-dashoffset=\"{:.2g}\"", 0.5F * period,
                       0.25F * period);
}

/// The head of an arrow at the middle of a line (shaders/line.frag).
void drawHead(SvgCanvas& canvas, const Line& line, const Ink& color, glm::vec2 a, glm::vec2 b) {
    const float size = line.arrow * canvas.em() * canvas.markZoom();
    const float length = glm::distance(a, b);
    if (!(size > 0.0F) || length <= 1.1F * size) return;
    const glm::vec2 way = (b - a) / length;
    const glm::vec2 across(-way.y, way.x);
    const glm::vec2 middle = 0.5F * (a + b);
    const glm::vec2 back = middle - 0.42F * size * way;
    canvas.polygon(
        {middle + 0.5F * size * way, back + 0.484F * size * across, back - 0.484F * size * across},
        color);
}

void drawPart(SvgCanvas& canvas, const Line& line, const Ink& color, glm::vec2 a, glm::vec2 b,
              bool hidden) {
    const float width = std::max(1.0F, line.width * canvas.em() * canvas.markZoom());
    const float alpha = line.color.a * (hidden ? kHiddenAlpha : 1.0F);
    if (alpha < kInvisible) return;
    const float dash = canvas.em() * (hidden ? std::max(line.dash, kHiddenDash) : line.dash);
    canvas.setMore(dashesOf(dash, glm::distance(a, b)));
    canvas.line(a, b, color.withAlpha(alpha).line(width));
    canvas.setMore({});
}

void drawLine(SvgCanvas& canvas, std::size_t i) {
    const Line& line = canvas.in().list.lines[i];
    const float bias = kTowardEye * canvas.in().model.spacing;
    const auto a = canvas.screen().at(line.from, bias);
    const auto b = canvas.screen().at(line.to, bias);
    if (!a || !b) return;
    const Ink color = SvgCanvas::colors(line, canvas.counterpart(&DrawList::lines, i));
    if (line.depth == Depth::OnTop) {
        drawPart(canvas, line, color, glm::vec2(*a), glm::vec2(*b), false);
        return drawHead(canvas, line, color, glm::vec2(*a), glm::vec2(*b));
    }
    for (const LinePart& part : partsOf(canvas, *a, *b)) {
        if (part.hidden && line.depth == Depth::Tested) continue;
        drawPart(canvas, line, color, glm::vec2(glm::mix(*a, *b, part.from)),
                 glm::vec2(glm::mix(*a, *b, part.to)), part.hidden);
    }
    if (!canvas.depth().hides(glm::mix(*a, *b, 0.5F)))
        drawHead(canvas, line, color, glm::vec2(*a), glm::vec2(*b));
}

void drawSheet(SvgCanvas& canvas, std::size_t i) {
    const Sheet& sheet = canvas.in().list.sheets[i];
    std::array<glm::vec2, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto at = canvas.screen().at(sheet.corners[k]);
        if (!at) return;
        corners[k] = glm::vec2(*at);
    }
    // Between the stripes of a hatched one it is clearer.
    const float alpha = sheet.color.a * (sheet.hatched ? 0.64F : 1.0F);
    if (alpha < kInvisible) return;
    const Ink ink = SvgCanvas::colors(sheet, canvas.counterpart(&DrawList::sheets, i));
    canvas.polygon({corners[0], corners[1], corners[2]}, ink.withAlpha(alpha));
}

/// Clear in the middle, denser at the rim (shaders/shell.frag).
void drawSphere(SvgCanvas& canvas, std::size_t i) {
    const Sphere& sphere = canvas.in().list.spheres[i];
    const auto center = canvas.screen().at(sphere.center);
    if (!center) return;
    const CameraMatrices& camera = canvas.in().camera;
    const float away = glm::length(camera.eye - sphere.center);
    if (!camera.orthographic && away <= sphere.radius) return;
    const float reach =
        camera.orthographic ? 1.0F : std::sqrt(away * away - sphere.radius * sphere.radius);
    const float radius =
        0.5F * canvas.in().size.y * camera.projection[1][1] * sphere.radius / reach;
    const Ink color = SvgCanvas::colors(sphere, canvas.counterpart(&DrawList::spheres, i));
    const std::string name = fmt::format("{}sphere-{}", canvas.prefix(), i);
    std::string stops;
    for (const float at : {0.0F, 0.5F, 0.7F, 0.8F, 0.9F, 0.95F, 1.0F}) {
        const float rim = 1.0F - std::sqrt(1.0F - at * at);
        const float alpha = std::min(1.0F, sphere.color.a * (0.6F + 3.0F * rim * rim * rim));
        stops += fmt::format(
            "<stop offset=\"{}\" stop-color=\"currentColor\" stop-opacity=\"{:.2g}\"/>", at, alpha);
    }
    // A gradient takes the color of the group: its stops have no class of a fill.
    canvas.add(fmt::format(
        "<g class=\"{}\"><radialGradient id=\"{}\">{}</radialGradient>"
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" stroke=\"none\" "
        "fill=\"url(#{})\"/></g>",
        canvas.classes().current(color), name, stops, center->x, center->y, radius, name));
}

}  // namespace

void drawSvgLayers(SvgCanvas& canvas) {
    const DrawList& list = canvas.in().list;
    for (std::size_t k = 0; k < list.layers.size(); ++k) {
        const LayerStart& layer = list.layers[k];
        const LayerStart end = list.endOf(k);
        canvas.beginGroup(nameOfTitle(layer.title));
        for (std::size_t i = layer.sheets; i < end.sheets; ++i) drawSheet(canvas, i);
        for (std::size_t i = layer.spheres; i < end.spheres; ++i) drawSphere(canvas, i);
        for (std::size_t i = layer.lines; i < end.lines; ++i) drawLine(canvas, i);
        canvas.endGroup();
    }
}

// Points and single marks.

namespace {

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
    return 0.3F + 0.7F * smoothStep(-0.25F, 0.15F, facing);
}

void drawPoint(SvgCanvas& canvas, std::size_t p, float marks) {
    const FrameShapes& in = canvas.in();
    const std::uint8_t which = in.list.cloudStyleOf[p];
    const PointStyle& style = in.list.cloudStyles.styles[which];
    const PointStyle* other = in.other != nullptr ? &in.other->cloudStyles.styles[which] : nullptr;
    const float strength = style.color.a * (style.onMesh ? marks : 1.0F);
    if (style.shape == Shape::Hidden || strength < kFaintest) return;
    const auto at = canvas.screen().at(in.model.place[p], kTowardEye * in.model.spacing);
    if (!at || !Rect{{0.0F, 0.0F}, in.size}.contains(glm::vec2(*at))) return;
    if (canvas.depth().hides(*at)) return;
    const bool solid = drawnSolid(canvas.dots());
    const float zoom = std::clamp(canvas.dots() / in.em / 1.5F, 0.45F, 1.35F);
    const float size = solid ? std::max(2.0F, kSolidShare * canvas.dots())
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
