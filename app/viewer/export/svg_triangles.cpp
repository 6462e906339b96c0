// Triangles from back to front, each in the color that the light gives it (shaders/mesh.frag);
// those that others hide at all pixels are left out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "svg_frame.h"

namespace se::view {

namespace {

/// Steps of the light: fewer classes of colors.
constexpr float kShades = 48.0F;
/// Opacity of triangles that hide the decision.
constexpr float kGhostAlpha = 0.25F;

Color times(const Color& color, float shade) {
    return {std::min(1.0F, color.r * shade), std::min(1.0F, color.g * shade),
            std::min(1.0F, color.b * shade), color.a};
}

/// A triangle on the screen.
struct SvgTriangle {
    std::array<glm::vec3, 3> places{};
    std::array<glm::vec3, 3> screen{};
    Ink color{Color{}};
    float smooth = 0.0F;  ///< Share of the light by the normals of the points.
    float soft = 0.0F;    ///< Share without light.
    glm::vec3 normal{0.0F};
    bool hatched = false;
    bool ghost = false;
    float far = 0.0F;  ///< Distance from the eye.
};

class TriangleCollector {
  public:
    explicit TriangleCollector(SvgCanvas& canvas) : canvas_(canvas), in_(canvas.in()) {}

    std::vector<SvgTriangle> collect() {
        if (in_.list.meshVisible && in_.list.meshStyle != MeshStyle::Wire) addFinished();
        if (in_.list.meshVisible) addTinted();
        for (std::size_t i = 0; i < in_.list.faces.size(); ++i) {
            SvgTriangle triangle;
            triangle.places = in_.list.faces[i].corners;
            triangle.hatched = in_.list.faces[i].hatched;
            triangle.color =
                SvgCanvas::colors(in_.list.faces[i], canvas_.counterpart(&DrawList::faces, i));
            put(triangle);
        }
        return std::move(all_);
    }

  private:
    std::span<const Triangle> finished() const {
        if (in_.list.repaired) return *in_.list.repaired;
        return in_.triangles.first(std::min(in_.triangles.size(), in_.list.finishedTriangles));
    }

    static Color colorAt(const DrawList& list, std::size_t i) {
        if (list.meshStyle == MeshStyle::CreationOrder) {
            const std::size_t end = std::max<std::size_t>(list.creationEnd, 2);
            return viridis(static_cast<float>(i) / static_cast<float>(end - 1));
        }
        Color color = list.meshColor;
        for (const MeshStretch& each : list.meshStretches) {
            if (each.first <= i) color = each.color;
        }
        return color;
    }

    void addFinished() {
        const std::span<const Triangle> triangles = finished();
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Color color = colorAt(in_.list, i);
            addOfModel(triangles[i],
                       {color, in_.other != nullptr ? colorAt(*in_.other, i) : color});
        }
    }

    void addTinted() {
        for (std::size_t k = 0; k < in_.list.tinted.size(); ++k) {
            const TintedTriangles& tinted = in_.list.tinted[k];
            const Color other = in_.other != nullptr ? in_.other->tinted[k].color : tinted.color;
            for (std::size_t i = 0; i < tinted.count; ++i)
                addOfModel((*tinted.triangles)[i], {tinted.color, other});
        }
    }

    void addOfModel(const Triangle& t, const Ink& color) {
        SvgTriangle triangle;
        const Model& model = in_.model;
        triangle.places = model.cornersOf(t);
        triangle.normal = model.normal[t.a] + model.normal[t.b] + model.normal[t.c];
        triangle.color = color;
        triangle.smooth = in_.list.meshStyle == MeshStyle::Shaded ? 1.0F : 0.0F;
        triangle.soft = in_.list.meshStyle >= MeshStyle::CreationOrder ? 0.6F : 0.0F;
        triangle.ghost = in_.list.ghosts && in_.list.decision && hidesDecision(triangle.places);
        put(triangle);
    }

    /// Before the sphere of the decision, and beside it on the screen by less than its radius.
    bool hidesDecision(const std::array<glm::vec3, 3>& places) const {
        const DecisionPlace& decision = *in_.list.decision;
        const glm::vec3 offset = (places[0] + places[1] + places[2]) / 3.0F - decision.center;
        const glm::vec3 toEye = canvas_.screen().toEye(decision.center);
        const float front = glm::dot(offset, toEye);
        const float away = glm::length(in_.camera.eye - decision.center);
        const float narrow = in_.camera.orthographic ? 1.0F : std::max(1.0F - front / away, 0.01F);
        const float beside = glm::length(offset - front * toEye) / narrow;
        return front > 0.0F && glm::length(offset) > 0.95F * decision.radius &&
               beside < 1.04F * decision.radius;
    }

    void put(SvgTriangle& triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = canvas_.screen().at(triangle.places[i]);
            if (!at) return;
            triangle.screen[i] = *at;
        }
        const glm::vec3 middle =
            (triangle.places[0] + triangle.places[1] + triangle.places[2]) / 3.0F;
        triangle.far = -glm::dot(canvas_.screen().toEye(in_.model.middle), middle);
        if (!in_.camera.orthographic) triangle.far = glm::length(in_.camera.eye - middle);
        all_.push_back(triangle);
    }

    SvgCanvas& canvas_;
    const FrameShapes& in_;
    std::vector<SvgTriangle> all_;
};

/// Twice the area on the screen; above 0 if the front faces the eye.
float screenArea(const SvgTriangle& t) {
    const glm::vec2 a(t.screen[1] - t.screen[0]);
    const glm::vec2 b(t.screen[2] - t.screen[0]);
    return -(a.x * b.y - a.y * b.x);
}

/// Pixels of the least height.
float heightOf(const SvgTriangle& t) {
    float longest = 1e-6F;
    for (std::size_t i = 0; i < 3; ++i) {
        longest = std::max(longest,
                           glm::distance(glm::vec2(t.screen[i]), glm::vec2(t.screen[(i + 1) % 3])));
    }
    return std::abs(screenArea(t)) / longest;
}

/// The light of shaders/mesh.frag.
float shadeOf(const SvgTriangle& t, const ScreenSpace& screen) {
    const glm::vec3 toEye = screen.toEye((t.places[0] + t.places[1] + t.places[2]) / 3.0F);
    const glm::vec3 across = glm::cross(t.places[1] - t.places[0], t.places[2] - t.places[0]);
    if (!(glm::length(across) > 0.0F)) return 1.0F;
    glm::vec3 normal = glm::normalize(across);
    if (glm::dot(normal, toEye) < 0.0F) normal = -normal;
    if (glm::length(t.normal) > 0.1F) {
        glm::vec3 smooth = glm::normalize(t.normal);
        if (glm::dot(smooth, normal) < 0.0F) smooth = -smooth;
        const float share = std::max(t.smooth, 1.0F - smoothStep(5.0F, 16.0F, heightOf(t)));
        const glm::vec3 mixed = glm::mix(normal, smooth, share);
        if (glm::length(mixed) > 1e-2F) normal = glm::normalize(mixed);
    }
    const float shade = lightOn(normal, toEye, screen);
    return screenArea(t) > 0.0F ? shade : 0.6F * shade;
}

std::string outlineOf(const SvgTriangle& t) {
    std::string data = "M";
    for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0) data += i == 1 ? 'L' : ' ';
        appendPlace(data, glm::vec2(t.screen[i]));
    }
    return data + 'z';
}

void drawTriangle(SvgCanvas& canvas, const SvgTriangle& t) {
    const DrawList& list = canvas.in().list;
    float shade = shadeOf(t, canvas.screen());
    shade = std::round(kShades * (shade + (1.0F - shade) * t.soft)) / kShades;
    const Ink color{times(t.color.color, shade), times(t.color.other, shade)};
    const Ink area = color.withAlpha(t.ghost ? kGhostAlpha : 1.0F);
    const float strength = list.meshEdges ? smoothStep(6.0F, 20.0F, heightOf(t)) : 0.0F;
    const float alpha = std::round(4.0F * strength) / 4.0F;
    const DrawList* other = canvas.in().other;
    const Ink edge =
        Ink(list.meshEdgeColor, other != nullptr ? other->meshEdgeColor : list.meshEdgeColor)
            .withAlpha(0.85F * alpha)
            .line(canvas.px(0.07F));
    const std::string outline = outlineOf(t);
    canvas.addPath(alpha > 0.0F ? canvas.attributesOf(area, edge) : canvas.attributesOf(area),
                   outline);
    if (t.hatched)
        canvas.addPath(" fill=\"url(#" + canvas.prefix() + "hatch)\" stroke=\"none\"", outline);
}

/// Edges alone.
void drawWire(SvgCanvas& canvas) {
    const FrameShapes& in = canvas.in();
    if (!in.list.meshVisible || in.list.meshStyle != MeshStyle::Wire) return;
    const Color other = in.other != nullptr ? in.other->meshEdgeColor : in.list.meshEdgeColor;
    const std::string attributes =
        " fill=\"none\"" +
        canvas.attributesOf(Ink(in.list.meshEdgeColor, other).line(canvas.px(0.07F)));
    const std::size_t count = std::min(in.triangles.size(), in.list.finishedTriangles);
    for (const Triangle& each : in.triangles.first(count)) {
        SvgTriangle t;
        t.places = in.model.cornersOf(each);
        bool before = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = canvas.screen().at(t.places[i]);
            before = before && at.has_value();
            if (at) t.screen[i] = *at;
        }
        if (before) canvas.addPath(attributes, outlineOf(t));
    }
}

/// Stripes over a new triangle, as of shaders/mesh.frag.
void defineHatch(SvgCanvas& canvas) {
    const float period = 0.55F * canvas.em() / std::sqrt(2.0F);
    canvas.add(
        fmt::format("<defs><pattern id=\"{}hatch\" width=\"{:.2f}\" height=\"{:.2f}\" "
                    "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(-45)\">"
                    "<rect width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#000\" "
                    "fill-opacity=\"0.28\"/></pattern></defs>",
                    canvas.prefix(), period, period, 0.56F * period, period));
}

}  // namespace

void drawSvgTriangles(SvgCanvas& canvas) {
    std::vector<SvgTriangle> all = TriangleCollector(canvas).collect();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].ghost) canvas.depth().add(all[i].screen, static_cast<std::uint32_t>(i));
    }
    std::vector<const SvgTriangle*> shown;
    for (const std::uint32_t i : canvas.depth().visible()) shown.push_back(&all[i]);
    for (const SvgTriangle& each : all) {
        if (each.ghost) shown.push_back(&each);
    }
    std::stable_sort(shown.begin(), shown.end(), [](const auto* a, const auto* b) {
        return a->ghost != b->ghost ? b->ghost : a->far > b->far;
    });
    const bool hatched = std::any_of(shown.begin(), shown.end(),
                                     [](const SvgTriangle* each) { return each->hatched; });
    if (hatched) defineHatch(canvas);
    canvas.beginGroup("triangles");
    for (const SvgTriangle* each : shown) drawTriangle(canvas, *each);
    drawWire(canvas);
    canvas.endGroup();
}

}  // namespace se::view
