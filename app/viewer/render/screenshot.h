/// Saves the content of the current framebuffer.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>

#include "spiraling_edge/base/result.h"

namespace se::view {

/// Reads `size` pixels of the bound framebuffer and writes them as PNG.
Status saveScreenshot(const std::filesystem::path& path, glm::ivec2 size);

}  // namespace se::view
