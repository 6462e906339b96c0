/// Points of an input that take no part in its run, by reason.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::view {

enum class AsideReason : std::uint8_t {
    LeftOut,    ///< By the user, in the view.
    Fixed,      ///< Dropped by a fix of the doctor.
    NotFinite,  ///< The position is not finite.
    Copy,       ///< Another point has the same position.
    NoPlane,    ///< No plane fits the neighbors, to derive a normal from.
    Noise,      ///< Others lie nearer to the middle of the noise.
    Stray,      ///< Far from all others.
};

/// The points with one reason.
struct AsidePoints {
    AsideReason reason = AsideReason::LeftOut;
    std::string fix = {};  ///< Check whose fix dropped them; empty for other reasons.
    std::size_t count = 0;
    /// Positions of those that are no points of the run, where they are finite.
    std::vector<Vec3> position = {};
    /// Indices in the run, ascending; empty if they are no points of the run.
    std::vector<Index> points = {};
};

/// The points that prepare() set aside.
std::vector<AsidePoints> asideOf(const PointSet& points);
/// The points of `file` that are not kept. `keep` has a value for each.
AsidePoints asideOf(const PointFile& file, const std::vector<bool>& keep, AsideReason reason,
                    std::string fix = {});

/// Number of points in all groups.
std::size_t countOf(const std::vector<AsidePoints>& groups);
/// Name of a group, for test scripts: "left_out", "noise", or the check of its fix.
std::string nameOf(const AsidePoints& group);
/// The reason in words, after a number of points: "set aside for noise".
std::string reasonText(const AsidePoints& group);
/// The effect of a click that returns them to the run, as a sentence; empty if nothing can.
std::string_view returnText(AsideReason reason);

}  // namespace se::view
