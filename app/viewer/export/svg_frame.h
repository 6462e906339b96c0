/// A frame as elements of SVG.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include "formats.h"
#include "paint/screen_space.h"
#include "paint/svg_text.h"

namespace se::view {

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
