#include "context.h"

#include <glad/gl.h>

namespace se::view {

Status loadGl(GlFunctionLoader loader) {
    const int version = gladLoadGL(loader);
    if (version < GLAD_MAKE_VERSION(3, 3)) return Error{"OpenGL 3.3 is not available."};
    return success();
}

void clearFrame(glm::ivec2 size, const Color& color) {
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(color.r, color.g, color.b, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

void finishGl() { glFinish(); }

std::string glDescription() {
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return value == nullptr ? std::string("?")
                                : std::string(reinterpret_cast<const char*>(value));
    };
    return "OpenGL " + text(GL_VERSION) + " on " + text(GL_RENDERER);
}

}  // namespace se::view
