/// Draws a DrawList into a picture of its own, which the window then shows.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>

#include "gl_objects.h"
#include "kept_picture.h"
#include "relief.h"
#include "scene/camera.h"
#include "scene/draw_list.h"
#include "surface.h"

namespace se::view {

// Draws lines with gaps where a nearer line crosses (halos by depth, Everts et al. 2009).

/// Sizes that lines are drawn with.
struct LineSizes {
    float em = 16.0F;       ///< Pixels.
    float zoom = 1.0F;      ///< Of widths and arrow heads.
    float bias = 0.0F;      ///< Distance by which lines are moved toward the eye, view units.
    float haloBias = 0.0F;  ///< That of the halos, less: lines that are nearly as near stay whole.
};

class LinePass {
  public:
    explicit LinePass(Shader& shader) : shader_(shader) {}

    /// The shader, whose camera has to be set before draw().
    Shader& shader() { return shader_; }
    /// Draws into the present target, whose depth is that of the mesh; it is lost.
    void draw(std::span<const Line> lines, const LineSizes& sizes);

  private:
    enum class Part { Lines, Halos };
    /// Makes this line of the upload the first that is drawn.
    void describeFrom(std::size_t first);
    /// Draws lines of the upload, from `first` up to `last`.
    void drawRange(std::size_t first, std::size_t last, Part part);

    Shader& shader_;
    Batch batch_;
    LineSizes sizes_;
};

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
