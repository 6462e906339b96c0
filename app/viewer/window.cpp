// A turn of the loop sleeps in glfwWaitEventsTimeout() unless something happened (wake_ counts the
// frames that are still to draw) or the picture is animated. It polls the results of threads at
// that interval, and draws only if there is something new.
#include "window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <utility>

#include "application.h"
#include "render/context.h"

namespace se::view {

static_assert(key::kF1 == GLFW_KEY_F1 && key::kHome == GLFW_KEY_HOME && key::kEnd == GLFW_KEY_END);
static_assert(key::kLeft == GLFW_KEY_LEFT && key::kRight == GLFW_KEY_RIGHT);
static_assert(key::kBackspace == GLFW_KEY_BACKSPACE && key::kKeypadEnter == GLFW_KEY_KP_ENTER);
static_assert(key::kEnter == GLFW_KEY_ENTER && key::kEscape == GLFW_KEY_ESCAPE);
static_assert(kShift == GLFW_MOD_SHIFT && kCtrl == GLFW_MOD_CONTROL && kAlt == GLFW_MOD_ALT);

namespace {

/// Sleep time when nothing happens; loading threads are polled this often.
constexpr double kIdleSeconds = 0.25;
/// A text field has the keyboard focus only in the fourth frame after the request.
constexpr int kSettleFrames = 5;
/// The item under the pointer, and its tooltip, are drawn in the second frame.
constexpr int kHoverFrames = 2;
constexpr double kFrameSeconds = 1.0 / 60.0;
constexpr double kDoubleClickSeconds = 0.3;

glm::vec2 cursorOf(GLFWwindow* window) {
    double x = 0.0;
    double y = 0.0;
    glfwGetCursorPos(window, &x, &y);
    return {x, y};
}

/// Keys by their labels, so that Ctrl+Q is where the keyboard layout has Q.
int layoutKey(int key, int scancode) {
    if (key < GLFW_KEY_SPACE || key > GLFW_KEY_GRAVE_ACCENT || key == GLFW_KEY_SPACE) return key;
    // The key that is held to look back is bound to its position, left of 1.
    if (key == GLFW_KEY_GRAVE_ACCENT) return key;
    const char* name = glfwGetKeyName(key, scancode);
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
    const auto sign = static_cast<unsigned char>(name[0]);
    return sign < 128 ? std::toupper(sign) : key;
}

}  // namespace

Result<std::unique_ptr<Window>> Window::create(glm::ivec2 size) {
    if (glfwInit() != GLFW_TRUE) {
        return Error{
            "There is no display to open a window on. Use a display (X forwarding, "
            "or xvfb-run spiraling-edge-viewer ...), or write a picture without one by "
            "--screenshot out.png."};
    }
    std::unique_ptr<Window> made(new Window);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    // Until there is something to show, by attach().
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    made->title_ = "Spiraling Edge";
    made->window_ = glfwCreateWindow(size.x, size.y, made->title_.c_str(), nullptr, nullptr);
    const Error noGl{
        "The display has no OpenGL 3.3: use a newer driver, or write a picture without "
        "the display by --screenshot out.png."};
    if (made->window_ == nullptr) return noGl;
    glfwSetWindowSizeLimits(made->window_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(made->window_);
    if (const Status status = loadGl(glfwGetProcAddress); !status) return noGl;
    glfwSwapInterval(1);
    made->listen();
    return made;
}

Window::~Window() {
    if (window_ != nullptr) glfwDestroyWindow(window_);
    glfwTerminate();
}

float Window::contentScale() const {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(x, 0.75F, 3.0F);
}

Window& Window::of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

void Window::noteInput(int frames) {
    ++inputs_;
    wake_ = std::max(wake_, frames);
    unsettled_ = std::max(unsettled_, frames);
}

void Window::redraw() {
    if (application_ != nullptr) application_->redraw();
    noteInput(kSettleFrames);
}

void Window::onKey(GLFWwindow* window, int key, int scancode, int action, int mods) {
    of(window).noteInput(kSettleFrames);
    const int known = mods & (kShift | kCtrl | kAlt);
    of(window).keys_.push_back({{layoutKey(key, scancode), known},
                                action == GLFW_REPEAT,
                                0,
                                action == GLFW_RELEASE,
                                key,
                                scancode,
                                mods});
}

void Window::listen() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        of(window).drops_.assign(paths, paths + count);
        of(window).noteInput(kSettleFrames);
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        of(window).pointer_ = {x, y};
        of(window).noteInput(kHoverFrames);
    });
    glfwSetScrollCallback(
        window_, [](GLFWwindow* window, double, double) { of(window).noteInput(kSettleFrames); });
    glfwSetFramebufferSizeCallback(window_,
                                   [](GLFWwindow* window, int, int) { of(window).redraw(); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { of(window).redraw(); });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* window, float, float) {
        if (of(window).application_ == nullptr) return;
        of(window).application_->setContentScale(of(window).contentScale());
        of(window).redraw();
    });
    glfwSetWindowFocusCallback(
        window_, [](GLFWwindow* window, int) { of(window).noteInput(kSettleFrames); });
}

void Window::listenToPresses() {
    glfwSetKeyCallback(window_, onKey);
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int mods) {
        // From the events: a query to the display server would return the current position.
        const glm::vec2 pointer = of(window).pointer_.value_or(cursorOf(window));
        if (action == GLFW_PRESS) of(window).presses_.push_back({button, mods, pointer});
        of(window).noteInput(kSettleFrames);
    });
    // Dear ImGui's own would take each character a second time.
    glfwSetCharCallback(window_, nullptr);
    // Also those typed with Ctrl: their position differs between keyboards.
    glfwSetCharModsCallback(window_, [](GLFWwindow* window, unsigned sign, int mods) {
        KeyPress typed;
        std::vector<KeyPress>& keys = of(window).keys_;
        if (!keys.empty() && keys.back().sign == 0 && !keys.back().released) typed = keys.back();
        typed.sign = sign;
        typed.rawMods = mods;
        keys.push_back(typed);
        of(window).noteInput(kSettleFrames);
    });
}

void Window::deliver() {
    const std::size_t limit = application_->keysHaveToWait() ? 0 : pressesOfNextFrame(keys_);
    std::size_t now = 0;
    for (; now < limit; ++now) {
        const KeyPress& press = keys_[now];
        // A key press may open something that takes the later keys.
        if (application_->keysHaveToWait() && !isSignOfKeyBefore(keys_, now)) break;
        const int action = press.released   ? GLFW_RELEASE
                           : press.repeated ? GLFW_REPEAT
                                            : GLFW_PRESS;
        bool usedUp = false;
        if (press.sign != 0) {
            application_->character(press);
            if (isText(press)) ImGui_ImplGlfw_CharCallback(window_, press.sign);
        } else if (press.released) {
            application_->keyReleased(press.chord);
        } else {
            usedUp = application_->key(press.chord, press.repeated);
        }
        if (press.sign != 0 || usedUp) continue;
        ImGui_ImplGlfw_KeyCallback(window_, press.rawKey, press.scancode, action, press.rawMods);
    }
    keys_.erase(keys_.begin(), keys_.begin() + static_cast<std::ptrdiff_t>(now));
    if (!keys_.empty()) wake_ = kSettleFrames;
    deliverButton();
    if (!drops_.empty()) application_->drop(std::exchange(drops_, {}));
}

/// Dear ImGui sees the buttons once in a frame: the second press of a double click needs a frame of
/// its own, after one with the button up.
void Window::deliverButton() {
    pressDelivered_ = !pressDelivered_ && !presses_.empty();
    if (!presses_.empty()) wake_ = kSettleFrames;
    if (!pressDelivered_) return;
    const ButtonPress press = presses_.front();
    presses_.erase(presses_.begin());
    application_->buttonPressed(press.pointer);
    ImGui_ImplGlfw_MouseButtonCallback(window_, press.button, GLFW_PRESS, press.mods);
}

void Window::drawFrame() {
    const double now = glfwGetTime();
    const double seconds = std::clamp(now - lastFrame_, 1e-4, 0.25);
    lastFrame_ = now;
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    if (size.x == 0 || size.y == 0) return;
    // The two presses of a double click are up to four frames apart.
    const double twoClicks = std::max(kDoubleClickSeconds, 4.0 * frameSeconds_);
    ImGui::GetIO().MouseDoubleClickTime = static_cast<float>(twoClicks);
    ImGui_ImplGlfw_NewFrame();
    const bool changed = application_->frame(size, seconds);
    if (const std::string title = application_->title(); title != title_) {
        title_ = title;
        glfwSetWindowTitle(window_, title_.c_str());
    }
    if (changed) glfwSwapBuffers(window_);
    frameSeconds_ = glfwGetTime() - now;
}

void Window::attach(Application& application) {
    application_ = &application;
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    // Instead of Dear ImGui's own callbacks: it gets keys and buttons from deliver(), frame by
    // frame.
    listenToPresses();
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    show(paletteOf(application.settings().theme).panel);
    lastFrame_ = glfwGetTime();
}

/// Shows the window in one color until the first frame is drawn: new memory may hold anything.
void Window::show(const Color& color) {
    glfwShowWindow(window_);
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    clearFrame(size, color);
    glfwSwapBuffers(window_);
}

void Window::detach() {
    if (glfwGetWindowMonitor(window_) == nullptr)
        glfwGetWindowSize(window_, &windowedSize_.x, &windowedSize_.y);
    application_->rememberSize(windowedSize_);
    ImGui_ImplGlfw_Shutdown();
    application_ = nullptr;
}

void Window::wake() { wake_ = std::max(wake_, 1); }

void Window::waitForInput() {
    if (wake_ > 0 || application_->animating()) {
        // Without a monitor to wait for, swapping returns at once: limit the rate.
        const double rest = kFrameSeconds - (glfwGetTime() - lastFrame_);
        rest > 0.001 ? glfwWaitEventsTimeout(rest) : glfwPollEvents();
    } else {
        glfwWaitEventsTimeout(kIdleSeconds);
    }
}

bool Window::turn() {
    assert(application_ != nullptr);
    if (glfwWindowShouldClose(window_) == GLFW_TRUE) {
        glfwSetWindowShouldClose(window_, GLFW_FALSE);
        application_->requestQuit();
        wake_ = kSettleFrames;
    }
    waitForInput();
    deliver();
    if (application_->poll()) wake_ = std::max(wake_, kSettleFrames);
    if (wake_ == 0 && !application_->animating()) return false;
    if (wake_ > 0) --wake_;
    if (unsettled_ > 0) --unsettled_;
    drawFrame();
    // A write error is reported on exit.
    static_cast<void>(
        application_->writeState({inputs_, unsettled_ == 0 && keys_.empty() && presses_.empty()}));
    setFullScreen(application_->fullScreen());
    return true;
}

void Window::setFullScreen(bool full) {
    if (full == (glfwGetWindowMonitor(window_) != nullptr)) return;
    GLFWmonitor* monitor = full ? glfwGetPrimaryMonitor() : nullptr;
    if (full && monitor == nullptr) return;
    if (!full) {
        glfwSetWindowMonitor(window_, nullptr, windowedPlace_.x, windowedPlace_.y, windowedSize_.x,
                             windowedSize_.y, GLFW_DONT_CARE);
    } else {
        glfwGetWindowPos(window_, &windowedPlace_.x, &windowedPlace_.y);
        glfwGetWindowSize(window_, &windowedSize_.x, &windowedSize_.y);
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
    wake_ = kSettleFrames;
}

}  // namespace se::view
