/// A picture without a window and without a display, by EGL with no surface.
#pragma once

#include <glm/vec2.hpp>
#include <memory>

#include "render/gl_objects.h"
#include "scene/picture.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

class Offscreen {
  public:
    static Result<std::unique_ptr<Offscreen>> create(glm::ivec2 size);
    ~Offscreen();
    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;

    glm::ivec2 size() const { return size_; }
    /// Makes the picture the target of drawing.
    void beginFrame() { target_->begin(size_); }
    /// The content of the target.
    Picture read() const;

  private:
    Offscreen() = default;
    Status makeContext();

    glm::ivec2 size_{1};
    void* display_ = nullptr;
    void* context_ = nullptr;
    std::unique_ptr<Target> target_;
};

}  // namespace se::view
