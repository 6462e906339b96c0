#include "context.h"

#include <glad/gl.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "gl_dialect.h"
#include "spiraling_edge/base/atomic_file.h"

namespace se::view {

Status loadGl(GlFunctionLoader loader) {
    const int version = gladLoadGL(loader);
    if (version < GLAD_MAKE_VERSION(3, 3)) return Error{"OpenGL 3.3 is not available."};
    return success();
}

const char* shaderVersion() { return kShaderVersion; }

int greatestPicture() {
    GLint texture = 0;
    GLint buffer = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
    GLint viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    return std::min({texture, buffer, viewport[0], viewport[1]});
}

void clearFrame(glm::ivec2 size, const Color& color) {
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(color.r, color.g, color.b, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

void finishGl() { glFinish(); }

Picture readPicture(glm::ivec2 size) {
    Picture picture{size, {}};
    picture.rgba.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    return picture;
}

namespace {

/// Level of compression: drawings have large even areas, which higher levels hardly make smaller.
constexpr int kPngLevel = 5;

bool isOpaque(const Picture& picture) {
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
        if (picture.rgba[i] != 255) return false;
    }
    return true;
}

std::vector<std::uint8_t> withoutAlpha(const Picture& picture) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        rgb.insert(rgb.end(), &picture.rgba[i], &picture.rgba[i] + 3);
    return rgb;
}

}  // namespace

Status writePicture(const std::filesystem::path& path, const Picture& picture) {
    const glm::ivec2 size = picture.size;
    std::string bytes;
    const bool opaque = isOpaque(picture);
    const std::vector<std::uint8_t> pixels = opaque ? withoutAlpha(picture) : picture.rgba;
    const int channels = opaque ? 3 : 4;
    const auto collect = [](void* context, void* data, int count) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                                   static_cast<std::size_t>(count));
    };
    stbi_flip_vertically_on_write(1);
    stbi_write_png_compression_level = kPngLevel;
    if (stbi_write_png_to_func(collect, &bytes, size.x, size.y, channels, pixels.data(),
                               size.x * channels) == 0) {
        return Error{"Cannot make a PNG of " + path.string() + "."};
    }
    return writeFileAtomically(path, bytes);
}

}  // namespace se::view
