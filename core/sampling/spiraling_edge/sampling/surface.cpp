/// Projection onto the surface along the gradient: a bracket from the Newton step, then the
/// Illinois variant of regula falsi. Curvature by differences of the unit normal.
#include "spiraling_edge/sampling/surface.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace se::sampling {

Surface::Surface(Field field, double curvature) : field_(std::move(field)), influence_(curvature) {}

bool Surface::inside(const Vec3& x) const { return glm::clamp(x, field_.low, field_.high) == x; }

std::optional<Vec3> Surface::settle(const Vec3& x, HeldAxes held, double reach,
                                    double tolerance) const {
    const Vec3 g = without(field_.gradient(x), held);
    const double steepness = lengthOf(g);
    double here = value(x);
    if (here == 0.0) return x;
    if (!(steepness > 0.0)) return std::nullopt;
    const Vec3 along = (here > 0.0 ? -1.0 : 1.0) / steepness * g;
    const auto at = [&](double t) { return x + t * along; };
    // Bracket: the Newton step, slightly enlarged, then ever farther.
    double from = 0.0;
    double to = std::min(1.05 * std::abs(here) / steepness + 1e-12 * reach, reach);
    double there = value(at(to));
    while ((there > 0.0) == (here > 0.0) && there != 0.0) {
        if (to >= reach) return std::nullopt;
        from = to;
        here = there;
        to = std::min(2.0 * to, reach);
        there = value(at(to));
    }
    // Regula falsi, halving the weight of an end that stays (the Illinois variant).
    constexpr int kMaxSteps = 60;
    for (int i = 0; i < kMaxSteps && there != 0.0; ++i) {
        const double middle = from + (to - from) * here / (here - there);
        if (!(std::abs(middle - to) > tolerance * reach)) break;
        const double value = this->value(at(middle));
        if ((value > 0.0) == (there > 0.0)) {
            here *= 0.5;
        } else {
            from = to;
            here = there;
        }
        to = middle;
        there = value;
    }
    const Vec3 found = at(to);
    if (!inside(found)) return std::nullopt;
    return found;
}

double Surface::curvature(const Vec3& x) const {
    const Vec3 n = field_.normal(x);
    const Vec3 sizes = cell();
    const double step = 0.5 * std::min({sizes.x, sizes.y, sizes.z});
    const Vec3 aside = std::abs(n.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    const Vec3 across = glm::cross(n, aside);
    const double size = lengthOf(across);
    if (!(size > 0.0)) return 0.0;
    const Vec3 u = across / size;
    double sum = 0.0;
    for (const Vec3& direction : {u, glm::cross(n, u)}) {
        const Vec3 one = glm::clamp(x + step * direction, field_.low, field_.high);
        const Vec3 other = glm::clamp(x - step * direction, field_.low, field_.high);
        const double apart = std::max(lengthOf(one - other), 0.5 * step);
        const Vec3 turn = (field_.normal(one) - field_.normal(other)) / apart;
        sum += glm::dot(turn, turn);
    }
    return std::sqrt(sum);
}

double Surface::relativeSpacing(const Vec3& x) const {
    constexpr double kMaxDense = 5.0;
    if (!followsCurvature() || !(meanCurvature_ > 0.0)) return 1.0;
    return 1.0 / std::min(1.0 + influence_ * curvature(x) / meanCurvature_, kMaxDense);
}

}  // namespace se::sampling
