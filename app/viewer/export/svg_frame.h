/// A frame as elements of SVG.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "formats.h"
#include "paint/svg_text.h"
#include "scene/camera.h"

namespace se::view {

// What the parts of an SVG picture draw on: the view, what hides things in it, and the text so
// far.

// The nearest triangle at each pixel of a view: for lines and points that triangles hide, where no
// graphics card draws. Plain arithmetic.

/// Positions of a view as pixels (y down) and depth (-1 near to 1 far).
class ScreenSpace {
  public:
    ScreenSpace(const CameraMatrices& camera, glm::vec2 size);

    /// Empty if the position is behind the eye. `bias`: view units toward the eye.
    std::optional<glm::vec3> at(const glm::vec3& position, float bias = 0.0F) const;
    /// The unit direction to the eye.
    glm::vec3 toEye(const glm::vec3& position) const;
    const CameraMatrices& camera() const { return camera_; }
    glm::vec2 size() const { return size_; }
    glm::vec3 right() const;
    glm::vec3 up() const;

  private:
    CameraMatrices camera_;
    glm::mat4 toClip_;
    glm::vec2 size_;
};

/// Depth and number of the nearest triangle, pixel by pixel.
class DepthPicture {
  public:
    /// Of a view of that size; larger ones have fewer pixels than the view.
    explicit DepthPicture(glm::vec2 size);

    /// Adds a triangle by its corners in screen space.
    void add(const std::array<glm::vec3, 3>& corners, std::uint32_t number);
    /// Whether a triangle lies before that place of the screen space.
    bool hides(const glm::vec3& place) const;
    /// The numbers of the triangles that are nearest at one pixel or more, ascending.
    std::vector<std::uint32_t> visible() const;

  private:
    float scale_;
    glm::ivec2 size_;
    std::vector<float> depth_;
    std::vector<std::uint32_t> number_;
};

/// The picture of one frame while it is drawn.
class SvgCanvas : public SvgPainter {
  public:
    SvgCanvas(const FrameShapes& shapes, SvgClasses& classes, std::string prefix);

    const FrameShapes& in() const { return in_; }
    const ScreenSpace& screen() const { return screen_; }
    DepthPicture& depth() { return depth_; }
    /// Distance of the points, in pixels.
    float dots() const { return dots_; }
    /// Zoom of marks and lines, as of the renderer.
    float markZoom() const;
    /// The point at exactly that position; kNone if there is none.
    Index pointAt(const glm::vec3& position) const;

    /// The color of an element in both themes: `color` of it, and of `other`, null for none.
    template <typename Element>
    static Ink colors(const Element& element, const Element* other) {
        return {element.color, other != nullptr ? other->color : element.color};
    }
    /// The element of the other theme's list; null if that is not needed.
    template <typename Element>
    const Element* counterpart(std::vector<Element> DrawList::*list, std::size_t i) const {
        if (in_.other == nullptr || i >= (in_.other->*list).size()) return nullptr;
        return &(in_.other->*list)[i];
    }

  private:
    const FrameShapes& in_;
    ScreenSpace screen_;
    DepthPicture depth_;
    float dots_;
    std::unordered_map<std::string, Index> points_;
};

/// Triangles; fills the depth picture.
void drawSvgTriangles(SvgCanvas& canvas);
void drawSvgPoints(SvgCanvas& canvas);
/// Sheets, spheres and lines, layer by layer.
void drawSvgLayers(SvgCanvas& canvas);
void drawSvgMarks(SvgCanvas& canvas);

/// Number of shapes above which a picture of pixels is smaller and faster.
inline constexpr std::size_t kMaxShapes = 50'000;

/// Attributes that all elements of a picture inherit.
inline constexpr std::string_view kSvgLook =
    "font-family=\"Inter, 'DejaVu Sans', sans-serif\" stroke-linecap=\"round\" "
    "stroke-linejoin=\"round\"";

/// The elements of a view, in drawing order: a group `triangles`, one `points`, one for each layer
/// that draws something, `marks` and `labels`. `prefix` begins their ids, and those that they refer
/// to. Fails if there are over kMaxShapes.
Result<std::string> svgFrame(const FrameShapes& shapes, SvgClasses& classes,
                             const std::string& prefix);

/// An element that fills a frame with the background of its view.
std::string svgBackground(const ExportFrame& frame, SvgClasses& classes);

/// The elements of a frame: those of its view, or of two views that are compared, each a group with
/// its title, `view-a` and `view-b`.
Result<std::string> svgViews(const ExportFrame& frame, SvgClasses& classes,
                             const std::string& prefix);

}  // namespace se::view
