#include "application.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "commands/commands.h"
#include "document/actions.h"
#include "document/ask_actions.h"
#include "document/piece_actions.h"
#include "export_run.h"
#include "input/key_routing.h"
#include "jobs/questions.h"
#include "panel_state/side_panels.h"
#include "panels/pages/scene_tiles.h"
#include "render/context.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

namespace {

/// Without threads, the time between two frames that other work has.
constexpr std::chrono::milliseconds kSlicesPerFrame{12};
constexpr const char* kStartWindow = "##start";
constexpr const char* kViewWindow = "##view";

/// Height of the sentence below a view alone, in em.
constexpr float kCaption = 3.6F;
/// Width of the dial beside a view alone, as a share of all, and its limits in em.
constexpr float kDialShare = 0.3F;
constexpr float kDialLeast = 10.0F;
constexpr float kDialMost = 22.0F;

}  // namespace

Application::Application(const Options& options, const ViewSettings& settings)
    : options_(options),
      context_{session_, playback_, camera_,  ui_,   document_,
               history_, lesson_,   compare_, mesh_, sampling_},
      document_(context_),
      alerts_(context_),
      sampling_(context_),
      compare_(context_),
      mesh_(context_),
      lesson_(context_),
      firstRun_(context_),
      export_(std::make_unique<WindowExport>(context_)),
      history_(context_) {
    ui_.settings = settings;
    if (options.cheatSheet) ui_.help = HelpPage::Keys;
    ui_.picture = options.picture;
    ui_.layoutPreset = options.layout.value_or(LayoutPreset::Debug);
    ui_.follow = followIn(ui_.layoutPreset);
    playback_.setRate(settings.playRate);
}

Application::~Application() = default;

Status Application::start(float contentScale) {
    contentScale_ = contentScale;
    imgui_ = std::make_unique<Ui>();
    ui_.clipboard.connect(
        [] {
            const char* text = ImGui::GetClipboardText();
            return std::string(text != nullptr ? text : "");
        },
        [](const std::string& text) { ImGui::SetClipboardText(text.c_str()); });
    Result<std::shared_ptr<Shaders>> shaders = Shaders::load(options_.shaders);
    if (!shaders) return shaders.error();
    painter_.start(shaders.value());
    compare_.setShaders(shaders.value());
    document_.begin(options_);
    alerts_.begin(options_);
    lesson_.begin(options_);
    if (!options_.onPaper()) firstRun_.begin(options_.playSeconds);
    sampling_.setUsual(options_.input);
    if (options_.grow) sampling_.begin(*options_.grow);
    for (const std::string& each : std::exchange(ui_.settings.complaints, {}))
        document_.warnLater(each);
    return success();
}

void Application::drop(const std::vector<std::string>& paths) {
    if (ui_.leaving.asked || paths.empty()) return;
    // The file that the open dialog waits for, or one to open.
    const bool chosen = std::exchange(ui_.fileBrowser, false) && ui_.browser != BrowserTask::Open;
    if (chosen && (ui_.browser == BrowserTask::Mesh || ui_.browser == BrowserTask::Volume))
        return actions::openFor(context_, ui_.browser, paths.front());
    document_.drop(paths);
}

bool Application::poll() {
    working_ = runSlices(kSlicesPerFrame);
    const bool opened = session_.poll();
    const bool saved = mesh_.poll();
    const bool changed = sampling_.poll() || opened || saved;
    document_.poll();
    if (const double seconds = document_.takePlay(); seconds > 0.0) firstRun_.begin(seconds);
    const bool taught = lesson_.poll();
    const bool played = firstRun_.poll();
    if (!ui_.lesson.walk.isOpen()) alerts_.poll();
    const bool compared = compare_.poll();
    const Compared* found = compare_.comparison().result();
    if (options_.atDifference && found != nullptr && !session_.moves().busy() &&
        !std::exchange(differenceAsked_, true)) {
        options_.atDifference = !found->meshes.same() || found->alignment().diverge;
        compare_.toFirstDifference();
    }
    followTask();
    // The lists of a figure are those of its drawing, and nothing is to be fixed.
    const bool figure = session_.ready() && !session_.model().params.start.empty();
    if (session_.takeProblemFound() && !figure && !ui_.lesson.walk.isOpen())
        ui_.column.note(Task::Input);
    const bool notice = !session_.messages().notice().empty();
    return std::exchange(noticed_, notice) != notice || changed || compared || taught || played;
}

Status Application::waitUntilDone() {
    sampling_.waitUntilDone();
    if (sampling_.growth().phase() == GrowthPhase::Failed) return Error{ui_.growth.complaint};
    lesson_.waitUntilDone();
    if (const std::string& why = lesson_.opening().complaint(); !why.empty()) return Error{why};
    session_.waitUntilDone();
    if (inputFailed()) return Error{session_.input().error()};
    document_.poll();
    session_.waitUntilDone();
    alerts_.poll();
    session_.waitUntilDone();
    if (!alerts_.status()) return alerts_.status();
    if (!document_.placeStatus()) return document_.placeStatus();
    if (!options_.goTo.empty() && session_.messages().missed())
        return Error{session_.messages().last()};
    compare_.waitUntilDone();
    if (const std::string& wrong = compare_.comparison().complaint(); !wrong.empty())
        return Error{wrong};
    // First the jump, then the compared run.
    for (int i = 0; i < 2; ++i) {
        poll();
        session_.waitUntilDone();
        compare_.waitUntilDone();
    }
    document_.warn();
    return success();
}

bool Application::animating() const {
    return working_ || firstRun_.active() || session_.moves().busy() || playback_.playing() ||
           painter_.moving() || painter_.unfinished() || painter_.late() || compare_.late() ||
           ui_.look.blinking() || ui_.click.waiting() || compare_.moving() ||
           session_.input().phase() == SessionPhase::Loading || sampling_.moving() ||
           session_.questions().busy() || mesh_.busy() || framed_.has_value() ||
           ui_.cameraMove.active() || lesson_.moving() || export_->busy() ||
           (session_.startPage() && context_.ui.states.of<StartPage>().sampling.busy());
}

std::string Application::title() const {
    if (ui_.growth.open) return "New points \xE2\x80\x93 Spiraling Edge";
    if (!session_.ready()) return "Spiraling Edge";
    const std::string place = session_.event() != nullptr ? toString(session_.address()) : "start";
    const std::string dash = " \xE2\x80\x93 ";
    std::string what = session_.model().name;
    if (!ui_.sessionPath.empty()) {
        what = std::filesystem::path(ui_.sessionPath).filename().string() + dash + what;
    }
    return place + dash + what + (ui_.unsaved.empty() ? "" : " (unsaved " + ui_.unsaved + ")") +
           dash + "Spiraling Edge";
}

void Application::rememberSize(glm::ivec2 size) {
    lesson_.putBackChoices();
    ui_.settings.width = size.x;
    ui_.settings.height = size.y;
    ui_.settings.playRate = playback_.rate();
}

void Application::play(double seconds) {
    const PlayLoop& loop = playback_.loop;
    if (!playback_.playing() || session_.moves().busy()) return;
    if (playback_.until && session_.reached(*playback_.until)) {
        session_.moves().playTo(*playback_.until);
        playback_.pause();
    }
    const bool turn = loop.complete() && session_.reached(*loop.to);
    if (!turn && session_.atEnd()) playback_.pause();
    const int due = playback_.due(seconds);
    if (due == 0) return;
    if (turn) return session_.moves().playTo(*loop.from);
    if (!heldByBreakpoint(context_, due)) playSteps(context_, due);
}

/// Places the camera for a newly opened input.
void Application::placeCamera() {
    if (!session_.ready()) return;
    settleCamera();
    if (std::exchange(placedGeneration_, session_.generation()) != session_.generation()) {
        // Another input resets the camera; reloading the same one keeps it.
        if (std::exchange(homeOf_, session_.model().name) != session_.model().name) {
            camera_.setUp(document_.openedSession() ? UpAxis::Z : actions::usualUp(context_));
            frameNow(FrameRequest::Home);
        }
        if (const auto pose = document_.takeCamera()) camera_.setPose(*pose);
    }
    if (lesson_.takeAim()) {
        lesson_.aim();
        // Not a change of the user's.
        history_.acceptCamera();
    }
    // The undo stack begins here: the user has not changed anything yet.
    if (alerts_.takeOpened()) history_.begin();
    const bool atDifference = differenceAsked_ && session_.event() != nullptr &&
                              !session_.moves().busy() &&
                              std::exchange(options_.atDifference, false);
    if (session_.moves().busy()) return;
    const FrameRequest request = resolved(context_, std::exchange(ui_.frame, FrameRequest::None));
    if (atDifference) return frameNow(FrameRequest::Decision);
    if (request != FrameRequest::None) frameNow(request);
}

/// Frames again what was framed in the last frame, if the view has another size since: the layout
/// settles over the first frames. Not if something else has moved the camera.
void Application::settleCamera() {
    if (!framed_) return;
    const bool stays = framed_->revision == camera_.revision();
    if (!stays || framed_->part == ui_.viewPart()) return framed_.reset();
    frameNow(framed_->request);
    history_.acceptCamera();
}

void Application::frameNow(FrameRequest request) {
    frameRequested(context_, request);
    framed_ = Framed{request, ui_.viewPart(), camera_.revision()};
    if (request == FrameRequest::Decision) closeUp_ = camera_.revision();
}

/// Smooth moves of the camera. While the decision is followed, one begins where the cursor comes to
/// another pivot, or to a decision that another side shows best; never on opening. Otherwise
/// playing leads to a pivot that has left the view, unless the user has moved the view away from
/// it.
void Application::moveCamera() {
    const bool placed = session_.ready() && !session_.moves().busy();
    if (placed && session_.picture().pivot != kNone) {
        const Model& model = session_.shown();
        const Index pivot = session_.picture().pivot;
        const FollowedDecision here{session_.generation(), pivot,
                                    viewWayOf(model, session_.picture())};
        const FollowedDecision before = std::exchange(followed_, here);
        // Dragged points change the decision, not the view of it.
        const bool dragging = session_.drag().active();
        const bool stays = std::exchange(dragged_, dragging) || dragging || before == here ||
                           before.generation != here.generation;
        const bool moving = ui_.cameraMove.kind() == CameraMove::Kind::Followed;
        const bool seen = isInView(model.place[pivot], ui_.viewPart(), camera_);
        const bool left = std::exchange(pivotSeen_, seen || moving) && !seen && !moving;
        if (ui_.follow == Follow::EachDecision && !stays)
            moveToDecision(context_, CameraMove::Kind::Followed);
        if (ui_.follow == Follow::LeavingPivot && left && playback_.playing() &&
            !ImGui::IsAnyMouseDown()) {
            pivotSeen_ = true;
            followPivot(context_);
        }
    }
    if (placed && session_.atEnd() && !std::exchange(ended_, true)) showFinishedMesh();
    ended_ = ended_ && (!placed || session_.atEnd());
    const bool follows = ui_.cameraMove.kind() == CameraMove::Kind::Followed;
    ui_.cameraMove.apply(camera_, ui_.motionClock());
    if (follows) closeUp_ = camera_.revision();
}

/// Moves back to all of the mesh at the end of a run, if the camera was led close to a decision and
/// nothing else has moved it since.
void Application::showFinishedMesh() {
    const bool near =
        closeUp_ == camera_.revision() && followed_.generation == session_.generation();
    if (near && ui_.follow != Follow::Never) moveToAll(context_, CameraMove::Kind::Followed);
}

void Application::drawUserInterface(const PanelRects& rects) {
    const StatusCounts& counts = session_.picture().status.counts();
    Session* other = compare_.other();
    CommandContext beside = context_.of(other != nullptr ? *other : session_);
    std::optional<OtherView> view;
    if (compare_.shows())
        view.emplace(OtherView{other != nullptr ? &beside : nullptr, compare_.list(),
                               beside.session.picture().status.counts(), compare_.texture()});
    const PanelContext context{context_,
                               palette(),
                               imgui_->fonts(),
                               rects,
                               painter_.list(),
                               counts,
                               imgui_->em(),
                               painter_.texture(),
                               view ? &*view : nullptr,
                               false,
                               view ? other : nullptr};
    // Popups requested in this frame are drawn in the next one, and have no window yet.
    const bool page = ui_.growth.open;
    drawPanels(context);
    const char* home = session_.startPage() && !page ? kStartWindow : kViewWindow;
    // After a click the view has the keyboard focus again; Ctrl+Tab leads into the panels.
    const bool released =
        ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive();
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    ui_.popupOpen = popup;
    const bool covered = popup || ui_.coversView();
    if ((released && !covered) || focused_ != home) {
        ImGui::SetWindowFocus(home);
        ui_.walk.leave();
        focused_ = home;
    }
}

bool Application::frame(glm::ivec2 size, double seconds) {
    const auto began = std::chrono::steady_clock::now();
    update(seconds);
    layOut(size, seconds);
    fillViews();
    ui_.betweenFrames.beginDrawing();
    drawUserInterface(areas_);
    const bool panelsChanged = imgui_->endFrame();
    const auto built = std::chrono::steady_clock::now();
    const bool drawn = draw(size, panelsChanged);
    uiSeconds_ = std::chrono::duration<double>(built - began).count();
    glSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - built).count();
    endFrame(size);
    return drawn;
}

/// Sets what is searched for, plays, and chooses the state that is shown.
void Application::update(double seconds) {
    ui_.clock += seconds;
    // Ignore breakpoints and watches while a text field is active.
    if (!ImGui::GetIO().WantTextInput) {
        session_.hits().want(ui_.breakpoints);
        session_.watches().want(ui_.watch.expressions);
    }
    play(seconds);
    if (ui_.growth.open) sampling_.play(seconds);
    session_.showNames(ui_.settings.names);
    session_.showBefore(ui_.look.showsBefore(ui_.clock));
}

void Application::layOut(glm::ivec2 size, double seconds) {
    ui_.scale = scaleIn(size);
    imgui_->setLooks(ui_.scale, ui_.settings.theme);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
    io.DeltaTime = static_cast<float>(seconds);
    imgui_->beginFrame();
    areas_ = areasIn(glm::vec2(size));
    ui_.navigation.stripFolded = areas_.stripFolded;
    ui_.phone = areas_.phone;
    ui_.viewAspect = areas_.view.size.x / std::max(1.0F, areas_.view.size.y);
}

/// Places the camera, and lists what the views show.
void Application::fillViews() {
    if (ui_.growth.open) return painter_.fillParticles(sampling_, ui_.settings.theme);
    placeCamera();
    moveCamera();
    if (session_.ready() && ui_.settings.pointTint == PointTint::Margin && !ui_.lesson.hides())
        session_.questions().requestClosest();
    const bool onPaper = ui_.takesPicture || options_.onPaper();
    painter_.fill(context_, onPaper, compare_.look());
    compare_.fill(onPaper);
}

/// Draws the frame, unless it equals the one before; true if it did.
bool Application::draw(glm::ivec2 size, bool panelsChanged) {
    const bool viewChanged = painter_.draw(context_, areas_.view, imgui_->em());
    const bool otherViewChanged = compare_.draw(areas_.otherView, imgui_->em());
    // A picture is read from what this frame draws.
    const bool forced = redraws_ > 0 || ui_.takesPicture;
    redraws_ = std::max(redraws_ - 1, 0);
    // A view of another size is shown only with its picture: until then the frame before stays, if
    // the window has it.
    const bool late = painter_.late() || compare_.late();
    if (!forced && (late || !(viewChanged || otherViewChanged || panelsChanged))) return false;
    const auto& tile = ui_.picture.tile;
    clearFrame(tile ? tile->size : size, palette().panel);
    imgui_->draw(tile);
    return true;
}

/// What follows the drawing: changes are recorded, deferred calls are made, pictures are taken.
void Application::endFrame(glm::ivec2 size) {
    if (options_.narrate) narrate();
    ui_.typing.endFrame(ImGui::GetIO().WantTextInput);
    history_.observe(ImGui::IsAnyMouseDown() || ImGui::GetIO().WantTextInput);
    ui_.betweenFrames.endDrawing();
    export_->advance();
    ui_.unsaved = document_.unsaved();
    // A picture requested while this frame was drawn is taken from the next one.
    if (ui_.takesPicture && (painter_.onPaper() || !session_.ready())) {
        ui_.takesPicture = false;
        saveWindowPicture(size);
    }
    if (std::exchange(ui_.closesPopups, false)) {
        ImGui::SetWindowFocus(focused_);
        if (ui_.walk.at() != KeyStop::View) ui_.walk.leave();
    }
}

void Application::narrate() {
    if (!session_.ready() || session_.event() == nullptr || session_.moves().busy()) return;
    const std::string address = toString(session_.address());
    if (address == narrated_) return;
    narrated_ = address;
    std::printf(
        "%s\t%s\n", address.c_str(),
        printable(describe(*session_.event(), session_.names()) + session_.noticedText()).c_str());
    std::fflush(stdout);
}

void Application::saveWindowPicture(glm::ivec2 size) {
    // In the user's folder for pictures, not in the working directory.
    std::error_code error;
    const char* home = std::getenv("HOME");
    std::filesystem::path folder = home != nullptr ? home : ".";
    if (std::filesystem::is_directory(folder / "Pictures", error)) folder /= "Pictures";
    const std::string place = session_.event() != nullptr ? toString(session_.address()) : "start";
    // A file that is there stays.
    const std::string stem = "spiraling-edge-" + place;
    std::filesystem::path path = folder / (stem + ".png");
    for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(path, error)); ++i)
        path = folder / (stem + "-" + std::to_string(i) + ".png");
    const Status status = writePicture(path, readPicture(size));
    session_.messages().say(status ? "Saved " + path.string() + "." : status.error().message);
}

/// The scale of text and panels. Present is read from a distance: it is so large that at most
/// kPresentLines em fit the height of the window, whatever its resolution.
float Application::scaleIn(glm::ivec2 size) const {
    constexpr float kPresentLines = 32.0F;
    constexpr float kLargest = 3.0F;
    const double chosen = ui_.settings.uiScale > 0.0 ? ui_.settings.uiScale : contentScale_;
    const auto scale = static_cast<float>(chosen);
    const bool present = ui_.layoutPreset == LayoutPreset::Present && !ui_.picture.viewAlone;
    const float fitting = static_cast<float>(size.y) / (kPresentLines * kEmPixels);
    return present ? std::max(scale, std::min(fitting, kLargest)) : scale;
}

WindowState Application::windowState() const {
    WindowState state;
    state.layoutPreset = ui_.layoutPreset;
    state.strip = ui_.navigation.strips;
    state.sizes = ui_.settings.panels;
    state.sheet = ui_.column.sheet;
    state.finished = session_.ready() && session_.atEnd();
    state.lesson = ui_.lesson.walk.isOpen();
    state.captionEms = ui_.lesson.captionEms;
    state.beside = ui_.compare.isIn(LayoutPreset::Present);
    // The lesson is needed for the answer.
    state.asks = ui_.lesson.hides();
    if (state.asks) state.sizes.folded = false;
    return state;
}

/// Switches the column to the task that the run calls for, unless the user has picked one.
void Application::followTask() {
    const std::string& source = session_.input().spec().source;
    if (std::exchange(taskOf_, source) != source && !ui_.lesson.walk.isOpen()) {
        ui_.column.reset();
        if (ui_.layoutPreset == LayoutPreset::Compare) actions::openPart(context_, kComparePart);
        finished_ = false;
        judged_ = false;
    }
    const bool finished = session_.ready() && session_.atEnd();
    if (std::exchange(finished_, finished) != finished && finished)
        ui_.column.suggest(Task::Faults);
    const RunAlerts& alerts = session_.alerts();
    if (std::exchange(judged_, alerts.done()) != alerts.done() && alerts.done() && !alerts.sound())
        ui_.column.note(Task::Faults);
}

PanelRects Application::areasIn(glm::vec2 size) const {
    const float em = imgui_->em();
    if (ui_.picture.viewAlone) {
        const bool two = ui_.layoutPreset == LayoutPreset::Compare;
        const float dial = std::clamp(kDialShare * size.x, kDialLeast * em, kDialMost * em);
        // Each of two views has its own caption, in it.
        const bool below = ui_.picture.caption && !two;
        return viewAlone(size, {below ? std::round(kCaption * em) : 0.0F,
                                two ? std::round(kViewTitle * em) : 0.0F,
                                ui_.picture.dial ? std::round(dial) : 0.0F});
    }
    if (ui_.growth.open) return computePageRects(size, em);
    PanelRects rects = computePanelRects(size, em, windowState());
    // The start page replaces all panels.
    if (session_.startPage()) {
        rects.view = {{0.0F, rects.menu.size.y}, size - glm::vec2(0.0F, rects.menu.size.y)};
        rects.narration = {};
    }
    return rects;
}

void Application::character(const KeyPress& typed) {
    if (ui_.help == HelpPage::ChangeKeys) return;
    // The position of digits and signs differs between keyboards; a key with a command has acted.
    const std::optional<KeyChord> chord = chordOfSign(typed);
    if (chord && commandFor(typed.chord) == nullptr) key(*chord, typed.repeated);
}

bool Application::key(const KeyChord& chord, bool repeated) {
    if (ui_.keyCapture.active()) {
        ui_.keyCapture.press(chord, ui_.settings.keys);
        return false;
    }
    if (firstRun_.key()) return false;
    const ImGuiIO& io = ImGui::GetIO();
    if (chord.key == key::kEscape && io.WantTextInput && !ui_.coversView()) {
        // Dear ImGui would undo the edit of the text.
        ImGui::ClearActiveID();
        return true;
    }
    const bool enter = chord.key == key::kEnter || chord.key == key::kKeypadEnter;
    const bool panel = ui_.walk.at() != KeyStop::View || (session_.startPage() && !ui_.growth.open);
    if (enter && chord.mods == kNoMods && panel && io.NavVisible && !io.WantTextInput &&
        !ui_.coversView()) {
        // Dear ImGui itself handles Space only.
        ImGui::ActivateItem(ImGui::GetFocusID());
        return true;
    }
    if (endsBlankScreen(chord)) return true;
    const bool over = io.WantTextInput || ui_.coversView() || ui_.popupOpen;
    if (!over && !repeated && runOnPieceTool(chord, context_)) return true;
    if (!over && !repeated && answerByKey(chord, context_)) return true;
    if (isShiftKey(chord.key) && !repeated) ui_.look.shift(true, ui_.clock);
    const Command* command = commandFor(chord);
    // A question comes first.
    if (ui_.leaving.asked && command != findCommand("help.leave")) return false;
    if (command == nullptr || (repeated && !command->repeats)) return false;
    const bool closes = ui_.help == HelpPage::Keys && command == findCommand("help.keys");
    const Keyboard keyboard{io.WantTextInput, ui_.coversView() && !closes,
                            io.NavVisible && io.WantCaptureKeyboard && !isOfLesson(*command)};
    const bool reaches = reachesActions(chord, keyboard);
    if (reaches && !holdsLook(*command, chord.key)) runCommand(*command, context_);
    // Dear ImGui's own navigation is not used.
    return reaches && chord.key == key::kTab;
}

/// Any key shows the blanked window again, and does nothing else.
bool Application::endsBlankScreen(const KeyChord& chord) {
    if (ui_.blank == BlankScreen::None || isModifierKey(chord.key)) return false;
    ui_.blank = BlankScreen::None;
    return true;
}

/// The commands of the open lesson come before those of panels and of a presenter's remote control.
bool Application::isOfLesson(const Command& command) const {
    return ui_.lesson.walk.isOpen() && command.id.starts_with("lesson.");
}

/// The command of a key in the present layout.
const Command* Application::commandFor(const KeyChord& chord) const {
    const Command* usual = ui_.settings.keys.commandFor(chord);
    if (usual != nullptr && isOfLesson(*usual)) return usual;
    const bool present = ui_.layoutPreset == LayoutPreset::Present && !ui_.growth.open;
    const Command* first = present ? presenterCommandFor(chord) : nullptr;
    // In a lesson the start of what is shown is the position of its step.
    if (first != nullptr && first == findCommand("run.start") && ui_.lesson.walk.isOpen())
        return findCommand("lesson.return");
    return first != nullptr ? first : usual;
}

/// The two actions that last while their key is held.
bool Application::holdsLook(const Command& command, int key) {
    if (ui_.growth.open) return false;
    const bool blinks = &command == findCommand("step.blink");
    if (!blinks && &command != findCommand("step.before")) return false;
    ui_.look.begin(blinks ? LookBack::Mode::Blink : LookBack::Mode::Before, key, ui_.clock);
    return true;
}

void Application::keyReleased(const KeyChord& chord) {
    ui_.look.released(chord.key);
    if (isShiftKey(chord.key)) ui_.look.shift(false, ui_.clock);
}

}  // namespace se::view
