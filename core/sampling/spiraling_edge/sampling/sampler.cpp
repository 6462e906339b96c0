/// The schedule of the sampler: 160 steps of relaxation, birth and death of particles after every
/// tenth of the first 150, then a projection to the last digits and an order along a Z-curve. Each
/// step costs O(n) for n particles, so that a window can draw between steps.
#include "spiraling_edge/sampling/sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/z_curve.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/sampling/particles.h"

namespace se {

namespace {

constexpr int kAllSteps = 160;
/// Steps between two balances; the last steps have none.
constexpr int kBalanceEvery = 10;
constexpr int kLastExchange = 150;
/// Share of the particles that may be exchanged at a time.
constexpr double kMaxExchanged = 0.02;
constexpr std::size_t kMaxExchangedAtOnce = 2000;
/// Share of the relaxation in a step with balance.
constexpr double kRelaxShare = 0.5;
/// Share of the search for the surface in all work.
constexpr double kBeginShare = 0.05;

}  // namespace

struct Sampler::Content {
    sampling::Surface surface;
    SamplerOptions options;
    sampling::Start start;
    int steps = 0;
};

Sampler::Sampler(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Sampler::~Sampler() = default;
Sampler::Sampler(Sampler&& other) noexcept = default;
Sampler& Sampler::operator=(Sampler&& other) noexcept = default;

Result<Sampler> Sampler::begin(Field field, const SamplerOptions& options,
                               const Progress& progress) {
    sampling::Surface surface(std::move(field), options.curvature);
    Result<sampling::Start> start = sampling::scatter(surface, options, progress);
    if (!start) return start.error();
    return Sampler(
        std::make_unique<Content>(Content{std::move(surface), options, std::move(start.value())}));
}

bool Sampler::done() const { return content_->steps >= kAllSteps; }

int Sampler::steps() const { return content_->steps; }

int Sampler::allSteps() { return kAllSteps; }

double Sampler::share() const { return static_cast<double>(content_->steps) / kAllSteps; }

bool Sampler::step(const Progress& progress) {
    if (done()) return true;
    Content& c = *content_;
    sampling::Particles& particles = c.start.particles;
    if (!sampling::relax(c.surface, c.start.spacing, c.options.threads,
                         partOf(progress, 0.0, kRelaxShare), particles))
        return false;
    ++c.steps;
    const Progress rest = partOf(progress, kRelaxShare, 1.0);
    if (c.steps % kBalanceEvery == 0 && c.steps <= kLastExchange) {
        const auto most =
            static_cast<std::size_t>(kMaxExchanged * static_cast<double>(particles.size()));
        if (!sampling::balance(c.surface, c.start.count, c.start.spacing,
                               std::min(most, kMaxExchangedAtOnce), c.options.threads, rest,
                               particles))
            return false;
    }
    if (!done()) return true;
    if (!sampling::settleAll(c.surface, c.options.threads, rest, particles)) return false;
    // Neighbors in space become neighbors in memory, for all later work.
    particles.arrange(zCurveOrder(particles.position));
    return true;
}

std::span<const Vec3> Sampler::positions() const { return content_->start.particles.position; }
std::span<const std::uint8_t> Sampler::types() const { return content_->start.particles.type; }
double Sampler::spacing() const { return content_->start.spacing; }

PointFile Sampler::points() const {
    const sampling::Particles& particles = content_->start.particles;
    PointFile file;
    file.positionType = file.normalType = ScalarType::Double;
    file.position = particles.position;
    file.normal = particles.normal;
    file.type = particles.type;
    return file;
}

Result<PointFile> sample(const Field& field, const SamplerOptions& options,
                         const Progress& progress) {
    Result<Sampler> begun = Sampler::begin(field, options, partOf(progress, 0.0, kBeginShare));
    if (!begun) return begun.error();
    Sampler& sampler = begun.value();
    const Progress steps = partOf(progress, kBeginShare, 1.0);
    while (!sampler.done()) {
        const double done = sampler.share();
        if (!sampler.step(partOf(steps, done, done + 1.0 / kAllSteps)))
            return Error{"sampling was cancelled"};
    }
    return sampler.points();
}

SampleQuality measureSample(const Field& field, const PointFile& points, const Progress& progress) {
    SampleQuality quality;
    NeighborOptions options;
    options.reach = KNearest{1};
    const std::vector<bool> all(points.position.size(), true);
    const Result<NeighborLists> lists =
        findNeighbors(points.position, points.normal, all, options, progress);
    if (!lists) return quality;
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (Index i = 0; i < points.position.size(); ++i) {
        const auto list = lists.value()[i];
        const Vec3 x = points.position[i];
        const double steepness = glm::length(field.gradient(x));
        if (steepness > 0.0)
            quality.off =
                std::max(quality.off, std::abs(field.value(x) - field.isovalue) / steepness);
        if (list.empty() || isBoundary(points.type[i])) continue;
        const double distance = glm::length(points.position[list[0]] - x);
        sum += distance;
        squares += distance * distance;
        count += 1.0;
    }
    if (count == 0.0) return {};
    quality.spacing = sum / count;
    const double variance = squares / count - quality.spacing * quality.spacing;
    quality.variation = std::sqrt(std::max(variance, 0.0)) / quality.spacing;
    quality.off /= quality.spacing;
    return quality;
}

}  // namespace se
