/// What the parts of an SVG picture draw on: the view, what hides things in it, and the text so
/// far.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "depth_picture.h"
#include "frame.h"
#include "paint/svg_painter.h"

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

}  // namespace se::view
