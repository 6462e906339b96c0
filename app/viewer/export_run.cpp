#include "export_run.h"

#include <imgui.h>

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "commands/command_actions.h"
#include "export/lesson_frames.h"
#include "picture_frames.h"
#include "render/context.h"
#include "scene/decision_view.h"
#include "session/view_position.h"
#include "spiraling_edge/replay/event_text.h"
#include "teach/lesson_text.h"

namespace se::view {

namespace {

/// Share of the view that the points of a range fill.
constexpr float kRangeShare = 0.72F;
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

Theme otherTheme(Theme theme) { return theme == Theme::Dark ? Theme::Light : Theme::Dark; }

/// The steps to export, from 0.
std::vector<std::size_t> chosenSteps(const ExportOrder& order) {
    std::vector<std::size_t> steps(order.lesson->lesson.steps.size());
    std::iota(steps.begin(), steps.end(), std::size_t{0});
    if (order.steps.empty()) return steps;
    steps.clear();
    for (const std::size_t step : order.steps) steps.push_back(step - 1);
    return steps;
}

}  // namespace

ExportRun::ExportRun(const Options& options, ViewSettings settings)
    : options_(options),
      settings_(std::move(settings)),
      order_(*options.exported),
      format_(exportFormatOf(order_.path)),
      runs_(order_.lesson ? order_.lesson->folder : std::filesystem::path()) {
    assert(format_ != nullptr);
    PictureLook& look = options_.picture;
    look.viewAlone = look.pointLabels = true;
    look.caption = order_.captions && format_->captioned;
    // Not those of the window that the settings come from.
    options_.layout = LayoutPreset::Debug;
    if (options_.session) options_.session->layout.reset();
    size_ = drawnSize(settings_, look);
}

ExportRun::~ExportRun() {
    const ImGuiScope scope(context_);
    application_.reset();
}

void ExportRun::advance(bool waits) {
    const ImGuiScope scope(context_);
    carryOut(waits);
}

void ExportRun::carryOut(bool waits) {
    switch (phase_) {
        case Phase::Starting:
            return start();
        case Phase::Opening:
            return open(waits);
        case Phase::Planning:
            return plan();
        case Phase::Frames:
            return makeFrame();
        case Phase::Done:
            return;
    }
}

void ExportRun::fail(int code, std::string message) {
    writer_.reset();
    failure_ = ExportFailure{code, std::move(message)};
    phase_ = Phase::Done;
}

void ExportRun::start() {
    if (order_.lesson) {
        steps_ = chosenSteps(order_);
        Result<InputSpec> input = inputOfStep(*order_.lesson, steps_.front());
        if (!input)
            return fail(kExitInput,
                        stepPlace(*order_.lesson, steps_.front(), "rules") + input.error().message);
        options_.input = opened_ = input.value();
        options_.goTo = "0";
    }
    if (const Status small = checkSize(); !small) return fail(kExitUsage, small.error().message);
    application_ = std::make_unique<Application>(options_, settings_);
    if (const Status begun = application_->start(1.0F); !begun)
        return fail(kExitNoDisplay, begun.error().message);
    context_ = ImGui::GetCurrentContext();
    ui().follow = false;
    phase_ = Phase::Opening;
}

Status ExportRun::checkSize() const {
    const int most = greatestPicture();
    if (std::max(size_.x, size_.y) <= most) return success();
    return Error{"this graphics card draws at most " + std::to_string(most) +
                 " pixels a side; choose a smaller --size, --scale or --supersample"};
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
    camera.fill(places, ui().viewAspect, kRangeShare);
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

/// Opens the input of a step, if the one before had another.
Status ExportRun::openStep(std::size_t step) {
    const LessonFile& file = *order_.lesson;
    Result<InputSpec> input = inputOfStep(file, step);
    if (!input) return Error{stepPlace(file, step, "rules") + input.error().message};
    const bool fresh = !(input.value() == opened_);
    opened_ = input.value();
    if (fresh) {
        session().open(opened_);
        session().waitUntilDone();
        if (application_->inputFailed())
            return Error{stepPlace(file, step, "") + session().input().error()};
        draw(1);
    }
    const teach::StepSetting setting = teach::settingOf(file.lesson, step);
    const Status moved = goTo(setting.at == "0" ? "" : setting.at);
    if (!moved) return Error{stepPlace(file, step, "at") + moved.error().message};
    ui().settings.layers = layersOfStep(settings_.layers, file.lesson.steps[step]);
    session().select(selectionOfStep(file.lesson.steps[step], setting.names));
    names_ = setting.names;
    pointNames_ = teach::pointNames(names_);
    session().giveNames(pointNames_);
    const bool first = step == steps_.front();
    if (fresh || first || !file.lesson.steps[step].frame.empty() ||
        !file.lesson.steps[step].camera.empty() || !file.lesson.steps[step].view.empty())
        aimAtStep(file.lesson.steps[step], step);
    return success();
}

/// Camera of a step: its own, or the direction of its view at the decision or at all.
void ExportRun::aimAtStep(const teach::LessonStep& step, std::size_t number) {
    Camera& camera = application_->camera();
    if (!step.camera.empty()) {
        const Result<ViewPosition> place = viewPositionFromText(step.camera);
        if (place && place.value().camera) return camera.setPose(*place.value().camera);
    }
    const auto direction = teach::viewDirection(teach::settingOf(order_.lesson->lesson, number));
    if (direction) camera.faceStraight(glm::vec3(*direction));
    if (step.frame == "all") return actions::frameAll(application_->commands());
    frameFocus(application_->commands());
    if (direction) return camera.faceStraight(glm::vec3(*direction));
    lookAtDecision(session().shown(), session().picture(), session().shownTriangles(), camera,
                   ui().viewEms);
}

void ExportRun::draw(int frames) { pixels_ = drawPicture(*application_, target_, size_, frames); }

void ExportRun::makeFrame() {
    std::optional<std::size_t> step;
    if (order_.lesson) step = steps_[made_];
    const Status there = step ? openStep(*step) : goTo(plan_.places[made_]);
    if (!there) return fail(step ? kExitInput : kExitUsage, there.error().message);
    const Status added = step ? addStep(*step) : addFrame(nullptr, false);
    // Of a lesson, an answer that the run does not give has been reported already.
    if (!added && !done()) return fail(kExitInternal, added.error().message);
    if (done() || ++made_ < total()) return;
    if (const Status finished = writer_->finish(); !finished)
        return fail(kExitInternal, finished.error().message);
    phase_ = Phase::Done;
}

/// The frame of a step; on a page, that of the answer to its question as well.
Status ExportRun::addStep(std::size_t step) {
    const LessonFile& file = *order_.lesson;
    FrameStep of{file.lesson, step, teach::settingOf(file.lesson, step).names, file.folder};
    const bool asks =
        file.lesson.steps[step].question && format_->content == FrameContent::BothThemes;
    if (!asks) return addFrame(&of, false);
    const Result<teach::RightAnswer> right = teach::rightAnswer(file.lesson, step, runs_);
    if (!right) {
        fail(kExitInput, stepPlace(file, step, "") + "answer: " + right.error().message);
        return right.error();
    }
    of.right = &right.value();
    if (const Status added = addFrame(&of, false); !added) return added;
    goToAnswer(step);
    return addFrame(&of, true);
}

/// Goes to where the question of a step is answered: to the end of the pivot, without a position.
void ExportRun::goToAnswer(std::size_t step) {
    const std::string place = teach::settingOf(order_.lesson->lesson, step).answerPlace;
    if (!place.empty() && goTo(place)) return;
    session().moves().finishPivot();
    session().waitUntilDone();
}

Status ExportRun::addFrame(const FrameStep* step, bool answer) {
    ExportFrame frame;
    frame.answer = answer;
    frame.step = step;
    frame.address = session().event() != nullptr ? toString(session().address()) : "";
    frame.caption = sentenceAt(session());
    if (step != nullptr) frame.title = step->lesson.steps[step->step].title;
    ui().picture.captionText = frame.title;
    if (format_->content != FrameContent::Pixels) return addShapes(frame);
    draw(1);
    frame.pixels = std::move(pixels_);
    return writer_->add(frame);
}

/// Shapes of a frame; for both themes it is made in the other one first.
Status ExportRun::addShapes(ExportFrame& frame) {
    std::optional<DrawList> other;
    if (format_->content == FrameContent::BothThemes) {
        ui().settings.theme = otherTheme(settings_.theme);
        draw(1);
        other = application_->drawn();
        ui().settings.theme = settings_.theme;
    }
    draw(1);
    const glm::vec2 size = application_->viewSize();
    const FrameShapes shapes{application_->drawn(),
                             other ? &*other : nullptr,
                             session().shown(),
                             session().triangles(),
                             application_->camera().matrices(size.x / size.y),
                             size,
                             application_->em(),
                             paletteOf(settings_.theme).background,
                             paletteOf(otherTheme(settings_.theme)).background,
                             ui().labels};
    frame.shapes = &shapes;
    return writer_->add(frame);
}

std::string ExportRun::doneText() const {
    const std::string what = made_ == 1 ? "a frame" : std::to_string(made_) + " frames";
    return "Saved " + what + " as " + order_.path.string() + ".";
}

}  // namespace se::view
