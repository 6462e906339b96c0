/// Draws lines with gaps where a nearer line crosses (halos by depth, Everts et al. 2009).
#pragma once

#include <span>

#include "gl_objects.h"
#include "scene/draw_list.h"

namespace se::view {

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

}  // namespace se::view
