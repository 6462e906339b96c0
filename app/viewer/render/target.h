/// An off-screen picture with depth.
#pragma once

#include <glm/vec2.hpp>

namespace se::view {

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

}  // namespace se::view
