/// The doctor's examination of the open input, in a thread of its own (core's doctor.h).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "run/model.h"
#include "spiraling_edge/doctor.h"

namespace se::view {

class Checkup {
  public:
    Checkup() = default;
    /// Cancels, and waits until the threads have ended.
    ~Checkup();
    Checkup(const Checkup&) = delete;
    Checkup& operator=(const Checkup&) = delete;

    /// Sets the input to examine, which starts at begin(); an examination in progress is cancelled
    /// and finishes in the background.
    void wait(std::shared_ptr<const PointFile> file);
    /// Starts the examination, unless it was done.
    void begin();
    /// Takes the result. True if there was anything new.
    bool poll();
    /// Blocks until there is a result to take, or nothing was started.
    void finish();

    bool busy() const { return job_ != nullptr; }
    bool done() const { return diagnosis_.has_value(); }
    /// In [0, 1], while busy.
    double share() const { return job_ ? job_->share.load() : 0.0; }
    /// A sentence why the examination failed; then it is never done. Empty if it did not.
    const std::string& complaint() const { return complaint_; }
    /// Empty before the examination is done.
    std::span<const Finding> findings() const {
        return diagnosis_ ? std::span<const Finding>(*diagnosis_) : std::span<const Finding>{};
    }

  private:
    struct Job {
        std::shared_ptr<const PointFile> file;
        std::optional<Diagnosis> found;
        std::string complaint;  ///< Valid once the job has ended, like `found`.
        std::atomic<double> share = 0.0;
        std::atomic<bool> cancelled = false;
        std::atomic<bool> ended = false;
        std::jthread thread;  // last: it uses all members above
    };
    void cancel();

    std::shared_ptr<const PointFile> file_;  ///< Null once the job has it.
    std::optional<Diagnosis> diagnosis_;
    std::string complaint_;
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> cancelled_;  ///< Until they have ended.
};

/// Points of a finding that are highlighted: all, or evenly chosen ones if there are more than
/// `most`; none that cannot be drawn.
std::vector<Index> pointsToMark(const Model& model, const Finding& finding,
                                std::size_t most = 2000);

/// A sphere for the camera to frame, in view space.
struct MarkedPlace {
    glm::vec3 center{0.0F};
    float radius = 1.0F;
    glm::vec3 normal{0.0F};  ///< The side to look from; zero if there is none.
};
/// Around all of the points, with some of their surroundings. Requires at least one point.
MarkedPlace placeOf(const Model& model, std::span<const Index> points);

}  // namespace se::view
