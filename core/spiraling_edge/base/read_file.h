/// Reads whole files into memory.
#pragma once

#include <filesystem>
#include <string>

#include "spiraling_edge/base/result.h"

namespace se {

/// All bytes of a file or pipe.
Result<std::string> readBytes(const std::filesystem::path& path);

}  // namespace se
