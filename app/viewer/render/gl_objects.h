/// Objects of OpenGL that free themselves: a linked pair of shaders, a vertex array with its
/// buffers, and an off-screen picture.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "scene/screen_rect.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

/// A linked pair of shaders.
class Shader {
  public:
    Shader() = default;
    ~Shader();
    Shader(Shader&& other) noexcept;
    Shader& operator=(Shader&& other) noexcept;

    /// Compiles `vertexName` and `fragmentName`. They are read from `folder` unless it is empty,
    /// otherwise from the embedded ones. `defines` is inserted after the version line.
    static Result<Shader> load(const std::string& vertexName, const std::string& fragmentName,
                               const std::filesystem::path& folder = {},
                               const std::string& defines = {});

    void use() const;
    void set(const char* name, const glm::mat4& value);
    void set(const char* name, const glm::vec2& value);
    void set(const char* name, const glm::vec3& value);
    void set(const char* name, const glm::vec4& value);
    void set(const char* name, float value);
    void set(const char* name, bool value);
    void set(const char* name, int value);
    void set(const char* name, std::span<const glm::vec4> values);
    void set(const char* name, std::span<const glm::vec2> values);

  private:
    int location(const char* name);

    unsigned program_ = 0;
    std::unordered_map<std::string, int> locations_;
};

/// One vertex attribute of a batch.
struct VertexAttribute {
    unsigned location = 0;
    int components = 3;
    std::size_t offset = 0;
    bool bytes = false;  ///< Unsigned bytes read as integers; otherwise floats.
    bool signs = false;  ///< Signed bytes read as numbers from -1 to 1.
};

/// A vertex array with up to two buffers: one that seldom changes, one that often does.
class Batch {
  public:
    Batch() = default;
    ~Batch();
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    /// Describes the vertices of buffer `buffer` (0 or 1). With `perInstance`, one per instance.
    void describe(int buffer, std::size_t stride, const std::vector<VertexAttribute>& attributes,
                  bool perInstance = false);
    /// Replaces the contents of a buffer.
    void upload(int buffer, const void* data, std::size_t bytes);
    /// Grows the buffer to at least `bytes`, keeping its contents.
    void reserve(int buffer, std::size_t bytes);
    /// Replaces the bytes from `offset` on; grows the buffer, keeping what is before.
    void append(int buffer, std::size_t offset, const void* data, std::size_t bytes);
    void bind();

  private:
    unsigned array_ = 0;
    unsigned buffers_[2] = {0, 0};
    std::size_t capacity_[2] = {0, 0};
};

/// Makes a framebuffer the target of drawing, and clears all of its color and depth. To be called
/// where storage is new, which holds whatever the memory held before.
void beginNew(unsigned frame, const glm::vec4& color);

/// The samples of a buffer: `wanted`, or fewer where the graphics card has no more.
int samplesOf(int wanted);
/// A buffer of that size as a part of the bound frame.
void allocateBuffer(unsigned buffer, int samples, unsigned format, glm::ivec2 size,
                    unsigned attachment);
/// A texture of that size and format, to be read with that filter, without repetition.
void allocateTexture(unsigned texture, unsigned format, glm::ivec2 size, unsigned filter);
/// Draws go to that part of a frame of that size.
void aimAt(unsigned frame, glm::ivec2 size, const PixelRect& rect);

/// An off-screen picture with depth.
class Target {
  public:
    /// As many samples per pixel as available, up to `samples`.
    explicit Target(int samples = 4) : samples_(samples) {}
    ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    /// Resizes it to `size` pixels and makes it the target of drawing.
    void begin(glm::ivec2 size);
    /// Resolves the drawing into texture().
    void end();
    unsigned texture() const { return texture_; }

  private:
    void release();
    void allocate(glm::ivec2 size);

    int samples_;
    glm::ivec2 size_{0};
    unsigned drawn_ = 0;
    unsigned color_ = 0;
    unsigned depth_ = 0;
    unsigned resolved_ = 0;
    unsigned texture_ = 0;
    int previous_ = 0;
};

// The shaders that a scene is drawn with, compiled once for all views of a window.

struct Shaders {
    Shader mesh;
    Shader shape;  ///< Points with their shapes, over the shaded surfaces.
    Shader dot;    ///< Points too close together for shapes, shaded as surfaces are.
    Shader line;
    Shader shell;  ///< Spheres.
    Shader sprite;
    Shader occlusion;
    Shader relief;   ///< Outlines and occlusion.
    Shader outline;  ///< Outlines alone.

    /// Compiles them; from `folder` unless it is empty. Call with a current OpenGL context.
    static Result<std::shared_ptr<Shaders>> load(const std::filesystem::path& folder);
};

}  // namespace se::view
