#include "compared_runs.h"

#include <algorithm>

#include "document/document.h"
#include "jobs/questions.h"
#include "scene/framing.h"

namespace se::view {

namespace {

/// Maximum number of outlines; more would hide the region itself.
constexpr std::size_t kMaxGhosts = 600;

}  // namespace

ComparedRuns::ComparedRuns(CommandContext& context) : c_(context) {
    c_.ui.compare.now = &comparison_;
}

bool ComparedRuns::otherBusy() const {
    const Session* other = comparison_.other();
    return other != nullptr && (other->moves().busy() || other->questions().busy());
}

/// The same input opened again with other options: its previous state can be compared with.
void ComparedRuns::rememberBefore() {
    const Session& run = c_.session;
    if (!run.ready() || std::exchange(generation_, run.generation()) == run.generation()) return;
    ComparePage& page = c_.ui.compare;
    page.why.reset();
    const bool same = spec_ && spec_->source == run.input().spec().source;
    if (!same) {
        page.before.reset();
        page.form.take(run.input().spec(), run.model());
    } else if (differenceText(*spec_, run.input().spec()) != kNoDifference) {
        page.before = spec_;
        page.form.follow(*spec_, run.input().spec(), run.model());
    }
    spec_ = run.input().spec();
}

bool ComparedRuns::poll() {
    rememberBefore();
    if (waiting_ && c_.session.ready() && c_.session.input().phase() != SessionPhase::Loading)
        start(*std::exchange(waiting_, std::nullopt));
    const bool changed = comparison_.poll(c_.session);
    reportRefusal();
    takeResult();
    shareSelection();
    shareNames();
    return changed;
}

void ComparedRuns::reportRefusal() {
    if (std::exchange(reportedRefusal_, comparison_.refusal()) == comparison_.refusal()) return;
    if (!reportedRefusal_.empty()) c_.session.messages().say(reportedRefusal_);
}

void ComparedRuns::waitUntilDone() {
    poll();
    comparison_.waitUntilDone(c_.session);
    poll();
}

/// Copies selection and hover from one view to the other: points have the same numbers.
void ComparedRuns::shareSelection() {
    Session* other = comparison_.other();
    if (other == nullptr || !c_.session.ready()) return;
    const bool there = !(other->selection() == selected_);
    selected_ = there ? other->selection() : c_.session.selection();
    c_.session.select(selected_);
    other->select(selected_);
    other->highlights().hover(c_.session.highlights().hovered());
}

/// Points have the same names in both views.
void ComparedRuns::shareNames() {
    Session* other = comparison_.other();
    if (other == nullptr || !c_.session.ready()) return;
    other->showNames(c_.ui.settings.names);
    const std::span<const PointName> names = c_.session.givenNames();
    const std::span<const PointName> theirs = other->givenNames();
    if (names.data() != theirs.data() || names.size() != theirs.size()) other->giveNames(names);
}

/// Keys may come before the next poll(): to be called wherever the result may have changed.
void ComparedRuns::takeResult() {
    if (comparison_.sharedResult() != shaded_) makeShades();
}

void ComparedRuns::makeShades() {
    shaded_ = comparison_.sharedResult();
    // The triangles of the result before may have had the same address.
    if (painter_) painter_->forgetStill();
    tracedState_.reset();
    shades_ = {};
    ghosts_ = {};
    c_.ui.compare.region.reset();
    ++lookRevision_;
    if (shaded_ == nullptr) return;
    const RunComparison& runs = shaded_->runs;
    shades_[0] =
        DifferenceShade(runs.a.inOrder(), std::make_shared<const TriangleSet>(shaded_->setB));
    shades_[1] =
        DifferenceShade(runs.b.inOrder(), std::make_shared<const TriangleSet>(shaded_->setA));
}

const DifferenceLook* ComparedRuns::look() {
    if (!inLayout() || shaded_ == nullptr) return nullptr;
    const Theme theme = c_.ui.settings.theme;
    if (std::exchange(theme_, theme) != theme) ++lookRevision_;
    const Palette& palette = paletteOf(theme);
    looks_[0] = {&shades_[0], palette.used, palette.rejected,
                 ghosts_[0],  palette.last, lookRevision_ + 1};
    looks_[1] = {&shades_[1], palette.last, palette.rejected,
                 ghosts_[1],  palette.used, lookRevision_ + 1};
    return &looks_[0];
}

void ComparedRuns::fill(bool onPaper) {
    shown_ = false;
    if (!inLayout() || !comparison_.chosen()) return;
    Session* other = comparison_.other();
    const bool file = comparison_.with().isFile() && shaded_ != nullptr;
    if (other == nullptr && !file) return;
    if (!painter_) {
        painter_ = std::make_unique<ScenePainter>();
        painter_->start(shaders_);
    }
    const DifferenceLook* mine = look() != nullptr ? &looks_[1] : nullptr;
    if (other != nullptr) {
        CommandContext context = c_.of(*other);
        painter_->fill(context, onPaper, mine);
    } else {
        fillFile(mine);
    }
    shown_ = true;
}

void ComparedRuns::fillFile(const DifferenceLook* look) {
    if (!shaded_->trace) {
        return painter_->fillStill(shaded_->b, shaded_->runs.b.triangles, c_.ui.settings, look);
    }
    const TraceReplay& replay = shaded_->trace->replay;
    const TracePosition position = comparison_.tracePosition(c_.session);
    const std::span<const Triangle> fan = replay.fanOf(position.pivot);
    const std::size_t laid = position.complete ? fan.size() : std::min(position.laid, fan.size());
    if (!tracedState_ || tracedAt_ != position) tracedState_ = replay.stateAt(position);
    tracedAt_ = position;
    painter_->fillTrace(c_, *tracedState_, replay.mesh().triangles, fan.subspan(laid), look);
}

bool ComparedRuns::draw(const Rect& view, float em) {
    if (!shown_) return false;
    Session* other = comparison_.other();
    return painter_->draw(other != nullptr ? c_.of(*other) : c_, view, em);
}

/// Points have the same numbers in both.
void ComparedRuns::askWhy(const Selection& what) {
    c_.ui.compare.why = what;
    c_.session.questions().askWhy(what);
    if (Session* other = comparison_.other()) other->questions().askWhy(what);
}

void ComparedRuns::begin(CompareWith with) {
    c_.ui.betweenFrames([this, with = std::move(with)] { start(with); });
}

void ComparedRuns::beginUsual() {
    begin(CompareWith::otherRun(usualOther(c_.session.input().spec())));
}

void ComparedRuns::stop() {
    c_.ui.betweenFrames([this] {
        comparison_.cancel();
        takeResult();
    });
}

void ComparedRuns::start(CompareWith with) {
    c_.ui.compare.choosing = false;
    c_.ui.compare.why.reset();
    comparison_.start(c_.session, std::move(with));
    takeResult();
}

/// The difference is known; otherwise says why it is not.
bool ComparedRuns::isReady() {
    if (shaded_ == nullptr) c_.session.messages().say("The comparison is still running.");
    return shaded_ != nullptr;
}

void ComparedRuns::toFirstDifference() {
    if (isReady())
        toDifference(shaded_->runs.first, "These two runs are the same from start to end.");
}

void ComparedRuns::toFirstHarmless() {
    if (isReady()) toDifference(shaded_->runs.harmless, "No earlier decision differs.");
}

void ComparedRuns::goTo(const ComparedAddresses& addresses) {
    comparison_.goTo(c_.session, addresses);
}

void ComparedRuns::stepRegion(int direction) {
    if (!isReady()) return;
    const std::size_t count = shaded_->meshes.regions.size();
    if (count == 0) return c_.session.messages().say("The meshes are the same.");
    const auto& at = c_.ui.compare.region;
    if (direction > 0) return showRegion(at ? (*at + 1) % count : 0);
    showRegion((at.value_or(0) + count - 1) % count);
}

/// To our first decision that accounts for the difference.
void ComparedRuns::goToTraced(const std::optional<teach::TraceDifference>& difference) {
    if (!difference) {
        return c_.session.messages().say(
            shaded_->meshes.onlyA == 0
                ? "The trace and the run are the same from start to end."
                : "The trace is that of the run, which goes on where it ends.");
    }
    Address at{static_cast<std::uint32_t>(difference->pivot), Stage::Pivot, 0};
    for (const teach::TraceReason& each : difference->reasons) {
        if (!each.address) continue;
        at = *each.address;
        break;
    }
    c_.ui.frame = FrameRequest::Decision;
    goTo({difference->run ? std::optional(at) : std::nullopt, {}});
}

void ComparedRuns::toDifference(const std::optional<RunDifference>& difference,
                                const char* nothing) {
    if (shaded_->trace) return goToTraced(shaded_->trace->comparison.difference);
    if (comparison_.with().kind == CompareWith::Kind::Mesh) {
        // A mesh has no decisions: go to the first triangle of the run that it lacks.
        const MadeMesh& run = shaded_->runs.a;
        std::optional<Address> first;
        for (std::size_t i = 0; i < run.triangles.size(); ++i) {
            const Address& made = run.made[i];
            if (shaded_->meshes.a[i] == Match::Same) continue;
            if (!first || made.pivot < first->pivot) first = made;
        }
        if (!first) return c_.session.messages().say("All triangles of the run are in the mesh.");
        return goTo({first, std::nullopt});
    }
    if (!difference) return c_.session.messages().say(nothing);
    const auto addressOf = [](const DifferenceSide& side) {
        return side.line ? std::optional(side.line->event.address) : std::nullopt;
    };
    c_.ui.frame = FrameRequest::Decision;
    goTo({addressOf(difference->a), addressOf(difference->b)});
}

std::vector<Triangle> ComparedRuns::ghostsOf(const std::vector<Index>& region,
                                             const std::vector<Triangle>& mesh) const {
    std::vector<Triangle> ghosts;
    if (region.size() > kMaxGhosts) return ghosts;
    ghosts.reserve(region.size());
    for (const Index i : region) ghosts.push_back(mesh[i]);
    return ghosts;
}

/// Shows both meshes at the end of their runs, with the region in the middle.
void ComparedRuns::showRegion(std::size_t number) {
    c_.ui.betweenFrames([this, number] {
        if (shaded_ == nullptr || number >= shaded_->meshes.regions.size()) return;
        const DifferenceRegion& region = shaded_->meshes.regions[number];
        c_.ui.compare.region = number;
        // A vertex of the mesh that is no point of the run has no position in the view of the run.
        const std::size_t points = shaded_->a->place.size();
        ghosts_[0] = ghostsOf(region.inB, shaded_->runs.b.triangles);
        std::erase_if(ghosts_[0], [&](const Triangle& t) {
            return std::max({t.a, t.b, t.c}) >= points;
        });
        ghosts_[1] = ghostsOf(region.inA, shaded_->runs.a.triangles);
        ++lookRevision_;
        frameFault(*shaded_->b, region.points, c_.ui.viewPart(), c_.camera);
        if (!c_.session.atEnd()) c_.session.moves().toEnd();
    });
}

void ComparedRuns::swap() {
    c_.ui.betweenFrames([this] {
        const Session* other = comparison_.other();
        if (other == nullptr)
            return c_.session.messages().say("B has no decisions to step through.");
        waiting_ = CompareWith::otherRun(c_.session.input().spec());
        c_.document.openSpec(other->input().spec());
        comparison_.cancel();
        takeResult();
    });
}

}  // namespace se::view
