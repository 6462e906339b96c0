/// Numbers and boxes as text, independent of the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "spiraling_edge/walls.h"

namespace se::view {

/// The shortest text that reads back as the same number.
std::string exact(double value);
/// Parses one finite number; the whole text must match.
std::optional<double> numberFromText(std::string_view text);
/// Parses digits; the whole text must match.
std::optional<std::uint64_t> wholeFromText(std::string_view text);

/// "x0,y0,z0,x1,y1,z1", with the character `between` instead of the commas.
std::string boxText(const WallBox& box, char between);
/// Six numbers, the lower corner first.
std::optional<WallBox> boxFromText(std::string_view text, char between);

}  // namespace se::view
