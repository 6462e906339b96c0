/// The shader files of shaders/, embedded by the build.
#pragma once

#include <span>
#include <string_view>

namespace se::view {

struct ShaderSource {
    std::string_view name;  ///< "line.vert"
    std::string_view text;
};

std::span<const ShaderSource> embeddedShaders();

}  // namespace se::view
