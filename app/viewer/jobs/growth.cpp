// The sampler's slices are paced by the window: `due` counts the steps to make, and there is a
// pause between them while it is played. Only the newest picture is kept, so a slow window skips
// pictures instead of lagging. Quality measures are costly and get a fixed share of the time,
// except at rest, where the figures must belong to the picture.
#include "growth.h"

#include <algorithm>
#include <atomic>
#include <chrono>
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
    // Guarded by the mutex:
    int due = 0;          ///< Steps to be made.
    bool slowly = false;  ///< At kRate.
    std::optional<GrowthPicture> fresh;
    std::optional<std::string> error;
    GrowthPhase phase = GrowthPhase::Finding;

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
    const std::vector<std::uint8_t>& type = picture.points->type;
    picture.onWalls = static_cast<std::size_t>(std::count_if(type.begin(), type.end(), isBoundary));
    picture.corners = static_cast<std::size_t>(std::count_if(type.begin(), type.end(), isCorner));
    picture.wanted = sampler.spacing();
    picture.quality = measurer.of(field, *picture.points, resting, goOn);
    picture.low = field.low;
    picture.high = field.high;
    return picture;
}

}  // namespace

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
    cancelled_.push_back(std::move(job_));
}

void Growth::setTarget(int steps, bool slowly) {
    if (!job_ || phase_ == GrowthPhase::Done || phase_ == GrowthPhase::Failed) return;
    {
        const std::scoped_lock lock(job_->mutex);
        job_->due = steps;
        job_->slowly = slowly;
    }
    job_->thread->wake();
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
    const auto rests = [this] {
        const std::scoped_lock lock(job_->mutex);
        return job_->phase == GrowthPhase::Paused && job_->due == 0;
    };
    while (!job_->thread->waitFor(std::chrono::hours(1), rests)) {
    }
    poll();
}

SampleSpec Growth::spec() const {
    SampleSpec spec = spec_;
    spec.steps = picture_ && picture_->step < Sampler::allSteps() ? picture_->step : 0;
    return spec;
}

/// The slices of the work: the surface is found, then each is a step.
class Growth::Worker {
  public:
    explicit Worker(Job& job) : job_(job) {}

    Slice work(const CancelFlag& cancelled) {
        if (cancelled.isSet()) return Slice::Done;
        const Progress goOn = [&cancelled](double) { return !cancelled.isSet(); };
        if (!sampler_) return begin(cancelled, goOn);
        if (sampler_->done()) {
            publish(GrowthPhase::Done, goOn);
            return Slice::Done;
        }
        const Turn turn = takeTurn();
        if (turn == Turn::Wait) return Slice::Pause;
        if (turn == Turn::Rest) {
            publish(GrowthPhase::Paused, goOn);
            return Slice::Idle;
        }
        if (!sampler_->step(goOn)) return Slice::Done;
        if (turn == Turn::StepAndShow && !sampler_->done()) publish(GrowthPhase::Spreading, goOn);
        return Slice::More;
    }
    Slice fail(const std::string& message) {
        const std::scoped_lock lock(job_.mutex);
        job_.error = message;
        job_.phase = GrowthPhase::Failed;
        return Slice::Done;
    }

  private:
    enum class Turn : std::uint8_t { Rest, Wait, Step, StepAndShow };

    Slice begin(const CancelFlag& cancelled, const Progress& goOn) {
        Result<Field> field = surfaceOf(job_.spec);
        if (!field) return fail(field.error().message);
        field_ = std::move(field.value());
        Result<Sampler> begun = Sampler::begin(field_, job_.spec.sampler(), [&](double share) {
            job_.found = share;
            return !cancelled.isSet();
        });
        if (!begun) return fail(begun.error().message);
        sampler_.emplace(std::move(begun.value()));
        publish(GrowthPhase::Spreading, goOn);
        return Slice::More;
    }

    /// Publishes a picture; one that was not taken is replaced, so the newest is always next.
    void publish(GrowthPhase phase, const Progress& goOn) {
        const bool resting = phase != GrowthPhase::Spreading;
        GrowthPicture picture = pictureOf(field_, *sampler_, measurer_, resting, goOn);
        const std::scoped_lock lock(job_.mutex);
        job_.fresh = std::move(picture);
        // No rest if the user resumed in the meantime.
        job_.phase = phase == GrowthPhase::Paused && job_.due > 0 ? GrowthPhase::Spreading : phase;
    }

    /// Whether it is time for the next step; finish() ends the wait early.
    Turn takeTurn() {
        const std::scoped_lock lock(job_.mutex);
        const auto now = Clock::now();
        if (job_.due == 0) return Turn::Rest;
        // After a rest, no steps are made up for.
        if (std::exchange(job_.phase, GrowthPhase::Spreading) == GrowthPhase::Paused) next_ = now;
        if (job_.slowly && now < next_) return Turn::Wait;
        const std::chrono::duration<double> period(1.0 / kRate);
        next_ = std::max(next_ + std::chrono::duration_cast<Clock::duration>(period), now);
        if (job_.due != kAll) --job_.due;
        return job_.fresh ? Turn::Step : Turn::StepAndShow;
    }

    Job& job_;
    Field field_;
    std::optional<Sampler> sampler_;
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
    const auto worker = std::make_shared<Worker>(*job_);
    job_->thread.emplace([worker](const CancelFlag& cancelled) {
        Slice next = Slice::Done;
        const Status good = guarded([&] { next = worker->work(cancelled); });
        return good ? next : worker->fail(good.error().message);
    });
}

}  // namespace se::view
