/// Particles that spread over a surface while the window stays responsive: the sampler in a thread
/// of its own, one step of relaxation at a time, with play, pause and single steps.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run/sample_spec.h"
#include "spiraling_edge/sampling/sampler.h"

namespace se::view {

enum class GrowthPhase : std::uint8_t {
    Idle,       ///< Not started.
    Finding,    ///< The surface is being read and searched.
    Spreading,  ///< Steps are being made.
    Paused,     ///< Waits for the user to continue.
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
    /// Steps per second while it is played.
    static constexpr double kRate = 30.0;

    Growth();
    /// Cancels, and waits until all threads have ended.
    ~Growth();
    Growth(const Growth&) = delete;
    Growth& operator=(const Growth&) = delete;

    /// Restarts and plays; running work is cancelled. With spec.steps it makes those steps at
    /// full speed and pauses there.
    void start(const SampleSpec& spec);
    void play();
    void pause();
    /// One step, then pauses.
    void step();
    /// All remaining steps, at full speed.
    void finish();
    void cancel();

    /// Collects the results of the thread. True if there is something new to draw.
    bool poll();
    /// Blocks until nothing moves: paused, done or failed.
    void waitUntilDone();

    GrowthPhase phase() const { return phase_; }
    /// The surface is being found, or steps are being made.
    bool moving() const {
        return phase_ == GrowthPhase::Finding || phase_ == GrowthPhase::Spreading;
    }
    bool hasPoints() const { return picture_ && picture_->points->position.size() > 0; }
    /// Null until the surface is found, and after a failure or cancel().
    const GrowthPicture* picture() const { return picture_ ? &*picture_ : nullptr; }
    /// Share done while the surface is searched and particles are scattered over it.
    double found() const;
    const std::string& error() const { return error_; }
    /// Specification of the last start, up to the step of the current picture: it identifies the
    /// points.
    SampleSpec spec() const;

  private:
    struct Job;
    class Worker;
    void setTarget(int steps, bool slowly);
    void dropEnded();

    GrowthPhase phase_ = GrowthPhase::Idle;
    SampleSpec spec_;
    std::optional<GrowthPicture> picture_;
    std::string error_;
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> cancelled_;  ///< Until they have ended.
};

}  // namespace se::view
