/// The program in memory, driven as by a user with keys, text and mouse; without a window.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "application.h"
#include "document/ui_state.h"
#include "offscreen.h"

namespace se::view::test {

/// The program and its user: after every input, frames are made until nothing moves and no work is
/// left. Of these only the layout is drawn, since software takes most of the time for pixels.
class DrivenApp {
  public:
    /// `arguments` as on the command line.
    explicit DrivenApp(const std::vector<std::string>& arguments, glm::ivec2 size = {1280, 800});
    ~DrivenApp();
    DrivenApp(const DrivenApp&) = delete;
    DrivenApp& operator=(const DrivenApp&) = delete;

    /// False where there is no OpenGL: a test ends then.
    explicit operator bool() const { return display_ != nullptr; }

  private:
    DrivenApp(const Options& options, glm::ivec2 size);

    std::unique_ptr<Offscreen> display_;

  public:
    Application app;
    UiState& ui;
    Session& session;

    /// Keys by their names, one after the other: "Ctrl+G Home".
    void press(std::string_view chords);
    void type(std::string_view text);
    /// Entries of the go-to box and of the palette of commands.
    void goTo(std::string_view place);
    void command(std::string_view words);
    /// Buttons: 0 left, 1 right, 2 middle. Positions are in pixels.
    void click(glm::vec2 at, int button = 0);
    void drag(glm::vec2 from, glm::vec2 by, int button = 0);
    void moveTo(glm::vec2 at);
    void hold(int button, bool down);
    void wheel(glm::vec2 at, float notches);
    void doubleClick(glm::vec2 at);
    /// Holds Ctrl for the mouse.
    void holdCtrl(bool down);

    /// Clicks on the task of a part of the column, and on its title if it is folded.
    void part(const std::string& title);
    /// An item that was drawn, such as "rail Step"; see UiState::where.
    bool shows(const std::string& item) const { return ui.where.count(item) > 0; }
    /// A place within it, by shares of its size.
    glm::vec2 in(const std::string& item, float x = 0.5F, float y = 0.5F);
    void clickOn(const std::string& item, int button = 0) { click(in(item), button); }
    /// Turns the wheel over an area until the item is well within it, and clicks on the item.
    void reach(const std::string& area, const std::string& item);
    void retype(const std::string& item, std::string_view text);

    void settle();
    void frames(int count);
    void resize(glm::ivec2 size);
    /// The picture that the window shows now.
    Picture picture();
    /// A field of stateDump(), as text without quotes; a list is in JSON.
    std::string operator[](std::string_view field);
    std::string address() const { return toString(session.address()); }
    CameraPose pose() { return app.camera().pose(); }
    /// Saves the session as a file.
    void save(const std::filesystem::path& path);

  private:
    bool frame(double seconds);

    glm::ivec2 size_;
    std::unique_ptr<Target> target_;
};

/// Number of pixels that differ visibly.
std::size_t differing(const Picture& a, const Picture& b);

}  // namespace se::view::test
