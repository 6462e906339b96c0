/// Particles that spread over a surface while the window stays responsive: the sampler in the
/// background, some steps of relaxation at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "background_job.h"
#include "run/sample_spec.h"
#include "spiraling_edge/sampling/sampler.h"

namespace se::view {

enum class GrowthPhase : std::uint8_t {
    Idle,       ///< Not started.
    Finding,    ///< The surface is being read and searched.
    Spreading,  ///< Steps are being made.
    Paused,     ///< Waits for further steps to be asked for.
    Done,
    Failed,
};

/// The particles after a number of steps.
struct GrowthPicture {
    std::shared_ptr<const PointFile> points;  ///< With normals and types.
    int step = 0;
    std::size_t onWalls = 0;  ///< Points; corners among them.
    std::size_t corners = 0;
    double wanted = 0.0;       ///< Target spacing.
    SampleQuality quality;     ///< Of these particles; while running, of those a few steps earlier.
    Vec3 low{0.0}, high{0.0};  ///< The domain.
};

class Growth {
  public:
    /// Restarts: finds the surface, and makes as many steps as spec.steps. Running work is
    /// cancelled.
    void start(const SampleSpec& spec);
    /// Makes that many more steps, after which others will be requested.
    void play(int steps);
    /// Makes that many more steps.
    void advance(int steps);
    /// Makes all remaining steps.
    void finish() { advance(Sampler::allSteps()); }
    /// Stops after the step in progress.
    void pause();
    void cancel();

    /// Collects the results of the work. True if there is something new to draw.
    bool poll();
    /// Blocks until nothing moves: paused, done or failed.
    void waitUntilDone();

    GrowthPhase phase() const;
    bool hasPoints() const { return picture_ && picture_->points->position.size() > 0; }
    /// Null until the surface is found, and after a failure or cancel().
    const GrowthPicture* picture() const { return picture_ ? &*picture_ : nullptr; }
    /// Share done while the surface is searched and particles are scattered over it.
    double found() const { return job_.share(); }
    const std::string& error() const { return error_; }
    /// Specification of the last start, up to the step of the current picture: it identifies the
    /// points.
    SampleSpec spec() const;

  private:
    struct Spread;
    void work();

    SampleSpec spec_;
    std::shared_ptr<Spread> spread_;  ///< Null before start().
    BackgroundJob<Result<GrowthPicture>> job_;
    std::optional<GrowthPicture> picture_;
    std::string error_;
};

}  // namespace se::view
