#include "loader.h"

#include <utility>

namespace se::view {

Loader::~Loader() {
    cancel();
    // All know of it before the first is waited for.
    cancelled_.clear();
}

void Loader::begin(const InputSpec& spec) {
    cancel();
    job_ = std::make_unique<Job>();
    job_->spec = spec;
    job_->thread = std::jthread([&job = *job_] {
        job.result = work(job);
        job.done = true;
    });
}

void Loader::cancel() {
    if (!job_) return;
    job_->progress.cancelled = true;
    cancelled_.push_back(std::move(job_));
}

std::optional<Result<Opened>> Loader::take() {
    std::erase_if(cancelled_, [](const auto& job) { return job->done.load(); });
    if (!job_ || !job_->done) return std::nullopt;
    const std::unique_ptr<Job> job = std::move(job_);
    if (job->thread.joinable()) job->thread.join();
    return std::move(job->result);
}

void Loader::finish() {
    if (job_ && job_->thread.joinable()) job_->thread.join();
}

Result<Opened> Loader::work(Job& job) {
    Result<Loaded> loaded = loadInput(job.spec, job.progress);
    if (!loaded) return loaded.error();
    job.progress.part = LoadPart::Beginning;
    Opened opened{std::move(loaded.value().model), nullptr, std::move(loaded.value().file)};
    opened.runner = std::make_unique<Runner>(opened.model);
    opened.runner->request(0);
    while (!opened.runner->wait(std::chrono::milliseconds(50))) {
        if (job.progress.cancelled) return Error{"Opening was cancelled."};
    }
    return {std::move(opened)};
}

}  // namespace se::view
