// One Timeline makes the run and moves in it. Slices of making it alternate with requests, which
// come first: a request to a pivot that was made moves back there, one beyond makes the run up to
// it. Every pivot is shown to the observer once, when it is made. While the user steps, the
// timeline stays near the cursor: each way to the end of what was made and back costs some
// milliseconds in a run of a million points. Triangles are sent only once, since the run only ever
// appends them.
#include "runner.h"

#include <algorithm>
#include <cassert>

#include "spiraling_edge/run/reading.h"

namespace se::view {

namespace {

/// Time after a request during which another one is expected.
constexpr std::chrono::milliseconds kLinger{200};
/// Longest time between two slices of making the run.
constexpr std::chrono::milliseconds kLongestPause{1000};

}  // namespace

Runner::Runner(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      timeline_(model_->points, model_->params),
      counts_(model_->points),
      thread_([this](const CancelFlag& ending) { return work(ending); }) {}

void Runner::ask(const Request& request) {
    {
        const std::lock_guard lock(mutex_);
        assert(!open_);
        open_ = true;
        cancelled_ = false;
        wanted_ = request;
        asked_ = true;
    }
    thread_.wake();
}

bool Runner::waitFor(std::chrono::milliseconds timeout) {
    const auto isAnswered = [this] {
        const std::lock_guard lock(mutex_);
        return answer_ && answer_->final;
    };
    thread_.waitFor(timeout, isAnswered);
    return isAnswered();
}

std::optional<RunnerAnswer> Runner::take() {
    const std::lock_guard lock(mutex_);
    if (answer_ && answer_->final) open_ = false;
    return std::exchange(answer_, std::nullopt);
}

std::string Runner::complaint() {
    const std::lock_guard lock(mutex_);
    return answer_ ? answer_->complaint : std::string{};
}

bool Runner::takeOverview(RunOverview& overview) {
    std::vector<RunOverview> found;
    {
        const std::lock_guard lock(mutex_);
        found = std::exchange(overview_, {});
    }
    if (!found.empty() && overview.pivots.empty()) reservePivots(overview, model_->points.size());
    for (const RunOverview& fresh : found) append(overview, fresh);
    return !found.empty();
}

std::string Runner::takeComplaint() {
    const std::lock_guard lock(mutex_);
    return std::exchange(unmade_, {});
}

std::shared_ptr<const RunEnd> Runner::end() {
    const std::lock_guard lock(mutex_);
    return end_;
}

void Runner::waitUntilMade() {
    while (!thread_.waitFor(std::chrono::hours(1), [this] { return made(); })) {
    }
}

/// A slice of the thread.
Slice Runner::work(const CancelFlag& ending) {
    if (ending.isSet()) return Slice::Done;
    takeRequest();
    const bool waits = !serving_ && makes() && lingers();
    const Status good = guarded([&] {
        if (!complaint_.empty() || waits) return;
        if (!observer_ && !made_) begin();
        serving_ ? serve() : make(ending);
    });
    if (!good) complaint_ = good.error().message;
    if (!complaint_.empty()) publishComplaint();
    if (waits) return Slice::Pause;
    return serving_ || makes() ? Slice::More : Slice::Idle;
}

/// Begins to observe. Not in the constructor, whose caller gets no exception of it.
void Runner::begin() {
    timeline_.setVisitor([this](const SweptPivot& pivot) {
        if (observer_) observed([&] { observe(pivot); });
    });
    observed([this] { observer_.emplace(*model_, timeline_.state()); });
}

/// Calls `work` of the observer. A failure ends what is observed, not the moves.
void Runner::observed(const std::function<void()>& work) {
    const Status good = guarded(work);
    if (good) return;
    observer_.reset();
    const std::lock_guard lock(mutex_);
    unmade_ = good.error().message;
    made_ = true;
}

void Runner::takeRequest() {
    const std::lock_guard lock(mutex_);
    if (!wanted_) return;
    serving_ = std::exchange(wanted_, std::nullopt);
    asked_ = searching_ = false;
    found_ = true;
}

/// A slice of the open request.
void Runner::serve() {
    servedLast_ = Clock::now();
    const auto deadline = servedLast_ + sliceTime();
    const auto keepGoing = [&] {
        position_ = timeline_.position();
        return Clock::now() < deadline && !cancelled_;
    };
    const std::uint32_t pivot = serving_->pivot;
    if (!searching_) {
        const bool finds = serving_->point != kNone;
        const bool there = goTo(finds || pivot == 0 ? pivot : pivot - 1, keepGoing);
        searching_ = there && finds;
        if (cancelled_ || (there && !finds))
            return publish(there ? pivot : timeline_.position(), true);
        if (!there) return publish(timeline_.position(), false);
    }
    searchPoint(keepGoing);
    if (cancelled_) publish(timeline_.position(), true);
}

/// Moves the timeline. False if it did not arrive.
bool Runner::goTo(std::uint32_t position, const std::function<bool()>& keepGoing) {
    bool arrived = true;
    timeline_.seek(position, [&] { return arrived = keepGoing(); });
    noteEnd();
    return arrived;
}

/// Goes on until an event is about the point of the request; then the request is for its pivot.
void Runner::searchPoint(const std::function<bool()>& keepGoing) {
    EventLog log;
    for (bool more = true; more && keepGoing(); log.clear()) {
        more = timeline_.stepPivot(&log);
        noteEnd();
        const auto about = [&](const Event& event) { return subjectOf(event) == serving_->point; };
        const auto event = std::find_if(log.events().begin(), log.events().end(), about);
        found_ = event != log.events().end();
        if (more && !found_) continue;
        serving_ = Request{found_ ? event->address.pivot : serving_->pivot, kNone};
        searching_ = false;
        return;
    }
}

/// Soon after a request the timeline stays where it is, unless the run would not be made.
bool Runner::lingers() const {
    const auto now = Clock::now();
    return timeline_.position() != timeline_.farthest() && now - servedLast_ < kLinger &&
           now - madeLast_ < kLongestPause;
}

/// Makes the run for a slice, or until something is requested.
void Runner::make(const CancelFlag& ending) {
    if (!makes()) return;
    const auto deadline = Clock::now() + sliceTime();
    const auto keepGoing = [&] { return Clock::now() < deadline && !asked_ && !ending.isSet(); };
    timeline_.makeRest(keepGoing);
    noteEnd();
    madeLast_ = Clock::now();
    handOver();
    // Leaves the edited mesh, which takes as much memory as the run.
    if (made_) timeline_.seek(servedAt_);
}

/// Takes each pivot of the run when it is made for the first time.
void Runner::observe(const SweptPivot& pivot) {
    counts_.add(pivot);
    observer_->add(pivot, fresh_);
}

/// Keeps the end of the run, once it is reached.
void Runner::noteEnd() {
    if (made_ || !timeline_.state().finished()) return;
    const std::span<const Triangle> mesh = timeline_.state().mesh();
    RunEnd end{{mesh.begin(), mesh.end()},
               timeline_.state().capped(),
               std::move(counts_),
               stateHash(timeline_.state())};
    fresh_.complete = true;
    {
        const std::lock_guard lock(mutex_);
        end_ = std::make_shared<const RunEnd>(std::move(end));
    }
    handOver();
    made_ = true;
}

void Runner::handOver() {
    if (fresh_.pivots.empty() && !fresh_.complete) return;
    RunOverview fresh = std::exchange(fresh_, {});
    const std::lock_guard lock(mutex_);
    overview_.push_back(std::move(fresh));
}

void Runner::publish(std::uint32_t pivot, bool final) {
    std::shared_ptr<const PivotRecord> record = timeline_.record(pivot);
    noteEnd();
    handOver();
    position_ = timeline_.position();
    const std::vector<Triangle>& all = timeline_.state().triangles;
    if (final) {
        serving_.reset();
        servedAt_ = timeline_.position();
    }
    const std::lock_guard lock(mutex_);
    if (!answer_) answer_.emplace();
    answer_->record = std::move(record);
    answer_->final = final;
    answer_->found = found_;
    if (all.size() <= publishedTriangles_) return;
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(publishedTriangles_);
    answer_->newTriangles.insert(answer_->newTriangles.end(), from, all.end());
    publishedTriangles_ = all.size();
}

void Runner::publishComplaint() {
    const bool serves = std::exchange(serving_, std::nullopt).has_value();
    const std::lock_guard lock(mutex_);
    if (!made_ && !serves) unmade_ = complaint_;
    made_ = true;
    if (!serves) return;
    if (!answer_) answer_.emplace();
    answer_->complaint = complaint_;
    answer_->final = true;
}

}  // namespace se::view
