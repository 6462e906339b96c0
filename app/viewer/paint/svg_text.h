/// Pieces of SVG as text: numbers, escaped words, and colors as classes of a style sheet.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "painter.h"

namespace se::view {

/// Appends a length in pixels, with one digit after the point where it is not 0.
void appendPixels(std::string& out, float value);
/// Appends "12.3 45.6".
void appendPlace(std::string& out, glm::vec2 place);
/// Text with the signs of XML escaped, also for values of attributes.
std::string escapedXml(std::string_view text);
/// A layer's title as a name: "Edge ring" is "edge-ring".
std::string nameOfTitle(std::string_view title);
/// "#56b4e9"
std::string hexColor(const Color& color);

/// Attributes that all elements of a picture inherit.
inline constexpr std::string_view kSvgLook =
    "font-family=\"Inter, 'DejaVu Sans', sans-serif\" stroke-linecap=\"round\" "
    "stroke-linejoin=\"round\"";

/// A file of SVG. `title`: of the whole picture; empty: none.
std::string svgDocument(glm::vec2 size, std::string_view title, std::string_view style,
                        std::string_view elements);

/// What a class of a color sets.
enum class SvgPaint : std::uint8_t { Fill, Line, Current };

/// The classes of colors of a file, in the order of their first use. Colors of the palette have
/// the name of their meaning, "used"; others a number. Opacity is not a part of them.
class SvgClasses {
  public:
    /// `both`: the style sheet has the colors of the other theme, too.
    SvgClasses(Theme theme, bool both) : theme_(theme), both_(both) {}

    /// The class that fills with a color, draws lines in it, or makes it the current color.
    const std::string& fill(const Ink& color) { return classOf(color, SvgPaint::Fill); }
    const std::string& line(const Ink& color) { return classOf(color, SvgPaint::Line); }
    const std::string& current(const Ink& color) { return classOf(color, SvgPaint::Current); }
    /// The rules of all classes: of the theme, or of the other. `scope` begins each, such as
    /// "#a " for elements within that of the id a.
    std::string sheet(bool other = false, std::string_view scope = {}) const;

  private:
    struct Rule {
        std::string name;
        Ink color;
        SvgPaint paint = SvgPaint::Fill;
    };
    const std::string& classOf(const Ink& color, SvgPaint paint);
    std::string meaningOf(const Color& color) const;

    Theme theme_;
    bool both_;
    std::map<std::string, std::size_t> known_;
    std::vector<Rule> rules_;
};

// Drawings as elements of SVG: colors are classes, equal neighbors are one path.

/// Elements in the order in which they are drawn.
class SvgPainter : public Painter {
  public:
    /// `classes`: of the whole file. `prefix` begins the ids.
    SvgPainter(Theme theme, float em, SvgClasses& classes, std::string prefix)
        : Painter(paletteOf(theme), paletteOf(otherTheme(theme)), em),
          classes_(classes),
          prefix_(std::move(prefix)) {}

    using Painter::box;
    void line(glm::vec2 from, glm::vec2 to, const Ink& ink) override;
    void polygon(std::initializer_list<glm::vec2> corners, const Ink& ink) override;
    void box(glm::vec2 low, glm::vec2 high, const Ink& ink, float round = 0.0F) override;
    void circle(glm::vec2 center, float radius, const Ink& ink) override;
    void arc(glm::vec2 center, float radius, double from, double to, const Ink& ink) override;
    void text(glm::vec2 at, const std::string& words, const Ink& ink, const Type& type) override;
    /// An estimate for most fonts: the program that shows the file chooses one.
    glm::vec2 textSize(const std::string& words, const Type& type) const override;
    void setPoint(Index point) override;
    /// Attributes of all that is drawn from now on, beside that of setPoint().
    void setMore(std::string attributes) { more_ = std::move(attributes); }

    SvgClasses& classes() { return classes_; }
    const std::string& prefix() const { return prefix_; }

    void beginGroup(std::string_view name);
    /// Ends the group; one without elements is left out.
    void endGroup();
    /// Adds an element.
    void add(std::string_view element);
    /// Adds outlines with attributes; those that follow each other with equal ones are one path.
    void addPath(const std::string& attributes, std::string_view data);
    /// Class, width and opacity of an ink, as attributes.
    std::string attributesOf(const Ink& ink);
    /// Class, width and opacity of an area with an outline, as attributes.
    std::string attributesOf(const Ink& area, const Ink& edge);
    /// Elements so far.
    std::size_t count() const { return count_; }
    std::string take();

  private:
    void endPath();
    std::string beginOf(const std::string& classes) const;
    void addOutline(const Ink& ink, std::string_view data);

    SvgClasses& classes_;
    std::string prefix_;
    std::string point_;  ///< Attribute of setPoint().
    std::string more_;
    std::string out_;
    std::string attributes_;  ///< Of the open path.
    std::string data_;
    std::vector<std::size_t> groups_;  ///< Where the open groups begin.
    std::vector<std::size_t> filled_;  ///< Length of the text once they are open.
    std::size_t count_ = 0;
};

}  // namespace se::view
