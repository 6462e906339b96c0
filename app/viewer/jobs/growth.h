/// Particles that spread over a surface while the window stays awake: the sampler in a thread of
/// its own, one step of relaxation at a time, to be played, paused and stepped.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run/sample_spec.h"
#include "spiraling_edge/sampling/sample_quality.h"

namespace se::view {

enum class GrowthPhase : std::uint8_t {
    Idle,       ///< Nothing was begun.
    Finding,    ///< The surface is being read and searched for.
    Spreading,  ///< Steps are being made.
    Paused,     ///< Waits to be told to go on.
    Done,
    Failed,
};
/// "idle", "finding", "spreading", "paused", "done", "failed".
std::string_view growthPhaseName(GrowthPhase phase);

/// The particles after a step.
struct GrowthPicture {
    std::shared_ptr<const PointFile> points;  ///< With normals and types.
    int step = 0;
    double wanted = 0.0;    ///< The spacing that they are heading for.
    SampleQuality quality;  ///< Of these particles, or of those a few steps before while they run.
    Vec3 low{0.0}, high{0.0};  ///< The domain.
};

class Growth {
  public:
    /// Steps per second while it is played.
    static constexpr double kRate = 30.0;

    Growth();
    /// Cancels, and waits until all threads have noticed.
    ~Growth();
    Growth(const Growth&) = delete;
    Growth& operator=(const Growth&) = delete;

    /// Begins anew and plays; what was going on is cancelled. With spec.steps it makes those at
    /// full speed and pauses there.
    void begin(const SampleSpec& spec);
    void play();
    void pause();
    /// One step, then pauses.
    void step();
    /// All steps that are left, at full speed.
    void finish();
    void cancel();

    /// Takes over what the thread has made. True if there is something new to draw.
    bool poll();
    /// Blocks until nothing moves any more: paused, done or failed.
    void settle();

    GrowthPhase phase() const { return phase_; }
    /// Null before the surface is found, and after a failure or cancel().
    const GrowthPicture* picture() const { return picture_ ? &*picture_ : nullptr; }
    /// While the surface is searched for and particles are scattered over it: the share done.
    double found() const;
    const std::string& error() const { return error_; }
    /// What was begun last, up to the step that the picture shows: which points these are.
    SampleSpec spec() const;

  private:
    struct Job;
    class Worker;
    void tell(int steps, bool slowly);
    void dropEnded();

    GrowthPhase phase_ = GrowthPhase::Idle;
    SampleSpec spec_;
    std::optional<GrowthPicture> picture_;
    std::string error_;
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> cancelled_;  ///< Until they have noticed.
};

}  // namespace se::view
