/// What differs between OpenGL 3.3 core and OpenGL ES 3.0, which browsers have. All else that this
/// program calls is in both.
#pragma once

#include <glad/gl.h>

namespace se::view {

#ifdef GL_ES_VERSION_3_0
/// First lines of every shader.
inline constexpr const char* kShaderHeader =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
inline constexpr const char* kShaderVersion = "#version 300 es";
/// Lets shaders set the size of points: they always do.
inline void enablePointSize() {}
inline void disablePointSize() {}
#else
inline constexpr const char* kShaderHeader = "#version 330 core\n";
inline constexpr const char* kShaderVersion = "#version 330 core";
inline void enablePointSize() { glEnable(GL_PROGRAM_POINT_SIZE); }
inline void disablePointSize() { glDisable(GL_PROGRAM_POINT_SIZE); }
#endif

}  // namespace se::view
