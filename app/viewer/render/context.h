/// The few OpenGL calls that the window and the off-screen picture need themselves.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>

#include "scene/palette.h"
#include "scene/picture.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

using GlFunction = void (*)();
using GlFunctionLoader = GlFunction (*)(const char* name);

/// Loads the functions of the current context. Fails if it is older than 3.3.
Status loadGl(GlFunctionLoader loader);
/// The line "#version ..." of its shaders.
const char* shaderVersion();
/// Pixels that a picture of the current context can have in each direction.
int greatestPicture();
/// Fills the bound framebuffer of `size` pixels with a color.
void clearFrame(glm::ivec2 size, const Color& color);
/// Waits until all OpenGL commands are complete.
void finishGl();

/// Reads `size` pixels of the bound framebuffer, as opaque.
Picture readPicture(glm::ivec2 size);
/// Writes a PNG.
Status writePicture(const std::filesystem::path& path, const Picture& picture);

}  // namespace se::view
