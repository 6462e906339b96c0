#include <algorithm>

#include "spiraling_edge/doctor/checks.h"

namespace se {
namespace {

/// Calls visit(p, list) for each list of the file.
template <typename Visit>
void forEachList(const Patient& patient, Visit&& visit) {
    for (Index p = 0; p < patient.file.neighbors.size(); ++p) visit(p, patient.file.neighbors[p]);
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
        const std::string text =
            (entries_ == 1 ? "1 entry" : std::to_string(entries_) + " entries") + " in " +
            countText(points_.size(), "list") + " " + what;
        std::optional<Finding> found = findingAt(std::move(points_), severity, text);
        if (found) found->count = entries_;
        return found;
    }

  private:
    std::vector<Index> points_;
    std::size_t entries_ = 0;
};

}  // namespace

std::optional<Finding> findEntriesOutside(const Patient& patient) {
    EntryCount entries;
    const Index n = patient.size();
    forEachList(patient, [&](Index p, std::span<const Index> list) {
        entries.add(p, static_cast<std::size_t>(std::count_if(list.begin(), list.end(),
                                                              [n](Index q) { return q >= n; })));
    });
    return std::move(entries).finding(Severity::Error, "for points that do not exist");
}

std::optional<Finding> findRepeatedEntries(const Patient& patient) {
    EntryCount entries;
    std::vector<Index> lastList(patient.size(),
                                kNone);  // per point: the last list that holds it
    forEachList(patient, [&](Index p, std::span<const Index> list) {
        std::size_t repeated = 0;
        lastList[p] = p;
        for (const Index q : list) {
            if (q >= patient.size()) continue;
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

std::optional<Finding> findUnsortedLists(const Patient& patient) {
    std::vector<Index> points;
    forEachList(patient, [&](Index p, std::span<const Index> list) {
        if (!isNearestFirst(patient.file.position, p, list)) points.push_back(p);
    });
    const std::string text = countText(points.size(), "list") + " not ordered by distance";
    return findingAt(std::move(points), Severity::Warning, text);
}

std::optional<Finding> findShortLists(const Patient& patient) {
    std::vector<Index> points;
    forEachList(patient, [&](Index p, std::span<const Index> list) {
        const bool wall = patient.file.hasTypes() && isBoundary(patient.file.type[p]);
        const std::size_t least = wall ? 2 : 3;
        if (patient.present[p] && list.size() < least) points.push_back(p);
    });
    const std::string text =
        countText(points.size(), "list") + " with fewer than three entries, or two at a wall";
    return findingAt(std::move(points), Severity::Warning, text);
}

std::optional<Finding> findUnsymmetricLists(const Patient& patient) {
    EntryCount entries;
    const NeighborLists& lists = patient.file.neighbors;
    forEachList(patient, [&](Index p, std::span<const Index> list) {
        std::size_t unanswered = 0;
        for (const Index q : list) {
            if (q >= patient.size()) continue;
            const auto answer = lists[q];
            if (std::find(answer.begin(), answer.end(), p) == answer.end()) ++unanswered;
        }
        entries.add(p, unanswered);
    });
    return std::move(entries).finding(Severity::Note, "for points that do not list back");
}

}  // namespace se
