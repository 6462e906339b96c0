#include "doctor_job.h"

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace se::view {

void DoctorJob::enqueue(std::shared_ptr<const PointFile> file) {
    cancel();
    file_ = std::move(file);
}

void DoctorJob::start() {
    if (!file_ || busy()) return;
    BackgroundQuery::start(
        [file = std::move(file_)](const Progress& progress) -> Result<Diagnosis> {
            Result<Diagnosis> found = examine(*file, progress);
            // An input that cannot be examined could not have been opened.
            return found ? std::move(found) : Result<Diagnosis>(Diagnosis{});
        });
    file_ = nullptr;
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
