#include "export_run.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "compare/comparison.h"
#include "document/actions.h"
#include "document/document.h"
#include "document/link.h"
#include "document/link_actions.h"
#include "document/ui_state.h"
#include "lesson/lesson_player.h"
#include "panels/ui.h"
#include "render/relief.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

double textScale(glm::ivec2 size) {
    return std::max(1.0, std::min(size.x / 1280.0, size.y / 800.0));
}

glm::ivec2 drawnSize(ViewSettings& settings, const PictureLook& look) {
    const double factor = look.scale * look.supersample;
    if (factor != 1.0)
        settings.uiScale = factor * (settings.uiScale > 0.0 ? settings.uiScale : 1.0);
    const auto pixels = [&](int side) {
        return look.supersample * static_cast<int>(std::lround(look.scale * side));
    };
    return {pixels(settings.width), pixels(settings.height)};
}

namespace {

/// The last of `frames` frames of a window of `size` pixels, or what its tile of `drawn` pixels
/// shows of it, reduced by `factor`.
Picture drawTile(Application& application, Target& target, glm::ivec2 size, glm::ivec2 drawn,
                 int frames, int factor) {
    const auto draw = [&] {
        target.begin(drawn);
        for (int i = 0; i < frames; ++i) {
            application.redraw();
            application.poll();
            application.frame(size, 1.0 / 60.0);
        }
        Picture picture = readPicture(drawn);
        target.end();
        return picture;
    };
    if (!application.context().ui.picture.cutOut) return reduced(draw(), factor);
    application.setBackground(fromHex(0x000000));
    const Picture onBlack = draw();
    application.setBackground(fromHex(0xFFFFFF));
    return reduced(cutOut(onBlack, draw()), factor);
}

}  // namespace

Status checkDrawn(glm::ivec2 size, double uiScale, int most) {
    const float em = std::round(kEmPixels * static_cast<float>(uiScale > 0.0 ? uiScale : 1.0));
    const bool whole = std::max(size.x, size.y) <= most;
    if (whole || !tilesOf(size, most, Relief::reach(em), 1).empty()) return success();
    return Error{"this graphics card draws at most " + std::to_string(most) +
                 " pixels a side, too few for text of that size; choose a smaller --scale or "
                 "--supersample"};
}

Picture drawPicture(Application& application, Target& target, glm::ivec2 size, int frames,
                    int most) {
    PictureLook& look = application.context().ui.picture;
    if (std::max(size.x, size.y) <= most)
        return drawTile(application, target, size, size, frames, look.supersample);
    // Only the layout of the whole is needed before its tiles.
    look.tile = kLayoutAlone;
    if (frames > 1) drawTile(application, target, size, look.tile->size, frames - 1, 1);
    const int factor = look.supersample;
    Picture whole{size / factor, {}};
    whole.rgba.resize(static_cast<std::size_t>(whole.size.x) *
                      static_cast<std::size_t>(whole.size.y) * 4);
    for (const PictureTile& tile : tilesOf(size, most, Relief::reach(application.em()), factor)) {
        look.tile = tile;
        const glm::ivec2 corner(tile.min.x, size.y - tile.min.y - tile.size.y);
        copyInto(whole, corner / factor, drawTile(application, target, size, tile.size, 1, factor));
    }
    look.tile.reset();
    return whole;
}

namespace {

namespace fs = std::filesystem;

/// Frames in which the layout comes to rest.
constexpr int kFirstFrames = 4;

/// Makes a context of Dear ImGui the current one for a while.
class ImGuiScope {
  public:
    explicit ImGuiScope(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
        ImGui::SetCurrentContext(context);
    }
    ~ImGuiScope() { ImGui::SetCurrentContext(before_); }
    ImGuiScope(const ImGuiScope&) = delete;
    ImGuiScope& operator=(const ImGuiScope&) = delete;

  private:
    ImGuiContext* before_;
};

std::string sentenceAt(const Session& session) {
    const Event* event = session.event();
    if (event == nullptr) return "Nothing has happened yet: all points are UNUSED.";
    return describe(*event, session.names()) + session.noticedText();
}

/// The steps to export, from 0.
std::vector<std::size_t> chosenSteps(const ExportOrder& order) {
    std::vector<std::size_t> steps(order.lesson->lesson.steps.size());
    std::iota(steps.begin(), steps.end(), std::size_t{1});
    if (!order.steps.empty()) steps = order.steps;
    for (std::size_t& step : steps) --step;
    return steps;
}

bool hasOwnView(const teach::LessonStep& step) {
    return !step.frame.empty() || !step.camera.empty() || !step.view.empty();
}

}  // namespace

ExportRun::ExportRun(const Options& options, ViewSettings settings)
    : options_(options),
      settings_(std::move(settings)),
      order_(*options.exported),
      format_(exportFormatOf(order_.path)) {
    assert(format_ != nullptr);
    PictureLook& look = options_.picture;
    look.viewAlone = look.pointLabels = true;
    look.dial = order_.dial;
    look.caption = order_.captions && format_->captioned;
    // Not those of the window that the settings come from.
    options_.layout = LayoutPreset::Debug;
    if (options_.session) options_.session->layout.reset();
    if (settings_.uiScale <= 0.0)
        settings_.uiScale = textScale({settings_.width, settings_.height});
    size_ = drawnSize(settings_, look);
}

ExportRun::~ExportRun() {
    const ImGuiScope scope(context_);
    application_.reset();
}

void ExportRun::advance(bool waits) {
    const ImGuiScope scope(context_);
    if (phase_ == Phase::Starting) return start();
    if (phase_ == Phase::Opening) return open(waits);
    if (phase_ == Phase::Planning) return plan();
    if (phase_ == Phase::Frames) makeFrame();
}

void ExportRun::fail(int code, std::string message) {
    writer_.reset();
    failure_ = ExportFailure{code, std::move(message)};
    phase_ = Phase::Done;
}

void ExportRun::start() {
    if (order_.lesson) {
        steps_ = chosenSteps(order_);
        walk_.open(order_.lesson, steps_.front());
        options_.input = inputOfStep(walk_.setting(), walk_.folder()).value();
        options_.goTo = "0";
    }
    if (const Status drawn = checkDrawn(size_, settings_.uiScale); !drawn)
        return fail(kExitUsage, drawn.error().message);
    application_ = std::make_unique<Application>(options_, settings_);
    if (const Status begun = application_->start(1.0F); !begun)
        return fail(kExitNoDisplay, begun.error().message);
    context_ = ImGui::GetCurrentContext();
    shown_.emplace(application_->context());
    ui().follow = Follow::Never;
    phase_ = Phase::Opening;
}

void ExportRun::open(bool waits) {
    if (!waits && !application_->inputFailed()) {
        application_->poll();
        if (!session().ready() || session().input().phase() == SessionPhase::Loading) return;
    }
    if (const Status opened = application_->waitUntilDone(); !opened)
        return fail(application_->inputFailed() ? kExitInput : kExitUsage, opened.error().message);
    draw(kFirstFrames);
    phase_ = Phase::Planning;
}

void ExportRun::plan() {
    if (order_.lesson) {
        plan_.places.resize(steps_.size());
    } else if (order_.range) {
        Result<FramePlan> planned = planFrames(session().model(), *order_.range);
        if (!planned) return fail(kExitUsage, planned.error().message);
        plan_ = std::move(planned.value());
        placeCamera();
    } else {
        plan_.places = {session().event() != nullptr ? toString(session().address()) : ""};
        aimAtFigure();
    }
    const ExportTarget target{order_.path,
                              order_.lesson ? order_.lesson->lesson.title : session().model().name,
                              size_ / options_.picture.supersample,
                              plan_.places.size(),
                              order_.several(),
                              order_.captions,
                              order_.perSecond,
                              settings_.theme,
                              options_.picture.cutOut};
    Result<std::unique_ptr<FrameWriter>> writer = format_->open(target);
    if (!writer) return fail(kExitInternal, writer.error().message);
    writer_ = std::move(writer.value());
    phase_ = Phase::Frames;
}

/// One camera for all frames: that of the command line or the session, or one that holds the points
/// of all decisions.
void ExportRun::placeCamera() {
    if (options_.camera || options_.session) return;
    const Model& model = session().model();
    std::vector<glm::vec3> places;
    places.reserve(plan_.points.size());
    for (const Index p : plan_.points) places.push_back(model.place[p]);
    if (places.empty()) return;
    glm::vec3 normal(0.0F);
    for (const Index p : plan_.pivots) normal += model.normal[p];
    Camera& camera = application_->camera();
    const Figure* figure = figureOfSource(session().input().spec().source);
    if (figure != nullptr) {
        camera.faceStraight(glm::vec3(figure->view));
    } else if (glm::length(normal) > 1e-3F) {
        camera.face(glm::normalize(normal));
    }
    camera.fill(places, ui().viewPart(), kDecisionShare);
}

/// A single frame of a figure of the paper is seen as the figure.
void ExportRun::aimAtFigure() {
    const Figure* figure = figureOfSource(session().input().spec().source);
    if (figure == nullptr || options_.camera || options_.session) return;
    // A given start has few points: all of them are the figure, with room for what is drawn around.
    const Model& model = session().model();
    if (model.params.start.empty()) return frameDecision(application_->context());
    Camera& camera = application_->camera();
    camera.faceStraight(glm::vec3(figure->view));
    camera.fill(model.place, ui().viewPart(), kDecisionShare);
}

Status ExportRun::goTo(const std::string& place) {
    if (place.empty()) {
        session().moves().toStart();
    } else if (const Status moved = session().moves().goToText(place); !moved) {
        return moved;
    }
    session().waitUntilDone();
    if (session().messages().missed()) return Error{session().messages().last()};
    return success();
}

void ExportRun::draw(int frames) { pixels_ = drawPicture(*application_, target_, size_, frames); }

void ExportRun::makeFrame() {
    std::optional<std::size_t> step;
    if (order_.lesson) step = steps_[made_];
    const Status there = step ? openStep(*step) : goTo(plan_.places[made_]);
    if (!there) return fail(step ? kExitInput : kExitUsage, there.error().message);
    const Status added = step ? addStep() : addFrame(nullptr, false);
    if (!added) return fail(kExitInternal, added.error().message);
    if (++made_ < total()) return;
    if (const Status finished = writer_->finish(); !finished)
        return fail(kExitInternal, finished.error().message);
    phase_ = Phase::Done;
}

/// The sentence at the cursor, or those of both runs.
std::string ExportRun::caption() {
    const Session* other = application_->otherSession();
    if (other == nullptr) return sentenceAt(session());
    const auto titles = comparedTitles(session(), ui().compare.now);
    return titles[0].text() + ": " + sentenceAt(session()) + " " + titles[1].text() + ": " +
           sentenceAt(*other);
}

Status ExportRun::addFrame(const FrameStep* step, bool answer) {
    ExportFrame frame;
    frame.answer = answer;
    frame.step = step;
    frame.address = session().event() != nullptr ? toString(session().address()) : "";
    frame.caption = caption();
    if (step != nullptr) frame.title = step->lesson.steps[step->step].title;
    frame.link = linkToProgram();
    // Below two views stands the sentence of each.
    const bool two = application_->otherSession() != nullptr;
    ui().picture.captionText = two ? "" : frame.title;
    if (format_->content != FrameContent::Pixels) return addShapes(frame);
    draw(1);
    frame.pixels = std::move(pixels_);
    return writer_->add(frame);
}

/// Links to the program at addresses of the open run; null if there are none.
std::function<std::string(const std::string&)> ExportRun::linkToProgram() {
    if (order_.viewer.empty() || format_->content != FrameContent::BothThemes) return {};
    Options there;
    there.input = session().input().spec();
    const LinkedSource linked = linkedSource(there.input.source);
    const bool whole = linked.notice.empty() && there.input.start.empty();
    if (!whole) {
        notice_ = "addresses of " + fs::path(there.input.source).filename().string() +
                  " are no links: " +
                  (there.input.start.empty() ? "its points are too many for a link, or not a file"
                                             : "a link has no --start");
        return {};
    }
    there.input.source = linked.source;
    return [there, viewer = order_.viewer](const std::string& address) mutable {
        there.goTo = address;
        return viewer + "#" + linkText(there);
    };
}

/// Shapes of a frame; for both themes it is made in the other one first.
Status ExportRun::addShapes(ExportFrame& frame) {
    std::array<std::optional<DrawList>, 2> others;
    if (format_->content == FrameContent::BothThemes) {
        ui().settings.theme = otherTheme(settings_.theme);
        draw(1);
        others[0] = application_->drawn();
        if (application_->otherSession() != nullptr) others[1] = application_->otherDrawn();
        ui().settings.theme = settings_.theme;
    }
    draw(1);
    const PanelRects& areas = application_->areas();
    const auto titles = comparedTitles(session(), ui().compare.now);
    std::vector<FrameShapes> views{
        shapesOf(session(), application_->drawn(), areas.view, others[0])};
    if (Session* other = application_->otherSession()) {
        views.push_back(shapesOf(*other, application_->otherDrawn(), areas.otherView, others[1]));
        for (DrawnLabel& each : ui().labels[1]) each = each.movedBy(-areas.otherView.min);
        for (DrawnLabel& each : ui().labels[0]) each = each.movedBy(-areas.view.min);
        views[0].bar = areas.title;
        views[1].bar = areas.otherTitle;
        for (std::size_t i = 0; i < views.size(); ++i) views[i].title = &titles[i];
        views[1].labels = ui().labels[1];
    }
    FrameDial dial;
    if (areas.dial.size.x > 0.0F) {
        const Model& model = session().shown();
        dial = {makeDial(model.points, model.params, session().picture()), areas.dial,
                session().names()};
        frame.dial = &dial;
    }
    frame.shapes = views;
    frame.size = glm::vec2(size_);
    return writer_->add(frame);
}

/// The shapes of the view of a run; `other`: its list in the other theme.
FrameShapes ExportRun::shapesOf(const Session& run, const DrawList& list, const Rect& view,
                                const std::optional<DrawList>& other) {
    FrameShapes shapes{list,
                       other ? &*other : nullptr,
                       run.shown(),
                       run.triangles(),
                       application_->camera().matrices(view.size.x / view.size.y),
                       view.size,
                       application_->em(),
                       ui().labels[0]};
    shapes.corner = view.min;
    shapes.theme = settings_.theme;
    return shapes;
}

std::string ExportRun::doneText() const {
    const std::string what = made_ == 1 ? "a frame" : std::to_string(made_) + " frames";
    return "Saved " + what + " as " + order_.path.string() + ".";
}

/// Opens the input of a step, if the one before had another, and shows the step.
Status ExportRun::openStep(std::size_t step) {
    const bool wasSplit = ui().layoutPreset == LayoutPreset::Compare;
    shown_->leave();
    walk_.goTo(step);
    const teach::LessonStep& shown = walk_.shownStep();
    const auto fault = [&](std::size_t line, const std::string& message) {
        return Error{walk_.lesson().name + ":" + std::to_string(line) + ": " + message};
    };
    // It could be read: the lesson has no faults.
    const RunSpec input = inputOfStep(walk_.setting(), walk_.folder()).value();
    if (!(session().input().spec() == input)) {
        session().open(input);
        session().waitUntilDone();
        if (application_->inputFailed()) return fault(shown.line, session().input().error());
        draw(1);
    }
    const std::string& at = walk_.setting().at;
    if (const Status moved = goTo(at == "0" ? "" : at); !moved) return moved;
    shown_->enter(walk_);
    if (!shown.question && !shown.compare.empty()) shown_->compare(walk_);
    if (const Status compared = showComparison(wasSplit); !compared) return compared;
    const bool resized = wasSplit != (ui().layoutPreset == LayoutPreset::Compare);
    const bool own = hasOwnView(shown);
    const FollowedDecision here{session().generation(), session().picture().pivot,
                                viewWayOf(session().shown(), session().picture())};
    // Steps of one decision have one camera.
    const bool before = std::exchange(ownView_, own);
    if (std::exchange(aimed_, here) == here && !resized && !own && !before) return success();
    const Status aimed = shown_->aim(walk_);
    return aimed ? aimed : fault(shown.lines.of("camera"), "camera: " + aimed.error().message);
}

/// Draws until the second run of a step is there, or that of the step before has gone.
Status ExportRun::showComparison(bool wasSplit) {
    if (!wasSplit && ui().layoutPreset != LayoutPreset::Compare) return success();
    draw(1);
    if (const Status done = application_->waitUntilDone(); !done) return done;
    draw(1);
    return success();
}

/// The frame of a step; on a page, that of the answer to its question as well.
Status ExportRun::addStep() {
    FrameStep of{walk_.lesson(), walk_.step(), walk_.setting().names, walk_.folder()};
    const bool asks = walk_.question() != nullptr && format_->content == FrameContent::BothThemes;
    if (!asks) return addFrame(&of, false);
    of.right = &walk_.right();
    if (const Status added = addFrame(&of, false); !added) return added;
    goToAnswer();
    if (!walk_.shownStep().compare.empty()) shown_->compare(walk_);
    const Status compared = showComparison(false);
    return compared ? addFrame(&of, true) : compared;
}

/// Goes to where the question of a step is answered: to the end of the pivot, without a position.
void ExportRun::goToAnswer() {
    const std::string& place = walk_.setting().answerPlace;
    if (!place.empty() && goTo(place)) return;
    session().moves().finishPivot();
    session().waitUntilDone();
}

namespace {

bool isExportOpen(const UiState& ui) { return ui.fileBrowser && ui.browser == BrowserTask::Export; }

}  // namespace

WindowExport::WindowExport(CommandContext& context) : c_(context) {}

WindowExport::~WindowExport() = default;

void WindowExport::advance() {
    ExportForm& form = c_.ui.exported;
    if (form.working && !run_) {
        form.working = c_.session.ready();
        if (form.working) begin();
    }
    if (!run_) return;
    // A closed dialog cancels as its button does.
    if (!form.working || !isExportOpen(c_.ui)) {
        form.complaint = "Cancelled.";
        c_.session.messages().say("The export was cancelled.");
        return end();
    }
    run_->advance(false);
    form.made = run_->made();
    form.total = run_->total();
    if (!run_->done()) return;
    if (const auto& failure = run_->failure()) {
        form.complaint = failure->message;
    } else {
        c_.ui.fileBrowser = false;
        c_.session.messages().say(run_->doneText());
    }
    end();
}

/// Begins with the input, position, camera and layers of the window, or with the open lesson.
void WindowExport::begin() {
    ExportForm& form = c_.ui.exported;
    const Session& session = c_.session;
    const LessonWalk& walk = c_.ui.lesson.walk;
    const std::string address = session.event() != nullptr ? toString(session.address()) : "";
    Result<ExportOrder> order = form.order(address, walk.opened());
    form.complaint = order ? "" : order.error().message;
    form.working = order.ok();
    if (!order) return;
    ViewSettings settings = c_.ui.settings;
    Options options;
    options.noConfig = true;
    if (order.value().lesson) {
        settings.layers = c_.lesson.layersOfUser();
    } else {
        options.session = captureSession(c_);
        options.session->with = {};
        options.session->alert.clear();
        options.input = options.session->input;
    }
    options.exported = std::move(order.value());
    options.exported->viewer = webAddress();
    settings.width = pictureSize(form.size)->x;
    settings.height = pictureSize(form.size)->y;
    settings.uiScale = 0.0;
    run_ = std::make_unique<ExportRun>(options, settings);
    form.made = form.total = 0;
}

void WindowExport::end() {
    run_.reset();
    c_.ui.exported.working = false;
}

}  // namespace se::view
