/// An input as it stands on the command line: a file, `-` or scene:ID.
#pragma once

#include <string>

#include "spiraling_edge/io.h"

namespace se::cli {

/// Reads it. Throws Failure(Input) if it is missing or malformed.
PointFile readInput(const std::string& input);

}  // namespace se::cli
