#include "spiraling_edge/doctor/checks.h"

namespace se {

std::optional<Finding> findNonFinite(const Patient& patient) {
    const PointFile& file = patient.file;
    std::vector<Index> points;
    for (Index p = 0; p < patient.size(); ++p) {
        const bool good =
            isFinite(file.position[p]) && (!file.hasNormals() || isFinite(file.normal[p]));
        if (!good) points.push_back(p);
    }
    const std::string text = countText(points.size(), "point") +
                             " with a coordinate or a normal that is NaN or infinite";
    return findingAt(std::move(points), Severity::Error, text);
}

std::optional<Finding> findDuplicates(const Patient& patient) {
    std::vector<Index> points;
    for (Index p = 0; p < patient.size(); ++p) {
        if (patient.fitness[p] == Fitness::Copy) points.push_back(p);
    }
    const std::string text =
        countText(points.size(), "point") + " exactly where a point with a lower index stands";
    return findingAt(std::move(points), Severity::Warning, text);
}

std::optional<Finding> findTooFewPoints(const Patient& patient) {
    // Three points make one triangle, which may be intended but is no surface.
    constexpr std::size_t kTriangle = 3;
    if (patient.presentCount > kTriangle) return std::nullopt;
    const std::string text = countText(patient.presentCount, "point") + " with a place of " +
                             (patient.presentCount == 1 ? "its" : "their") + " own: ";
    if (patient.presentCount == kTriangle)
        return Finding{nullptr, Severity::Warning, kTriangle, {}, text + "one triangle at most"};
    return Finding{nullptr, Severity::Error, patient.presentCount, {}, text + "no triangle"};
}

}  // namespace se
