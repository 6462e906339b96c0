/* In the browser OpenGL ES 3 is linked, not loaded. */
#pragma once
#include <GLES3/gl3.h>
#define GLAD_MAKE_VERSION(major, minor) ((major)*10000 + (minor))
#define gladLoadGL(loader) ((void)(loader), GLAD_MAKE_VERSION(3, 3))
