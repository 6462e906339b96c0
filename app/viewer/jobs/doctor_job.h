/// The doctor's examination of the open input, in a thread of its own (core's doctor.h).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "background_job.h"
#include "run/model.h"
#include "spiraling_edge/doctor/doctor.h"

namespace se::view {

class DoctorJob : public BackgroundQuery<Diagnosis> {
  public:
    /// Sets the input to examine, which starts at start(); an examination in progress is cancelled.
    void enqueue(std::shared_ptr<const PointFile> file);
    /// Starts the examination, unless it was done.
    void start();
    bool done() const { return answer() != nullptr; }
    /// Empty before the examination is done.
    std::span<const Finding> findings() const {
        return done() ? std::span<const Finding>(answer()->findings) : std::span<const Finding>{};
    }

    /// "0.42 between points, 213 x 140 x 90"; empty before the examination is done.
    std::string sizeText() const { return done() ? se::sizeText(*answer()) : std::string{}; }

  private:
    std::shared_ptr<const PointFile> file_;  ///< Null once it is examined.
};

/// Points of a finding that are highlighted: all, or evenly chosen ones if there are more than
/// `most`; none that cannot be drawn.
std::vector<Index> pointsToMark(const Model& model, const Finding& finding,
                                std::size_t limit = 2000);

}  // namespace se::view
