// The other run is a second Session of its own, which prepares and steps it like the first. A job
// compares the two runs to their ends; poll() then moves the other session along with the first.
// Two runs have no common clock. Pivots before the first difference are the same in both; after it
// the rest of one run is mapped linearly to the rest of the other, so that both ends coincide and
// the mapping never goes back.

#include "comparison.h"

#include <algorithm>
#include <cassert>
#include <unordered_map>
#include <utility>

#include "panel_state/what_if_offers.h"
#include "run/strings.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/sampling/gzip.h"
#include "teach/trace/rule_guess.h"

namespace se::view {

// A fan p, f0, f1, ... makes the triangles (p, f0, f1), (p, f1, f2), ... as §6.4 does. A trace has
// no rings, unless it names them: a ring runs along the edges with one triangle, the mesh on its
// left, so the edges u -> v of triangles whose opposite v -> u is missing are chained.

namespace {

/// Directed edges with one triangle: the ends by the beginning, the newest last.
using OpenEdges = std::unordered_map<Index, std::vector<Index>>;

void layEdge(OpenEdges& open, Index from, Index to) {
    const auto opposite = open.find(to);
    if (opposite != open.end()) {
        std::vector<Index>& ends = opposite->second;
        const auto found = std::find(ends.begin(), ends.end(), from);
        if (found != ends.end()) {
            ends.erase(found);
            if (ends.empty()) open.erase(opposite);
            return;
        }
    }
    open[from].push_back(to);
}

/// Takes the loop of edges that begins at `from`, or the part of it that there is.
RingPath takeLoop(OpenEdges& open, Index from) {
    RingPath ring;
    Index at = from;
    for (auto found = open.find(at); found != open.end(); found = open.find(at)) {
        ring.points.push_back(at);
        at = found->second.back();
        found->second.pop_back();
        if (found->second.empty()) open.erase(found);
        if (at == from) break;
    }
    ring.open.assign(ring.points.size(), false);
    // What does not lead back is no ring; its last step is shown as no edge of the mesh.
    if (at != from) {
        ring.points.push_back(at);
        ring.open.push_back(true);
    }
    return ring;
}

std::string fanText(const std::vector<Index>& points) {
    std::string text;
    for (const Index each : points) text += " " + std::to_string(each);
    return text;
}

}  // namespace

TraceReplay::TraceReplay(teach::Trace trace, std::vector<Triangle> given, std::size_t pointCount)
    : trace_(std::move(trace)), pointCount_(pointCount) {
    mesh_.pivots = pivots();
    mesh_.triangles = std::move(given);
    mesh_.made.resize(mesh_.triangles.size());
    begin_.push_back(mesh_.triangles.size());
    for (std::uint32_t pivot = 1; pivot <= mesh_.pivots; ++pivot) {
        const teach::TracePivot& each = trace_.pivots[pivot - 1];
        const std::vector<Index> fan = each.fan.value_or(std::vector<Index>{});
        for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
            assert(std::max({each.p, fan[i], fan[i + 1]}) < pointCount_);
            mesh_.triangles.push_back({each.p, fan[i], fan[i + 1]});
            mesh_.made.push_back({pivot, Stage::Emit, static_cast<std::uint32_t>(i + 1)});
        }
        begin_.push_back(mesh_.triangles.size());
    }
}

std::span<const Triangle> TraceReplay::fanOf(std::uint32_t pivot) const {
    if (pivot == 0 || pivot > pivots()) return {};
    return std::span(mesh_.triangles).subspan(begin_[pivot - 1], begin_[pivot] - begin_[pivot - 1]);
}

std::vector<RingPath> TraceReplay::ringsAt(std::size_t triangles, std::uint32_t pivots) const {
    OpenEdges open;
    for (const Triangle& t : std::span(mesh_.triangles).first(triangles)) {
        layEdge(open, t.a, t.b);
        layEdge(open, t.b, t.c);
        layEdge(open, t.c, t.a);
    }
    std::vector<RingPath> rings;
    // The active ring is that of the next pivot.
    if (pivots < trace_.pivots.size() && open.contains(trace_.pivots[pivots].p)) {
        rings.push_back(takeLoop(open, trace_.pivots[pivots].p));
        rings.back().active = true;
    }
    // In the order of the triangles, so that the picture is the same each time.
    for (const Triangle& t : std::span(mesh_.triangles).first(triangles)) {
        for (const Index from : {t.a, t.b, t.c}) {
            while (open.contains(from)) {
                rings.push_back(takeLoop(open, from));
                rings.back().depth = kNone;  // whether it is on the stack is not known
            }
        }
    }
    const bool named = pivots > 0 && trace_.pivots[pivots - 1].ring.has_value();
    if (named && !rings.empty() && rings.front().active) {
        rings.front().points = *trace_.pivots[pivots - 1].ring;
        rings.front().open.assign(rings.front().points.size(), false);
    }
    return rings;
}

DecisionState TraceReplay::stateAt(const TracePosition& position) const {
    assert(position.pivot <= pivots());
    DecisionState state;
    const std::span<const Triangle> fan = fanOf(position.pivot);
    const std::size_t laid = position.complete ? fan.size() : std::min(position.laid, fan.size());
    state.complete = position.complete;
    state.finishedTriangles = begin_[std::max(position.pivot, 1U) - 1];
    if (position.complete) state.finishedTriangles += laid;
    if (position.pivot > 0) {
        const teach::TracePivot& at = trace_.pivots[position.pivot - 1];
        state.pivot = at.p;
        state.first = at.first;
        state.last = at.last;
        if (!position.complete) {
            state.newTriangles.assign(fan.begin(), fan.begin() + laid);
            for (std::size_t i = 1; i < fan.size(); ++i)
                state.candidates.push_back({fan[i].b, 0.0, CandidateState::Kept});
        }
        if (position.complete && position.pivot < pivots())
            state.nextPivot = trace_.pivots[position.pivot].p;
    }
    // The ring is that before the pivot until its fan is complete.
    const std::uint32_t done =
        position.complete || position.pivot == 0 ? position.pivot : position.pivot - 1;
    state.rings = ringsAt(state.finishedTriangles, done);
    std::vector<PointStatus> status(pointCount_, kUnused);
    for (const Triangle& t : std::span(mesh_.triangles).first(state.finishedTriangles))
        for (const Index each : {t.a, t.b, t.c}) status[each] = kDone;
    for (std::uint32_t i = 0; i < done; ++i) status[trace_.pivots[i].p] = kDone;
    for (const RingPath& ring : state.rings)
        for (const Index each : ring.points) status[each] = std::max(status[each], kUnused) + 1;
    state.status.assign(status);
    return state;
}

std::string TraceReplay::sentence(const TracePosition& position) const {
    if (position.pivot == 0) return "Before the first pivot of the trace.";
    const teach::TracePivot& at = trace_.pivots[position.pivot - 1];
    const std::string fan = at.fan && !at.fan->empty() ? "fan" + fanText(*at.fan) : "no triangle";
    return "Pivot " + std::to_string(position.pivot) + " of the trace: point " +
           std::to_string(at.p) + " between " + std::to_string(at.first) + " and " +
           std::to_string(at.last) + ", " + fan + ".";
}

bool inStep(const RunAlignment& alignment, std::uint32_t pivot) {
    return !alignment.diverge || pivot <= alignment.alike + 1;
}

std::uint32_t matchingPivot(const RunAlignment& alignment, std::uint32_t pivot) {
    if (inStep(alignment, pivot)) return pivot;
    const std::uint32_t from = alignment.alike + 1;
    if (alignment.endA <= from || alignment.endB <= from) return std::max(from, alignment.endB);
    const std::uint64_t gone = std::min(pivot, alignment.endA) - from;
    const std::uint64_t left = alignment.endA - from;
    return from + static_cast<std::uint32_t>(gone * (alignment.endB - from) / left);
}

namespace {

/// No pivot: the other run has no request.
constexpr std::uint32_t kNowhere = 0xffffffffU;

/// The run, and the other one prepared from its own points.
Status compareTwo(Compared& found, const Progress& progress) {
    Result<RunComparison> runs = compareRuns({found.a->points, found.a->params},
                                             {found.b->points, found.b->params}, progress);
    if (!runs) return runs.error();
    found.runs = std::move(runs.value());
    return success();
}

/// Positions for drawing a mesh on the points of `run`; its extra vertices come after them.
std::shared_ptr<const Model> stillModel(const Model& run, const MatchedMesh& mesh,
                                        std::string name) {
    auto model = std::make_shared<Model>();
    model->name = std::move(name);
    model->place = run.place;
    model->normal = run.normal;
    model->drawable = run.drawable;
    model->center = run.center;
    model->scale = run.scale;
    model->spacing = run.spacing;
    model->points.position = run.points.position;
    for (const Vec3& x : mesh.unmatchedVertices) {
        model->points.position.push_back(x);
        model->place.push_back(model->toView(x));
        model->normal.emplace_back(0.0F);
        model->drawable.push_back(true);
    }
    return model;
}

/// The run, and a mesh that is finished already.
Status compareWithMesh(Compared& found, const std::string& path, const ByteLimit& limit,
                       const Progress& progress) {
    const Result<PointFile> file = readPoints(std::filesystem::path(path), limit, unpackGzip);
    if (!file) return file.error();
    if (file.value().faces.empty()) return Error{path + " has no triangles to compare with."};
    MatchedMesh matched = matchMesh(found.a->points.position, file.value());
    found.b = stillModel(*found.a, matched, std::filesystem::path(path).filename().string());
    Result<MadeMesh> run = makeMesh({found.a->points, found.a->params}, progress);
    if (!run) return run.error();
    found.runs.a = std::move(run.value());
    found.runs.b.triangles = std::move(matched.triangles);
    found.unmatchedVertices = std::move(matched.unmatchedNumbers);
    return success();
}

/// The run, and the trace of another implementation.
Status compareWithTrace(Compared& found, const std::string& path, const Progress& progress) {
    Result<teach::Trace> trace = teach::readTraceFile(path);
    if (!trace) return trace.error();
    const PointSet& points = found.a->points;
    if (const Status same = teach::requireTraceOf(trace.value(), points, path); !same)
        return same.error();
    const Params& params = found.a->params;
    const SharedPoints shared(std::shared_ptr<const PointSet>(found.a, &points));
    Result<teach::TraceComparison> comparison =
        teach::compareTrace(trace.value(), shared, params, std::nullopt, progress);
    if (!comparison) return comparison.error();
    std::string guess;
    const auto& difference = comparison.value().difference;
    if (difference && difference->runPivots == 0) {
        const auto rules = teach::guessRules(trace.value(), shared, params, std::nullopt, progress);
        if (!rules) return rules.error();
        guess = teach::guessText(rules.value(), trace.value());
        guess.pop_back();  // the end of the line
    }
    Result<MadeMesh> run = makeMesh({points, params}, progress);
    if (!run) return run.error();
    found.b = found.a;
    found.runs.a = std::move(run.value());
    found.runs.commonPivots = static_cast<std::uint32_t>(comparison.value().alike);
    TraceReplay replay(std::move(trace.value()), params.start.triangles, points.size());
    found.runs.b = replay.mesh();
    found.trace = std::make_shared<const ComparedTrace>(
        ComparedTrace{std::move(replay), std::move(comparison.value()), std::move(guess)});
    return success();
}

/// The comparison of a run `a` with a run `b`, or with a file: `compareWith` makes the meshes and
/// compares the decisions.
Result<std::shared_ptr<const Compared>> compare(
    const std::shared_ptr<const Model>& a, const std::shared_ptr<const Model>& b,
    const std::function<Status(Compared& found)>& compareWith) {
    auto found = std::make_shared<Compared>();
    found->a = a;
    found->b = b;
    if (const Status compared = compareWith(*found); !compared) return compared.error();
    const std::span<const Triangle> ofA = found->runs.a.triangles;
    const std::span<const Triangle> ofB = found->runs.b.triangles;
    found->meshes = compareMeshes(found->b->points.position, ofA, ofB);
    found->setA = TriangleSet(ofA);
    found->setB = TriangleSet(ofB);
    return std::shared_ptr<const Compared>(std::move(found));
}

}  // namespace

bool Comparison::fits(const Session& run) const {
    const RunSpec& spec = run.input().spec();
    return with_.kind != CompareWith::Kind::Run ||
           (with_.run.source == spec.source && with_.run.piece == spec.piece &&
            with_.run.leftOut == spec.leftOut);
}

void Comparison::start(const Session& run, CompareWith with) {
    if (with.kind == CompareWith::Kind::Trace) return startTrace(run, with.path);
    cancel();
    with_ = std::move(with);
    if (with_.kind != CompareWith::Kind::Run) return;
    with_.run.source = run.input().spec().source;
    with_.run.points = run.input().spec().points;
    with_.run.piece = run.input().spec().piece;
    with_.run.leftOut = run.input().spec().leftOut;
    other_ = std::make_unique<Session>();
    other_->open(with_.run);
}

void Comparison::startTrace(const Session& run, const std::string& path) {
    traceFile_.begin(path);
    traceQuery_.start([a = run.sharedModel(), path](const Progress& progress) {
        return compare(a, nullptr,
                       [&](Compared& found) { return compareWithTrace(found, path, progress); });
    });
}

void Comparison::takeTrace(const Session& run) {
    const std::shared_ptr<const Compared> found = traceQuery_.takeAnswer().value_or(nullptr);
    if (!found) return refuse(run);
    // The run has been opened again meanwhile.
    if (found->a != run.sharedModel()) return startTrace(run, traceFile_.path().string());
    cancel();
    with_ = CompareWith::otherTrace(traceFile_.path().string());
    comparedA_ = found->a;
    result_ = found;
}

/// The comparison before stays, if it is still one of the open run.
void Comparison::refuse(const Session& run) {
    refusal_ = traceQuery_.complaint();
    const bool another = chosen() && with_.kind != CompareWith::Kind::Trace;
    if (another) return;
    if (result_ && comparedA_ == run.sharedModel()) {
        if (traceFile_.path() != with_.path) traceFile_.begin(with_.path);
        return;
    }
    const std::string why = refusal_;
    cancel();
    with_ = CompareWith::otherTrace(traceFile_.path().string());
    comparedA_ = run.sharedModel();
    complaint_ = why;
}

/// Takes the trace that was read, and reads it again where the file or the open run has changed.
bool Comparison::pollTrace(const Session& run) {
    const bool taken = traceQuery_.poll();
    if (taken) takeTrace(run);
    if (with_.kind != CompareWith::Kind::Trace || traceQuery_.busy()) return taken;
    const bool stale = comparedA_ != run.sharedModel();
    if (stale) result_.reset();
    if (stale || traceFile_.hasChanged()) startTrace(run, with_.path);
    return taken || stale;
}

TracePosition Comparison::tracePosition(const Session& run) const {
    assert(result_ && result_->trace);
    const TraceReplay& replay = result_->trace->replay;
    const std::uint32_t at = run.record().pivot;
    const RunAlignment alignment = result_->alignment();
    if (run.atEnd()) return {replay.pivots(), 0, true};
    const std::uint32_t pivot = std::min(matchingPivot(alignment, at), replay.pivots());
    const DecisionState& ours = run.picture();
    const bool within = inStep(alignment, at) && pivot == at && pivot > 0 && !ours.complete;
    if (!within) return {pivot, 0, true};
    const bool later = run.stage() && *run.stage() > Stage::Emit;
    return {pivot, later ? replay.fanOf(pivot).size() : ours.newTriangles.size(), false};
}

void Comparison::cancel() {
    query_.cancel();
    traceQuery_.cancel();
    refusal_.clear();
    with_ = {};
    other_.reset();
    result_.reset();
    comparedA_.reset();
    comparedB_.reset();
    complaint_.clear();
    held_.reset();
    followed_.reset();
    asked_ = kNowhere;
    ++revision_;
}

bool Comparison::working() const {
    if (query_.busy() || traceQuery_.busy()) return true;
    return runs() && other_->input().phase() == SessionPhase::Loading;
}

double Comparison::share() const {
    constexpr double kOpening = 0.4;
    if (traceQuery_.busy()) return traceQuery_.share();
    if (query_.busy())
        return runs() ? kOpening + (1.0 - kOpening) * query_.share() : query_.share();
    return runs() ? kOpening * other_->input().loadShare() : 0.0;
}

void Comparison::startJob(const Session& run) {
    result_.reset();
    complaint_.clear();
    ++revision_;
    comparedA_ = run.sharedModel();
    comparedB_ = runs() ? other_->sharedModel() : nullptr;
    const ByteLimit limit{run.input().spec().maxBytes};
    query_.start([a = comparedA_, b = comparedB_, mesh = with_.path,
                  limit](const Progress& progress) {
        return compare(a, b, [&](Compared& found) {
            return b ? compareTwo(found, progress) : compareWithMesh(found, mesh, limit, progress);
        });
    });
}

bool Comparison::takeResult() {
    if (!query_.poll()) return false;
    result_ = query_.takeAnswer().value_or(nullptr);
    complaint_ = query_.complaint();
    followed_.reset();
    asked_ = kNowhere;
    ++revision_;
    return true;
}

bool Comparison::poll(const Session& run) {
    if (!run.ready()) return false;
    bool changed = pollTrace(run);
    if (!chosen() || with_.kind == CompareWith::Kind::Trace) return changed;
    if (!fits(run)) {
        cancel();
        return true;
    }
    if (runs()) {
        changed = other_->poll() || changed;
        if (other_->input().phase() == SessionPhase::Failed) complaint_ = other_->input().error();
    }
    const bool there = !runs() || other_->ready();
    const auto mine = run.sharedModel();
    const auto theirs = runs() && there ? other_->sharedModel() : nullptr;
    if (there && (mine != comparedA_ || theirs != comparedB_)) startJob(run);
    changed = takeResult() || changed;
    if (runs() && there) {
        const std::uint32_t before = other_->revision();
        follow(run);
        changed = changed || other_->revision() != before;
    }
    return changed;
}

void Comparison::waitUntilDone(Session& run) {
    traceQuery_.waitUntilDone();
    poll(run);
    traceQuery_.waitUntilDone();
    if (!chosen()) return;
    poll(run);
    if (runs()) other_->waitUntilDone();
    poll(run);
    query_.waitUntilDone();
    // Two moves: to the pivot, and to the event in it.
    for (int i = 0; i < 3; ++i) {
        poll(run);
        if (runs()) other_->waitUntilDone();
    }
}

Comparison::Stand Comparison::standOf(const Session& run) {
    return {run.generation(), run.record().pivot, run.cursor()};
}

/// Where the other run is held; or the counterpart of a decision at which the two diverge.
std::optional<Address> Comparison::wantedAddress(const Session& run) const {
    if (held_) return held_;
    if (!result_ || !result_->runs.first || run.event() == nullptr) return {};
    const RunDifference& first = *result_->runs.first;
    const bool here = first.a.line && first.a.line->event.address == run.address();
    return here && first.b.line ? std::optional(first.b.line->event.address) : std::nullopt;
}

void Comparison::follow(const Session& run) {
    Session& other = *other_;
    other.showBefore(run.showsBefore());
    if (run.moves().busy() || other.moves().busy()) return;
    const Stand here = standOf(run);
    if (held_) {
        if (!heldBy_) heldBy_ = here;
        if (!(*heldBy_ == here)) held_.reset();
    }
    if (followed_ == here) return;
    const std::optional<Address> wanted = wantedAddress(run);
    if (!wanted && run.atEnd()) {
        // There may be steps after the last pivot: both ends correspond.
        followed_ = here;
        asked_ = kNowhere;
        return other.atEnd() ? void() : other.moves().toEnd();
    }
    const RunAlignment alignment = result_ ? result_->alignment() : RunAlignment{};
    const std::uint32_t pivot = wanted ? wanted->pivot : matchingPivot(alignment, here.pivot);
    if (other.record().pivot != pivot && asked_ != pivot) {
        asked_ = pivot;
        other.moves().playTo({pivot, Stage::Pivot, 0});
        // A result in memory is available at once, and drawn once.
        if (other.moves().busy()) return;
    }
    followed_ = here;
    asked_ = pivot;
    const std::vector<Event>& events = other.record().events;
    if (events.empty()) return;
    std::size_t cursor = events.size() - 1;
    if (wanted) {
        cursor = other.record().find(*wanted).value_or(cursor);
    } else if (inStep(alignment, here.pivot) && other.record().pivot == here.pivot) {
        // Both ends correspond.
        const bool last = run.event() == nullptr || run.cursor() + 1 == run.record().events.size();
        if (!last) cursor = eventLike(events, run.address(), subjectOf(*run.event()));
    }
    if (cursor != other.cursor()) other.moves().goToEvent(cursor);
}

void Comparison::goTo(Session& run, const ComparedAddresses& place) {
    held_ = place.b;
    heldBy_.reset();
    followed_.reset();
    asked_ = kNowhere;
    place.a ? run.moves().goTo(*place.a) : run.moves().toEnd();
}

void CompareForm::takeOther(const RunSpec& other, const Model& model) {
    rules = other;
    prepare.take(other, model);
    prepare.open = false;
    whatIf.clear();
    complaint.clear();
}

void CompareForm::take(const RunSpec& spec, const Model& model) {
    takeOther(usualOther(spec), model);
    ruleFilter = {};
}

void CompareForm::follow(const RunSpec& before, const RunSpec& now, const Model& model) {
    // With the rules of `now` only the preparation remains to differ.
    if (differenceText(withRulesOf(before, now), now) != kNoDifference) {
        prepare.take(now, model);
        prepare.open = false;
    }
    if (before.whatIf != now.whatIf) rules.whatIf = now.whatIf;
}

void CompareForm::addWhatIf() {
    const Result<WhatIf> read = whatIfFromText(whatIf);
    complaint = read ? std::string{} : read.error().message;
    if (!read) return;
    rules = withWhatIf(rules, read.value());
    whatIf.clear();
}

Result<RunSpec> CompareForm::spec(const RunSpec& base) const {
    return prepare.spec(withRulesOf(base, rules));
}

RunSpec trueRunOf(RunSpec spec) {
    spec.whatIf.clear();
    return spec;
}

namespace {

/// The position of a run, and the number of triangles only in it.
std::string runNote(const Session& session, std::size_t only) {
    const bool placed = session.ready() && session.event() != nullptr;
    return (placed ? toString(session.address()) : "start") + "   " + grouped(only) + " only here";
}

}  // namespace

std::array<ComparedTitle, 2> comparedTitles(const Session& run, const Comparison* now) {
    ComparedTitle a{"A", run.ready() ? runTitle(run.input().spec()) : "", "", &Palette::used};
    ComparedTitle b{"B", "nothing yet", "", &Palette::last};
    const Compared* found = now != nullptr ? now->result() : nullptr;
    if (found != nullptr) a.note = runNote(run, found->meshes.onlyA);
    if (now == nullptr || !now->chosen()) return {a, b};
    if (now->with().isFile()) {
        b.name = fileTitle(now->with());
        if (found != nullptr) b.note = grouped(found->meshes.onlyB) + " only here";
    } else if (run.ready()) {
        b.name = differenceText(run.input().spec(), now->with().run);
        if (found != nullptr && now->other() != nullptr)
            b.note = runNote(*now->other(), found->meshes.onlyB);
    }
    return {a, b};
}

}  // namespace se::view
