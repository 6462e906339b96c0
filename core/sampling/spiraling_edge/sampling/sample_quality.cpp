#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/sampling/sampler.h"

namespace se {

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
    if (count == 0.0) return quality;
    quality.spacing = sum / count;
    const double variance = squares / count - quality.spacing * quality.spacing;
    quality.variation = std::sqrt(std::max(variance, 0.0)) / quality.spacing;
    quality.off /= quality.spacing;
    return quality;
}

}  // namespace se
