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

MarkedSphere sphereAround(const Model& model, std::span<const Index> points) {
    assert(!points.empty());
    glm::vec3 low = model.place[points.front()];
    glm::vec3 high = low;
    MarkedSphere place;
    for (const Index p : points) {
        low = glm::min(low, model.place[p]);
        high = glm::max(high, model.place[p]);
        place.normal += model.normal[p];
    }
    place.center = 0.5F * (low + high);
    // Points all around have no preferred side.
    const float agreement = glm::length(place.normal) / static_cast<float>(points.size());
    place.normal = agreement > 0.5F ? glm::normalize(place.normal) : glm::vec3(0.0F);
    place.radius = 0.0F;
    for (const Index p : points)
        place.radius = std::max(place.radius, glm::distance(place.center, model.place[p]));
    place.radius = std::max(1.15F * place.radius, 5.0F * model.spacing);
    return place;
}

}  // namespace se::view
