/// Shading by depth alone: outlines and the relief of surfaces and solid points (eye-dome
/// lighting), and ambient occlusion of surfaces.
#pragma once

#include "gl_objects.h"
#include "kept_picture.h"
#include "scene/camera.h"

namespace se::view {

class Relief {
  public:
    explicit Relief(Shaders& shaders) : shaders_(shaders) {}
    ~Relief();
    Relief(const Relief&) = delete;
    Relief& operator=(const Relief&) = delete;

    /// Pixels by which a change of the surfaces reaches beyond them. `em` in pixels.
    static int reach(float em);
    /// Finds the ambient occlusion of the surfaces in `rect`, which takes several times as long as
    /// shade().
    void findOcclusion(const KeptPicture& picture, const PixelRect& rect,
                       const CameraMatrices& camera, float em);
    /// Fills the kept color in `rect` from the surfaces. `full`: with the occlusion found, and from
    /// all neighbors of a pixel; otherwise outlines alone, in a fraction of the time.
    void shade(KeptPicture& picture, const PixelRect& rect, const CameraMatrices& camera, float em,
               bool full);

  private:
    void useDepth(Shader& shader, const KeptPicture& picture, const CameraMatrices& camera);
    void allocate(glm::ivec2 size);
    void release();

    Shaders& shaders_;
    Batch nothing_;  ///< Vertices are made in the shader.
    glm::ivec2 size_{0};
    unsigned frame_ = 0;
    unsigned texture_ = 0;  ///< Occlusion, at half the size.
};

}  // namespace se::view
