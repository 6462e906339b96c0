/// The shaders and texts of the program, put into it by the build (embed.cmake).
#pragma once

#include <string_view>

namespace se::view {

/// The contents of an embedded file by its name without folder, such as "line.vert"; empty if there
/// is none of that name.
std::string_view embeddedFile(std::string_view name);

}  // namespace se::view
