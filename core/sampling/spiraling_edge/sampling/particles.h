/// The particles of the sampler and what is done with them.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "spiraling_edge/base/random.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/surface.h"

namespace se::sampling {

/// Columns of equal length. The first `onWalls` stay on their walls, corners where they are.
struct Particles {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;  ///< Unit, outer side.
    std::vector<std::uint8_t> type;
    std::vector<double> spacing;  ///< Wanted here, in units of the field.
    std::vector<Vec3> drift;      ///< The last move, of which a part goes on.
    std::size_t onWalls = 0;

    std::size_t size() const { return position.size(); }
    /// Appends one at rest.
    void add(const Surface& surface, const Vec3& x, std::uint8_t faces, double flatSpacing);
    /// Those of these indices, in this order; says nothing about walls.
    void arrange(std::span<const Index> order);
    /// Keeps those with `stays`, in their order.
    void keep(const std::vector<bool>& stays);
};

/// Fewer particles are not worth a thread.
inline constexpr std::size_t kPerThread = 2048;
/// Beyond so many spacings particles do not feel each other: the second ring of neighbors in
/// equilateral triangles is just outside.
inline constexpr double kReach = 1.7;
/// How hard particles push each other apart, at a distance in units of kReach spacings.
inline double push(double q) { return q < 1.0 ? (1.0 - q) * (1.0 - q) : 0.0; }

/// Two nearer than this many spacings are too near, however much room there is around them.
inline constexpr double kTooNear = 0.7;
/// What such two feel besides push(), of the same q. On tips and ridges finer than the spacing few
/// others are around, so that push() alone would let two come close.
inline double squeeze(double q) { return std::max(0.0, 1.0 - q * (kReach / kTooNear)); }

/// Where the particles begin, and how many there will be.
struct Start {
    Particles particles;
    std::size_t count = 0;
    double spacing = 0.0;
};
/// Finds the surface, divides its curves on the walls evenly, and scatters the rest by area.
Result<Start> scatter(Surface& surface, const SamplerOptions& options, const Progress& progress);

/// Moves all that may move by one step. This and what follows: false if `progress` cancelled.
bool relax(const Surface& surface, double flatSpacing, unsigned threads, const Progress& progress,
           Particles& particles);

/// Brings all, which are near it, onto the surface to the last digits.
bool settleAll(const Surface& surface, unsigned threads, const Progress& progress,
               Particles& particles);

/// Crowded particles die, and those on specks too small for triangles; new ones are born where
/// there is room. At most `most` are exchanged, besides what brings their number to `count`.
bool balance(const Surface& surface, std::size_t count, double flatSpacing, std::size_t most,
             unsigned threads, const Progress& progress, Particles& particles);

}  // namespace se::sampling
