/// Points of an input that take no part in its run, by reason.
#pragma once

#include <string>
#include <vector>

#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::view {

/// The points with one reason.
struct AsidePoints {
    Aside reason = Aside::LeftOut;
    std::string fix = {};  ///< Check whose fix dropped them; empty for other reasons.
    std::size_t count = 0;
    /// Positions of those that are no points of the run, where they are finite.
    std::vector<Vec3> position = {};
    /// Indices in the run, ascending; empty if they are no points of the run.
    std::vector<Index> points = {};

    /// By the user, in the view.
    bool isLeftOut() const { return reason == Aside::LeftOut && fix.empty(); }
};

/// The points that prepare() set aside.
std::vector<AsidePoints> asideOf(const PointSet& points);
/// The points of `file` that are not kept: left out by the user, or by a fix. `keep` has a value
/// for each.
AsidePoints leftOutOf(const PointFile& file, const std::vector<bool>& keep, std::string fix = {});

/// Number of points in all groups.
std::size_t countOf(const std::vector<AsidePoints>& groups);
/// Name of a group, for test scripts: "left_out", "noise", or the check of its fix.
std::string nameOf(const AsidePoints& group);
/// The reason in words, after a number of points: "far from all others".
std::string reasonText(const AsidePoints& group);
/// The effect of a click that returns them to the run, as a sentence; empty if nothing can.
std::string_view returnText(const AsidePoints& group);

}  // namespace se::view
