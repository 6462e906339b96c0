// Answers to what Dear ImGui asks of the context in order to put it back after it has drawn. The
// context itself answers only after all that was drawn before is done, and shaders are compiled:
// each question would stop the page. Our renderer sets what it needs before it draws, so defaults
// are put back.
#include <GLES3/gl3.h>
#include <emscripten/html5.h>

extern "C" void pageGetIntegerv(GLenum name, GLint* values) {
    switch (name) {
        case GL_VIEWPORT:
        case GL_SCISSOR_BOX:
            values[0] = values[1] = 0;
            emscripten_get_canvas_element_size("#canvas", &values[2], &values[3]);
            return;
        case GL_ACTIVE_TEXTURE:
            *values = GL_TEXTURE0;
            return;
        case GL_BLEND_SRC_RGB:
        case GL_BLEND_SRC_ALPHA:
            *values = GL_ONE;
            return;
        case GL_BLEND_EQUATION_RGB:
        case GL_BLEND_EQUATION_ALPHA:
            *values = GL_FUNC_ADD;
            return;
        case GL_BLEND_DST_RGB:
        case GL_BLEND_DST_ALPHA:
        case GL_CURRENT_PROGRAM:
        case GL_TEXTURE_BINDING_2D:
        case GL_SAMPLER_BINDING:
        case GL_ARRAY_BUFFER_BINDING:
        case GL_VERTEX_ARRAY_BINDING:
            *values = 0;
            return;
        default:
            glGetIntegerv(name, values);
    }
}
