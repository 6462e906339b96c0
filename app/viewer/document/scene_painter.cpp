// Two caches with keys: the draw list is filled again only if one of its inputs changed (Filled),
// and the texture is drawn again only if the list, the camera or the size did (Drawn). The
// renderer uploads only the positions and triangles that are new.
#include "scene_painter.h"

#include <algorithm>
#include <utility>

#include "alert_actions.h"
#include "jobs/questions.h"
#include "scene/picking.h"
#include "session/playback.h"
#include "session/session.h"

namespace se::view {

namespace {

/// Playback rate, in steps per second, above which moves are not animated.
constexpr double kFollowedRate = 1.5;
/// Time without a move after which the camera rests.
constexpr double kRestSeconds = 0.15;

/// Number of triangles at the last seed before the cursor.
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

/// First point of the last ring before the one at the cursor.
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

/// Not 0 if the points are colored by their margins, and the margins are known.
std::uint32_t tintOf(const Session& session, PointTint tint) {
    const bool known = !session.questions().leastMargin().empty() && !session.horizon();
    return tint == PointTint::Margin && known ? session.generation() + 1 : 0;
}

/// Colors triangles that the other mesh lacks, and outlines what it has in the shown region.
void addDifference(const DifferenceLook& look, const Model& model, std::size_t finished,
                   const std::shared_ptr<const std::vector<Triangle>>& repaired, DrawList& out) {
    if (look.shade != nullptr)
        out.tinted = look.shade->at(finished, repaired, look.only, look.turned);
    for (const Triangle& t : look.ghosts)
        out.loop(model.cornersOf(t), look.ghost, 0.1F, Depth::OnTop, 0.35F);
}

/// From this radius on the screen, in em, what hides a decision fades: from afar there is nothing
/// to see of it.
constexpr float kGhostsFrom = 1.5F;

bool showsGhosts(const Session& session, const CameraMatrices& camera, const DrawList& list,
                 glm::ivec2 size, float em) {
    const float radius = pixelRadius(camera, *list.decision, static_cast<float>(size.y));
    const std::span<const Triangle> all = session.triangles();
    return radius > kGhostsFrom * em &&
           isHidden(session.shown(), all.first(std::min(all.size(), list.finishedTriangles)),
                    camera, *list.decision);
}

}  // namespace

void ScenePainter::start(std::shared_ptr<Shaders> shaders) {
    renderer_ = std::make_unique<Renderer>(std::move(shaders));
}

/// Phase of the short animations at which the scene is drawn.
const Moment& ScenePainter::lookAtMoment(const CommandContext& context, bool onPaper) {
    static constexpr Moment kPaper{Moment::Kind::Paper, 0.0, false};
    if (onPaper) return kPaper;
    const Session& session = context.session;
    const Playback& playback = context.playback;
    const bool tooFast =
        playback.playing() && (playback.unlimited() || playback.rate() > kFollowedRate);
    const bool still = session.moves().busy() || tooFast || context.ui.look.on();
    return motion_.look({session.generation(), session.record().pivot, session.cursor()},
                        still ? 0.0 : motionSeconds(session.picture()), context.ui.motionClock());
}

void ScenePainter::upload(const Session& session) {
    const bool another =
        std::exchange(uploadedGeneration_, session.generation()) != session.generation();
    // A what-if moves points from a pivot on.
    if (std::exchange(uploaded_, &session.shown()) != &session.shown() || another) {
        renderer_->surface().setModel(session.shown());
        filled_.revision = 0;
    }
    const PointDrag& drag = session.drag();
    if (std::exchange(uploadedDrag_, drag.revision()) != drag.revision() && drag.active())
        renderer_->surface().movePoint(session.shown(), drag.point(), session.triangles());
    renderer_->surface().setTriangles(session.shown(), session.triangles());
    renderer_->surface().setRepaired(session.shown(), session.picture().repaired);
}

MeshColoring ScenePainter::coloringOf(const Session& session, MeshStyle style) {
    // The length of the run is not known while there is a horizon.
    static const RunOverview unknown;
    MeshColoring mesh = meshColoring(style, session.horizon() ? unknown : session.overview(),
                                     session.triangles().size());
    const auto& repaired = session.picture().repaired;
    if (style == MeshStyle::Component && repaired) {
        mesh.repaired = repairedComponents_.of(repaired, session.triangles(), mesh.starts,
                                               session.model().points.size());
    }
    return mesh;
}

void ScenePainter::fill(CommandContext& context, bool onPaper, const DifferenceLook* look) {
    const Session& session = context.session;
    particles_ = false;
    if (!session.ready()) return;
    // A finished mesh has been uploaded in between.
    if (std::exchange(still_, nullptr)) uploadedGeneration_ = 0;
    model_ = session.sharedModel();
    upload(session);
    const ViewSettings& settings = context.ui.settings;
    // The finished mesh is shown without its last decision.
    const bool finished = showsFinishedMesh(context);
    shownLayers_ = shownLayers(settings.layers, finished ? std::nullopt : session.stage());
    const RunFailureSearch* faults = finished ? session.finishedFaults() : nullptr;
    const std::size_t shapes = session.overview().shapes.size();
    Filled now{session.revision(),
               shownLayers_,
               settings.theme,
               coloringOf(session, settings.meshStyle),
               lookAtMoment(context, onPaper),
               shapes,
               tintOf(session, settings.pointTint),
               session.noticedHere().size(),
               finished,
               faults != nullptr,
               shownChange(context),
               look != nullptr ? look->revision : 0U};
    if (now == filled_) return;
    const LayerInput input{
        session.shown(),
        session.picture(),
        paletteOf(settings.theme),
        session.selected(),
        session.highlights().litRing(),
        session.highlights().hovered(),
        session.triangles(),
        componentBegin(session),
        shapeAt(session.overview().shapes, session.record().pivot),
        session.selection(),
        context.ui.facts.of(session).present,
        now.mesh,
        session.highlights().marked(),
        session.highlights().lines(),
        now.moment,
        &session.meshIndex(),
        seedBefore(session),
        now.tint == 0 ? std::span<const double>{} : session.questions().leastMargin(),
        now.tint,
        settings.theme,
        session.alerts().shown(),
        finished,
        faults,
        session.noticedHere(),
        session.names(),
        session.highlights().labeled(),
        now.change};
    fillDrawList(input, shownLayers_, drawList_);
    if (look != nullptr)
        addDifference(*look, session.model(), session.picture().finishedTriangles,
                      session.picture().repaired, drawList_);
    filled_ = std::move(now);
    ++fills_;
}

/// Uploads the triangles of a file, once. True if they are new.
bool ScenePainter::uploadStill(const std::shared_ptr<const Model>& model,
                               const std::vector<Triangle>& triangles) {
    const bool fresh = std::exchange(still_, model) != model || uploadedStill_ != &triangles;
    if (!fresh) return false;
    renderer_->surface().setModel(*model);
    renderer_->surface().setTriangles(*model, triangles);
    uploadedStill_ = &triangles;
    model_ = model;
    return true;
}

void ScenePainter::fillTrace(const CommandContext& run, const DecisionState& state,
                             const std::vector<Triangle>& triangles,
                             std::span<const Triangle> coming, const DifferenceLook* look) {
    const Session& session = run.session;
    const ViewSettings& settings = run.ui.settings;
    Filled now;
    // Also changes with the cursor, which the trace follows.
    now.revision = session.revision();
    now.layers = shownLayers(settings.layers, Stage::Emit);
    for (const LayerId decided : {LayerId::Sector, LayerId::Alerts, LayerId::Aside})
        now.layers.reset(static_cast<std::size_t>(decided));
    now.theme = settings.theme;
    now.mesh.style =
        settings.meshStyle < MeshStyle::CreationOrder ? settings.meshStyle : MeshStyle::Flat;
    now.difference = look != nullptr ? look->revision : 0U;
    const bool fresh = uploadStill(session.sharedModel(), triangles);
    if (!fresh && now == filled_) return;
    LayerInput input{session.model(), state, paletteOf(settings.theme)};
    input.triangles = triangles;
    input.selected = session.selected();
    input.selection = session.selection();
    input.hovered = session.highlights().hovered();
    input.marked = session.highlights().marked();
    input.markedLines = session.highlights().lines();
    input.mesh = now.mesh;
    input.theme = settings.theme;
    input.names = session.names();
    fillDrawList(input, now.layers, drawList_);
    for (const Triangle& t : coming)
        drawList_.loop(input.cornersOf(t), input.palette.test, 0.1F, Depth::OnTop, 0.3F);
    if (look != nullptr)
        addDifference(*look, session.model(), state.finishedTriangles, nullptr, drawList_);
    filled_ = std::move(now);
    ++fills_;
}

void ScenePainter::fillStill(const std::shared_ptr<const Model>& model,
                             const std::vector<Triangle>& triangles, const ViewSettings& settings,
                             const DifferenceLook* look) {
    Filled now;
    now.theme = settings.theme;
    now.difference = look != nullptr ? look->revision : 0U;
    now.mesh.style =
        settings.meshStyle == MeshStyle::Shaded || settings.meshStyle == MeshStyle::Wire
            ? settings.meshStyle
            : MeshStyle::Flat;
    const bool fresh = uploadStill(model, triangles);
    if (!fresh && now == filled_) return;
    const Palette& palette = paletteOf(settings.theme);
    drawList_ = {};
    drawList_.cloudVisible = false;
    drawList_.finishedTriangles = triangles.size();
    drawList_.meshColor = palette.mesh;
    drawList_.meshEdgeColor = now.mesh.style == MeshStyle::Wire ? palette.done : palette.meshEdge;
    drawList_.meshStyle = now.mesh.style;
    if (look != nullptr) addDifference(*look, *model, triangles.size(), nullptr, drawList_);
    filled_ = std::move(now);
    ++fills_;
}

void ScenePainter::fillParticles(NewPoints& sampling, Theme theme) {
    const bool fresh = !std::exchange(particles_, true) || particleTheme_ != theme ||
                       filledParticles_ != sampling.revision();
    if (!fresh) return;
    // Everything drawn for the run is made again when the page is left.
    uploadedGeneration_ = 0;
    filled_.revision = 0;
    filledParticles_ = sampling.revision();
    particleTheme_ = theme;
    if (sampling.model() != nullptr) renderer_->surface().setModel(*sampling.model());
    particleList_ = sampling.drawList(paletteOf(theme));
    ++fills_;
}

/// Quick from a move of the camera until it has rested for a moment; full in saved pictures, and
/// at once where the size is another one.
Finish ScenePainter::finishAt(double clock, const Drawn& next) {
    if (next.size != drawn_.size) return Finish::Full;
    const bool moved = next.camera != drawn_.camera;
    if (moved) movedAt_ = clock;
    if (!moved && finish_ == Finish::Full) return finish_;
    return onPaper() || clock - movedAt_ > kRestSeconds ? Finish::Full : Finish::Quick;
}

/// The picture of a new size is delayed by a test.
bool ScenePainter::waits(glm::ivec2 pixels, int lateFrames) {
    if (std::exchange(pixels_, pixels) != pixels) {
        framesToWait_ = lateFrames;
    } else if (framesToWait_ > 0) {
        --framesToWait_;
    }
    return late();
}

bool ScenePainter::draw(const CommandContext& context, const Rect& view, float em) {
    const glm::ivec2 size(view.size);
    const PixelRect part = partOfView(view, context.ui.picture.tile);
    if (part.empty()) return false;
    const Session& session = context.session;
    const Color background =
        context.ui.picture.background.value_or(paletteOf(context.ui.settings.theme).background);
    const Drawn key{session.revision(),
                    session.generation(),
                    context.camera.revision(),
                    size,
                    part,
                    shownLayers_,
                    background,
                    em,
                    fills_};
    if (waits(part.max - part.min, context.ui.picture.lateFrames)) {
        renderer_->drawNothing(part.max - part.min, background);
        drawn_ = {};
        return false;
    }
    const Finish finish = finishAt(context.ui.clock, key);
    if (key == drawn_ && finish == finish_) return false;
    drawn_ = key;
    finish_ = finish;
    if (model_ && !particles_) renderer_->surface().setTinted(*model_, list());
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    const CameraMatrices camera = context.camera.matrices(aspect);
    drawList_.ghosts = session.ready() && !particles_ && drawList_.decision &&
                       showsGhosts(session, camera, drawList_, size, em);
    renderer_->draw(
        list(),
        {croppedTo(part, camera, size), part.max - part.min, {}, em, 0.0F, background, part.min},
        finish);
    return true;
}

}  // namespace se::view
