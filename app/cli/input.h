/// An input as given on the command line: a file, `-` or scene:ID.
#pragma once

#include <string>
#include <string_view>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/points/point_file.h"

namespace se::cli {

inline constexpr std::string_view kStandardInput = "-";

/// Name of the input in messages: "standard input" for -.
std::string nameOfInput(const std::string& input);

/// Reads it. Throws Failure(Input) if it is missing or malformed.
PointFile readInput(const std::string& input, const ByteLimit& limit);

}  // namespace se::cli
