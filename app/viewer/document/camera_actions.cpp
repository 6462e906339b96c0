#include "camera_actions.h"

#include "actions.h"
#include "scene/decision_view.h"
#include "scene/framing.h"

namespace se::view {

namespace {

/// The points of the chosen place with faults, or of the chosen alert: those of the triangles as
/// well, of which an edge shows too little.
std::vector<Index> pointsOfFault(const RunAlerts& alerts) {
    std::vector<Index> points;
    if (alerts.place()) {
        for (const std::size_t i : alerts.search().places()[*alerts.place()].faults) {
            const std::vector<Index>& ofFault = alerts.search().found()->all[i].points;
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

}  // namespace

void frameDecision(CommandContext& context, std::optional<glm::vec3> from) {
    const Session& session = context.session;
    if (!session.ready()) return;
    const Figure* figure = figureOfSource(session.input().spec().source);
    if (figure != nullptr && !from) from = glm::vec3(figure->view);
    lookAtDecision(session.shown(), session.picture(), session.shownTriangles(),
                   context.ui.viewPart(), context.camera, from);
}

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

void frameStep(CommandContext& context, bool all, const std::optional<Vec3>& direction) {
    const DecisionState& picture = context.session.picture();
    std::optional<glm::vec3> from;
    if (direction) from = glm::vec3(*direction);
    if (!all && (picture.pivot != kNone || picture.underTest != kNone))
        return frameDecision(context, from);
    if (from) context.camera.faceStraight(*from);
    actions::frameAll(context);
}

void frameRequested(CommandContext& context, FrameRequest request) {
    const Session& session = context.session;
    switch (request) {
        case FrameRequest::None:
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

void swing(CommandContext& c) { c.ui.cameraMove.swing(c.camera); }

}  // namespace actions

}  // namespace se::view
