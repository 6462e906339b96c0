#include "runner.h"

#include <algorithm>

namespace se::view {

namespace {

/// How long to run between two pictures of a long way.
constexpr std::chrono::milliseconds kSlice{120};

}  // namespace

Runner::Runner(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      timeline_(model_->points, model_->params),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

Runner::~Runner() { cancelled_ = true; }

void Runner::request(std::uint32_t pivot) {
    {
        const std::lock_guard lock(mutex_);
        cancelled_ = false;
        wanted_ = pivot;
    }
    changed_.notify_all();
}

void Runner::wait(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] { return answer_ && answer_->final; });
}

std::optional<RunnerAnswer> Runner::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(answer_, std::nullopt);
}

void Runner::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::uint32_t pivot = 0;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [&] { return wanted_.has_value(); })) return;
            pivot = *std::exchange(wanted_, std::nullopt);
        }
        serve(pivot, stop);
    }
}

void Runner::serve(std::uint32_t pivot, const std::stop_token& stop) {
    const std::uint32_t before = pivot == 0 ? 0 : pivot - 1;
    bool arrived = false;
    while (!arrived && !cancelled_ && !stop.stop_requested()) {
        const auto deadline = std::chrono::steady_clock::now() + kSlice;
        arrived = true;
        timeline_.seek(before, [&] {
            position_ = timeline_.position();
            arrived = std::chrono::steady_clock::now() < deadline && !cancelled_;
            return arrived;
        });
        if (!arrived && !cancelled_) publish(timeline_.position(), false);
    }
    publish(arrived ? pivot : timeline_.position(), true);
}

void Runner::publish(std::uint32_t pivot, bool final) {
    std::shared_ptr<const PivotRecord> record = recordPivot(timeline_, pivot, status_);
    position_ = timeline_.position();
    const std::vector<Triangle>& all = timeline_.state().triangles;
    {
        const std::lock_guard lock(mutex_);
        if (!answer_) answer_.emplace();
        answer_->record = std::move(record);
        answer_->final = final;
        if (all.size() > publishedTriangles_) {
            const auto from = all.begin() + static_cast<std::ptrdiff_t>(publishedTriangles_);
            answer_->newTriangles.insert(answer_->newTriangles.end(), from, all.end());
            publishedTriangles_ = all.size();
        }
    }
    changed_.notify_all();
}

}  // namespace se::view
