#include "svg_canvas.h"

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

}  // namespace

SvgCanvas::SvgCanvas(const FrameShapes& shapes, SvgClasses& classes, std::string prefix)
    : SvgPainter(shapes.theme, shapes.em, classes, std::move(prefix)),
      in_(shapes),
      screen_(shapes.camera, shapes.size),
      depth_(shapes.size),
      dots_(spacingInPixels(shapes.camera, shapes.size.y, shapes.model.spacing)) {
    for (std::size_t p = 0; p < shapes.model.place.size(); ++p)
        points_.emplace(bytesOf(shapes.model.place[p]), static_cast<Index>(p));
}

float SvgCanvas::markZoom() const { return std::clamp(dots_ / em() / 1.5F, 0.72F, 1.15F); }

Index SvgCanvas::pointAt(const glm::vec3& position) const {
    const auto found = points_.find(bytesOf(position));
    return found == points_.end() ? kNone : found->second;
}

}  // namespace se::view
