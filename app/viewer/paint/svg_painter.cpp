#include "svg_painter.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

namespace se::view {

namespace {

/// Size of letters and of the part above the baseline, as shares of the height of a line.
constexpr float kLetters = 0.826F;
constexpr float kBaseline = 0.8F;
/// About the mean width of a letter, as a share of the height of a line.
constexpr float kMeanLetter = 0.56F;

std::string opacityOf(const char* kind, float alpha) {
    return alpha > 0.995F ? std::string() : fmt::format(" {}-opacity=\"{:.2g}\"", kind, alpha);
}

glm::vec2 onCircle(glm::vec2 center, float radius, double degrees) {
    const float a = glm::radians(static_cast<float>(degrees));
    return center + radius * glm::vec2(std::cos(a), -std::sin(a));
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
    appendPlace(data, onCircle(center, radius, from));
    data += fmt::format("A{0:.1f} {0:.1f} 0 {1} 0 ", radius, to - from > 180.0 ? 1 : 0);
    appendPlace(data, onCircle(center, radius, to));
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
    return {kMeanLetter * type.size * static_cast<float>(words.size()), type.size};
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
