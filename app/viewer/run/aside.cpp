#include "aside.h"

#include <cassert>
#include <utility>

namespace se::view {

std::vector<AsidePoints> asideOf(const PointSet& points) {
    std::vector<AsidePoints> groups;
    for (const AsideWords& each : asideReasons()) {
        AsidePoints group{each.reason};
        for (Index p = 0; p < points.aside.size(); ++p) {
            if (points.aside[p] == each.reason) group.points.push_back(p);
        }
        group.count = group.points.size();
        if (group.count > 0) groups.push_back(std::move(group));
    }
    return groups;
}

AsidePoints leftOutOf(const PointFile& file, const std::vector<bool>& keep, std::string fix) {
    assert(keep.size() == file.position.size());
    AsidePoints group{Aside::LeftOut, std::move(fix)};
    for (std::size_t p = 0; p < keep.size(); ++p) {
        if (keep[p]) continue;
        ++group.count;
        if (isFinite(file.position[p])) group.position.push_back(file.position[p]);
    }
    return group;
}

std::size_t countOf(const std::vector<AsidePoints>& groups) {
    std::size_t count = 0;
    for (const AsidePoints& group : groups) count += group.count;
    return count;
}

std::string nameOf(const AsidePoints& group) {
    return group.fix.empty() ? std::string(wordsOf(group.reason).name) : group.fix;
}

std::string reasonText(const AsidePoints& group) {
    if (!group.fix.empty()) return "dropped by the fix of " + group.fix;
    if (group.isLeftOut()) return "left out in the view";
    return std::string(wordsOf(group.reason).words);
}

std::string_view returnText(const AsidePoints& group) {
    if (!group.fix.empty()) return "Takes that fix back, and runs without it.";
    if (group.isLeftOut()) return "Runs with them again.";
    if (group.reason == Aside::Noise) return "Turns the rule noise off, and runs with all points.";
    if (group.reason == Aside::Stray) return "Turns the rule strays off, and runs with them.";
    return {};
}

}  // namespace se::view
