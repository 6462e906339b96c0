#include "scene_painter.h"

#include <utility>

#include "session/session.h"

namespace se::view {

namespace {

/// Steps played faster than this, per second, do not leave the time to see them move.
constexpr double kFollowedRate = 1.5;

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

Status ScenePainter::start(const std::filesystem::path& shaders) {
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create(shaders);
    if (!renderer) return renderer.error();
    renderer_ = std::move(renderer.value());
    return success();
}

/// At which point of its short movements the scene is to be drawn.
const Moment& ScenePainter::lookAtMoment(const CommandContext& context, bool onPaper) {
    static constexpr Moment kPaper{Moment::Kind::Paper, 0.0, false};
    if (onPaper) return kPaper;
    const Session& session = context.session;
    const Playback& playback = context.playback;
    const bool tooFast =
        playback.playing() && (playback.unlimited() || playback.rate() > kFollowedRate);
    const bool still = session.busy() || tooFast || context.ui.look.on();
    return motion_.look({session.generation(), session.record().pivot, session.cursor()},
                        still ? 0.0 : motionSeconds(session.picture()), context.ui.clock);
}

void ScenePainter::upload(const Session& session) {
    if (std::exchange(uploadedGeneration_, session.generation()) != session.generation()) {
        renderer_->setModel(session.model());
        filled_.revision = 0;
    }
    renderer_->setTriangles(session.model(), session.triangles());
    renderer_->setMended(session.model(), session.picture().mended);
}

MeshColoring ScenePainter::coloringOf(const Session& session, MeshStyle style) {
    MeshColoring mesh = meshColoring(style, session.overview(), session.triangles().size());
    const auto& mended = session.picture().mended;
    if (style == MeshStyle::Component && mended) {
        mesh.mended = mendedComponents_.of(mended, session.triangles(), mesh.starts,
                                           session.model().points.size());
    }
    return mesh;
}

void ScenePainter::fill(CommandContext& context, bool onPaper) {
    const Session& session = context.session;
    particles_ = false;
    if (!session.ready()) return;
    upload(session);
    const ViewSettings& settings = context.ui.settings;
    shownLayers_ = shownLayers(settings.layers, session.stage());
    const std::size_t shapes = session.overview().shapes.size();
    Filled now{session.revision(),
               shownLayers_,
               settings.theme,
               coloringOf(session, settings.meshStyle),
               lookAtMoment(context, onPaper),
               shapes};
    if (now == filled_) return;
    const LayerInput input{session.model(),
                           session.picture(),
                           paletteOf(settings.theme),
                           session.selected(),
                           session.litRing(),
                           session.hovered(),
                           session.triangles(),
                           componentBegin(session),
                           shapeAt(session.overview().shapes, session.record().pivot),
                           session.selection(),
                           context.ui.facts.of(session).present,
                           now.mesh,
                           session.marked(),
                           now.moment,
                           &session.meshIndex(),
                           seedBefore(session)};
    fillDrawList(input, shownLayers_, drawList_);
    filled_ = std::move(now);
    ++fills_;
}

void ScenePainter::fillParticles(Growing& growing, Theme theme) {
    const bool fresh = !std::exchange(particles_, true) || particleTheme_ != theme ||
                       filledParticles_ != growing.revision();
    if (!fresh) return;
    // Whatever was drawn for the run is made anew when these are left.
    uploadedGeneration_ = 0;
    filled_.revision = 0;
    filledParticles_ = growing.revision();
    particleTheme_ = theme;
    if (growing.model() != nullptr) renderer_->setModel(*growing.model());
    particleList_ = growing.drawList(paletteOf(theme));
    ++fills_;
}

void ScenePainter::draw(const CommandContext& context, glm::ivec2 size, float em) {
    if (size.x < 1 || size.y < 1) return;
    const Session& session = context.session;
    const Theme theme = context.ui.settings.theme;
    const Drawn key{session.revision(),
                    session.generation(),
                    context.camera.revision(),
                    size,
                    shownLayers_,
                    theme,
                    em,
                    fills_};
    if (key == drawn_) return;
    drawn_ = key;
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    renderer_->draw(list(), context.camera.matrices(aspect), size, em, paletteOf(theme).background);
}

}  // namespace se::view
