/// Noise along the normal: its amount, and the points to leave out so that the rest is a surface
/// that can be followed from point to point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The surfaces that the points near each other may lie on.
enum class Sheets : std::uint8_t {
    One,    ///< One surface: all heights are its noise.
    Apart,  ///< Also two sheets (TwoHeaps), a spacing apart or more: the other one is no noise.
};

/// Height of neighbors above or below a point's tangent plane, in units of its spacing (the
/// distance to its sixth neighbor, or its last): the root mean square over the first twelve of its
/// list, and the median of those over all points with a list. Smooth surfaces have less than 0.35
/// even where they bend between one point and the next; at 0.45 triangles slope by 30 degrees and
/// more, and no order of the points determines where the surface runs. 0 if no point has a list.
/// `threads` as in NeighborOptions; the result is the same for any.
double noiseAlongNormals(std::span<const Vec3> position, std::span<const Vec3> normal,
                         const NeighborLists& neighbors, Sheets sheets, unsigned threads = 0);

/// Noise above which points count as noisy.
inline constexpr double kNoisy = 0.45;
/// Points of the patch over which noise is averaged.
inline constexpr std::size_t kNoisePatch = 60;

/// The middle of the noise about a point: its patch is the point and its list, of kNoisePatch
/// points whose normals agree.
struct NoisePatch {
    Vec3 normal{0.0};     ///< Mean normal of the patch, unit length.
    double width = 0.0;   ///< Root mean square of the heights over the mean place, along it.
    double height = 0.0;  ///< Height of the point itself, without sign.
};
/// One per position; those of points with usable[p] false stay empty. `threads` as in
/// NeighborOptions; the result is the same for any.
std::vector<NoisePatch> noisePatches(std::span<const Vec3> position, std::span<const Vec3> normal,
                                     const NeighborLists& lists, const std::vector<bool>& usable,
                                     unsigned threads = 0);

/// Chooses points near the middle of the noise, as far apart as it is wide: those nearest to the
/// middle choose first, and each that is chosen sets aside those of its list that lie over or under
/// it, nearer along the surface than twice the width. Only points with usable[p] true take part; it
/// becomes false for those set aside, which the return value counts. As lists do not reach all
/// points over and under a point, call it again with lists of the rest. Deterministic: ties by
/// index.
std::size_t setNoiseAside(std::span<const Vec3> position, std::span<const NoisePatch> patches,
                          const NeighborLists& lists, std::vector<bool>& usable);

}  // namespace se
