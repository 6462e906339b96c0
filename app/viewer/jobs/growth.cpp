// The sampler runs in a thread that is paced by the window: `due` counts the steps to make, and
// the thread sleeps between them while it is played. Only the newest picture is kept, so a slow
// window skips pictures instead of lagging. Quality measures are costly and get a fixed
// share of the time, except at rest, where the figures must belong to the picture.
#include "growth.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <utility>

#include "thread.h"

namespace se::view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kAll = std::numeric_limits<int>::max();
/// Measuring may take at most this share of the time.
constexpr double kMeasureShare = 0.2;

}  // namespace

/// State shared by the window and the thread.
struct Growth::Job {
    SampleSpec spec;
    std::mutex mutex;
    std::condition_variable changed;
    // Guarded by the mutex:
    int due = 0;          ///< Steps to be made.
    bool slowly = false;  ///< At kRate.
    std::optional<GrowthPicture> fresh;
    std::optional<std::string> error;
    GrowthPhase phase = GrowthPhase::Finding;
    bool over = false;  ///< Nothing follows.

    std::atomic<double> found = 0.0;
    std::optional<Thread> thread;  // last: it uses all members above
};

namespace {

/// Measures as often as possible without slowing the steps.
class Measurer {
  public:
    SampleQuality of(const Field& field, const PointFile& points, bool atOnce,
                     const Progress& goOn) {
        const auto now = Clock::now();
        const std::chrono::duration<double> since = now - last_;
        if (!atOnce && since.count() * kMeasureShare < cost_) return known_;
        known_ = measureSample(field, points, goOn);
        last_ = Clock::now();
        cost_ = std::chrono::duration<double>(last_ - now).count();
        return known_;
    }

  private:
    SampleQuality known_;
    Clock::time_point last_{};
    double cost_ = 0.0;
};

GrowthPicture pictureOf(const Field& field, const Sampler& sampler, Measurer& measurer,
                        bool resting, const Progress& goOn) {
    GrowthPicture picture;
    picture.points = std::make_shared<const PointFile>(sampler.points());
    picture.step = sampler.steps();
    picture.wanted = sampler.spacing();
    picture.quality = measurer.of(field, *picture.points, resting, goOn);
    picture.low = field.low;
    picture.high = field.high;
    return picture;
}

}  // namespace

std::string_view growthPhaseName(GrowthPhase phase) {
    constexpr std::array<std::string_view, 6> kNames = {"idle",   "finding", "spreading",
                                                        "paused", "done",    "failed"};
    static_assert(kNames.size() == static_cast<std::size_t>(GrowthPhase::Failed) + 1);
    return kNames[static_cast<std::size_t>(phase)];
}

Growth::Growth() = default;

Growth::~Growth() {
    cancel();
    // Cancel all threads before joining the first.
    cancelled_.clear();
}

void Growth::dropEnded() {
    std::erase_if(cancelled_, [](const auto& job) { return job->thread->ended(); });
}

void Growth::cancel() {
    dropEnded();
    phase_ = GrowthPhase::Idle;
    picture_.reset();
    error_.clear();
    if (!job_) return;
    job_->thread->cancel();
    {
        const std::scoped_lock lock(job_->mutex);
        job_->changed.notify_all();
    }
    cancelled_.push_back(std::move(job_));
}

void Growth::setTarget(int steps, bool slowly) {
    if (!job_ || phase_ == GrowthPhase::Done || phase_ == GrowthPhase::Failed) return;
    const std::scoped_lock lock(job_->mutex);
    job_->due = steps;
    job_->slowly = slowly;
    job_->changed.notify_all();
}

void Growth::play() { setTarget(kAll, true); }
void Growth::pause() { setTarget(0, false); }
void Growth::step() {
    int due = 0;
    if (job_) {
        const std::scoped_lock lock(job_->mutex);
        due = job_->due == kAll ? 0 : job_->due;
    }
    setTarget(due + 1, false);
}
void Growth::finish() { setTarget(kAll, false); }

double Growth::found() const { return job_ ? job_->found.load() : 0.0; }

bool Growth::poll() {
    dropEnded();
    if (!job_) return false;
    const std::scoped_lock lock(job_->mutex);
    bool changed = std::exchange(phase_, job_->phase) != job_->phase;
    if (job_->error) {
        error_ = *std::exchange(job_->error, std::nullopt);
        picture_.reset();
        changed = true;
    }
    if (job_->fresh) {
        picture_ = std::exchange(job_->fresh, std::nullopt);
        changed = true;
    }
    return changed;
}

void Growth::waitUntilDone() {
    if (!job_) return;
    {
        std::unique_lock lock(job_->mutex);
        job_->changed.wait(lock, [this] {
            const bool waits = job_->phase == GrowthPhase::Paused && job_->due == 0;
            return waits || job_->over;
        });
    }
    poll();
}

SampleSpec Growth::spec() const {
    SampleSpec spec = spec_;
    spec.steps = picture_ && picture_->step < Sampler::allSteps() ? picture_->step : 0;
    return spec;
}

/// Body of the thread.
class Growth::Worker {
  public:
    Worker(Job& job, const CancelFlag& cancelled) : job_(job), cancelled_(cancelled) {}

    void work() {
        Result<Field> field = surfaceOf(job_.spec);
        if (!field) return fail(field.error().message);
        field_ = std::move(field.value());
        Result<Sampler> begun = Sampler::begin(field_, job_.spec.sampler(), [this](double share) {
            job_.found = share;
            return !cancelled_.isSet();
        });
        if (!begun) return fail(begun.error().message);
        Sampler& sampler = begun.value();
        publish(sampler, GrowthPhase::Spreading);
        while (!sampler.done()) {
            const Turn turn = await();
            if (cancelled_.isSet()) return;
            if (turn == Turn::Rest) {
                publish(sampler, GrowthPhase::Paused);
                rest();
                continue;
            }
            if (!sampler.step(goOn_)) return;
            if (turn == Turn::StepAndShow && !sampler.done()) {
                publish(sampler, GrowthPhase::Spreading);
            }
        }
        publish(sampler, GrowthPhase::Done);
    }
    void fail(const std::string& message) {
        const std::scoped_lock lock(job_.mutex);
        job_.error = message;
        job_.phase = GrowthPhase::Failed;
    }

  private:
    enum class Turn : std::uint8_t { Rest, Step, StepAndShow };

    /// Publishes a picture; one that was not taken is replaced, so the newest is always next.
    void publish(const Sampler& sampler, GrowthPhase phase) {
        const bool resting = phase != GrowthPhase::Spreading;
        GrowthPicture picture = pictureOf(field_, sampler, measurer_, resting, goOn_);
        const std::scoped_lock lock(job_.mutex);
        job_.fresh = std::move(picture);
        // No rest if the user resumed in the meantime.
        job_.phase = phase == GrowthPhase::Paused && job_.due > 0 ? GrowthPhase::Spreading : phase;
        job_.changed.notify_all();
    }

    /// Waits for the time of the next step; a pause or finish() ends the wait early.
    Turn await() {
        std::unique_lock lock(job_.mutex);
        if (job_.due > 0 && job_.slowly) {
            const std::chrono::duration<double> period(1.0 / kRate);
            next_ =
                std::max(next_ + std::chrono::duration_cast<Clock::duration>(period), Clock::now());
            job_.changed.wait_until(lock, next_,
                                    [this] { return !job_.slowly || cancelled_.isSet(); });
        }
        if (job_.due == 0) return Turn::Rest;
        if (job_.due != kAll) --job_.due;
        return job_.fresh ? Turn::Step : Turn::StepAndShow;
    }

    void rest() {
        std::unique_lock lock(job_.mutex);
        job_.changed.wait(lock, [this] { return job_.due > 0 || cancelled_.isSet(); });
        job_.phase = GrowthPhase::Spreading;
        next_ = Clock::now();
    }

    Job& job_;
    const CancelFlag& cancelled_;
    const Progress goOn_ = [this](double) { return !cancelled_.isSet(); };
    Field field_;
    Measurer measurer_;
    Clock::time_point next_ = Clock::now();
};

void Growth::start(const SampleSpec& spec) {
    cancel();
    spec_ = spec;
    phase_ = GrowthPhase::Finding;
    job_ = std::make_unique<Job>();
    job_->spec = spec;
    job_->due = spec.steps > 0 ? spec.steps : kAll;
    job_->slowly = spec.steps == 0;
    job_->thread.emplace([&job = *job_](const CancelFlag& cancelled) {
        Worker worker(job, cancelled);
        const Status good = guarded([&worker] { worker.work(); });
        if (!good) worker.fail(good.error().message);
        const std::scoped_lock lock(job.mutex);
        job.over = true;
        job.changed.notify_all();
    });
}

}  // namespace se::view
