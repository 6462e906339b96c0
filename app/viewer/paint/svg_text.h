/// Pieces of SVG as text: numbers, escaped words, and colors as classes of a style sheet.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <string_view>
#include <utility>
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
    /// The rules of all classes: of the theme, or of the other.
    std::string sheet(bool other = false) const;

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

}  // namespace se::view
