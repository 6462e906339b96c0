#include "spiraling_edge/doctor/checks.h"

namespace se {

std::optional<Finding> findNonFinite(const ExaminedFile& examined) {
    const PointFile& file = examined.file;
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        const bool good =
            isFinite(file.position[p]) && (!file.hasNormals() || isFinite(file.normal[p]));
        if (!good) points.push_back(p);
    }
    const std::string text = countText(points.size(), "point") +
                             " with a coordinate or a normal that is NaN or infinite";
    return findingAt(std::move(points), Severity::Error, text);
}

std::optional<Finding> findDuplicates(const ExaminedFile& examined) {
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        if (examined.fitness[p] == Fitness::Copy) points.push_back(p);
    }
    const std::string text =
        countText(points.size(), "point") + " exactly where a point with a lower index stands";
    return findingAt(std::move(points), Severity::Warning, text);
}

std::optional<Finding> findTooFewPoints(const ExaminedFile& examined) {
    // Three points make one triangle, which may be intended but is no surface.
    constexpr std::size_t kTriangle = 3;
    if (examined.presentCount > kTriangle) return std::nullopt;
    const std::string text = countText(examined.presentCount, "point") + " with a place of " +
                             (examined.presentCount == 1 ? "its" : "their") + " own: ";
    if (examined.presentCount == kTriangle)
        return Finding{nullptr, Severity::Warning, kTriangle, {}, text + "one triangle at most"};
    return Finding{nullptr, Severity::Error, examined.presentCount, {}, text + "no triangle"};
}

}  // namespace se
