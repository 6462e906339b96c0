#include "figures.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <vector>

#include "dial_painter.h"
#include "scene/screen_rect.h"
#include "screen_space.h"
#include "spiraling_edge/run/event_text.h"
#include "svg_text.h"
#include "text_cut.h"

namespace se::view {

std::string decisionSvg(const PointSet& points, const Params& params, const DecisionState& state,
                        float width) {
    constexpr float kEm = 16.0F;
    constexpr float kMargin = 0.7F * kEm;
    SvgClasses classes(Theme::Light, false);
    SvgPainter painter(Theme::Light, kEm, classes, "");
    const Dial dial = makeDial(points, params, state);
    const float top = dial.empty() ? 0.0F : 1.05F * width;
    drawDialFigure(painter, {dial, {}}, {{0.0F, 0.0F}, {width, top}});
    std::string address = "The start of the run";
    std::string sentence = std::to_string(points.size()) + " points.";
    if (state.event) {
        address = toString(state.event->address);
        sentence = describe(*state.event);
        if (const auto section = rowOf(state.event->address.stage).section; !section.empty())
            address.append(", section ").append(section);
    }
    float bottom = top + kMargin;
    const auto write = [&](const std::string& words, Typeface face) {
        painter.text({kMargin, bottom}, words, painter.ink(&Palette::text), {kEm, face});
        bottom += 1.3F * kEm;
    };
    write(address, Typeface::Strong);
    const auto measure = [&](const std::string& words) { return painter.textSize(words, {kEm}).x; };
    for (const std::string& line : linesAtBlanks(sentence, width - 2.0F * kMargin, measure))
        write(line, Typeface::Text);
    // Named after its content: equal names have equal styles.
    const std::string body = painter.take();
    const std::string id = fmt::format("decision-{:x}", std::hash<std::string>()(body));
    const std::string ground = "<rect class=\"" + classes.fill(painter.ink(&Palette::background)) +
                               "\" width=\"100%\" height=\"100%\"/>";
    return svgDocument({width, bottom + kMargin}, address, classes.sheet(false, "#" + id + " "),
                       "<g id=\"" + id + "\">" + ground + body + "</g>");
}

namespace {

/// Pixels a side of the squares whose means smooth the outlines.
constexpr int kFiner = 2;

/// The view of triangles from a direction, without perspective; its unit is their width in it.
struct MeshView {
    CameraMatrices camera;
    Vec3 middle{0.0};  ///< Of the triangles: the origin of the view.
    double wide = 1.0;

    glm::vec3 place(const Vec3& position) const { return glm::vec3((position - middle) / wide); }
};

MeshView viewOf(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                const Vec3& toEye) {
    constexpr float kSpan = 0.94F;  // of the picture, that the mesh takes
    const Vec3 eye = glm::normalize(toEye);
    const Vec3 up = std::abs(eye.z) < 0.999 ? Vec3(0.0, 0.0, 1.0) : Vec3(0.0, 1.0, 0.0);
    const glm::dmat3 turn(glm::lookAt(eye, Vec3(0.0), up));
    Vec3 low(std::numeric_limits<double>::max());
    Vec3 high(-low);
    for (const Triangle& t : triangles) {
        for (const Index p : {t.a, t.b, t.c}) {
            low = glm::min(low, turn * positions[p]);
            high = glm::max(high, turn * positions[p]);
        }
    }
    const Vec3 room = glm::max(high - low, Vec3(std::numeric_limits<double>::min()));
    MeshView view;
    view.wide = std::max(room.x, room.y);
    view.camera.view = glm::mat4(glm::mat3(turn));
    const auto deep = static_cast<float>(std::clamp(room.z / view.wide, 1.0, 1e6));
    view.camera.projection =
        glm::scale(glm::mat4(1.0F), {2.0F * kSpan, 2.0F * kSpan, -1.0F / deep});
    view.camera.eye = glm::vec3(eye);
    view.camera.orthographic = true;
    view.middle = glm::transpose(turn) * (0.5 * (low + high));
    return view;
}

using Corners = std::array<glm::vec3, 3>;

/// The color of a triangle by the light and its side.
Color colorOf(const Corners& places, const ScreenSpace& screen) {
    const Palette& palette = paletteOf(Theme::Light);
    const glm::vec3 across = glm::cross(places[1] - places[0], places[2] - places[0]);
    const glm::vec3 toEye = screen.toEye(places[0]);
    const bool outer = glm::dot(across, toEye) > 0.0F;
    const float length = (outer ? 1.0F : -1.0F) * glm::length(across);
    const float light = length == 0.0F ? 1.0F : lightOn(across / length, toEye, screen);
    return mix(fromHex(0), outer ? palette.mesh : palette.rejected, std::min(1.0F, light));
}

/// True if a triangle on the screen is large enough to show its sides.
bool showsSides(const Corners& at) {
    constexpr float kLeastHeight = 6.0F * kFiner;
    const std::array<glm::vec2, 3> p{at[0], at[1], at[2]};
    const float longest =
        std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    return std::abs(crossOf(p[1] - p[0], p[2] - p[0])) > kLeastHeight * longest;
}

}  // namespace

Picture meshPicture(std::span<const Vec3> positions, std::span<const Triangle> triangles, int size,
                    const Vec3& toEye) {
    const int wide = kFiner * size;
    const auto pixels = static_cast<float>(wide);
    const MeshView view = viewOf(positions, triangles, toEye);
    const ScreenSpace screen(view.camera, glm::vec2(pixels));
    DepthPicture nearest(glm::vec2(pixels), pixels);
    std::vector<Color> colors;
    std::vector<bool> hasSides;
    for (const Triangle& t : triangles) {
        Corners places{};
        Corners seen{};
        for (std::size_t i = 0; i < 3; ++i) {
            places[i] = view.place(positions[std::array{t.a, t.b, t.c}[i]]);
            seen[i] = screen.at(places[i]).value_or(glm::vec3(0.0F));
        }
        nearest.add(seen, static_cast<std::uint32_t>(colors.size()));
        colors.push_back(colorOf(places, screen));
        hasSides.push_back(showsSides(seen));
    }
    const Palette& palette = paletteOf(Theme::Light);
    const auto numberAt = [&](int x, int y) {
        const auto at = static_cast<std::size_t>(std::max(y, 0) * wide + std::min(x, wide - 1));
        return nearest.numbers()[at];
    };
    Picture picture{glm::ivec2(wide), {}};
    for (int y = wide - 1; y >= 0; --y) {
        for (int x = 0; x < wide; ++x) {
            const std::uint32_t number = numberAt(x, y);
            const bool filled = number != DepthPicture::kNobody;
            const bool side = filled && hasSides[number] &&
                              (numberAt(x + 1, y) != number || numberAt(x, y - 1) != number);
            const Color& color = side     ? palette.meshEdge
                                 : filled ? colors[number]
                                          : palette.background;
            for (const float share : {color.r, color.g, color.b, 1.0F})
                picture.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0F * share)));
        }
    }
    return reduced(picture, kFiner);
}

}  // namespace se::view
