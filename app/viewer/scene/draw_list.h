/// Things to draw, as plain values: layers fill the list, render/ draws it, tests read it.
/// Positions are in view space (model.h); sizes are in em, the height of a line of text.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_style.h"
#include "palette.h"
#include "spiraling_edge/base/block_list.h"
#include "spiraling_edge/points/point_set.h"

namespace se::view {

/// Share of the point spacing by which points and lines are moved toward the eye.
inline constexpr float kTowardEye = 0.12F;
/// Strength of hidden lines.
inline constexpr float kHiddenAlpha = 0.34F;
/// Length of the dashes of hidden lines and of their gaps, in em.
inline constexpr float kHiddenDash = 0.4F;

struct PointStyle {
    Color color;
    float size = 0.5F;
    Shape shape = Shape::Disc;
    bool onMesh = false;  ///< Fades where points are close together: the mesh shows them.
    friend bool operator==(const PointStyle&, const PointStyle&) = default;
};

/// A single marked point, always on top.
struct Sprite {
    glm::vec3 position{0.0F};
    PointStyle style;
};

/// Visibility of a line behind other things.
enum class Depth : std::uint8_t {
    Tested,  ///< Hidden parts are not drawn.
    XRay,    ///< Hidden parts shine through faintly.
    OnTop,   ///< Always visible.
};

struct Line {
    glm::vec3 from{0.0F};
    glm::vec3 to{0.0F};
    Color color;
    float width = 0.1F;
    float dash = 0.0F;   ///< Length of dash and gap; 0: solid.
    float arrow = 0.0F;  ///< Size of an arrow head at the middle; 0: none.
    Depth depth = Depth::Tested;
};

struct Face {
    std::array<glm::vec3, 3> corners{};
    Color color;
    bool hatched = false;
    friend bool operator==(const Face&, const Face&) = default;
};

/// A transparent filled shape, e.g. the free sector of a pivot.
using Sheet = Face;

struct Sphere {
    glm::vec3 center{0.0F};
    float radius = 1.0F;
    Color color;
};

/// The place of the points of a decision, view units.
struct DecisionPlace {
    glm::vec3 center{0.0F};
    float radius = 0.0F;
    std::vector<glm::vec3> points;
};

/// Text beside a point.
struct Label {
    glm::vec3 position{0.0F};
    std::string text;
    Color color;
    bool strong = false;     ///< In bold type.
    bool essential = false;  ///< The name of a point of the decision: placed first.
    /// Radius of the labeled place, view units: it has no label where it is too small to be seen.
    /// 0: it always has.
    float extent = 0.0F;
    bool asked = false;  ///< Of a point that the user points at or chooses from: always shown.
    bool given = false;  ///< A name that a lesson or a figure gives: always shown.
};

/// Styles of the points of the input, chosen per point by one byte.
struct CloudStyles {
    static constexpr std::size_t kCount = 80;
    /// Style of points of the run that were set aside.
    static constexpr std::uint8_t kAside = 14;
    std::array<PointStyle, kCount> styles{};
};

/// Finished triangles from `first` up to the next stretch.
struct MeshStretch {
    std::size_t first = 0;
    Color color;
    friend bool operator==(const MeshStretch&, const MeshStretch&) = default;
};

/// Finished triangles in a color of their own, drawn over the others.
struct TintedTriangles {
    std::shared_ptr<const std::vector<Triangle>> triangles;  ///< Null: none.
    std::size_t count = 0;  ///< Number of them to draw, from the first.
    Color color;
    friend bool operator==(const TintedTriangles&, const TintedTriangles&) = default;
};

/// Where the things of one layer begin, in each list.
struct LayerStart {
    std::string_view title;  ///< Of the layer.
    std::size_t lines = 0;
    std::size_t sheets = 0;
    std::size_t spheres = 0;
    std::size_t sprites = 0;
};

/// Looks of the finished triangles: a change redraws all of them.
struct MeshLooks {
    Color meshColor;
    Color meshEdgeColor;
    MeshStyle meshStyle = MeshStyle::Flat;
    std::size_t creationEnd = 1;  ///< The triangle at the light end of the scale.
    /// Stretches of the finished triangles with a color of their own, in order; the rest has
    /// meshColor.
    std::vector<MeshStretch> meshStretches;
    bool meshVisible = true;
    bool meshEdges = true;
    std::array<TintedTriangles, 2> tinted{};
    friend bool operator==(const MeshLooks&, const MeshLooks&) = default;
};

struct DrawList : MeshLooks {
    bool operator==(const DrawList&) const = delete;  // It would compare the looks alone.

    /// The layers, in drawing order; the things of each end where those of the next begin.
    std::vector<LayerStart> layers;

    // The input: positions are uploaded once, only the bytes change.
    bool cloudVisible = true;
    CloudStyles cloudStyles;
    BlockList<std::uint8_t> cloudStyleOf;
    /// Source of cloudStyleOf: kept when all else is cleared, so that only blocks of points
    /// that changed are computed again.
    BlockList<std::int32_t> cloudMadeOf;
    std::uint32_t cloudTintMadeOf = 0;  ///< Revision of the margins in cloudStyleOf; 0: by status.
    bool marginTint = false;            ///< Points have the color of their least margin.

    // Finished triangles: uploaded once, drawn up to a count.
    std::size_t finishedTriangles = 0;
    std::size_t components = 0;  ///< Triangles that have a color of their own.

    /// Triangles to draw instead of the finished ones, if not null.
    std::shared_ptr<const std::vector<Triangle>> repaired;

    std::optional<DecisionPlace> decision;
    bool ghosts = false;  ///< Finished triangles that hide the decision are faint.

    std::vector<Face> faces;  ///< New triangles: lit, opaque.
    std::vector<Line> lines;
    std::vector<Sheet> sheets;  ///< Transparent, unlit.
    std::vector<Sphere> spheres;
    std::vector<Sprite> sprites;
    std::vector<Label> labels;

    /// Empties all but the styles of the cloud, see cloudMadeOf.
    void clear();
    /// Where the things of a layer of the list end.
    LayerStart endOf(std::size_t layer) const {
        if (layer + 1 < layers.size()) return layers[layer + 1];
        return {{}, lines.size(), sheets.size(), spheres.size(), sprites.size()};
    }
    void line(const glm::vec3& from, const glm::vec3& to, const Color& color, float width,
              Depth depth = Depth::Tested) {
        lines.push_back({from, to, color, width, 0.0F, 0.0F, depth});
    }
    void dashed(const glm::vec3& from, const glm::vec3& to, const Color& color, float width,
                float dash = 0.3F, Depth depth = Depth::OnTop) {
        lines.push_back({from, to, color, width, dash, 0.0F, depth});
    }
    /// The lines around a polygon.
    void loop(std::span<const glm::vec3> corners, const Color& color, float width,
              Depth depth = Depth::OnTop, float dash = 0.0F) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            dashed(corners[i], corners[(i + 1) % corners.size()], color, width, dash, depth);
        }
    }
    /// A line with its head near the far end, always on top.
    void arrow(const glm::vec3& from, const glm::vec3& to, const Color& color, float width,
               float head = 0.6F);
    void sheet(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Color& color) {
        sheets.push_back({{a, b, c}, color, false});
    }
    /// A filled quadrilateral.
    void sheet(const std::array<glm::vec3, 4>& corners, const Color& color) {
        sheet(corners[0], corners[1], corners[2], color);
        sheet(corners[0], corners[2], corners[3], color);
    }
    /// A triangle filled with `stripes` lines parallel to its edge from a to b.
    void hatch(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Color& color,
               int stripes = 8);
    void mark(const glm::vec3& position, Shape shape, const Color& color, float size) {
        sprites.push_back({position, {color, size, shape}});
    }
    void label(const glm::vec3& position, std::string text, const Color& color,
               bool strong = false) {
        labels.push_back({position, std::move(text), color, strong, false, 0.0F, false});
    }
    /// A circle about `center` with the unit vectors u and v, as `segments` lines.
    void circle(const glm::vec3& center, const glm::vec3& u, const glm::vec3& v, float radius,
                const Color& color, float width, Depth depth, int segments = 64);
};

}  // namespace se::view
