/// A frame as elements of SVG.
#pragma once

#include <string>
#include <string_view>

#include "frame.h"
#include "paint/svg_text.h"

namespace se::view {

/// Number of shapes above which a picture of pixels is smaller and faster.
inline constexpr std::size_t kMaxShapes = 50'000;

/// Attributes that all elements of a picture inherit.
inline constexpr std::string_view kSvgLook =
    "font-family=\"Inter, 'DejaVu Sans', sans-serif\" stroke-linecap=\"round\" "
    "stroke-linejoin=\"round\"";

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
