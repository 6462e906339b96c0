/// One step of relaxation: every particle gives way to the repulsion of its neighbors by a damped
/// Newton step of its own (Jacobi), plus a part of its last move, and is projected back onto the
/// surface along the gradient. Particles on walls move along their curve only. All moves start from
/// the old positions, so that the result does not depend on threads. O(n) for n particles.
#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/sampling/particles.h"

namespace se::sampling {
namespace {

/// One step for all particles from their old positions: their order does not matter.
class Relaxation {
  public:
    Relaxation(const Surface& surface, const Particles& particles, double flatSpacing,
               double widest)
        : surface_(surface),
          old_(particles),
          flat_(flatSpacing),
          grid_(surface.field().low, surface.field().high, kReach * widest) {
        for (const Vec3& x : particles.position) grid_.add(x);
    }

    /// Moves particle i of `next`.
    void move(std::size_t i, Particles& next) const {
        const double spacing = old_.spacing[i];
        Vec3 step = without(kInertia * old_.drift[i] + shove(i), heldBy(old_.type[i]));
        const double length = lengthOf(step);
        if (length > kLongest * spacing) step *= kLongest * spacing / length;
        const Vec3 from = old_.position[i];
        // A step around a sharp bend or onto another sheet fails; a part of it may succeed.
        for (int attempt = 0; attempt < kAttempts; ++attempt, step *= 0.5) {
            const std::optional<Vec3> to = place(i, step);
            if (!to || *to == from) continue;
            const Vec3 n = surface_.field().normal(*to);
            if (glm::dot(n, old_.normal[i]) < kLeastCosine) continue;
            next.position[i] = *to;
            next.normal[i] = n;
            const Vec3 drift = *to - from;
            next.drift[i] = drift - glm::dot(drift, n) * n;
            if (surface_.followsCurvature()) next.spacing[i] = relaxedSpacing(i, *to);
            return;
        }
        next.drift[i] = Vec3(0.0);
    }

  private:
    static constexpr double kInertia = 0.7;
    static constexpr double kLongest = 0.25;
    static constexpr double kLeastCosine = 0.3;
    /// The whole step, its half, ...
    static constexpr int kAttempts = 4;
    /// Damping of the Newton step, which is computed per particle (Jacobi).
    static constexpr double kDamping = 0.6;
    /// Weight of the repulsion of pairs that are too near, in units of squeeze().
    static constexpr double kSqueeze = 2.0;
    /// Tolerance of the distance to the surface, in units of the reach, until the last step.
    static constexpr double kTolerance = 1e-6;
    /// Least sine of the angle between surface and wall.
    static constexpr double kLeastSine = 0.05;
    /// Distance of interior particles from the walls in spacings, where the surface allows.
    static constexpr double kMargin = 0.3;

    double relaxedSpacing(std::size_t i, const Vec3& x) const {
        return 0.5 * (old_.spacing[i] + flat_ * surface_.relativeSpacing(x));
    }

    /// The move of a particle by the push of its neighbors and their stiffness.
    Vec3 shove(std::size_t i) const {
        return isBoundary(old_.type[i]) ? shoveAlongWall(i) : shoveInside(i);
    }

    /// Calls visit(j, d, distance, reach) for all j that push particle i: the vector from j to i,
    /// its length, and the length at which the push ends.
    template <typename Visit>
    void pushers(std::size_t i, Visit&& visit) const {
        const Vec3 x = old_.position[i];
        grid_.near(x, [&](Index j) {
            const Vec3 d = x - old_.position[j];
            const double reach = 0.5 * kReach * (old_.spacing[i] + old_.spacing[j]);
            const double square = glm::dot(d, d);
            if (square >= reach * reach || square == 0.0) return;
            // The other side of a thin part.
            if (glm::dot(old_.normal[i], old_.normal[j]) <= 0.0) return;
            visit(j, d, std::sqrt(square), reach);
        });
    }

    Vec3 shoveInside(std::size_t i) const {
        const Vec3 n = old_.normal[i];
        Vec3 force(0.0);
        double stiffness = 0.0;
        pushers(i, [&](Index, const Vec3& d, double distance, double reach) {
            const double q = distance / reach;
            const double size = push(q) + kSqueeze * squeeze(q);
            force += size / distance * d;
            // Half the trace of the second derivative in the plane, where it is positive.
            stiffness += std::max((1.0 - q) / reach - 0.5 * push(q) / distance, 0.0);
            if (squeeze(q) > 0.0) stiffness += 0.5 * kReach / kTooNear / reach;
        });
        force -= glm::dot(force, n) * n;
        return kDamping / std::max(stiffness, 0.4 / old_.spacing[i]) * force;
    }

    /// The move of a particle on a wall: those of the same curve push each other along it. Interior
    /// particles have no influence, so that the chain is even regardless of its surroundings.
    Vec3 shoveAlongWall(std::size_t i) const {
        Vec3 wall(0.0);
        for (int axis = 0; axis < 3; ++axis)
            wall[axis] = heldBy(old_.type[i]) >> static_cast<unsigned>(axis) & 1U;
        const Vec3 across = glm::cross(old_.normal[i], wall);
        const double sine = lengthOf(across);
        if (!(sine > kLeastSine))
            return Vec3(0.0);  // touches the wall: no direction along the curve
        const Vec3 along = across / sine;
        double force = 0.0;
        double stiffness = 0.0;
        pushers(i, [&](Index j, const Vec3& d, double distance, double reach) {
            if ((old_.type[i] & old_.type[j] & kFaceBits) == 0) return;
            const double cosine = glm::dot(d, along) / distance;
            const double q = distance / reach;
            force += push(q) * cosine;
            stiffness += 2.0 * (1.0 - q) / reach * cosine * cosine;
        });
        return kDamping / std::max(stiffness, 0.4 / old_.spacing[i]) * force * along;
    }

    bool inMargin(const Vec3& x, int axis, double margin) const {
        const Field& field = surface_.field();
        return x[axis] < field.low[axis] + margin || x[axis] > field.high[axis] - margin;
    }
    /// The new place on the surface, away from walls that the particle is not on where possible;
    /// nothing if there is none.
    std::optional<Vec3> place(std::size_t i, const Vec3& step) const {
        const Field& field = surface_.field();
        const double reach = kLongest * old_.spacing[i];
        const double margin = kMargin * old_.spacing[i];
        const Vec3 from = old_.position[i];
        const HeldAxes own = heldBy(old_.type[i]);
        const auto to =
            surface_.settle(glm::clamp(from + step, field.low, field.high), own, reach, kTolerance);
        if (!to) return to;
        Vec3 held = *to;
        HeldAxes axes = own;
        for (int axis = 0; axis < 3; ++axis) {
            if ((own >> static_cast<unsigned>(axis) & 1U) != 0 || !inMargin(*to, axis, margin))
                continue;
            axes |= 1U << static_cast<unsigned>(axis);
            // A particle already in the margin does not move nearer.
            held[axis] = std::clamp(held[axis], std::min(field.low[axis] + margin, from[axis]),
                                    std::max(field.high[axis] - margin, from[axis]));
        }
        return axes == own ? to : surface_.settle(held, axes, reach, kTolerance);
    }

    const Surface& surface_;
    const Particles& old_;
    double flat_;
    CellGrid grid_;
};

}  // namespace

void Particles::arrange(std::span<const Index> order) {
    const auto apply = [&](auto& column) {
        std::remove_reference_t<decltype(column)> arranged;
        arranged.reserve(order.size());
        for (const Index i : order) arranged.push_back(column[i]);
        column = std::move(arranged);
    };
    apply(position);
    apply(normal);
    apply(type);
    apply(spacing);
    apply(drift);
}

void Particles::keep(const std::vector<bool>& stays) {
    std::vector<Index> kept;
    for (Index i = 0; i < size(); ++i) {
        if (stays[i]) kept.push_back(i);
    }
    onWalls = static_cast<std::size_t>(
        std::lower_bound(kept.begin(), kept.end(), static_cast<Index>(onWalls)) - kept.begin());
    arrange(kept);
}

bool relax(const Surface& surface, double flatSpacing, unsigned threads, const Progress& progress,
           Particles& particles) {
    Particles next = particles;
    const double widest = *std::max_element(particles.spacing.begin(), particles.spacing.end());
    const Relaxation relaxation(surface, particles, flatSpacing, widest);
    const bool all =
        forEachWithProgress(next.size(), threads, kPerThread, progress, [&](std::size_t i) {
            if (!isCorner(particles.type[i])) relaxation.move(i, next);
        });
    if (all) particles = std::move(next);
    return all;
}

bool settleAll(const Surface& surface, unsigned threads, const Progress& progress,
               Particles& particles) {
    return forEachWithProgress(particles.size(), threads, kPerThread, progress, [&](std::size_t i) {
        const Vec3 x = particles.position[i];
        const auto place = surface.settle(x, heldBy(particles.type[i]), 0.1 * particles.spacing[i]);
        particles.position[i] = place.value_or(x);
        particles.normal[i] = surface.field().normal(particles.position[i]);
    });
}

}  // namespace se::sampling
