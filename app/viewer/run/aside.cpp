#include "aside.h"

#include <array>
#include <cassert>
#include <utility>

#include "spiraling_edge/points/usable_points.h"

namespace se::view {

namespace {

struct ReasonRow {
    AsideReason reason;
    std::string_view name;
    std::string_view text;
    std::string_view back;  ///< Effect of a click that returns the points; empty: there is none.
};

constexpr std::array kReasons = {
    ReasonRow{AsideReason::LeftOut, "left_out", "left out in the view", "Runs with them again."},
    ReasonRow{AsideReason::Fixed, "fixed", "dropped by the fix of ",
              "Takes that fix back, and runs without it."},
    ReasonRow{AsideReason::NotFinite, "not_finite", "without a finite position: cannot be drawn",
              ""},
    ReasonRow{AsideReason::Copy, "copy", "set aside: another point is at the same place", ""},
    ReasonRow{AsideReason::NoPlane, "no_plane", "set aside: no plane fits their neighbors", ""},
    ReasonRow{AsideReason::Noise, "noise", "set aside for noise",
              "Turns the rule noise off, and runs with all points."},
    ReasonRow{AsideReason::Stray, "strays", "set aside: far from all others",
              "Turns the rule strays off, and runs with them."},
};

const ReasonRow& rowOf(AsideReason reason) {
    const ReasonRow& row = kReasons[static_cast<std::size_t>(reason)];
    assert(row.reason == reason);
    return row;
}

AsideReason reasonOf(const PointSet& points, Index p, Fitness fitness) {
    switch (fitness) {
        case Fitness::NonFinite:
            return AsideReason::NotFinite;
        case Fitness::Copy:
            return AsideReason::Copy;
        case Fitness::Usable:
            break;
    }
    if (!points.stray.empty() && points.stray[p]) return AsideReason::Stray;
    return points.normal[p] == Vec3(0.0) ? AsideReason::NoPlane : AsideReason::Noise;
}

}  // namespace

std::vector<AsidePoints> asideOf(const PointSet& points) {
    std::array<AsidePoints, kReasons.size()> byReason;
    for (const ReasonRow& row : kReasons)
        byReason[static_cast<std::size_t>(row.reason)].reason = row.reason;
    std::vector<Fitness> fitness;
    for (Index p = 0; p < points.setAside.size(); ++p) {
        if (!points.setAside[p]) continue;
        if (fitness.empty()) fitness = fitnessOf(points.position);
        AsidePoints& group = byReason[static_cast<std::size_t>(reasonOf(points, p, fitness[p]))];
        group.points.push_back(p);
        ++group.count;
    }
    std::vector<AsidePoints> groups;
    for (AsidePoints& group : byReason) {
        if (group.count > 0) groups.push_back(std::move(group));
    }
    return groups;
}

AsidePoints asideOf(const PointFile& file, const std::vector<bool>& keep, AsideReason reason,
                    std::string fix) {
    assert(keep.size() == file.position.size());
    AsidePoints group{reason, std::move(fix)};
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
    return group.fix.empty() ? std::string(rowOf(group.reason).name) : group.fix;
}

std::string reasonText(const AsidePoints& group) {
    return std::string(rowOf(group.reason).text) + group.fix;
}

std::string_view returnText(AsideReason reason) { return rowOf(reason).back; }

}  // namespace se::view
