#include "actions.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compare/compared_runs.h"
#include "document.h"
#include "mesh_saving.h"
#include "new_points.h"
#include "piece_actions.h"
#include "run/model.h"
#include "run/packed_file.h"
#include "scene/framing.h"

namespace se::view {

namespace actions {

using C = CommandContext;

namespace {

constexpr std::array kScales = {0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0};

void closeDialogs(UiState& ui) {
    ui.help = HelpPage::None;
    ui.fileBrowser = false;
    ui.palette.open = false;
    ui.prepare.close();
}

}  // namespace

void pause(C& c) { c.playback.pause(); }

void escape(C& c) {
    UiState& ui = c.ui;
    if (ui.leaving.asked) return c.document.answer(LeaveAnswer::Cancel);
    // One thing at a time, the topmost first.
    const bool covered =
        ui.coversView() || ui.popupOpen || ui.prepare.open || ui.walk.at() != KeyStop::View;
    closeDialogs(ui);
    ui.offersTour = false;
    ui.closesPopups = true;
    if (covered) return;
    if (ui.growth.open) return c.sampling.leave();
    if (c.session.drag().held()) return c.session.drag().takeBack();
    if (ui.piece.on) return endPieceTool(c);
    if (c.session.moves().busySeconds() > kLongMove) return c.session.moves().cancel();
    const bool picked = c.session.selection().kind != SelectionKind::None ||
                        c.session.highlights().any() || c.session.alerts().chosen().has_value();
    c.session.select(Selection{});
    c.session.highlights().mark({});
    c.session.alerts().choose({});
    if (!picked && ui.layoutPreset == LayoutPreset::Present)
        applyLayoutPreset(c, LayoutPreset::Debug);
}

void nextMeshStyle(C& c) {
    MeshStyle& style = c.ui.settings.meshStyle;
    style = following(style);
    c.session.messages().say("Finished triangles: " + std::string(rowOf(style).title) + ".");
}

void toggleTheme(C& c) {
    Theme& theme = c.ui.settings.theme;
    theme = theme == Theme::Dark ? Theme::Light : Theme::Dark;
}

void oppositeView(C& c) {
    CameraPose pose = c.camera.pose();
    pose.yawDegrees += 180.0F;
    pose.pitchDegrees = -pose.pitchDegrees;
    c.camera.setPose(pose);
}

UpAxis usualUp(const C& c) {
    if (!c.session.ready() || c.ui.growth.open) return UpAxis::Z;
    const std::string& source = c.session.input().spec().source;
    if (isScene(source) || isSample(source) || isPractice(source)) return UpAxis::Z;
    if (c.ui.settings.up) return *c.ui.settings.up;
    return guessUpAxis(c.session.model().points, isPacked(source) ? packedName(source) : source);
}

void chooseUp(C& c, UpAxis axis) {
    c.ui.settings.up = axis;
    c.camera.setUp(axis);
    c.session.messages().say("Up axis: " + std::string(upAxisName(axis)) +
                             ", for this and all other files.");
}

void followUpAxis(C& c) {
    c.ui.settings.up.reset();
    c.camera.setUp(usualUp(c));
    c.session.messages().say("Up axis: " + std::string(upAxisName(c.camera.up())) +
                             " (automatic).");
}

void toggleBookmarkHere(C& c) {
    if (c.session.event() == nullptr)
        return c.session.messages().say("The start of the run cannot be bookmarked.");
    const Address here = c.session.address();
    const bool there = toggleBookmark(c.ui.bookmarks, here, c.camera.pose());
    c.session.messages().say((there ? "Bookmark set: " : "Bookmark removed: ") + toString(here) +
                             ".");
}

void resetRules(C& c) {
    RunSpec rules = c.session.input().rules();
    rules.choices.clear();
    c.document.rerun(rules);
}

void openBrowser(C& c, BrowserTask task) {
    c.ui.browser = task;
    c.ui.fileBrowser = true;
    c.ui.typing.open(TypedField::Dialog);
}

void openFor(C& c, BrowserTask task, const std::string& source) {
    if (task == BrowserTask::Mesh) return c.compare.begin(CompareWith::otherFile(source));
    if (task == BrowserTask::Volume) return c.sampling.openVolume(source);
    c.document.open(source);
}

void saveMesh(C& c) {
    pause(c);
    c.ui.mesh.clearLines();
    openBrowser(c, BrowserTask::SaveMesh);
}

void openPalette(C& c) {
    c.ui.palette.show();
    c.ui.typing.open(TypedField::Dialog);
}

void openGoTo(C& c) {
    c.ui.goTo = {true, {}};
    c.ui.typing.open(TypedField::GoTo);
}

void copyCommand(C& c) { c.mesh.copyCommand({}); }

void savePoints(C& c) {
    const bool made = c.session.ready() && c.session.input().spec().points != nullptr;
    if (c.ui.growth.open ? !c.sampling.growth().hasPoints() : !made) {
        return c.session.messages().say("There are no new points to save.");
    }
    openBrowser(c, BrowserTask::SavePoints);
}

void openPrepare(C& c) {
    pause(c);
    closeDialogs(c.ui);
    c.ui.prepare.take(c.session.input().spec(), c.session.model());
    c.ui.prepare.shown = c.session.generation();
    c.ui.typing.open(TypedField::Prepare);
    openPart(c, kPreparePart);
}

void toMark(C& c, int direction) {
    pause(c);
    const std::optional<Address> mark = c.session.nextMark(direction);
    const Bookmark* own = nextBookmark(c.ui.bookmarks, c.session.address(), direction);
    // A mark of the run has no number within its stage: it is at the first event.
    const bool ownIsNearer =
        own != nullptr &&
        (!mark || (direction > 0 ? isBefore(own->address, *mark) : isBefore(*mark, own->address)));
    if (ownIsNearer) return jumpingMoves(c).goTo(own->address);
    if (mark) return jumpingMoves(c).goTo(*mark);
    c.session.messages().say(
        direction > 0 ? "There is no split, join, seed, alert or bookmark after this one."
                      : "There is no split, join, seed, alert or bookmark before this one.");
}

void step(C& c) {
    pause(c);
    c.ui.offersTour = false;
    c.ui.column.suggest(Task::Step);
}

void playOrPause(C& c) {
    c.ui.column.suggest(Task::Step);
    // A long move to the next event must not continue after the pause.
    if (c.playback.playing() && c.playback.unit() == PlayUnit::Event) c.session.moves().cancel();
    c.playback.toggle();
}

void stepByUnit(C& c, int direction) {
    step(c);
    playSteps(c, direction);
}

void setLoop(C& c, const char* end, void (PlayLoop::*set)(const Address& address)) {
    (c.playback.loop.*set)(c.session.address());
    c.session.messages().say("Loop " + std::string(end) + ": " + toString(c.session.address()) +
                             ".");
}

void toggle(C& c, LayerId layer) { toggleLayer(c.ui.settings.layers, layer, c.session.stage()); }

namespace {

/// The comparison stays in sight while both runs are stepped through; then the panel before it is
/// there again.
void followLayout(C& c, LayoutPreset before) {
    Column& column = c.ui.column;
    const bool compares = c.ui.layoutPreset == LayoutPreset::Compare;
    if (compares == (before == LayoutPreset::Compare)) return;
    if (!compares) return column.takeBack();
    column.keep();
    column.open(*partNamed(kComparePart));
    setOpen(c.ui.settings.parts, *partNamed(kComparePart), true);
    column.chosen = true;
}

}  // namespace

void applyLayoutPreset(C& c, LayoutPreset layoutPreset) {
    const LayoutPreset before = std::exchange(c.ui.layoutPreset, layoutPreset);
    c.ui.blank = BlankScreen::None;
    const LayoutPresetRow& row = rowOf(layoutPreset);
    c.ui.follow = followIn(layoutPreset);
    followLayout(c, before);
    c.session.messages().say("Layout " + std::string(row.title) + ". " + std::string(row.help));
}

void blankScreen(C& c, BlankScreen with) {
    c.playback.pause();
    c.ui.blank = with;
}

void showPart(C& c, std::string_view title) {
    const PartRow* part = partNamed(title);
    assert(part != nullptr);
    if (c.ui.layoutPreset == LayoutPreset::Present) applyLayoutPreset(c, LayoutPreset::Debug);
    setOpen(c.ui.settings.parts, *part, true);
    c.ui.settings.panels.folded = false;
    c.ui.column.open(*part);
}

void openPart(C& c, std::string_view title) {
    showPart(c, title);
    c.ui.column.chosen = true;
}

void pickTask(C& c, Task task) {
    Column& column = c.ui.column;
    bool& folded = c.ui.settings.panels.folded;
    const bool open = c.ui.phone ? column.sheet : !folded;
    if (c.ui.layoutPreset == LayoutPreset::Present) applyLayoutPreset(c, LayoutPreset::Debug);
    if (open && column.task == task) return foldColumn(c);
    if (!c.ui.phone) folded = false;
    column.choose(task);
}

void turnSection(C& c, int direction) {
    constexpr double kTurn = 15.0;
    c.ui.section.turn(kTurn * direction);
    const bool shown =
        c.ui.column.task == Task::Step && isOpen(c.ui.settings.parts, *partNamed(kSectionPart));
    if (!shown) openPart(c, kSectionPart);
}

void foldColumn(C& c) {
    if (c.ui.phone) {
        c.ui.column.sheet = !c.ui.column.sheet;
    } else {
        c.ui.settings.panels.folded = !c.ui.settings.panels.folded;
    }
}

void goToCreation(C& c) {
    const std::optional<std::uint32_t> number = factsOf(c.session, c.session.selection()).number;
    const auto origin = number ? originOfTriangle(c.session.overview(), *number) : std::nullopt;
    if (!origin) return c.session.messages().say("The decision that made this is not known yet.");
    jumpingMoves(c).goTo(*origin);
}

void scaleBy(C& c, int direction) {
    double chosen = c.ui.scale;
    for (const double scale : kScales) {
        if (direction > 0 && scale > c.ui.scale + 0.01F) {
            chosen = scale;
            break;
        }
        if (direction < 0 && scale < c.ui.scale - 0.01F) chosen = scale;
    }
    c.ui.settings.uiScale = chosen;
}

void enterCompare(C& c) {
    pause(c);
    applyLayoutPreset(c, LayoutPreset::Compare);
}

void walkPanels(CommandContext& c, int direction) {
    if (c.ui.walk.go(direction)) c.ui.closesPopups = true;
}

}  // namespace actions

void playSteps(CommandContext& context, int count) {
    Session& session = context.session;
    const PlayLoop& loop = context.playback.loop;
    switch (context.playback.unit()) {
        case PlayUnit::SubStep:
            session.moves().stepEvent(count);
            break;
        case PlayUnit::Pivot:
            if (count > 0 && loop.complete() && session.ready()) {
                const auto here = static_cast<long>(session.record().pivot);
                const long rest = static_cast<long>(loop.to->pivot) - here;
                if (rest > 0) count = static_cast<int>(std::min<long>(count, rest));
            }
            session.moves().stepPivot(count);
            break;
        case PlayUnit::Event: {
            const std::optional<Address> mark = session.nextMark(count);
            if (mark) {
                session.moves().playTo(*mark);
            } else if (session.ready() && session.overview().complete) {
                context.playback.pause();
                session.messages().say(count > 0 ? "There is no event after this one."
                                                 : "There is no event before this one.");
            }
            break;
        }
    }
}

namespace {

/// The points of the chosen place with faults, or of the chosen alert: those of the triangles as
/// well, of which an edge shows too little.
std::vector<Index> pointsOfFault(const RunAlerts& alerts) {
    std::vector<Index> points;
    if (alerts.place()) {
        for (const std::size_t i : alerts.places()[*alerts.place()].faults) {
            const std::vector<Index>& ofFault = alerts.found()->all[i].points;
            points.insert(points.end(), ofFault.begin(), ofFault.end());
        }
    } else if (const RunFailure* alert = alerts.shown()) {
        points = alert->failure.points;
        if (isLoop(alert->failure)) return points;
        for (const Triangle& t : alert->corners) points.insert(points.end(), {t.a, t.b, t.c});
    }
    return points;
}

/// Moves the camera smoothly to what a function frames.
void moveTo(CommandContext& context, CameraMove::Kind kind, void (*frame)(CommandContext&)) {
    Camera aim = context.camera;
    CommandContext aimed = context.of(context.session, aim);
    frame(aimed);
    context.ui.cameraMove.begin(context.camera, aim.pose(), kind);
}

/// Frames the selection, else the decision at the cursor, else everything.
void frameFocus(CommandContext& context) {
    const Session& session = context.session;
    if (!session.ready()) return;
    const DecisionState& picture = session.picture();
    const auto selected = session.selection().corners();
    if (!selected.empty())
        return frameSelected(session.shown(), selected, context.ui.viewPart(), context.camera);
    if (picture.pivot == kNone && picture.underTest == kNone) return actions::frameAll(context);
    frameDecision(context);
}

}  // namespace

void frameDecision(CommandContext& context, std::optional<glm::vec3> from) {
    const Session& session = context.session;
    if (!session.ready()) return;
    const Figure* figure = figureOfSource(session.input().spec().source);
    if (figure != nullptr && !from) from = glm::vec3(figure->view);
    lookAtDecision(session.shown(), session.picture(), session.shownTriangles(),
                   context.ui.viewPart(), context.camera, from);
}

void frameStep(CommandContext& context, bool all, const std::optional<Vec3>& direction) {
    const DecisionState& picture = context.session.picture();
    std::optional<glm::vec3> from;
    if (direction) from = glm::vec3(*direction);
    if (!all && (picture.pivot != kNone || picture.underTest != kNone))
        return frameDecision(context, from);
    if (from) context.camera.faceStraight(*from);
    actions::frameAll(context);
}

Moves& jumpingMoves(CommandContext& context) {
    context.playback.pause();
    context.ui.frame = FrameRequest::Unseen;
    return context.session.moves();
}

FrameRequest resolved(const CommandContext& context, FrameRequest request) {
    if (request != FrameRequest::Unseen) return request;
    const Session& session = context.session;
    const Index pivot = session.ready() ? session.picture().pivot : kNone;
    const bool seen = pivot == kNone ||
                      isInView(session.shown().place[pivot], context.ui.viewPart(), context.camera);
    return seen ? FrameRequest::None : FrameRequest::Decision;
}

void frameRequested(CommandContext& context, FrameRequest request) {
    const Session& session = context.session;
    switch (request) {
        case FrameRequest::None:
        case FrameRequest::Unseen:
            break;
        case FrameRequest::Home:
            return actions::home(context);
        case FrameRequest::Focus:
            return frameFocus(context);
        case FrameRequest::Decision:
            return frameDecision(context);
        case FrameRequest::Fault:
            return frameFault(session.model(), pointsOfFault(session.alerts()),
                              context.ui.viewPart(), context.camera);
    }
}

void moveToDecision(CommandContext& context, CameraMove::Kind kind) {
    if (!context.session.ready() || context.session.picture().pivot == kNone) return;
    moveTo(context, kind, [](CommandContext& c) { frameDecision(c); });
}

void moveToAll(CommandContext& context, CameraMove::Kind kind) {
    moveTo(context, kind, actions::frameAll);
}

void followPivot(CommandContext& context) {
    const Model& model = context.session.shown();
    const Index pivot = context.session.picture().pivot;
    Camera aim = context.camera;
    centerPlace(model.place[pivot], model.normal[pivot], context.ui.viewPart(), aim);
    context.ui.cameraMove.begin(context.camera, aim.pose(), CameraMove::Kind::Followed);
}

namespace actions {

void home(CommandContext& c) {
    if (c.session.ready()) showBroadside(c.session.model(), c.ui.viewPart(), c.camera);
}

void frameAll(CommandContext& c) {
    if (c.session.ready()) frameModel(c.session.model(), c.ui.viewPart(), c.camera);
}

void frameSmoothly(CommandContext& c) {
    if (c.session.ready()) moveTo(c, CameraMove::Kind::Requested, frameFocus);
}

void toggleFollow(CommandContext& c) {
    const bool on = c.ui.follow != Follow::EachDecision;
    c.ui.follow = on ? Follow::EachDecision : Follow::Never;
    c.session.messages().say(on ? "The camera follows the decision."
                                : "The camera stays where it is.");
    if (on) moveToDecision(c, CameraMove::Kind::Requested);
}

}  // namespace actions

}  // namespace se::view
