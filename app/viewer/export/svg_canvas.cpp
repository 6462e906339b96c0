#include "svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "scene/detail.h"

namespace se::view {

namespace {

/// The bytes of a position: equal ones are the same point.
std::string bytesOf(const glm::vec3& position) {
    std::string bytes(sizeof(position), '\0');
    std::memcpy(bytes.data(), &position, sizeof(position));
    return bytes;
}

std::string opacityOf(const char* kind, float alpha) {
    return alpha > 0.995F ? std::string() : fmt::format(" {}-opacity=\"{:.2g}\"", kind, alpha);
}

}  // namespace

SvgCanvas::SvgCanvas(const FrameShapes& shapes, SvgClasses& classes, std::string prefix)
    : in_(shapes),
      screen_(shapes.camera, shapes.size),
      depth_(shapes.size),
      classes_(classes),
      prefix_(std::move(prefix)),
      dots_(spacingInPixels(shapes.camera, shapes.size.y, shapes.model.spacing)) {
    for (std::size_t p = 0; p < shapes.model.place.size(); ++p)
        points_.emplace(bytesOf(shapes.model.place[p]), static_cast<Index>(p));
}

float SvgCanvas::markZoom() const { return std::clamp(dots_ / em() / 1.5F, 0.72F, 1.15F); }

Index SvgCanvas::pointAt(const glm::vec3& position) const {
    const auto found = points_.find(bytesOf(position));
    return found == points_.end() ? kNone : found->second;
}

void SvgCanvas::beginGroup(std::string_view name) {
    endPath();
    groups_.push_back(out_.size());
    out_ += fmt::format("<g id=\"{}{}\">", prefix_, name);
    filled_.push_back(out_.size());
}

void SvgCanvas::endGroup() {
    endPath();
    if (out_.size() == filled_.back()) {
        out_.resize(groups_.back());
    } else {
        out_ += "</g>\n";
    }
    groups_.pop_back();
    filled_.pop_back();
}

void SvgCanvas::add(std::string_view element) {
    endPath();
    out_ += element;
    ++count_;
}

void SvgCanvas::addPath(const std::string& attributes, std::string_view data) {
    if (attributes != attributes_) endPath();
    attributes_ = attributes;
    data_ += data;
    ++count_;
}

void SvgCanvas::endPath() {
    if (data_.empty()) return;
    out_ += "<path" + attributes_ + " d=\"" + data_ + "\"/>";
    data_.clear();
    attributes_.clear();
}

std::string SvgCanvas::take() {
    endPath();
    return std::move(out_);
}

ColorPair bothThemes(const FrameShapes& shapes, Color Palette::*color) {
    return {paletteOf(shapes.theme).*color, paletteOf(otherTheme(shapes.theme)).*color};
}

std::string fillOf(SvgCanvas& canvas, const ColorPair& color, float alpha) {
    return " class=\"" + canvas.classes().fill(color) + "\"" + opacityOf("fill", alpha);
}

std::string strokeOf(SvgCanvas& canvas, const ColorPair& color, float alpha, float width) {
    return " class=\"" + canvas.classes().line(color) +
           fmt::format("\" stroke-width=\"{:.3g}\"", width) + opacityOf("stroke", alpha);
}

}  // namespace se::view
