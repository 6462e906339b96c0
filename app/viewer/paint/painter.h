/// Drawing in the plane, with one backend for the screen (panels/widgets/screen_painter.h) and one
/// for files (svg_text.h). Places and lengths are in pixels, y down.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <string>

#include "layout/panel_rects.h"
#include "scene/palette.h"
#include "spiraling_edge/base/types.h"

namespace se::view {

/// The color of an area, or of a line with its width.
struct Ink {
    explicit Ink(const Color& inBoth) : Ink(inBoth, inBoth) {}
    Ink(const Color& inOne, const Color& inOther) : color(inOne), other(inOther) {}

    Ink withAlpha(float alpha) const {
        Ink faint = *this;
        faint.color.a = faint.other.a = alpha;
        return faint;
    }
    /// This color for a line of that width; 0: for an area.
    Ink line(float pixels) const {
        Ink line = *this;
        line.width = pixels;
        return line;
    }

    Color color;
    Color other;  ///< In the other theme, for pictures that have both.
    float width = 0.0F;
};

enum class Typeface : std::uint8_t { Text, Strong, Small, Caption };
/// The part of a text that is at its place.
enum class Align : std::uint8_t { Left, Middle, Right };

/// The look of a text of one line.
struct Type {
    float size = 16.0F;  ///< Height of the line.
    Typeface face = Typeface::Text;
    Align align = Align::Left;
    float length = 0.0F;  ///< Of the text, where it has been measured already; else 0.
};

/// A picture that is drawn on.
class Painter {
  public:
    Painter(const Palette& colors, const Palette& other, float em)
        : colors_(colors), other_(other), em_(em) {}
    virtual ~Painter() = default;
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    /// Height of a line of text.
    float em() const { return em_; }
    /// Width of a line of that many em, which can be seen.
    float px(float ems) const { return std::max(1.0F, ems * em_); }
    Ink ink(Color Palette::*color, float alpha = 1.0F) const {
        return Ink(colors_.*color, other_.*color).withAlpha(alpha);
    }

    /// A line whose ends reach half its width farther, as those of shapes do.
    virtual void line(glm::vec2 from, glm::vec2 to, const Ink& ink) = 0;
    /// A convex polygon, clockwise.
    virtual void polygon(std::initializer_list<glm::vec2> corners, const Ink& ink) = 0;
    /// A box from its upper left to its lower right corner; `round`: radius of its corners.
    virtual void box(glm::vec2 low, glm::vec2 high, const Ink& ink, float round = 0.0F) = 0;
    virtual void circle(glm::vec2 center, float radius, const Ink& ink) = 0;
    /// A sector, or the line of its arc: degrees counterclockwise, 0 to the right, from < to.
    virtual void arc(glm::vec2 center, float radius, double from, double to, const Ink& ink) = 0;
    /// A text whose upper edge is at `at`.
    virtual void text(glm::vec2 at, const std::string& words, const Ink& ink, const Type& type) = 0;
    virtual glm::vec2 textSize(const std::string& words, const Type& type) const = 0;
    /// The point of the input that stands for what is drawn from now on; kNone: none.
    virtual void setPoint(Index /*point*/) {}

    void box(const Rect& rect, const Ink& ink, float round = 0.0F) {
        box(rect.min, rect.max(), ink, round);
    }

  private:
    const Palette& colors_;
    const Palette& other_;
    float em_;
};

// Where a label of a view is drawn.

/// One label of a view where it is drawn, in pixels of the window.
struct DrawnLabel {
    std::size_t index = 0;  ///< Into the labels of the draw list.
    glm::vec2 at{0.0F};     ///< The labeled point.
    Rect plate;             ///< Behind the text.
    glm::vec2 text{0.0F};   ///< Upper left corner of the text.
    Type type;
    bool leader = false;  ///< A line leads from `at` to the plate.

    DrawnLabel movedBy(glm::vec2 way) const {
        return {index, at + way, {plate.min + way, plate.size}, text + way, type, leader};
    }
};

}  // namespace se::view
