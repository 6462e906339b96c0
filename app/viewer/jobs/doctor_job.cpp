#include "doctor_job.h"

#include <cassert>
#include <utility>

#include "spiraling_edge/why/tried_fixes.h"

namespace se::view {

void DoctorJob::enqueue(std::shared_ptr<const PointFile> file) {
    cancel();
    fixes_.cancel();
    file_ = std::move(file);
}

void DoctorJob::start() {
    if (!file_ || busy()) return;
    examined_ = std::move(file_);
    BackgroundQuery::start([file = examined_](const Progress& progress) -> Result<Diagnosis> {
        Result<Diagnosis> found = examine(*file, progress);
        // An input that cannot be examined could not have been opened.
        return found ? std::move(found) : Result<Diagnosis>(Diagnosis{});
    });
    file_ = nullptr;
}

void DoctorJob::tryFixes() {
    assert(done());
    // Without threads the window would wait for the runs.
    if constexpr (kHasThreads) {
        if (!usesThreads() || examined_->position.size() > kManyForFixes) return;
        fixes_.start([file = examined_, diagnosis = *answer()](
                         const Progress& progress) mutable -> Result<Diagnosis> {
            const Status tried = se::tryFixes(*file, diagnosis, progress);
            return tried ? Result<Diagnosis>(std::move(diagnosis)) : tried.error();
        });
    }
}

std::vector<Index> pointsToMark(const Model& model, const Finding& finding, std::size_t limit) {
    std::vector<Index> points;
    for (const Index p : finding.points) {
        if (p < model.drawable.size() && model.drawable[p]) points.push_back(p);
    }
    if (points.size() <= limit) return points;
    for (std::size_t i = 0; i < limit; ++i) points[i] = points[i * points.size() / limit];
    points.resize(limit);
    return points;
}

}  // namespace se::view
