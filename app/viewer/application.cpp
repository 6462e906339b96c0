#include "application.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "gl/context.h"
#include "gl/screenshot.h"
#include "interface/close_up.h"
#include "interface/key_routing.h"
#include "session/place.h"

namespace se::view {

namespace {

std::string clipboard() {
    const char* text = ImGui::GetClipboardText();
    return text != nullptr ? text : "";
}

/// Steps played faster than this, per second, do not leave the time to see them move.
constexpr double kFollowedRate = 1.5;

}  // namespace

Application::Application(const Options& options, const ViewSettings& settings)
    : options_(options), commands_{session_, playback_, camera_, ui_}, filing_(commands_) {
    ui_.settings = settings;
    ui_.cheatSheet = options.cheatSheet;
    ui_.arrangement = options.layout.value_or(Arrangement::Debug);
    playback_.setRate(settings.playRate);
    camera_.home();
}

Application::~Application() = default;

Status Application::start(float contentScale) {
    contentScale_ = contentScale;
    imgui_ = std::make_unique<Ui>();
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create(options_.shaders);
    if (!renderer) return renderer.error();
    renderer_ = std::move(renderer.value());
    filing_.begin(options_);
    std::string complaints;
    for (const std::string& each : std::exchange(ui_.settings.complaints, {})) {
        complaints += (complaints.empty() ? "" : " ") + each;
    }
    if (!complaints.empty()) session_.say(std::move(complaints));
    return success();
}

void Application::character(unsigned sign) {
    if (ui_.goTo.active()) {
        ui_.goTo.type(sign);
    } else if (sign == '?' && !ui_.keyEditor) {
        // Where the question mark lies differs between keyboards.
        key({'?', kNoMods}, false);
    }
}

void Application::goToTyped() {
    playback_.pause();
    const Status status = session_.goToText(ui_.goTo.text());
    if (!status) session_.say(status.error().message);
}

bool Application::key(const KeyChord& chord, bool repeated) {
    if (ui_.keyCapture.active()) {
        ui_.keyCapture.press(chord, ui_.settings.keys);
        return false;
    }
    if (ui_.goTo.active() && chord == KeyChord{'V', kCtrl}) {
        const std::string text = clipboard();
        const Result<Place> place = placeFromText(text);
        const std::string& address = place ? place.value().address : text;
        for (const char sign : address) ui_.goTo.type(static_cast<unsigned char>(sign));
        return false;
    }
    if (ui_.goTo.active() && ui_.goTo.press(chord)) {
        if (ui_.goTo.takeSubmitted()) goToTyped();
        return false;
    }
    const ImGuiIO& io = ImGui::GetIO();
    if (chord.key == key::kEscape && io.WantTextInput && !ui_.dialogOpen()) {
        // Dear ImGui would take back what was typed.
        ImGui::ClearActiveID();
        return true;
    }
    const bool enter = chord.key == key::kEnter || chord.key == key::kKeypadEnter;
    if (enter && chord.mods == kNoMods && ui_.walk.at() != KeyStop::View && io.NavVisible &&
        !io.WantTextInput && !ui_.dialogOpen()) {
        // Dear ImGui itself takes Space alone.
        ImGui::ActivateItem(ImGui::GetFocusID());
        return true;
    }
    if (isShiftKey(chord.key) && !repeated) ui_.look.shift(true, ui_.clock);
    const Command* command = ui_.settings.keys.commandFor(chord);
    // A question comes first.
    if (ui_.leaving.asked && command != findCommand("help.leave")) return false;
    if (command == nullptr || (repeated && !command->repeats)) return false;
    const bool closes = ui_.cheatSheet && command == findCommand("help.keys");
    const Keyboard keyboard{io.WantTextInput, ui_.dialogOpen() && !closes,
                            io.NavVisible && io.WantCaptureKeyboard};
    const bool reaches = reachesActions(chord, keyboard);
    if (reaches && !holdsLook(*command, chord.key)) command->run(commands_);
    // Dear ImGui has ways of its own to walk.
    return reaches && chord.key == key::kTab;
}

/// The two actions that last as long as their key is held.
bool Application::holdsLook(const Command& command, int key) {
    const bool blinks = &command == findCommand("step.blink");
    if (!blinks && &command != findCommand("step.before")) return false;
    ui_.look.begin(blinks ? LookBack::Mode::Blink : LookBack::Mode::Before, key, ui_.clock);
    return true;
}

void Application::keyReleased(const KeyChord& chord) {
    ui_.look.released(chord.key);
    if (isShiftKey(chord.key)) ui_.look.shift(false, ui_.clock);
}

void Application::drop(const std::vector<std::string>& paths) {
    if (ui_.leaving.asked || paths.empty()) return;
    ui_.fileBrowser = false;
    filing_.drop(paths);
}

bool Application::poll() {
    const bool changed = session_.poll();
    filing_.poll();
    if (session_.takeAccusation()) ui_.wantedTab = kDoctorTab;
    const bool notice = !session_.notice().empty();
    return std::exchange(noticed_, notice) != notice || changed;
}

Status Application::settle() {
    session_.settle();
    if (inputFailed()) return Error{session_.error()};
    filing_.poll();
    session_.settle();
    if (!filing_.placeStatus()) return filing_.placeStatus();
    if (!options_.goTo.empty() && session_.missed()) return Error{session_.message()};
    filing_.warn();
    return success();
}

bool Application::animating() const {
    return session_.busy() || playback_.playing() || motion_.moving() || ui_.look.blinking() ||
           ui_.click.waiting() || session_.phase() == SessionPhase::Loading;
}

std::string Application::title() const {
    if (!session_.ready()) return "Spiraling Edge";
    const std::string place = session_.event() != nullptr ? toString(session_.address()) : "start";
    const std::string dash = " \xE2\x80\x93 ";
    std::string what = session_.model().name;
    if (!ui_.sessionPath.empty()) {
        what = std::filesystem::path(ui_.sessionPath).filename().string() + dash + what;
    }
    return place + dash + what + (ui_.unsaved ? " (unsaved notes)" : "") + dash + "Spiraling Edge";
}

void Application::rememberSize(glm::ivec2 size) {
    ui_.settings.width = size.x;
    ui_.settings.height = size.y;
    ui_.settings.playRate = playback_.rate();
}

void Application::play(double seconds) {
    const PlayLoop& loop = playback_.loop;
    if (!playback_.playing() || session_.busy()) return;
    const bool turn = loop.complete() && session_.reached(*loop.to);
    if (!turn && session_.atEnd()) playback_.pause();
    const int due = playback_.due(seconds);
    if (due == 0) return;
    turn ? session_.playTo(*loop.from) : playSteps(commands_, due);
}

namespace {

/// How many triangles there were at the last seed before the cursor.
std::size_t componentBegin(const Session& session) {
    const RunOverview& run = session.overview();
    const std::uint32_t pivot = session.record().pivot;
    std::size_t begin = 0;
    for (const RunMark& mark : run.marks) {
        if (mark.kind != MarkKind::Seed || mark.pivot > pivot || mark.pivot < 2) continue;
        const std::size_t before = mark.pivot - 2;
        if (before < run.triangles.size()) begin = run.triangles[before];
    }
    return begin;
}

/// The point that the last ring before that at the cursor began with.
Index seedBefore(const Session& session) {
    const RunOverview& run = session.overview();
    const std::uint32_t pivot = session.record().pivot;
    Index seed = kNone;
    for (const ComponentSummary& each : run.components) {
        if (each.firstPivot >= pivot) break;
        if (each.firstPivot <= run.pivots.size()) seed = run.pivots[each.firstPivot - 1].point;
    }
    return seed;
}

}  // namespace

/// At which point of its short movements the scene is to be drawn.
const Moment& Application::lookAtMoment() {
    static constexpr Moment kPaper{Moment::Kind::Paper, 0.0, false};
    if (ui_.requests.screenshot || !options_.screenshot.empty()) return kPaper;
    const bool tooFast =
        playback_.playing() && (playback_.unlimited() || playback_.rate() > kFollowedRate);
    const bool still = !session_.ready() || session_.busy() || tooFast || ui_.look.on();
    return motion_.look(
        {session_.generation(), session_.ready() ? session_.record().pivot : 0, session_.cursor()},
        still ? 0.0 : motionSeconds(session_.picture()), ui_.clock);
}

void Application::fillScene(const Layout& layout) {
    if (!session_.ready()) return;
    const ViewSettings& settings = ui_.settings;
    if (uploadedGeneration_ != session_.generation()) {
        renderer_->setModel(session_.model());
        uploadedGeneration_ = session_.generation();
        // Another input, another home; reloading the same one leaves the camera alone.
        if (std::exchange(homeOf_, session_.model().name) != session_.model().name) {
            camera_.home(session_.model().beginning, session_.model().sample, ui_.viewAspect);
        }
        if (const auto pose = filing_.takeCamera()) camera_.setPose(*pose);
        filledRevision_ = 0;
    }
    if (!session_.busy() && filing_.takeFocus()) {
        frameFocus(commands_);
        closeUp(session_, camera_, layout.view.size / imgui_->em());
    }
    renderer_->setTriangles(session_.model(), session_.triangles());
    renderer_->setMended(session_.model(), session_.picture().mended);
    shownLayers_ = shownLayers(settings.layers, session_.stage());
    MeshColoring mesh =
        meshColoring(settings.meshStyle, session_.overview(), session_.triangles().size());
    const Moment& moment = lookAtMoment();
    if (filledRevision_ == session_.revision() && filledLayers_ == shownLayers_ &&
        filledTheme_ == settings.theme && filledMesh_ == mesh && filledMoment_ == moment &&
        filledShapes_ == session_.overview().shapes.size()) {
        return;
    }
    const LayerInput input{session_.model(),
                           session_.picture(),
                           palette(),
                           session_.selected(),
                           session_.litRing(),
                           session_.hovered(),
                           session_.triangles(),
                           componentBegin(session_),
                           shapeAt(session_.overview().shapes, session_.record().pivot),
                           session_.selection(),
                           ui_.facts.of(session_).present,
                           mesh,
                           session_.marked(),
                           moment,
                           &session_.meshIndex(),
                           seedBefore(session_)};
    fillDrawList(input, shownLayers_, drawList_);
    filledRevision_ = session_.revision();
    filledLayers_ = shownLayers_;
    filledTheme_ = settings.theme;
    filledShapes_ = session_.overview().shapes.size();
    filledMesh_ = std::move(mesh);
    filledMoment_ = moment;
    ++fills_;
}

void Application::drawScene(const Layout& layout) {
    const glm::ivec2 size(layout.view.size);
    if (size.x < 1 || size.y < 1) return;
    const SceneKey key{session_.revision(), session_.generation(), camera_.revision(), size,
                       shownLayers_,        ui_.settings.theme,    imgui_->em(),       fills_};
    if (key == drawn_) return;
    drawn_ = key;
    const float aspect = layout.view.size.x / layout.view.size.y;
    renderer_->draw(drawList_, camera_.matrices(aspect), size, imgui_->em(), palette().background);
}

void Application::drawUserInterface(const Layout& layout) {
    const StatusCounts& counts = session_.picture().status.counts();
    const PanelContext context{commands_, palette(), imgui_->fonts(), layout,
                               drawList_, counts,    imgui_->em(),    renderer_->texture()};
    drawPanels(context);
    // After a click the keys go to the view again; Ctrl+Tab leads into the panels.
    const bool released =
        ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive();
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    ui_.popupOpen = popup;
    const bool covered = popup || ui_.fileBrowser || ui_.cheatSheet || ui_.keyEditor ||
                         ui_.palette.open || ui_.leaving.asked;
    if ((released && !covered) || !focused_) {
        ImGui::SetWindowFocus(session_.startPage() ? "##start" : "##view");
        ui_.walk.leave();
        focused_ = true;
    }
}

void Application::frame(glm::ivec2 size, double seconds) {
    const auto began = std::chrono::steady_clock::now();
    ui_.clock += seconds;
    poll();
    play(seconds);
    session_.showBefore(ui_.look.showsBefore(ui_.clock));
    const double chosen = ui_.settings.uiScale > 0.0 ? ui_.settings.uiScale : contentScale_;
    ui_.scale = static_cast<float>(chosen);
    imgui_->setLooks(static_cast<float>(chosen), ui_.settings.theme);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
    io.DeltaTime = static_cast<float>(seconds);
    imgui_->beginFrame();
    const Layout layout =
        computeLayout(glm::vec2(size), imgui_->em(), ui_.arrangement, ui_.navigation.drawer);
    ui_.navigation.drawerFolded = layout.drawerFolded;
    ui_.viewAspect = layout.view.size.x / std::max(1.0F, layout.view.size.y);
    fillScene(layout);
    drawUserInterface(layout);
    const auto built = std::chrono::steady_clock::now();
    drawScene(layout);
    clearFrame(size, palette().panel);
    imgui_->endFrame();
    uiSeconds_ = std::chrono::duration<double>(built - began).count();
    noteTimes(built);
    if (options_.narrate) narrate();
    observeEdits();
    undoOrRedo();
    filing_.carryOut(ui_.requests);
    ui_.unsaved = filing_.unsaved();
    if (std::exchange(ui_.requests.copyPlace, false)) copyPlace();
    if (std::exchange(ui_.requests.pastePlace, false)) pastePlace();
    // One that was asked for while this frame was drawn is taken from the next one.
    if (ui_.requests.screenshot &&
        (filledMoment_.kind == Moment::Kind::Paper || !session_.ready())) {
        ui_.requests.screenshot = false;
        saveWindowPicture(size);
    }
    if (const int direction = std::exchange(ui_.requests.walk, 0); direction != 0) {
        ui_.walk.go(direction);
        ui_.requests.closePopups = ui_.walk.at() == KeyStop::View;
    }
    if (std::exchange(ui_.requests.closePopups, false)) {
        ImGui::SetWindowFocus("##view");
        if (ui_.walk.at() != KeyStop::View) ui_.walk.leave();
    }
}

void Application::noteTimes(std::chrono::steady_clock::time_point built) {
    using Seconds = std::chrono::duration<double>;
    const bool first = firstFrameSeconds_ == 0.0 && session_.ready();
    if (first || options_.benchFrames > 0) finishGl();
    const auto drawn = std::chrono::steady_clock::now();
    glSeconds_ = Seconds(drawn - built).count();
    const double sinceStart = Seconds(drawn - options_.began).count();
    if (first) firstFrameSeconds_ = sinceStart;
    if (firstWindowSeconds_ == 0.0) firstWindowSeconds_ = sinceStart;
    if (std::exchange(opening_, session_.phase() == SessionPhase::Loading)) {
        const double gap = Seconds(drawn - lastFrame_).count() - glSeconds_;
        longestOpeningSeconds_ = std::max(longestOpeningSeconds_, gap);
    }
    lastFrame_ = drawn;
}

void Application::observeEdits() {
    const Edits now = captureEdits(commands_);
    if (std::exchange(undoGeneration_, session_.generation()) != session_.generation()) {
        return undo_.begin(now);
    }
    const bool changing = ImGui::IsAnyMouseDown() || ImGui::GetIO().WantTextInput;
    const auto sinceStart = std::chrono::steady_clock::now().time_since_epoch();
    undo_.observe(now, std::chrono::duration<double>(sinceStart).count(), changing);
}

void Application::undoOrRedo() {
    const bool undo = std::exchange(ui_.requests.undo, false);
    const bool redo = std::exchange(ui_.requests.redo, false);
    if (!undo && !redo) return;
    const Edits now = captureEdits(commands_);
    const auto step = undo ? undo_.undo(now) : undo_.redo(now);
    if (!step)
        return session_.say(undo ? "There is nothing to undo." : "There is nothing to redo.");
    applyEdits(step->edits, commands_);
    undo_.accept(captureEdits(commands_));
    session_.say((undo ? "Undone: " : "Redone: ") + step->change + ".");
}

void Application::copyPlace() {
    if (!session_.ready()) return;
    const std::string address = session_.event() != nullptr ? toString(session_.address()) : "0";
    ImGui::SetClipboardText(toText(Place{address, camera_.pose()}).c_str());
    session_.say("Copied: " + address + " and the camera.");
}

void Application::pastePlace() {
    const Result<Place> place = placeFromText(clipboard());
    if (!place) return session_.say(place.error().message);
    playback_.pause();
    if (place.value().camera) camera_.setPose(*place.value().camera);
    const Status status = session_.goToText(place.value().address);
    if (!status) session_.say(status.error().message);
}

void Application::narrate() {
    if (!session_.ready() || session_.event() == nullptr || session_.busy()) return;
    const std::string address = toString(session_.address());
    if (address == narrated_) return;
    narrated_ = address;
    std::printf("%s\t%s\n", address.c_str(), describe(*session_.event()).c_str());
    std::fflush(stdout);
}

void Application::saveWindowPicture(glm::ivec2 size) {
    // Beside other pictures of the person, not where the program happened to be started.
    std::error_code error;
    const char* home = std::getenv("HOME");
    std::filesystem::path folder = home != nullptr ? home : ".";
    if (std::filesystem::is_directory(folder / "Pictures", error)) folder /= "Pictures";
    const std::string place = session_.event() != nullptr ? toString(session_.address()) : "start";
    const std::filesystem::path path = folder / ("spiraling-edge-" + place + ".png");
    const Status status = saveScreenshot(path, size);
    session_.say(status ? "Saved " + path.string() + "." : status.error().message);
}

}  // namespace se::view
