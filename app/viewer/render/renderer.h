/// Draws a DrawList into a picture of its own, which the window then shows.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>

#include "gl_objects.h"
#include "kept_picture.h"
#include "line_pass.h"
#include "relief.h"
#include "scene/camera.h"
#include "scene/draw_list.h"
#include "shaders.h"
#include "surface.h"

namespace se::view {

class Renderer {
  public:
    /// Call with a current OpenGL context.
    explicit Renderer(std::shared_ptr<Shaders> shaders);

    /// The triangles and points to draw.
    Surface& surface() { return surface_; }

    /// Draws. Sizes follow the distance of the points on the screen within limits. The result is
    /// texture(). Only what differs from the last picture is drawn. Of the view, `rect` and `dots`
    /// are found here.
    void draw(const DrawList& list, SurfaceView view, Finish finish);
    /// Makes a picture of that size of the background alone, for as long as draw() is not called.
    void drawNothing(glm::ivec2 size, const Color& background);
    /// The last picture drawn, for ImGui::Image (upside down, as in OpenGL). Always this name.
    unsigned texture() const { return picture_.texture(); }

  private:
    void keep(const DrawList& list, SurfaceView view, Finish finish);
    void drawLines(const DrawList& list, const CameraMatrices& camera);
    void drawSheets(const DrawList& list, const CameraMatrices& camera);
    void drawSpheres(const DrawList& list, const CameraMatrices& camera);
    void drawSprites(const DrawList& list, const CameraMatrices& camera, const Color& background);

    std::shared_ptr<Shaders> shaders_;
    Surface surface_;
    Relief relief_;
    LinePass lines_;
    KeptPicture picture_;
    SurfaceView kept_;               ///< View of the kept surfaces.
    Finish finish_ = Finish::Quick;  ///< Finish of them.
    Batch sprites_;
    Batch shell_;
    std::size_t shellVertices_ = 0;
    float em_ = 16.0F;
    float markZoom_ = 1.0F;
    glm::vec2 size_{1.0F};
};

}  // namespace se::view
