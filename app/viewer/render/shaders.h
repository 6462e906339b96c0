/// The shaders that a scene is drawn with, compiled once for all views of a window.
#pragma once

#include <filesystem>
#include <memory>

#include "gl_objects.h"

namespace se::view {

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
