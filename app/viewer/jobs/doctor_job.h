/// The doctor's examination of the open input, in a thread of its own (core's doctor.h).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "background_query.h"
#include "run/model.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se::view {

class DoctorJob {
  public:
    /// Sets the input to examine, which starts at start(); an examination in progress is cancelled.
    void enqueue(std::shared_ptr<const PointFile> file);
    /// Starts the examination, unless it was done.
    void start();
    /// Takes the result. True if there was anything new.
    bool poll() { return query_.poll(); }
    /// Blocks until there is a result to take, or nothing was started.
    void waitUntilDone() { query_.waitUntilDone(); }

    bool busy() const { return query_.busy(); }
    bool done() const { return query_.answer() != nullptr; }
    /// In [0, 1], while busy.
    double share() const { return query_.share(); }
    /// A sentence why the examination failed; then it is never done. Empty if it did not.
    const std::string& complaint() const { return query_.complaint(); }
    /// Empty before the examination is done.
    std::span<const Finding> findings() const {
        return done() ? std::span<const Finding>(*query_.answer()) : std::span<const Finding>{};
    }

  private:
    std::shared_ptr<const PointFile> file_;  ///< Null once it is examined.
    BackgroundQuery<Diagnosis> query_;
};

/// Points of a finding that are highlighted: all, or evenly chosen ones if there are more than
/// `most`; none that cannot be drawn.
std::vector<Index> pointsToMark(const Model& model, const Finding& finding,
                                std::size_t limit = 2000);

/// A sphere for the camera to frame, in view space.
struct MarkedSphere {
    glm::vec3 center{0.0F};
    float radius = 1.0F;
    glm::vec3 normal{0.0F};  ///< The side to look from; zero if there is none.
};
/// Around all of the points, with some of their surroundings. Requires at least one point.
MarkedSphere sphereAround(const Model& model, std::span<const Index> points);

}  // namespace se::view
