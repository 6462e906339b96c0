// The part of GLFW that the window and Dear ImGui's backend call, on the canvas of a page, so that
// window.cpp is built unchanged. page/input.js listens to the page and calls the functions at the
// end, which take pixels of the screen, numbers of GLFW's keys and buttons, and its bits of
// modifiers.
#include <GLFW/glfw3.h>
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include <cstdint>
#include <string>
#include <vector>

/// The only window: the state that the page last reported, and the callbacks.
struct GLFWwindow {
    int width = 1280;
    int height = 800;
    double ratio = 1.0;
    double x = -1e9;  ///< The pointer: nowhere before its first move.
    double y = -1e9;
    bool focused = true;
    bool full = false;  ///< The page fills the screen, or has asked for it.
    bool buttons[8] = {};
    void* user = nullptr;
    std::string clipboard;
    GLFWkeyfun key = nullptr;
    GLFWcharmodsfun character = nullptr;
    GLFWmousebuttonfun button = nullptr;
    GLFWcursorposfun pointer = nullptr;
    GLFWscrollfun scroll = nullptr;
    GLFWdropfun drop = nullptr;
    GLFWframebuffersizefun size = nullptr;
    GLFWwindowfocusfun focus = nullptr;
    GLFWwindowcontentscalefun scale = nullptr;
};

namespace {

GLFWwindow* theWindow() {
    static GLFWwindow window;
    return &window;
}

template <typename Function>
Function exchanged(Function& kept, Function given) {
    const Function before = kept;
    kept = given;
    return before;
}

}  // namespace

extern "C" {

int glfwInit() { return GLFW_TRUE; }
void glfwTerminate() {}
void glfwWindowHint(int, int) {}
GLFWerrorfun glfwSetErrorCallback(GLFWerrorfun) { return nullptr; }

GLFWwindow* glfwCreateWindow(int, int, const char*, GLFWmonitor*, GLFWwindow*) {
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = EM_FALSE;
    wanted.antialias = EM_FALSE;
    // A frame that equals the one before is not drawn, and has to stay.
    wanted.preserveDrawingBuffer = EM_TRUE;
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context =
        emscripten_webgl_create_context("#canvas", &wanted);
    if (context <= 0 || emscripten_webgl_make_context_current(context) != EMSCRIPTEN_RESULT_SUCCESS)
        return nullptr;
    EM_ASM({ Module.sendSize(); });
    return theWindow();
}
void glfwDestroyWindow(GLFWwindow*) {}
void glfwMakeContextCurrent(GLFWwindow*) {}
GLFWglproc glfwGetProcAddress(const char*) { return nullptr; }
void glfwSwapInterval(int) {}
void glfwSwapBuffers(GLFWwindow*) {}
void glfwShowWindow(GLFWwindow*) {}
void glfwSetWindowSizeLimits(GLFWwindow*, int, int, int, int) {}
void glfwSetWindowTitle(GLFWwindow*, const char* title) {
    EM_ASM({ document.title = UTF8ToString($0); }, title);
}
int glfwWindowShouldClose(GLFWwindow*) { return GLFW_FALSE; }
void glfwSetWindowShouldClose(GLFWwindow*, int) {}
void glfwSetWindowUserPointer(GLFWwindow* window, void* user) { window->user = user; }
void* glfwGetWindowUserPointer(GLFWwindow* window) { return window->user; }
int glfwGetWindowAttrib(GLFWwindow* window, int attribute) {
    return attribute == GLFW_FOCUSED && window->focused ? GLFW_TRUE : GLFW_FALSE;
}
void glfwGetWindowSize(GLFWwindow* window, int* width, int* height) {
    *width = window->width;
    *height = window->height;
}
void glfwGetFramebufferSize(GLFWwindow* window, int* width, int* height) {
    glfwGetWindowSize(window, width, height);
}
void glfwGetWindowPos(GLFWwindow*, int* x, int* y) { *x = *y = 0; }
void glfwGetWindowContentScale(GLFWwindow* window, float* x, float* y) {
    *x = *y = static_cast<float>(window->ratio);
}

// The screen: a page may ask to fill it.
GLFWmonitor* glfwGetPrimaryMonitor() { return reinterpret_cast<GLFWmonitor*>(theWindow()); }
GLFWmonitor* glfwGetWindowMonitor(GLFWwindow* window) {
    return window->full ? glfwGetPrimaryMonitor() : nullptr;
}
const GLFWvidmode* glfwGetVideoMode(GLFWmonitor*) {
    static constexpr GLFWvidmode kAny{};
    return &kAny;
}
void glfwSetWindowMonitor(GLFWwindow* window, GLFWmonitor* monitor, int, int, int, int, int) {
    window->full = monitor != nullptr;
    EM_ASM({ Module.setFullScreen($0); }, window->full);
}
GLFWmonitorfun glfwSetMonitorCallback(GLFWmonitorfun) { return nullptr; }

const float* glfwGetJoystickAxes(int, int* count) { return *count = 0, nullptr; }
const unsigned char* glfwGetJoystickButtons(int, int* count) { return *count = 0, nullptr; }

double glfwGetTime() { return 1e-3 * emscripten_get_now(); }
void glfwPollEvents() {}
void glfwWaitEventsTimeout(double) {}  // the page calls again

void glfwGetCursorPos(GLFWwindow* window, double* x, double* y) {
    *x = window->x;
    *y = window->y;
}
void glfwSetCursorPos(GLFWwindow*, double, double) {}
int glfwGetMouseButton(GLFWwindow* window, int button) {
    return window->buttons[button & 7] ? GLFW_PRESS : GLFW_RELEASE;
}
int glfwGetInputMode(GLFWwindow*, int) { return GLFW_CURSOR_NORMAL; }
void glfwSetInputMode(GLFWwindow*, int, int) {}
const char* glfwGetKeyName(int, int) { return nullptr; }  // input.js sends keys by their labels
GLFWcursor* glfwCreateStandardCursor(int shape) {
    return reinterpret_cast<GLFWcursor*>(static_cast<std::uintptr_t>(shape));
}
void glfwDestroyCursor(GLFWcursor*) {}
void glfwSetCursor(GLFWwindow*, GLFWcursor* cursor) {
    EM_ASM({ Module.setCursor($0); }, static_cast<int>(reinterpret_cast<std::uintptr_t>(cursor)));
}
const char* glfwGetClipboardString(GLFWwindow*) { return theWindow()->clipboard.c_str(); }
void glfwSetClipboardString(GLFWwindow*, const char* text) {
    theWindow()->clipboard = text;
    EM_ASM({ Module.copied(UTF8ToString($0)); }, text);
}

GLFWkeyfun glfwSetKeyCallback(GLFWwindow* w, GLFWkeyfun f) { return exchanged(w->key, f); }
GLFWcharfun glfwSetCharCallback(GLFWwindow*, GLFWcharfun) { return nullptr; }
GLFWcharmodsfun glfwSetCharModsCallback(GLFWwindow* w, GLFWcharmodsfun f) {
    return exchanged(w->character, f);
}
GLFWmousebuttonfun glfwSetMouseButtonCallback(GLFWwindow* w, GLFWmousebuttonfun f) {
    return exchanged(w->button, f);
}
GLFWcursorposfun glfwSetCursorPosCallback(GLFWwindow* w, GLFWcursorposfun f) {
    return exchanged(w->pointer, f);
}
GLFWcursorenterfun glfwSetCursorEnterCallback(GLFWwindow*, GLFWcursorenterfun) { return nullptr; }
GLFWscrollfun glfwSetScrollCallback(GLFWwindow* w, GLFWscrollfun f) {
    return exchanged(w->scroll, f);
}
GLFWdropfun glfwSetDropCallback(GLFWwindow* w, GLFWdropfun f) { return exchanged(w->drop, f); }
GLFWframebuffersizefun glfwSetFramebufferSizeCallback(GLFWwindow* w, GLFWframebuffersizefun f) {
    return exchanged(w->size, f);
}
GLFWwindowrefreshfun glfwSetWindowRefreshCallback(GLFWwindow*, GLFWwindowrefreshfun) {
    return nullptr;
}
GLFWwindowfocusfun glfwSetWindowFocusCallback(GLFWwindow* w, GLFWwindowfocusfun f) {
    return exchanged(w->focus, f);
}
GLFWwindowcontentscalefun glfwSetWindowContentScaleCallback(GLFWwindow* w,
                                                            GLFWwindowcontentscalefun f) {
    return exchanged(w->scale, f);
}

// Called by page/input.js.

EMSCRIPTEN_KEEPALIVE void webSize(int width, int height, double ratio) {
    GLFWwindow* const w = theWindow();
    const bool rescaled = w->ratio != ratio;
    w->width = width;
    w->height = height;
    w->ratio = ratio;
    if (rescaled && w->scale) w->scale(w, static_cast<float>(ratio), static_cast<float>(ratio));
    if (w->size) w->size(w, width, height);
}
EMSCRIPTEN_KEEPALIVE void webKey(int key, int action, int mods) {
    GLFWwindow* const w = theWindow();
    if (w->key) w->key(w, key, 0, action, mods);
}
EMSCRIPTEN_KEEPALIVE void webCharacter(unsigned character, int mods) {
    GLFWwindow* const w = theWindow();
    if (w->character) w->character(w, character, mods);
}
EMSCRIPTEN_KEEPALIVE void webPointer(double x, double y) {
    GLFWwindow* const w = theWindow();
    w->x = x;
    w->y = y;
    if (w->pointer) w->pointer(w, x, y);
}
EMSCRIPTEN_KEEPALIVE void webButton(int button, int action, int mods) {
    GLFWwindow* const w = theWindow();
    w->buttons[button & 7] = action == GLFW_PRESS;
    if (w->button) w->button(w, button, action, mods);
}
EMSCRIPTEN_KEEPALIVE void webWheel(double x, double y) {
    GLFWwindow* const w = theWindow();
    if (w->scroll) w->scroll(w, x, y);
}
EMSCRIPTEN_KEEPALIVE void webFocus(int focused) {
    GLFWwindow* const w = theWindow();
    w->focused = focused != 0;
    if (w->focus) w->focus(w, focused);
}
/// Takes over that the page has entered or left full screen.
EMSCRIPTEN_KEEPALIVE void webMonitor(int full) { theWindow()->full = full != 0; }
EMSCRIPTEN_KEEPALIVE void webPasted(const char* text) { theWindow()->clipboard = text; }
/// Paths in the file system of the page, one a line.
EMSCRIPTEN_KEEPALIVE void webDropped(const char* lines) {
    std::vector<std::string> paths(1);
    for (const char* c = lines; *c != 0; ++c)
        if (*c == '\n')
            paths.emplace_back();
        else
            paths.back() += *c;
    std::vector<const char*> texts;
    for (const std::string& path : paths) texts.push_back(path.c_str());
    GLFWwindow* const w = theWindow();
    if (w->drop) w->drop(w, static_cast<int>(texts.size()), texts.data());
}
}
