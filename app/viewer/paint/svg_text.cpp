#include "svg_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dial_painter.h"
#include "text_cut.h"

namespace se::view {

namespace {

struct ColorClass {
    std::string_view name;
    Color Palette::*color;
};
constexpr std::array kColorClasses{
    ColorClass{"pivot", &Palette::pivot},     ColorClass{"used", &Palette::used},
    ColorClass{"first", &Palette::first},     ColorClass{"last", &Palette::last},
    ColorClass{"test", &Palette::test},       ColorClass{"rejected", &Palette::rejected},
    ColorClass{"unused", &Palette::unused},   ColorClass{"done", &Palette::done},
    ColorClass{"mesh", &Palette::mesh},       ColorClass{"mesh-edge", &Palette::meshEdge},
    ColorClass{"text", &Palette::text},       ColorClass{"text-dim", &Palette::textDim},
    ColorClass{"view", &Palette::background},
};

/// One row per SvgPaint.
struct PaintRow {
    std::string_view property;
    std::string_view suffix;  ///< Of classes named after a meaning.
    char letter;              ///< Of the others.
};
constexpr std::array kPaints{PaintRow{"fill", "", 'f'}, PaintRow{"stroke", "-line", 'l'},
                             PaintRow{"color", "-color", 'c'}};

unsigned byteOf(float share) {
    return static_cast<unsigned>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

}  // namespace

void appendPixels(std::string& out, float value) {
    const long tenths = std::lround(10.0F * std::clamp(value, -1e6F, 1e6F));
    if (tenths < 0) out += '-';
    const long size = std::labs(tenths);
    out += std::to_string(size / 10);
    if (size % 10 != 0) (out += '.') += static_cast<char>('0' + size % 10);
}

void appendPlace(std::string& out, glm::vec2 place) {
    appendPixels(out, place.x);
    out += ' ';
    appendPixels(out, place.y);
}

std::string escapedXml(std::string_view text) {
    std::string out;
    constexpr std::string_view kSigns = "&<>\"'";
    constexpr std::array<const char*, 5> kNames = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
    for (const char sign : text) {
        if (const std::size_t i = kSigns.find(sign); i < kNames.size()) {
            out += kNames[i];
        } else if (static_cast<unsigned char>(sign) >= 32 || sign == '\n' || sign == '\t') {
            // XML has no other control characters.
            out += sign;
        }
    }
    return out;
}

std::string nameOfTitle(std::string_view title) {
    std::string name;
    for (const char sign : title) {
        if (sign >= 'A' && sign <= 'Z') {
            name += static_cast<char>(sign - 'A' + 'a');
        } else if ((sign >= 'a' && sign <= 'z') || (sign >= '0' && sign <= '9')) {
            name += sign;
        } else if (!name.empty() && name.back() != '-') {
            name += '-';
        }
    }
    return name;
}

std::string hexColor(const Color& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", byteOf(color.r), byteOf(color.g), byteOf(color.b));
}

std::string svgDocument(glm::vec2 size, std::string_view title, std::string_view style,
                        std::string_view elements) {
    const std::string name = title.empty() ? "" : "<title>" + escapedXml(title) + "</title>\n";
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" {2}>\n{3}<style>{4}</style>\n{5}</svg>\n",
        size.x, size.y, kSvgLook, name, style, elements);
}

std::string SvgClasses::meaningOf(const Color& color) const {
    const Palette& palette = paletteOf(theme_);
    const std::string hex = hexColor(color);
    for (const ColorClass& each : kColorClasses) {
        if (hexColor(palette.*each.color) == hex) return std::string(each.name);
    }
    return {};
}

const std::string& SvgClasses::classOf(const Ink& color, SvgPaint paint) {
    const PaintRow& row = kPaints[static_cast<std::size_t>(paint)];
    std::string key = std::string(row.property) + hexColor(color.color);
    if (both_) key += hexColor(color.other);
    if (const auto found = known_.find(key); found != known_.end())
        return rules_[found->second].name;
    std::string name = meaningOf(color.color);
    if (!name.empty()) name += row.suffix;
    const bool taken = std::any_of(rules_.begin(), rules_.end(),
                                   [&](const Rule& each) { return each.name == name; });
    if (name.empty() || taken) name = row.letter + std::to_string(rules_.size());
    known_.emplace(std::move(key), rules_.size());
    rules_.push_back({std::move(name), color, paint});
    return rules_.back().name;
}

std::string SvgClasses::sheet(bool other, std::string_view scope) const {
    std::string text;
    for (const Rule& each : rules_) {
        text += fmt::format("{}.{}{{{}:{}}}", scope, each.name,
                            kPaints[static_cast<std::size_t>(each.paint)].property,
                            hexColor(other ? each.color.other : each.color.color));
    }
    return text;
}

namespace {

/// Size of letters and of the part above the baseline, as shares of the height of a line.
constexpr float kLetters = 0.826F;
constexpr float kBaseline = 0.8F;
/// About the mean width of a letter, as a share of the height of a line.
constexpr float kMeanLetter = 0.56F;

std::string opacityOf(const char* kind, float alpha) {
    return alpha > 0.995F ? std::string() : fmt::format(" {}-opacity=\"{:.2g}\"", kind, alpha);
}

}  // namespace

void SvgPainter::line(glm::vec2 from, glm::vec2 to, const Ink& ink) {
    std::string data = "M";
    appendPlace(data, from);
    data += 'L';
    appendPlace(data, to);
    addPath(attributesOf(ink), data);
}

void SvgPainter::polygon(std::initializer_list<glm::vec2> corners, const Ink& ink) {
    std::string data;
    for (const glm::vec2& corner : corners) {
        data += data.empty() ? 'M' : 'L';
        appendPlace(data, corner);
    }
    addOutline(ink, data + 'z');
}

void SvgPainter::box(glm::vec2 low, glm::vec2 high, const Ink& ink, float round) {
    std::string corners;
    if (round > 0.0F) corners = fmt::format(" rx=\"{:.1f}\"", round);
    add(fmt::format("<rect{}{} x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"{}/>",
                    attributesOf(ink), ink.width > 0.0F ? " fill=\"none\"" : "", low.x, low.y,
                    high.x - low.x, high.y - low.y, corners));
}

void SvgPainter::circle(glm::vec2 center, float radius, const Ink& ink) {
    // Two halves: they end where they should only if both lengths are written in full.
    const float r = std::round(100.0F * radius) / 100.0F;
    std::string data = "M";
    appendPlace(data, center - glm::vec2(r, 0.0F));
    addOutline(ink, data + fmt::format("a{0:.6g} {0:.6g} 0 1 1 {1:.6g} 0a{0:.6g} {0:.6g} 0 1 1 "
                                       "{2:.6g} 0z",
                                       r, 2.0F * r, -2.0F * r));
}

void SvgPainter::arc(glm::vec2 center, float radius, double from, double to, const Ink& ink) {
    to = std::min(to, from + 359.9);
    std::string data = "M";
    if (ink.width <= 0.0F) {
        appendPlace(data, center);
        data += 'L';
    }
    const DialCircle circle{center, radius};
    appendPlace(data, circle.at(from));
    data += fmt::format("A{0:.1f} {0:.1f} 0 {1} 0 ", radius, to - from > 180.0 ? 1 : 0);
    appendPlace(data, circle.at(to));
    if (ink.width <= 0.0F) return addOutline(ink, data + 'z');
    addPath(attributesOf(ink) + " fill=\"none\" stroke-linecap=\"butt\"", data);
}

void SvgPainter::text(glm::vec2 at, const std::string& words, const Ink& ink, const Type& type) {
    constexpr std::array kAnchors = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
    std::string length;
    if (type.length > 0.0F)
        length =
            fmt::format(" textLength=\"{:.1f}\" lengthAdjust=\"spacingAndGlyphs\"", type.length);
    add(fmt::format("<text{}{}{} x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\"{}{}>{}</text>",
                    attributesOf(ink), type.face == Typeface::Strong ? " font-weight=\"600\"" : "",
                    kAnchors[static_cast<std::size_t>(type.align)], at.x,
                    at.y + kBaseline * type.size, kLetters * type.size, length,
                    words.find("  ") != std::string::npos ? " xml:space=\"preserve\"" : "",
                    escapedXml(words)));
}

glm::vec2 SvgPainter::textSize(const std::string& words, const Type& type) const {
    const auto letters =
        std::count_if(words.begin(), words.end(), [](char byte) { return !continuesSign(byte); });
    return {kMeanLetter * type.size * static_cast<float>(letters), type.size};
}

void SvgPainter::setPoint(Index point) {
    point_ = point == kNone ? std::string() : fmt::format(" data-point=\"{}\"", point);
}

void SvgPainter::beginGroup(std::string_view name) {
    endPath();
    groups_.push_back(out_.size());
    out_ += fmt::format("<g id=\"{}{}\">", prefix_, name);
    filled_.push_back(out_.size());
}

void SvgPainter::endGroup() {
    endPath();
    if (out_.size() == filled_.back()) {
        out_.resize(groups_.back());
    } else {
        out_ += "</g>\n";
    }
    groups_.pop_back();
    filled_.pop_back();
}

void SvgPainter::add(std::string_view element) {
    endPath();
    out_ += element;
    ++count_;
}

void SvgPainter::addPath(const std::string& attributes, std::string_view data) {
    if (attributes != attributes_) endPath();
    attributes_ = attributes;
    data_ += data;
    ++count_;
}

/// The attributes that do not depend on the ink, and the classes.
std::string SvgPainter::beginOf(const std::string& classes) const {
    return point_ + more_ + " class=\"" + classes + "\"";
}

std::string SvgPainter::attributesOf(const Ink& ink) {
    if (ink.width <= 0.0F) return beginOf(classes_.fill(ink)) + opacityOf("fill", ink.color.a);
    return beginOf(classes_.line(ink)) +
           fmt::format(" stroke-width=\"{:.3g}\"{}", ink.width, opacityOf("stroke", ink.color.a));
}

std::string SvgPainter::attributesOf(const Ink& area, const Ink& edge) {
    const std::string fill = classes_.fill(area);
    return beginOf(classes_.line(edge) + " " + fill) + opacityOf("fill", area.color.a) +
           fmt::format(" stroke-width=\"{:.2g}\"{}", edge.width, opacityOf("stroke", edge.color.a));
}

void SvgPainter::addOutline(const Ink& ink, std::string_view data) {
    addPath(attributesOf(ink) + (ink.width > 0.0F ? " fill=\"none\"" : ""), data);
}

void SvgPainter::endPath() {
    if (data_.empty()) return;
    out_ += "<path" + attributes_ + " d=\"" + data_ + "\"/>";
    data_.clear();
    attributes_.clear();
}

std::string SvgPainter::take() {
    endPath();
    return std::move(out_);
}

}  // namespace se::view
