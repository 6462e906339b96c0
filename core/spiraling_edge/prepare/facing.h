/// The way that the normals of a component face: outward, or toward a scanner.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/base/types.h"

namespace se {

/// Points, each with a unit normal and the number of its component: kNone without a normal.
struct FacingInput {
    std::span<const Vec3> position;
    std::span<const Vec3> normal;
    std::span<const Index> component;
    std::size_t components = 0;
    /// False for points that hardly any list names, as those scattered off the surface; they vote
    /// only in components of such points alone.
    std::vector<bool> listed;
    std::span<const Index> number{};  ///< Numbers that break ties; empty: the indices.
};

/// Votes on the way that the normals of a component face.
struct FacingVote {
    std::size_t outward = 0;  ///< Or toward the scanner.
    std::size_t inward = 0;
    std::size_t needed = 1;  ///< Difference of the two from which on the side counts as known.
    double clearest = 0.0;   ///< The cosine with the greatest absolute value; negative: inward.

    bool isKnown() const { return outward >= inward + needed || inward >= outward + needed; }
    /// The majority; if there is none, the clearest vote decides.
    bool isInward() const { return outward != inward ? inward > outward : clearest < 0.0; }
};

/// A vote for each component: in 26 directions (along the axes and the diagonals between two and
/// three of them) the outermost point, if its normal is within 60 degrees of the direction. The
/// normals of a closed surface follow all directions, those of a sheet one half of them: the side
/// is known from a majority of half the directions on. Deterministic; ties go to the normal that
/// follows the direction best, then to the lower number. O(points).
std::vector<FacingVote> votesOutward(const FacingInput& input);

/// A vote for each component by the points that the scanner sees: in each of 96 cells of
/// direction from the scanner, the nearest point of the component, if its normal is within 60
/// degrees of the line to the scanner. Points farther along a cell do not vote: they lie on the
/// other side of the body. The side is known from a majority of half the votes on. Deterministic.
/// O(points log points).
std::vector<FacingVote> votesTowardScanner(const FacingInput& input, const Vec3& scanner);

}  // namespace se
