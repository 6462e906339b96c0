// Indices that are left out are those of the file, so that they stay valid whatever else is left
// out or repaired before a run. Keeping a piece leaves out all others, those that a fix has dropped
// included: the fix examines the piece alone.
#include "piece_actions.h"

#include <utility>

#include "actions.h"
#include "document.h"
#include "run/strings.h"
#include "scene/framing.h"
#include "scene/picking.h"
#include "session/session.h"
#include "spiraling_edge/points/index_ranges.h"
#include "spiraling_edge/spec/run_spec.h"
#include "ui_state.h"

namespace se::view {

namespace {

/// Enclosed points that are marked in the view: of more, evenly chosen ones.
constexpr std::size_t kMaxEnclosedMarks = 20'000;

constexpr const char* kNoneInside = "No points are inside: drag a box around some first.";

void markEnclosed(Session& session, std::span<const Index> points) {
    std::vector<Index> marks;
    const std::size_t stride = points.size() / kMaxEnclosedMarks + 1;
    for (std::size_t i = 0; i < points.size(); i += stride) marks.push_back(points[i]);
    session.highlights().mark(std::move(marks));
}

/// For each point of the file: true if it is enclosed.
std::vector<bool> enclosedInFile(const Model& model, std::span<const Index> inside) {
    std::vector<bool> enclosed(model.pointsInPiece, false);
    for (const Index p : inside) enclosed[model.numberInPiece(p)] = true;
    return enclosed;
}

/// Runs without the marked points of the file.
void runWithoutMarked(CommandContext& c, const std::vector<bool>& without) {
    Session& session = c.session;
    std::vector<Index> indices;
    for (Index p = 0; p < without.size(); ++p) {
        if (without[p]) indices.push_back(p);
    }
    if (indices.size() == without.size())
        return session.messages().say("No point would be left to run with.");
    c.document.runWithout(rangesOf(indices));
    endPieceTool(c);
}

/// True if there are enclosed points; otherwise a message says what to do.
bool hasEnclosed(CommandContext& c) {
    Session& session = c.session;
    if (!session.ready() || !c.ui.piece.on) return false;
    if (session.input().phase() == SessionPhase::Loading) {
        session.messages().say("Wait until the input is open.");
        return false;
    }
    const bool some = !c.ui.piece.inside.empty() && c.ui.piece.generation == session.generation();
    if (!some) session.messages().say(kNoneInside);
    return some;
}

}  // namespace

std::string insideText(std::size_t count) { return withS(count, "point") + " inside"; }

void enclosePoints(CommandContext& context, glm::vec2 size, std::span<const glm::vec2> path) {
    Session& session = context.session;
    PieceTool& tool = context.ui.piece;
    tool.generation = session.generation();
    tool.inside =
        pointsInside(session.shown(), context.camera.matrices(size.x / size.y), size, path);
    context.ui.doctor.shownCheck.clear();
    markEnclosed(session, tool.inside);
    if (tool.inside.empty()) session.messages().say(kNoneInside);
}

void keepEnclosed(CommandContext& context) {
    if (!hasEnclosed(context)) return;
    std::vector<bool> without = enclosedInFile(context.session.model(), context.ui.piece.inside);
    without.flip();
    runWithoutMarked(context, without);
}

void leaveOutEnclosed(CommandContext& context) {
    if (!hasEnclosed(context)) return;
    std::vector<bool> without = enclosedInFile(context.session.model(), context.ui.piece.inside);
    const std::vector<bool> before =
        marksOf(context.session.input().spec().leftOut, without.size());
    for (std::size_t p = 0; p < without.size(); ++p) {
        if (before[p]) without[p] = true;
    }
    runWithoutMarked(context, without);
}

void endPieceTool(CommandContext& context) {
    PieceTool& tool = context.ui.piece;
    if (!std::exchange(tool.on, false)) return;
    if (!tool.inside.empty()) context.session.highlights().mark({});
    tool = {false, tool.shape};
}

void followRun(CommandContext& context) {
    PieceTool& tool = context.ui.piece;
    if (tool.on && (!context.session.ready() || context.ui.growth.open)) endPieceTool(context);
    if (!tool.on || tool.generation == context.session.generation()) return;
    tool = {true, tool.shape};
    tool.generation = context.session.generation();
}

bool runOnPieceTool(const KeyChord& chord, CommandContext& context) {
    if (!context.ui.piece.on || chord.mods != kNoMods) return false;
    const bool keep = chord.key == key::kEnter || chord.key == key::kKeypadEnter;
    if (!keep && chord.key != key::kDelete) return false;
    keep ? keepEnclosed(context) : leaveOutEnclosed(context);
    return true;
}

void showAside(CommandContext& context, const AsidePoints& group) {
    const Model& model = context.session.model();
    std::vector<glm::vec3> places;
    places.reserve(group.position.size() + group.points.size());
    for (const Vec3& p : group.position) places.push_back(model.toView(p));
    for (const Index p : group.points) {
        if (model.drawable[p]) places.push_back(model.place[p]);
    }
    if (places.empty())
        return context.session.messages().say("These points have no finite position.");
    context.camera.fill(places, context.ui.viewPart(), kModelShare);
    LayerMode& mode = modeOf(context.ui.settings.layers, LayerId::Aside);
    if (mode == LayerMode::PinnedOff) mode = LayerMode::Automatic;
}

void bringBack(CommandContext& context, const AsidePoints& group) {
    Session& session = context.session;
    if (!session.ready()) return;
    const RunSpec& spec = session.input().spec();
    Document& document = context.document;
    actions::pause(context);
    if (group.isLeftOut()) document.runWithout({});
    if (!group.fix.empty()) {
        std::vector<std::string> fixes = spec.fixes;
        std::erase(fixes, group.fix);
        document.runWithFixes(std::move(fixes));
    }
    if (group.reason == Aside::Noise) document.rerun(withRule(spec, "noise", 0.0));
    if (group.reason == Aside::Stray) document.rerun(withRule(spec, "strays", 0.0));
}

namespace actions {

void togglePieceTool(CommandContext& c) {
    if (c.ui.piece.on) return endPieceTool(c);
    if (!c.session.ready() || c.ui.growth.open)
        return c.session.messages().say("There are no points to choose a piece of.");
    pause(c);
    c.ui.piece = {true, c.ui.piece.shape};
    c.ui.piece.generation = c.session.generation();
}

}  // namespace actions

}  // namespace se::view
