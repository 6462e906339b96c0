/// What the parts of an SVG picture draw on: the view, what hides things in it, and the text so
/// far.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "depth_picture.h"
#include "frame.h"
#include "svg_text.h"

namespace se::view {

/// The picture of one frame while it is drawn.
class SvgCanvas {
  public:
    SvgCanvas(const FrameShapes& shapes, SvgClasses& classes, std::string prefix);

    const FrameShapes& in() const { return in_; }
    const ScreenSpace& screen() const { return screen_; }
    DepthPicture& depth() { return depth_; }
    SvgClasses& classes() { return classes_; }
    const std::string& prefix() const { return prefix_; }
    float em() const { return in_.em; }
    /// Distance of the points, in pixels.
    float dots() const { return dots_; }
    /// Zoom of marks and lines, as of the renderer.
    float markZoom() const;
    /// The point at exactly that position; kNone if there is none.
    Index pointAt(const glm::vec3& position) const;

    /// The color of an element in both themes: `color` of it, and of `other`, null for none.
    template <typename Element>
    static ColorPair colors(const Element& element, const Element* other) {
        return {element.color, other != nullptr ? other->color : element.color};
    }
    /// The element of the other theme's list; null if that is not needed.
    template <typename Element>
    const Element* counterpart(std::vector<Element> DrawList::*list, std::size_t i) const {
        if (in_.other == nullptr || i >= (in_.other->*list).size()) return nullptr;
        return &(in_.other->*list)[i];
    }
    ColorPair background() const {
        return {in_.background, in_.other != nullptr ? in_.otherBackground : in_.background};
    }

    void beginGroup(std::string_view name);
    /// Ends the group; one without elements is left out.
    void endGroup();
    /// Adds an element.
    void add(std::string_view element);
    /// Adds outlines with attributes; those that follow each other with equal ones are one path.
    void addPath(const std::string& attributes, std::string_view data);
    /// Elements so far.
    std::size_t count() const { return count_; }
    std::string take();

  private:
    void endPath();

    const FrameShapes& in_;
    ScreenSpace screen_;
    DepthPicture depth_;
    SvgClasses& classes_;
    std::string prefix_;
    float dots_;
    std::string out_;
    std::string attributes_;  ///< Of the open path.
    std::string data_;
    std::vector<std::size_t> groups_;  ///< Where the open groups begin.
    std::vector<std::size_t> filled_;  ///< Length of the text once they are open.
    std::size_t count_ = 0;
    std::unordered_map<std::string, Index> points_;
};

/// ` class="a"`, ` class="a" fill-opacity="0.5"`.
std::string fillOf(SvgCanvas& canvas, const ColorPair& color, float alpha);
/// The same for lines of that width.
std::string strokeOf(SvgCanvas& canvas, const ColorPair& color, float alpha, float width);

/// Triangles; fills the depth picture.
void drawSvgTriangles(SvgCanvas& canvas);
void drawSvgPoints(SvgCanvas& canvas);
/// Sheets, spheres and lines, layer by layer.
void drawSvgLayers(SvgCanvas& canvas);
void drawSvgMarks(SvgCanvas& canvas);
void drawSvgLabels(SvgCanvas& canvas);
void drawSvgDial(SvgCanvas& canvas, const FrameDial& dial);

/// The shape of a point, with half the size `r`.
void drawSvgShape(SvgCanvas& canvas, Shape shape, glm::vec2 at, float r, const ColorPair& color,
                  Index point);
/// A color of the palette in the theme of the frame, and in the other.
ColorPair bothThemes(const FrameShapes& shapes, Color Palette::*color);

}  // namespace se::view
