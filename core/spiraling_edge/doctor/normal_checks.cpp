#include "spiraling_edge/doctor/checks.h"

namespace se {

std::optional<Finding> findNoNormals(const ExaminedFile& examined) {
    if (examined.file.hasNormals() || examined.size() == 0) return std::nullopt;
    return Finding{nullptr, Severity::Warning, examined.size(), {}, "the file has no normals"};
}

std::optional<Finding> findZeroNormals(const ExaminedFile& examined) {
    std::vector<Index> points;
    for (Index p = 0; p < examined.file.normal.size(); ++p) {
        if (examined.file.normal[p] == Vec3(0.0)) points.push_back(p);
    }
    std::string text = countText(points.size(), "point") + " with a zero normal";
    if (points.size() == examined.size()) text += ": all, so that they can be derived";
    return findingAt(std::move(points), Severity::Error, text);
}

std::optional<Finding> findUnscaledNormals(const ExaminedFile& examined) {
    std::vector<Index> points;
    for (Index p = 0; p < examined.file.normal.size(); ++p) {
        Vec3 normal = examined.file.normal[p];
        if (scaleToUnit(normal)) points.push_back(p);
    }
    const std::string text =
        countText(points.size(), "normal") + " off from unit length by more than a thousandth";
    return findingAt(std::move(points), Severity::Warning, text);
}

std::optional<Finding> findCloseSheets(const ExaminedFile& examined) {
    if (!examined.file.hasNormals()) return std::nullopt;
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        if (!examined.hasSide(p) || examined.nearest[p].empty()) continue;
        const Index q = examined.nearest[p].front();
        if (examined.hasSide(q) && normalsOppose(examined.side(p), examined.side(q)))
            points.push_back(p);
    }
    // Many shapes have thin parts. If every second point has its nearest on another sheet, the
    // spacing does not fit the set as a whole.
    const bool everywhere = 2 * points.size() >= examined.presentCount;
    const std::string text =
        countText(points.size(), "point") + " with the nearest other on a sheet that faces away";
    return findingAt(std::move(points), everywhere ? Severity::Warning : Severity::Note, text);
}

}  // namespace se
