#include "camera_actions.h"

#include "command_actions.h"
#include "scene/decision_view.h"

namespace se::view {

void frameDecision(CommandContext& context) {
    const Session& session = context.session;
    if (!session.ready()) return;
    const DecisionState& picture = session.picture();
    if (picture.pivot == kNone && picture.underTest == kNone) return;
    frameFocus(context);
    if (const Figure* figure = figureOfSource(session.input().spec().source))
        return context.camera.faceStraight(glm::vec3(figure->view));
    lookAtDecision(session.shown(), picture, session.shownTriangles(), context.camera,
                   context.ui.viewEms);
}

void moveToDecision(CommandContext& context, CameraMove::Kind kind) {
    const Session& session = context.session;
    if (!session.ready() || session.picture().pivot == kNone) return;
    Camera aim = context.camera;
    lookAtDecision(session.shown(), session.picture(), session.shownTriangles(), aim,
                   context.ui.viewEms);
    context.ui.cameraMove.begin(context.camera, aim.pose(), kind);
}

namespace actions {

void frameSmoothly(CommandContext& c) {
    if (!c.session.ready()) return;
    const bool selected = c.session.selection().kind != SelectionKind::None;
    if (!selected && c.session.picture().pivot != kNone)
        return moveToDecision(c, CameraMove::Kind::Requested);
    Camera aim = c.camera;
    CommandContext aimed{c.session, c.playback, aim, c.ui};
    frameFocus(aimed);
    c.ui.cameraMove.begin(c.camera, aim.pose(), CameraMove::Kind::Requested);
}

void toggleFollow(CommandContext& c) {
    c.ui.follow = !c.ui.follow;
    c.session.messages().say(c.ui.follow ? "The camera follows the decision."
                                         : "The camera stays where it is.");
    if (c.ui.follow) moveToDecision(c, CameraMove::Kind::Requested);
}

void swing(CommandContext& c) { c.ui.cameraMove.swing(c.camera); }

}  // namespace actions

}  // namespace se::view
