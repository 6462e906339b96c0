#include "spiraling_edge/doctor/examined_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace se {
namespace {

/// The default length of lists from prepare().
constexpr std::size_t kListed = KNearest{}.k;
constexpr std::size_t kAround = 6;

std::vector<Vec3> scaledNormals(const PointFile& file) {
    std::vector<Vec3> normal = file.normal;
    for (Vec3& n : normal) {
        if (hasDirection(n)) {
            scaleToUnit(n);
        } else {
            n = Vec3(0.0);
        }
    }
    return normal;
}

/// Median of the values above zero.
double median(std::vector<double> values) {
    values.erase(std::remove(values.begin(), values.end(), 0.0), values.end());
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

double ExaminedFile::distance(Index p, Index q) const {
    return std::sqrt(distanceSquared(file.position[p], file.position[q]));
}

Result<ExaminedFile> examineFile(const PointFile& file, const Progress& progress) {
    if (const Status status = checkColumns(file); !status) return status.error();
    ExaminedFile examined{file};
    examined.fitness = fitnessOf(file.position, file.normal);
    examined.normal = scaledNormals(file);
    for (const Fitness fitness : examined.fitness) {
        const bool present = fitness == Fitness::Usable || fitness == Fitness::NoDirection;
        examined.present.push_back(present);
        examined.presentCount += present ? 1U : 0U;
    }
    NeighborOptions options;
    options.reach = KNearest{kListed};
    options.dropOpposingNormals = false;
    Result<NeighborLists> lists =
        findNeighbors(file.position, {}, examined.present, options, progress);
    if (!lists) return lists.error();
    examined.nearest = std::move(lists.value());
    examined.spacing.resize(file.position.size(), 0.0);
    for (Index p = 0; p < examined.size(); ++p) {
        const auto list = examined.nearest[p];
        if (list.empty()) continue;
        examined.spacing[p] = examined.distance(p, list[std::min(kAround, list.size()) - 1]);
    }
    examined.middleSpacing = median(examined.spacing);
    examined.sides = sidesOf(examined);
    return examined;
}

std::string countText(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string shortNumber(double value) {
    std::string text(32, '\0');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.3g", value)));
    return text;
}

std::optional<Finding> findingAt(std::vector<Index> points, Severity severity,
                                 const std::string& text) {
    if (points.empty()) return std::nullopt;
    const std::size_t count = points.size();
    return Finding{nullptr, severity, count, std::move(points), text};
}

}  // namespace se
