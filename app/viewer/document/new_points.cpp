#include "new_points.h"

#include <algorithm>
#include <array>
#include <utility>

#include "actions.h"
#include "document.h"
#include "scene/framing.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/sampling/sampler.h"

namespace se::view {

namespace {

/// Above this number, particles are plain dots, like points in the view of a run.
constexpr std::size_t kGrownShapesUpTo = 100'000;

/// Positions for drawing particles. With `like`, at the same position and scale as before, so
/// that the view does not jump while they move.
std::unique_ptr<Model> modelOf(const GrowthPicture& picture, const Model* like) {
    auto model = std::make_unique<Model>();
    model->points.position = picture.points->position;
    model->points.normal = picture.points->normal;
    model->points.type = picture.points->type;
    model->points.neighbors.offset.assign(picture.points->position.size() + 1, 0);
    placeModel(*model);
    if (like != nullptr) {
        model->center = like->center;
        model->scale = like->scale;
        for (std::size_t p = 0; p < model->place.size(); ++p) {
            model->place[p] = model->toView(picture.points->position[p]);
        }
    }
    model->spacing = static_cast<float>(picture.wanted * model->scale);
    return model;
}

void addStyles(const Model& model, const Palette& palette, DrawList& out) {
    const std::size_t count = model.place.size();
    CloudStyles& s = out.cloudStyles;
    const bool dots = count > kGrownShapesUpTo;
    s.styles[0] = {palette.used, dots ? 0.16F : 0.40F, dots ? Shape::Dot : Shape::Disc};
    s.styles[1] = {palette.first, dots ? 0.20F : 0.44F, dots ? Shape::Dot : Shape::Square};
    s.styles[2] = {palette.last, dots ? 0.24F : 0.60F, dots ? Shape::Dot : Shape::Diamond};
    out.cloudStyleOf.resize(count);
    std::array<std::uint8_t, BlockList<std::uint8_t>::kBlock> styles{};
    for (std::size_t b = 0; b < out.cloudStyleOf.blockCount(); ++b) {
        const std::size_t from = b * BlockList<std::uint8_t>::kBlock;
        const std::size_t size = out.cloudStyleOf.block(b).size();
        for (std::size_t i = 0; i < size; ++i) {
            const std::uint8_t type = model.points.type[from + i];
            styles[i] = isCorner(type) ? 2 : isBoundary(type) ? 1 : 0;
        }
        out.cloudStyleOf.setBlock(b, std::span(styles).first(size));
    }
}

/// The box whose walls cut the surface.
void addDomain(const Model& model, const GrowthPicture& picture, const Palette& palette,
               DrawList& out) {
    const auto corner = [&](unsigned bits) {
        return model.toView({(bits & 1U) != 0 ? picture.high.x : picture.low.x,
                             (bits & 2U) != 0 ? picture.high.y : picture.low.y,
                             (bits & 4U) != 0 ? picture.high.z : picture.low.z});
    };
    for (unsigned from = 0; from < 8; ++from) {
        for (const unsigned axis : {1U, 2U, 4U}) {
            if ((from & axis) != 0) continue;
            out.line(corner(from), corner(from | axis), palette.border, 0.07F, Depth::XRay);
        }
    }
}

}  // namespace

void NewPoints::begin(SampleSpec spec) {
    GrowthPage& page = c_.ui.growth;
    page.form.take(spec);
    page.open = true;
    before_ = c_.camera.pose();
    spread(std::move(spec));
    poll();
}

/// Spreads them from the start: as many steps as the specification has, or played.
void NewPoints::spread(SampleSpec spec) {
    spec.maxBytes = usual_.maxBytes;
    spec.steps > 0 ? playback_.pause() : playback_.play();
    growth_.start(spec);
}

void NewPoints::showPage(GrowthSource from) {
    GrowthPage& page = c_.ui.growth;
    c_.playback.pause();
    page.form.from = from;
    page.open = true;
    page.complaint.clear();
    page.message.clear();
    c_.ui.closesPopups = true;
}

void NewPoints::openPage(GrowthSource from) {
    const GrowthPage& page = c_.ui.growth;
    const bool another = !page.open || page.form.from != from;
    showPage(from);
    if (from == GrowthSource::Volume && page.form.volume.empty())
        return actions::openBrowser(c_, BrowserTask::Volume);
    if (another) start();
}

void NewPoints::openVolume(const std::string& volume) {
    c_.ui.growth.form.chooseVolume(volume);
    showPage(GrowthSource::Volume);
    start();
}

void NewPoints::start() {
    GrowthPage& page = c_.ui.growth;
    page.message.clear();
    Result<SampleSpec> spec = page.form.spec();
    page.complaint = spec ? std::string{} : spec.error().message;
    if (!spec) return;
    spread(std::move(spec.value()));
}

bool NewPoints::moving() const {
    const GrowthPhase phase = growth_.phase();
    const bool works = phase == GrowthPhase::Finding || phase == GrowthPhase::Spreading;
    return c_.ui.growth.open && (works || playback_.playing());
}

void NewPoints::play(double seconds) {
    const GrowthPhase phase = growth_.phase();
    if (phase == GrowthPhase::Done || phase == GrowthPhase::Failed) playback_.pause();
    if (phase != GrowthPhase::Paused) return;
    if (const int due = playback_.due(seconds); due > 0) growth_.play(due);
}

void NewPoints::pause() {
    playback_.pause();
    growth_.pause();
}

bool NewPoints::poll() {
    if (c_.ui.growth.open && !before_) before_ = c_.camera.pose();
    const bool news = growth_.poll();
    if (news) takePicture();
    return news;
}

void NewPoints::takePicture() {
    if (growth_.phase() == GrowthPhase::Failed) c_.ui.growth.complaint = growth_.error();
    const GrowthPicture* picture = growth_.picture();
    if (picture == nullptr) {
        // Until the new particles are there, the old ones stay visible.
        if (growth_.phase() != GrowthPhase::Finding) model_.reset();
        ++revision_;
        return;
    }
    const bool first = picture->step == 0 || model_ == nullptr;
    model_ = modelOf(*picture, first ? nullptr : model_.get());
    ++revision_;
    const std::string surface = growth_.spec().surface;
    if (first && std::exchange(homeOf_, surface) != surface) home();
}

void NewPoints::home() {
    if (!model_) return;
    c_.camera.setPose({});
    frameModel(*model_, c_.ui.viewPart(), c_.camera);
}

void NewPoints::playOrPause() {
    if (moving()) return pause();
    growth_.phase() == GrowthPhase::Paused ? playback_.play() : start();
}

void NewPoints::step() {
    if (playback_.playing()) pause();
    growth_.advance(1);
}

void NewPoints::finish() {
    if (growth_.phase() == GrowthPhase::Idle) return start();
    playback_.pause();
    growth_.finish();
}

void NewPoints::use() {
    const GrowthPicture* picture = growth_.picture();
    if (picture == nullptr) return;
    pause();
    RunSpec spec = c_.session.ready() ? c_.session.input().spec() : usual_;
    spec.source = sampleSource(growth_.spec());
    spec.points = picture->points;
    // Sampled points have normals and walls.
    resetInputOptions(spec);
    c_.document.openSpec(std::move(spec));
}

void NewPoints::leave() {
    c_.ui.betweenFrames([this] {
        playback_.pause();
        growth_.cancel();
        c_.ui.growth.open = false;
        model_.reset();
        homeOf_.clear();
        ++revision_;
        if (before_) c_.camera.setPose(*before_);
        before_.reset();
    });
}

void NewPoints::save(const std::string& path) {
    GrowthPage& page = c_.ui.growth;
    const GrowthPicture* picture = growth_.picture();
    std::shared_ptr<const PointFile> points = picture != nullptr ? picture->points : nullptr;
    if (!page.open && c_.session.ready()) points = c_.session.input().spec().points;
    if (!points) return;
    const Status written = writeMesh(path, *points, {}, {.normals = true});
    const std::string text = written ? "Saved " + path + "." : written.error().message;
    if (!page.open) return c_.session.messages().say(text);
    page.message = written ? text : std::string{};
    page.complaint = written ? std::string{} : text;
}

void NewPoints::waitUntilDone() {
    if (!c_.ui.growth.open) return;
    if (playback_.playing()) finish();
    growth_.waitUntilDone();
    takePicture();
}

const DrawList& NewPoints::drawList(const Palette& palette) {
    list_ = {};
    list_.meshVisible = false;
    list_.cloudVisible = model_ != nullptr;
    const GrowthPicture* picture = growth_.picture();
    if (model_) addStyles(*model_, palette, list_);
    if (model_ && picture != nullptr) addDomain(*model_, *picture, palette, list_);
    return list_;
}

}  // namespace se::view
