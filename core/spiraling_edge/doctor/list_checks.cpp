// Checks of the neighbor lists: one-sided, empty, too short or out of order.
#include <algorithm>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/doctor/checks.h"

namespace se {
namespace {

/// A finding at the points in whose lists count(p, list) finds entries, with the number of these.
template <typename Count>
std::optional<Finding> entriesAt(const ExaminedFile& examined, Severity severity,
                                 const std::string& what, Count&& count) {
    std::size_t entries = 0;
    auto points = pointsWhere(examined.file.neighbors.size(), [&](Index p) {
        const std::size_t found = count(p, examined.file.neighbors[p]);
        entries += found;
        return found > 0;
    });
    std::optional<Finding> finding = findingAt(std::move(points), severity, what, "list");
    if (!finding) return finding;
    finding->count = entries;
    finding->text.insert(0, counted(entries, "entry", "entries") + " in ");
    return finding;
}

}  // namespace

std::optional<Finding> findEntriesOutside(const ExaminedFile& examined) {
    const auto count = [n = examined.size()](Index, std::span<const Index> list) {
        return countWhere(list, [n](Index q) { return q >= n; });
    };
    return entriesAt(examined, Severity::Error, "for points that do not exist", count);
}

std::optional<Finding> findRepeatedEntries(const ExaminedFile& examined) {
    // Per point: the last list that holds it.
    std::vector<Index> lastList(examined.size(), kNone);
    const auto count = [&](Index p, std::span<const Index> list) {
        std::size_t repeated = 0;
        lastList[p] = p;
        for (const Index q : list) {
            if (q >= examined.size()) continue;
            if (lastList[q] == p) ++repeated;
            lastList[q] = p;
        }
        return repeated;
    };
    return entriesAt(examined, Severity::Warning, "for the point itself, or for one a second time",
                     count);
}

bool isNearestFirst(std::span<const Vec3> position, Index p, std::span<const Index> list) {
    // Distances this nearly equal may have been swapped by a sort in floats. Twice the rounding,
    // since squares are compared.
    constexpr double kRounding = 2e-6;
    if (!isFinite(position[p])) return true;
    double farthest = 0.0;
    for (const Index q : list) {
        if (q >= position.size() || !isFinite(position[q])) continue;
        const double here = distanceSquared(position[p], position[q]);
        if (here < (1.0 - kRounding) * farthest) return false;
        farthest = std::max(farthest, here);
    }
    return true;
}

std::optional<Finding> findUnsortedLists(const ExaminedFile& examined) {
    const NeighborLists& lists = examined.file.neighbors;
    auto points = pointsWhere(lists.size(), [&](Index p) {
        return !isNearestFirst(examined.file.position, p, lists[p]);
    });
    return findingAt(std::move(points), Severity::Warning, "not ordered by distance", "list");
}

std::optional<Finding> findShortLists(const ExaminedFile& examined) {
    const PointFile& file = examined.file;
    auto points = pointsWhere(file.neighbors.size(), [&](Index p) {
        const std::size_t least = file.hasTypes() && isBoundary(file.type[p]) ? 2 : 3;
        return examined.present()[p] && file.neighbors[p].size() < least;
    });
    return findingAt(std::move(points), Severity::Warning,
                     "with fewer than three entries, or two at a wall", "list");
}

std::optional<Finding> findUnsymmetricLists(const ExaminedFile& examined) {
    const NeighborLists& lists = examined.file.neighbors;
    const auto count = [&](Index p, std::span<const Index> list) {
        return countWhere(list,
                          [&](Index q) { return q < examined.size() && !isAmong(p, lists[q]); });
    };
    return entriesAt(examined, Severity::Note, "for points that do not list back", count);
}

}  // namespace se
