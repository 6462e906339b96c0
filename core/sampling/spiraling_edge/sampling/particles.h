/// The particles of the sampler and the operations on them.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "spiraling_edge/base/random.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/surface.h"

namespace se::sampling {

/// Columns of equal length. The first `onWalls` particles stay on their walls, and corners do not
/// move.
struct Particles {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;  ///< Unit, outer side.
    std::vector<std::uint8_t> type;
    std::vector<double> spacing;  ///< Target spacing here, in units of the field.
    std::vector<Vec3> drift;      ///< The last move, of which a part continues.
    std::size_t onWalls = 0;

    std::size_t size() const { return position.size(); }
    /// Appends a particle at rest.
    void add(const Surface& surface, const Vec3& x, std::uint8_t faces, double flatSpacing);
    /// Selects the particles of `order`, in this order; does not update `onWalls`.
    void arrange(std::span<const Index> order);
    /// Keeps the particles with `stays` true, in their order.
    void keep(const std::vector<bool>& stays);
};

/// Least number of particles per thread.
inline constexpr std::size_t kPerThread = 2048;
/// Reach of the repulsion in spacings: the second ring of neighbors in equilateral triangles is
/// just outside.
inline constexpr double kReach = 1.7;
/// Repulsion of two particles at a distance of `q` times kReach spacings.
inline double push(double q) { return q < 1.0 ? (1.0 - q) * (1.0 - q) : 0.0; }

/// Two particles nearer than this many spacings are too near, even with free space around them.
inline constexpr double kTooNear = 0.7;
/// Repulsion of two such particles in addition to push(), for the same q. On tips and ridges finer
/// than the spacing there are few neighbors, so that push() alone would let two come close.
inline double squeeze(double q) { return std::max(0.0, 1.0 - q * (kReach / kTooNear)); }

/// The initial particles and their final number.
struct Start {
    Particles particles;
    std::size_t count = 0;
    double spacing = 0.0;
};
/// Finds the surface, divides its curves on the walls evenly, and scatters the rest by area.
Result<Start> scatter(Surface& surface, const SamplerOptions& options, const Progress& progress);

/// Moves all movable particles by one step. False if `progress` cancelled.
bool relax(const Surface& surface, double flatSpacing, unsigned threads, const Progress& progress,
           Particles& particles);

/// Moves all particles, which are near the surface, onto it to the last digits. False if `progress`
/// cancelled.
bool settleAll(const Surface& surface, unsigned threads, const Progress& progress,
               Particles& particles);

/// Removes crowded particles and those on parts too small for triangles; adds new ones where there
/// is room. Exchanges at most `limit`, besides those that bring the number to `count`. False if
/// `progress` cancelled.
bool balance(const Surface& surface, std::size_t count, double flatSpacing, std::size_t limit,
             unsigned threads, const Progress& progress, Particles& particles);

}  // namespace se::sampling
