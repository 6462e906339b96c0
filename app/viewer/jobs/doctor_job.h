/// The doctor's look at what is open, in a thread of its own (core's doctor.h).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "run/model.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se::view {

class Checkup {
  public:
    Checkup() = default;
    /// Cancels, and waits until the threads have noticed.
    ~Checkup();
    Checkup(const Checkup&) = delete;
    Checkup& operator=(const Checkup&) = delete;

    /// Another input, to be examined when begin() says so; what was going on is cancelled, and left
    /// to itself.
    void wait(std::shared_ptr<const PointFile> file);
    /// Begins, unless that was done.
    void begin();
    /// Takes over what was found. True if that is news.
    bool poll();
    /// Blocks until there is something to take over, or nothing was begun.
    void finish();

    bool busy() const { return job_ != nullptr; }
    bool done() const { return diagnosis_.has_value(); }
    /// In [0, 1], while busy.
    double share() const { return job_ ? job_->share.load() : 0.0; }
    /// Why it failed, a sentence; then it is never done. Empty if it did not.
    const std::string& complaint() const { return complaint_; }
    /// Empty before it is done.
    std::span<const Finding> findings() const {
        return diagnosis_ ? std::span<const Finding>(*diagnosis_) : std::span<const Finding>{};
    }

  private:
    struct Job {
        std::shared_ptr<const PointFile> file;
        std::optional<Diagnosis> found;
        std::string complaint;  ///< Valid once it has ended, like `found`.
        std::atomic<double> share = 0.0;
        std::atomic<bool> cancelled = false;
        std::atomic<bool> ended = false;
        std::jthread thread;  // last: it uses all of the above
    };
    void cancel();

    std::shared_ptr<const PointFile> file_;  ///< Null once the job has it.
    std::optional<Diagnosis> diagnosis_;
    std::string complaint_;
    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> cancelled_;  ///< Until they have noticed.
};

/// The points of a finding that are lit up: all, or evenly chosen ones if there are more than
/// `most`; none that cannot be drawn.
std::vector<Index> pointsToMark(const Model& model, const Finding& finding,
                                std::size_t most = 2000);

/// A sphere that the camera should frame, in view space.
struct MarkedPlace {
    glm::vec3 center{0.0F};
    float radius = 1.0F;
    glm::vec3 normal{0.0F};  ///< The side to look from; zero if there is none.
};
/// Around all of the points, with some of what is around them. Requires that there are some.
MarkedPlace placeOf(const Model& model, std::span<const Index> points);

}  // namespace se::view
