// A single thread owns the Timeline; the window posts one request at a time and takes immutable
// PivotRecords in return. A long move publishes a picture every kSlice. Triangles are sent only
// once, since the run only ever appends them.
#include "runner.h"

#include <algorithm>
#include <cassert>

#include "spiraling_edge/replay/reading.h"
#include "spiraling_edge/stepper/stepper.h"

namespace se::view {

namespace {

/// Time between two pictures during a long run.
constexpr std::chrono::milliseconds kSlice{120};

}  // namespace

Runner::Runner(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      timeline_(model_->points, model_->params),
      thread_([this](const CancelFlag&) { work(); }) {}

Runner::~Runner() {
    {
        const std::lock_guard lock(mutex_);
        cancelled_ = true;
        ending_ = true;
    }
    changed_.notify_all();
}

void Runner::request(std::uint32_t pivot) { ask({pivot, kNone}); }

void Runner::requestPoint(Index point, std::uint32_t pivot) { ask({pivot, point}); }

void Runner::ask(const Request& request) {
    {
        const std::lock_guard lock(mutex_);
        assert(!open_);
        open_ = true;
        cancelled_ = false;
        wanted_ = request;
    }
    changed_.notify_all();
}

bool Runner::waitFor(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, timeout, [&] { return answer_ && answer_->final; });
}

std::optional<RunnerAnswer> Runner::take() {
    const std::lock_guard lock(mutex_);
    if (answer_ && answer_->final) open_ = false;
    return std::exchange(answer_, std::nullopt);
}

void Runner::work() {
    while (true) {
        Request request;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [&] { return wanted_.has_value() || ending_; });
            if (ending_) return;
            request = *std::exchange(wanted_, std::nullopt);
        }
        const Status good = guarded([&] {
            if (!complaint_.empty()) return;
            request.point == kNone ? serve(request.pivot) : servePoint(request);
        });
        if (!good) complaint_ = good.error().message;
        if (!complaint_.empty()) publishComplaint();
    }
}

/// Moves the timeline, with a progress picture now and then. False if cancelled.
bool Runner::goTo(std::uint32_t position) {
    bool arrived = false;
    while (!arrived && !cancelled_) {
        const auto deadline = std::chrono::steady_clock::now() + kSlice;
        arrived = true;
        timeline_.seek(position, [&] {
            position_ = timeline_.position();
            arrived = std::chrono::steady_clock::now() < deadline && !cancelled_;
            return arrived;
        });
        if (!arrived && !cancelled_) publish(timeline_.position(), false);
    }
    return arrived;
}

void Runner::serve(std::uint32_t pivot) {
    const bool arrived = goTo(pivot == 0 ? 0 : pivot - 1);
    publish(arrived ? pivot : timeline_.position(), true);
}

void Runner::servePoint(const Request& request) {
    if (!goTo(request.pivot)) return publish(timeline_.position(), true);
    // With a stepper of its own: the timeline would make each pivot twice.
    EventLog log;
    Stepper stepper(model_->points, model_->params, &log);
    stepper.setState(timeline_.state());
    bool found = false;
    std::uint32_t pivot = request.pivot;
    for (bool more = true; more && !found && !cancelled_;) {
        log.clear();
        more = stepper.stepPivot();
        found = std::any_of(log.events().begin(), log.events().end(), [&](const Event& event) {
            if (subjectOf(event) != request.point) return false;
            pivot = event.address.pivot;
            return true;
        });
        position_ = stepper.state().counters.pivots;
    }
    if (found) return serve(pivot);
    found_ = false;
    serve(request.pivot);
    found_ = true;
}

void Runner::publishComplaint() {
    {
        const std::lock_guard lock(mutex_);
        if (!answer_) answer_.emplace();
        answer_->complaint = complaint_;
        answer_->final = true;
    }
    changed_.notify_all();
}

std::string Runner::complaint() {
    const std::lock_guard lock(mutex_);
    return answer_ ? answer_->complaint : std::string{};
}

void Runner::publish(std::uint32_t pivot, bool final) {
    std::shared_ptr<const PivotRecord> record = timeline_.record(pivot);
    position_ = timeline_.position();
    const std::vector<Triangle>& all = timeline_.state().triangles;
    {
        const std::lock_guard lock(mutex_);
        if (!answer_) answer_.emplace();
        answer_->record = std::move(record);
        answer_->final = final;
        answer_->found = found_;
        if (all.size() > publishedTriangles_) {
            const auto from = all.begin() + static_cast<std::ptrdiff_t>(publishedTriangles_);
            answer_->newTriangles.insert(answer_->newTriangles.end(), from, all.end());
            publishedTriangles_ = all.size();
        }
    }
    changed_.notify_all();
}

}  // namespace se::view
