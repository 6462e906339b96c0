// A job makes the steps up to a target; once it has ended, the next one goes on with the same
// sampler. Quality measures are costly and get a fixed share of the time, except at rest, where the
// figures must belong to the picture.
#include "growth.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

namespace se::view {

namespace {

using Clock = std::chrono::steady_clock;
using Results = BackgroundJob<Result<GrowthPicture>>::Results;

/// Measuring may take at most this share of the time.
constexpr double kMeasureShare = 0.2;

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

}  // namespace

/// The sampler of one start, shared by window and job. While the job goes on, it alone uses all but
/// the atomics.
struct Growth::Spread {
    SampleSpec spec;
    Field field;
    std::optional<Sampler> sampler;
    Measurer measurer;
    bool rests = false;                 ///< The last picture is measured.
    std::atomic<int> target = 0;        ///< The step to stop at.
    std::atomic<bool> follows = false;  ///< Further steps will be asked for then.

    /// Finds the surface, or makes a step. False at the target.
    bool advance(Results& results) {
        const auto goOn = [&](double share) { return results.report(sampler ? 1.0 : share); };
        if (!sampler) {
            if (const Status begun = begin(goOn); !begun) {
                results.add(begun.error());
                return false;
            }
        } else if (sampler->steps() < target && !sampler->step(goOn)) {
            return false;
        }
        const bool more = sampler->steps() < std::min(target.load(), Sampler::allSteps());
        rests = sampler->done() || !(more || follows);
        results.add(picture(goOn));
        return results.report(1.0) && more;
    }

    Status begin(const Progress& goOn) {
        Result<Field> found = surfaceOf(spec);
        if (!found) return found.error();
        field = std::move(found.value());
        Result<Sampler> begun = Sampler::begin(field, spec.sampler(), goOn);
        if (!begun) return begun.error();
        sampler.emplace(std::move(begun.value()));
        return success();
    }

    GrowthPicture picture(const Progress& goOn) {
        GrowthPicture picture;
        picture.points = std::make_shared<const PointFile>(sampler->points());
        picture.step = sampler->steps();
        const std::vector<std::uint8_t>& type = picture.points->type;
        const auto count = [&](auto is) {
            return static_cast<std::size_t>(std::count_if(type.begin(), type.end(), is));
        };
        picture.onWalls = count(isBoundary);
        picture.corners = count(isCorner);
        picture.wanted = sampler->spacing();
        picture.quality = measurer.of(field, *picture.points, rests, goOn);
        picture.low = field.low;
        picture.high = field.high;
        return picture;
    }
};

void Growth::start(const SampleSpec& spec) {
    cancel();
    spec_ = spec;
    spread_ = std::make_shared<Spread>();
    spread_->spec = spec;
    spread_->target = spec.steps;
    work();
}

void Growth::work() {
    if (!job_.busy())
        job_.startSlices([spread = spread_](Results& results) { return spread->advance(results); });
}

void Growth::cancel() {
    job_.cancel();
    spread_.reset();
    picture_.reset();
    error_.clear();
}

void Growth::play(int steps) {
    if (!spread_) return;
    spread_->follows = true;
    spread_->target = (picture_ ? picture_->step : 0) + steps;
    work();
}

void Growth::advance(int steps) {
    if (!spread_ || !error_.empty() || phase() == GrowthPhase::Done) return;
    spread_->follows = false;
    const int made = picture_ ? picture_->step : 0;
    const bool finishes = spread_->target >= Sampler::allSteps();
    spread_->target = (finishes ? made : std::max(made, spread_->target.load())) + steps;
    work();
}

void Growth::pause() {
    if (!spread_ || !error_.empty() || phase() == GrowthPhase::Done) return;
    spread_->follows = false;
    spread_->target = 0;
    work();
}

bool Growth::poll() {
    auto taken = job_.take();
    for (Result<GrowthPicture>& each : taken.items) {
        if (each) picture_ = std::move(each.value());
        if (!each) error_ = each.error().message;
    }
    if (!taken.ended) return taken.any();
    if (!taken.complaint.empty()) error_ = std::move(taken.complaint);
    if (!error_.empty()) picture_.reset();
    if (!picture_) return true;
    // What was asked for at its end.
    const bool lacks = picture_->step < std::min(spread_->target.load(), Sampler::allSteps());
    if (lacks || !(spread_->rests || spread_->follows)) work();
    return true;
}

void Growth::waitUntilDone() {
    while (job_.busy()) {
        job_.waitUntilDone();
        poll();
    }
}

GrowthPhase Growth::phase() const {
    if (!spread_) return GrowthPhase::Idle;
    if (!error_.empty()) return GrowthPhase::Failed;
    if (!picture_) return GrowthPhase::Finding;
    if (picture_->step == Sampler::allSteps()) return GrowthPhase::Done;
    return job_.busy() ? GrowthPhase::Spreading : GrowthPhase::Paused;
}

SampleSpec Growth::spec() const {
    SampleSpec spec = spec_;
    spec.steps = picture_ && picture_->step < Sampler::allSteps() ? picture_->step : 0;
    return spec;
}

}  // namespace se::view
