/// Numbers and boxes as text, whatever the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "spiraling_edge/points/wall_types.h"

namespace se::view {

/// The shortest text that reads back as the same number.
std::string exact(double value);
/// The whole text must be one finite number.
std::optional<double> numberFromText(std::string_view text);
/// The whole text must be digits.
std::optional<std::uint64_t> wholeFromText(std::string_view text);

/// "x0,y0,z0,x1,y1,z1", with the sign `between` in place of the commas.
std::string boxText(const WallBox& box, char between);
/// Six numbers, the lower corner first.
std::optional<WallBox> boxFromText(std::string_view text, char between);

}  // namespace se::view
