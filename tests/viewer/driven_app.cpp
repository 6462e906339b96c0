#include "driven_app.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "chord.h"
#include "export_run.h"
#include "options.h"
#include "state_dump.h"

namespace se::view::test {

namespace {

/// The options that the program reads from a command line.
Options optionsOf(const std::vector<std::string>& arguments) {
    std::vector<const char*> words = {"spiraling-edge-viewer", "--no-config"};
    for (const std::string& each : arguments) words.push_back(each.c_str());
    ParsedOptions parsed = parseOptions(static_cast<int>(words.size()), words.data());
    REQUIRE(parsed.options);
    Options& options = *parsed.options;
    for (const auto adopt : {adoptLesson, adoptSession, adoptStart}) REQUIRE(adopt(options).ok());
    REQUIRE(chooseComparison(options).ok());
    return options;
}

/// A display in memory; null where there is no OpenGL.
std::unique_ptr<Offscreen> openedDisplay() {
    auto made = Offscreen::create({8, 8});
    if (made) return std::move(made.value());
    MESSAGE("skipped: " << made.error().message);
    return nullptr;
}

/// Dear ImGui gets our numbers of keys.
void mapKeys(ImGuiIO& io) {
    constexpr std::array<std::pair<ImGuiKey_, int>, 20> kKeys = {
        {{ImGuiKey_Space, key::kSpace},
         {ImGuiKey_Escape, key::kEscape},
         {ImGuiKey_Enter, key::kEnter},
         {ImGuiKey_Tab, key::kTab},
         {ImGuiKey_Backspace, key::kBackspace},
         {ImGuiKey_Delete, key::kDelete},
         {ImGuiKey_RightArrow, key::kRight},
         {ImGuiKey_LeftArrow, key::kLeft},
         {ImGuiKey_DownArrow, key::kDown},
         {ImGuiKey_UpArrow, key::kUp},
         {ImGuiKey_PageUp, key::kPageUp},
         {ImGuiKey_PageDown, key::kPageDown},
         {ImGuiKey_Home, key::kHome},
         {ImGuiKey_End, key::kEnd},
         {ImGuiKey_A, 'A'},
         {ImGuiKey_C, 'C'},
         {ImGuiKey_V, 'V'},
         {ImGuiKey_X, 'X'},
         {ImGuiKey_Y, 'Y'},
         {ImGuiKey_Z, 'Z'}}};
    for (const auto& [theirs, ours] : kKeys) io.KeyMap[theirs] = ours;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
}

void sendKey(const KeyChord& chord, bool down) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = down && (chord.mods & kCtrl) != 0;
    io.KeyShift = down && (chord.mods & kShift) != 0;
    io.KeyAlt = down && (chord.mods & kAlt) != 0;
    io.KeysDown[chord.key] = down;
}

/// Frames after an input, as in the window.
constexpr int kFramesOfInput = 5;
/// Seconds from frame to frame while nothing is done: motions are over after a few.
constexpr double kLongFrame = 0.1;

ViewSettings settingsOf(const Options& options) {
    ViewSettings settings;
    if (options.uiScale > 0.0) settings.uiScale = options.uiScale;
    return settings;
}

}  // namespace

DrivenApp::DrivenApp(const std::vector<std::string>& arguments, glm::ivec2 size)
    : DrivenApp(optionsOf(arguments), size) {}

DrivenApp::DrivenApp(const Options& options, glm::ivec2 size)
    : display_(openedDisplay()),
      app(options, settingsOf(options)),
      ui(app.context().ui),
      session(app.session()),
      size_(size) {
    if (!display_) return;
    target_ = std::make_unique<Target>(0);
    ui.picture.tile = kLayoutAlone;
    REQUIRE(app.start(1.0F).ok());
    mapKeys(ImGui::GetIO());
    settle();
}

DrivenApp::~DrivenApp() = default;

bool DrivenApp::frame(double seconds) {
    target_->begin(ui.picture.tile ? ui.picture.tile->size : size_);
    app.poll();
    const bool drawn = app.frame(size_, seconds);
    target_->end();
    return drawn;
}

void DrivenApp::frames(int count) {
    for (int i = 0; i < count; ++i) frame(1.0 / 60.0);
}

void DrivenApp::settle() {
    int still = 0;
    for (int i = 0; i < 2000 && still < kFramesOfInput; ++i) {
        session.waitUntilDone();
        if (Session* other = app.otherSession(); other != nullptr) other->waitUntilDone();
        const bool drawn = frame(kLongFrame);
        if (!drawn && app.animating()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        still = app.animating() || app.keysHaveToWait() ? 0 : still + 1;
    }
}

void DrivenApp::press(std::string_view chords) {
    std::istringstream words{std::string(chords)};
    for (std::string word; words >> word;) {
        const KeyChord pressed = chord(word.c_str());
        if (!app.key(pressed, false)) sendKey(pressed, true);
        frames(1);
        app.keyReleased(pressed);
        sendKey(pressed, false);
        settle();
    }
}

void DrivenApp::type(std::string_view text) {
    for (const char sign : text) {
        REQUIRE(static_cast<unsigned char>(sign) < 0x80U);
        KeyPress typed;
        typed.sign = static_cast<unsigned char>(sign);
        app.character(typed);
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(sign));
    }
    frames(2);
    settle();
}

void DrivenApp::goTo(std::string_view place) {
    press("Ctrl+G");
    type(place);
    press("Enter");
}

void DrivenApp::command(std::string_view words) {
    press("Ctrl+P");
    type(words);
    press("Enter");
}

void DrivenApp::moveTo(glm::vec2 at) {
    ImGui::GetIO().MousePos = {at.x, at.y};
    frames(2);
}

void DrivenApp::hold(int button, bool down) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    if (down) app.buttonPressed({at.x, at.y});
    ImGui::GetIO().MouseDown[button] = down;
    frames(2);
}

void DrivenApp::click(glm::vec2 at, int button) {
    moveTo(at);
    hold(button, true);
    hold(button, false);
    settle();
}

void DrivenApp::doubleClick(glm::vec2 at) {
    moveTo(at);
    for (const bool down : {true, false, true, false}) hold(0, down);
    settle();
}

void DrivenApp::drag(glm::vec2 from, glm::vec2 by, int button) {
    moveTo(from);
    hold(button, true);
    moveTo(from + 0.5F * by);
    moveTo(from + by);
    hold(button, false);
    settle();
}

void DrivenApp::wheel(glm::vec2 at, float notches) {
    moveTo(at);
    ImGui::GetIO().MouseWheel = notches;
    frames(2);
    settle();
}

void DrivenApp::holdCtrl(bool down) {
    ImGui::GetIO().KeyCtrl = down;
    frames(1);
}

glm::vec2 DrivenApp::in(const std::string& item, float x, float y) {
    CAPTURE(item);
    Rect before;
    // Tabs and lists move to their positions in their first frames.
    for (int i = 0; i < 60; ++i) {
        const auto found = ui.where.find(item);
        const Rect now = found != ui.where.end() ? found->second : Rect{};
        if (now.size.x > 0.0F && now.min == before.min && now.size == before.size) break;
        before = now;
        frames(1);
    }
    REQUIRE(shows(item));
    return before.min + before.size * glm::vec2(x, y);
}

void DrivenApp::reach(const std::string& area, const std::string& item) {
    float before = -1.0F;
    for (int i = 0; i < 60; ++i) {
        REQUIRE(shows(area));
        const Rect room = ui.where.at(area);
        const float margin = std::min(55.0F, 0.3F * room.size.y);
        // What is far below is not drawn.
        const float at = shows(item) ? in(item).y : room.max().y;
        const bool above = at < room.min.y + margin;
        const bool atItsEnd = shows(item) && at == before && at < room.max().y - 12.0F;
        if ((!above && at <= room.max().y - margin) || atItsEnd) return clickOn(item);
        before = at;
        // A list may scroll within an area that scrolls: the margin belongs to the area alone.
        const float notches = above ? 0.5F : -0.5F;
        const float whole = shows(item) ? in(item).y : 0.0F;
        wheel(in(area, 0.985F, 0.6F), notches);
        if (!shows(item) || in(item).y == whole) wheel(in(area, 0.85F, 0.85F), notches);
    }
    const Rect room = ui.where.at(area);
    FAIL(item << " does not come into sight: it is at " << (shows(item) ? in(item).y : -1.0F)
              << ", the area from " << room.min.y << " to " << room.max().y);
}

void DrivenApp::part(const std::string& title) {
    const PartRow* row = partNamed(title);
    REQUIRE(row != nullptr);
    if (ui.column.task != row->task || !shows("part " + title))
        clickOn("rail " + std::string(rowOf(row->task).title));
    if (!isOpen(ui.settings.parts, *row)) reach("region column", "part " + title);
}

void DrivenApp::retype(const std::string& item, std::string_view text) {
    clickOn(item);
    press("Ctrl+A");
    type(text);
}

void DrivenApp::resize(glm::ivec2 size) {
    size_ = size;
    app.redraw();
    settle();
}

Picture DrivenApp::picture() {
    ui.picture.tile.reset();
    // The finish of the view comes once the camera has rested.
    do {
        app.redraw();
        frame(kLongFrame);
    } while (app.painter().unfinished());
    target_->begin(size_);
    app.redraw();
    app.frame(size_, 1.0 / 60.0);
    Picture read = readPicture(size_);
    target_->end();
    ui.picture.tile = kLayoutAlone;
    return read;
}

std::string DrivenApp::operator[](std::string_view field) {
    const auto state = nlohmann::json::parse(stateDump(app));
    const auto found = state.find(field);
    if (found == state.end()) return {};
    return found->is_string() ? found->get<std::string>() : found->dump();
}

void DrivenApp::save(const std::filesystem::path& path) {
    press("Ctrl+S");
    type(path.string());
    press("Enter");
}

std::size_t differing(const Picture& a, const Picture& b) {
    REQUIRE(a.rgba.size() == b.rgba.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t k = i; k < i + 3; ++k) {
            most = std::max(most, std::abs(int(a.rgba[k]) - int(b.rgba[k])));
        }
        count += most > 12 ? 1 : 0;
    }
    return count;
}

}  // namespace se::view::test
