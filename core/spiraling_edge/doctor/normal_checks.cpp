#include "spiraling_edge/doctor/checks.h"

namespace se {

std::optional<Finding> findNoNormals(const Patient& patient) {
    if (patient.file.hasNormals() || patient.size() == 0) return std::nullopt;
    return Finding{nullptr, Severity::Warning, patient.size(), {}, "the file has no normals"};
}

std::optional<Finding> findZeroNormals(const Patient& patient) {
    std::vector<Index> points;
    for (Index p = 0; p < patient.file.normal.size(); ++p) {
        if (patient.file.normal[p] == Vec3(0.0)) points.push_back(p);
    }
    std::string text = countText(points.size(), "point") + " with a zero normal";
    if (points.size() == patient.size()) text += ": all, so that they can be derived";
    return findingAt(std::move(points), Severity::Error, text);
}

std::optional<Finding> findUnscaledNormals(const Patient& patient) {
    std::vector<Index> points;
    for (Index p = 0; p < patient.file.normal.size(); ++p) {
        Vec3 normal = patient.file.normal[p];
        if (scaleToUnit(normal)) points.push_back(p);
    }
    const std::string text =
        countText(points.size(), "normal") + " off from unit length by more than a thousandth";
    return findingAt(std::move(points), Severity::Warning, text);
}

std::optional<Finding> findCloseSheets(const Patient& patient) {
    if (!patient.file.hasNormals()) return std::nullopt;
    std::vector<Index> points;
    for (Index p = 0; p < patient.size(); ++p) {
        if (!patient.hasSide(p) || patient.nearest[p].empty()) continue;
        const Index q = patient.nearest[p].front();
        if (patient.hasSide(q) && normalsOppose(patient.side(p), patient.side(q)))
            points.push_back(p);
    }
    // Many shapes have thin parts. If every second point has its nearest on another sheet, the
    // spacing does not fit the set as a whole.
    const bool everywhere = 2 * points.size() >= patient.presentCount;
    const std::string text =
        countText(points.size(), "point") + " with the nearest other on a sheet that faces away";
    return findingAt(std::move(points), everywhere ? Severity::Warning : Severity::Note, text);
}

}  // namespace se
