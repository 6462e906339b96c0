/// Checks of how points are spread over the surface as a whole: pairs, as of two stations, and
/// lines, as of a scanner, which are thinned (piece.h). O(points).
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/prepare/piece.h"
#include "spiraling_edge/prepare/scan_lines.h"

namespace se {
namespace {

/// Adds the points that thinning leaves to the text.
void thin(const ExaminedFile& examined, double spacing, Finding& finding) {
    finding.surplus = thinnedOut(examined, examined.presentPoints(), spacing);
    const std::string length = shortNumber(spacing);
    finding.text += "; --thin " + length + " leaves " +
                    counted(examined.presentCount - finding.surplus->size(), "point");
    finding.dropReason = "the rest are " + length + " apart";
}

/// `value` rounded as its text is, so that the text says exactly what is done.
double rounded(double value) { return std::strtod(shortNumber(value).c_str(), nullptr); }

}  // namespace

std::vector<Index> thinnedOut(const ExaminedFile& examined, const std::vector<Index>& points,
                              double spacing) {
    std::vector<Vec3> position;
    position.reserve(points.size());
    for (const Index p : points) position.push_back(examined.file.position[p]);
    const std::vector<bool> kept = pointsIn(position, {{}, spacing});
    std::vector<Index> out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!kept[i]) out.push_back(points[i]);
    }
    return out;
}

std::vector<EvidenceLine> alongLists(const ExaminedFile& examined, const NeighborLists& lists) {
    return evidenceAt(examined, [&](Index p) -> std::optional<EvidenceLine> {
        if (lists[p].empty()) return std::nullopt;
        return EvidenceLine{examined.file.position[p], examined.file.position[lists[p].back()]};
    });
}

std::optional<Finding> findTwins(const ExaminedFile& examined) {
    auto points = pointsWhere(examined.size(),
                              [&](Index p) { return examined.intake.judge->twinOf(p) != kNone; });
    constexpr std::size_t kFewest = 20;  // Fewer, as the corners of a beam, are no cloud of pairs.
    if (examined.presentCount < kFewest || 2 * points.size() <= examined.presentCount)
        return std::nullopt;
    std::vector<double> pairs;
    std::vector<double> others;
    for (const Index p : points) {
        pairs.push_back(examined.distance(p, examined.nearest()[p][0]));
        others.push_back(examined.distance(p, examined.nearest()[p][1]));
    }
    const double apart = medianOf(pairs);
    if (2.0 * apart > medianOf(others)) return std::nullopt;  // Short lines.
    // The spacing is between the distances in pairs and those to other points.
    constexpr double kMostPairs = 0.98;
    constexpr double kNearestOthers = 0.02;
    const double spacing =
        rounded(std::sqrt(quantileOf(pairs, kMostPairs) * quantileOf(others, kNearestOthers)));
    std::optional<Finding> finding =
        findingAt(std::move(points), Severity::Warning,
                  "of " + std::to_string(examined.presentCount) +
                      " in pairs, as of two stations: the nearest point is " + shortNumber(apart) +
                      " away in the median, under a quarter of the distance to the fourth");
    if (!finding) return finding;
    thin(examined, spacing, *finding);
    finding->lines = evidenceAt(examined, [&](Index p) -> std::optional<EvidenceLine> {
        const Index twin = examined.intake.judge->twinOf(p);
        if (twin == kNone) return std::nullopt;
        return EvidenceLine{examined.file.position[p], examined.file.position[twin]};
    });
    return finding;
}

std::optional<Finding> findLines(const ExaminedFile& examined) {
    const InputFacts& facts = examined.intake.judge->facts;
    if (facts.across == 0.0) return std::nullopt;
    // Of lines nearer to each other, lists hold points of other lines, too. Lines farther apart are
    // no surface, even thinned.
    constexpr double kLeast = 2.0;
    constexpr double kMost = 50.0;
    const double ratio = facts.across / facts.along;
    if (ratio < kLeast || ratio > kMost) return std::nullopt;
    Finding finding =
        findingOf(examined, Severity::Warning,
                  "the points lie in lines: " + shortNumber(facts.along) +
                      " apart along them, and " + shortNumber(facts.across) + " across");
    thin(examined, rounded(kThinnedLines * facts.across), finding);
    // From each point to the end of its list, all of which lies along the line.
    finding.lines = alongLists(examined, examined.nearest());
    return finding;
}

}  // namespace se
