#include "checkup.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "run/guarded.h"

namespace se::view {

Checkup::~Checkup() {
    cancel();
    // Cancel all threads before joining the first.
    cancelled_.clear();
}

void Checkup::cancel() {
    std::erase_if(cancelled_, [](const auto& job) { return job->ended.load(); });
    if (!job_) return;
    job_->cancelled = true;
    cancelled_.push_back(std::move(job_));
}

void Checkup::wait(std::shared_ptr<const PointFile> file) {
    cancel();
    file_ = std::move(file);
    diagnosis_.reset();
    complaint_.clear();
}

void Checkup::begin() {
    if (!file_ || busy()) return;
    job_ = std::make_unique<Job>();
    job_->file = std::move(file_);
    job_->thread = std::jthread([&job = *job_] {
        const Status good = guarded([&job] {
            Result<Diagnosis> found = examine(*job.file, [&job](double share) {
                job.share = share;
                return !job.cancelled.load();
            });
            if (found) job.found = std::move(found.value());
        });
        if (!good) job.complaint = good.error().message;
        job.ended = true;
    });
}

bool Checkup::poll() {
    if (!busy() || !job_->ended) return false;
    finish();
    complaint_ = std::move(job_->complaint);
    // An input that cannot be examined could not have been opened.
    if (complaint_.empty()) diagnosis_ = std::move(job_->found).value_or(Diagnosis{});
    job_.reset();
    return true;
}

void Checkup::finish() {
    if (busy() && job_->thread.joinable()) job_->thread.join();
}

std::vector<Index> pointsToMark(const Model& model, const Finding& finding, std::size_t most) {
    std::vector<Index> points;
    for (const Index p : finding.points) {
        if (p < model.drawable.size() && model.drawable[p]) points.push_back(p);
    }
    if (points.size() <= most) return points;
    for (std::size_t i = 0; i < most; ++i) points[i] = points[i * points.size() / most];
    points.resize(most);
    return points;
}

MarkedPlace placeOf(const Model& model, std::span<const Index> points) {
    glm::vec3 low = model.place[points.front()];
    glm::vec3 high = low;
    MarkedPlace place;
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
