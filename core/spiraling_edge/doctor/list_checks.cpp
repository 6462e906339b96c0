#include <algorithm>

#include "spiraling_edge/doctor/checks.h"

namespace se {
namespace {

/// Calls visit(p, list) for each list of the file.
template <typename Visit>
void forEachList(const ExaminedFile& examined, Visit&& visit) {
    for (Index p = 0; p < examined.file.neighbors.size(); ++p) visit(p, examined.file.neighbors[p]);
}

/// Counts entries, for a finding at the points whose lists have them.
class EntryCount {
  public:
    void add(Index p, std::size_t entries) {
        if (entries == 0) return;
        points_.push_back(p);
        entries_ += entries;
    }
    std::optional<Finding> finding(Severity severity, const std::string& what) && {
        std::optional<Finding> found = findingAt(std::move(points_), severity, what, "list");
        if (!found) return found;
        found->count = entries_;
        found->text.insert(
            0, (entries_ == 1 ? "1 entry" : std::to_string(entries_) + " entries") + " in ");
        return found;
    }

  private:
    std::vector<Index> points_;
    std::size_t entries_ = 0;
};

}  // namespace

std::optional<Finding> findEntriesOutside(const ExaminedFile& examined) {
    EntryCount entries;
    const Index n = examined.size();
    forEachList(examined, [&](Index p, std::span<const Index> list) {
        entries.add(p, static_cast<std::size_t>(std::count_if(list.begin(), list.end(),
                                                              [n](Index q) { return q >= n; })));
    });
    return std::move(entries).finding(Severity::Error, "for points that do not exist");
}

std::optional<Finding> findRepeatedEntries(const ExaminedFile& examined) {
    EntryCount entries;
    std::vector<Index> lastList(examined.size(),
                                kNone);  // per point: the last list that holds it
    forEachList(examined, [&](Index p, std::span<const Index> list) {
        std::size_t repeated = 0;
        lastList[p] = p;
        for (const Index q : list) {
            if (q >= examined.size()) continue;
            if (lastList[q] == p) ++repeated;
            lastList[q] = p;
        }
        entries.add(p, repeated);
    });
    return std::move(entries).finding(Severity::Warning,
                                      "for the point itself, or for one a second time");
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
        return examined.present[p] && file.neighbors[p].size() < least;
    });
    return findingAt(std::move(points), Severity::Warning,
                     "with fewer than three entries, or two at a wall", "list");
}

std::optional<Finding> findUnsymmetricLists(const ExaminedFile& examined) {
    EntryCount entries;
    const NeighborLists& lists = examined.file.neighbors;
    forEachList(examined, [&](Index p, std::span<const Index> list) {
        std::size_t unanswered = 0;
        for (const Index q : list) {
            if (q >= examined.size()) continue;
            const auto answer = lists[q];
            if (std::find(answer.begin(), answer.end(), p) == answer.end()) ++unanswered;
        }
        entries.add(p, unanswered);
    });
    return std::move(entries).finding(Severity::Note, "for points that do not list back");
}

}  // namespace se
