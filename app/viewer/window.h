/// The window: lifetime of GLFW and its OpenGL context, and the input from keyboard, mouse
/// and desktop. Draws only after input, during animations or when data was loaded.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/key_routing.h"
#include "scene/palette.h"
#include "spiraling_edge/base/result.h"

struct GLFWwindow;

namespace se::view {

class Application;

/// A mouse button came down.
struct ButtonPress {
    int button = 0;
    int mods = 0;
    glm::vec2 pointer{0.0F};
};

class Window {
  public:
    static Result<std::unique_ptr<Window>> create(glm::ivec2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Connects a started application, until detach(): it gets the input and draws the frames.
    void attach(Application& application);
    void detach();
    /// Waits for input or for the time of the next frame, then draws one frame. False if nothing
    /// has changed, and none was drawn. Requires an attached application.
    bool turn();
    /// Makes the next turn() draw in any case.
    void wake();
    /// Pixels per unit of size, as reported by the monitor.
    float contentScale() const;

  private:
    Window() = default;
    void listen();
    void listenToPresses();
    void waitForInput();
    void noteInput(int frames);
    /// The window lost its content, or has another size.
    void redraw();
    void deliver();
    void deliverButton();
    void drawFrame();
    /// Fills the monitor, or returns to the place before; no effect if it does so already.
    void setFullScreen(bool full);
    void show(const Color& color);
    static Window& of(GLFWwindow* window);
    static void onKey(GLFWwindow* window, int key, int scancode, int action, int mods);

    GLFWwindow* window_ = nullptr;
    Application* application_ = nullptr;  ///< The attached one; null: none.
    std::vector<KeyPress> keys_;          ///< In order of arrival.
    std::vector<std::string> drops_;
    std::optional<glm::vec2> pointer_;  ///< At the last event; empty before the first.
    std::vector<ButtonPress> presses_;  ///< In order of arrival.
    bool pressDelivered_ = false;       ///< In the last frame.
    double frameSeconds_ = 0.0;         ///< Duration of drawing the last frame.
    std::string title_;
    std::uint64_t inputs_ = 0;  ///< Events since the start.
    int wake_ = 5;              ///< Frames still to draw: the layout settles over a few of them.
    int unsettled_ = 0;         ///< Of them, those that the last input asks for.
    double lastFrame_ = 0.0;
    glm::ivec2 windowedPlace_{0};
    glm::ivec2 windowedSize_{1280, 800};
};

}  // namespace se::view
