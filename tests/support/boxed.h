/// Even samples of surfaces cut by a box, with points on its walls and edges.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "../../core/src/scenes_sampling.h"
#include "oracles.h"

namespace se::test {

/// One of the triply periodic minimal surfaces: bent the same way everywhere, and branching.
inline ImplicitSurface gyroid() {
    return {[](const Vec3& x) {
                return std::sin(x.x) * std::cos(x.y) + std::sin(x.y) * std::cos(x.z) +
                       std::sin(x.z) * std::cos(x.x);
            },
            [](const Vec3& x) {
                return Vec3(std::cos(x.x) * std::cos(x.y) - std::sin(x.z) * std::sin(x.x),
                            std::cos(x.y) * std::cos(x.z) - std::sin(x.x) * std::sin(x.y),
                            std::cos(x.z) * std::cos(x.x) - std::sin(x.y) * std::sin(x.z));
            },
            Vec3(-4.0), Vec3(4.0)};
}

/// Places points first where edges of the box meet the surface, then on its walls, then inside;
/// each kind pushes itself apart, the kinds before staying.
class BoxSampler {
  public:
    BoxSampler(const ImplicitSurface& surface, const Vec3& low, const Vec3& high, double spacing,
               std::uint64_t seed)
        : surface_(surface), low_(low), high_(high), spacing_(spacing), random_(seed) {}

    PointFile sample() {
        addCorners();
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool top : {false, true}) addWall(axis, top);
        }
        addInterior();
        return file();
    }

  private:
    using Fixed = std::array<bool, 3>;  ///< Axes along which a point may not move.

    void addCorners() {
        for (int axis = 0; axis < 3; ++axis) {
            for (int corner = 0; corner < 4; ++corner) {
                Vec3 a = low_;
                if ((corner & 1) != 0) a[(axis + 1) % 3] = high_[(axis + 1) % 3];
                if ((corner & 2) != 0) a[(axis + 2) % 3] = high_[(axis + 2) % 3];
                addRoots(a, axis);
            }
        }
    }
    void addRoots(Vec3 a, int axis) {
        constexpr int kSteps = 200;
        const double step = (high_[axis] - low_[axis]) / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            double from = low_[axis] + i * step;
            double to = from + step;
            const auto valueAt = [&](double t) {
                a[axis] = t;
                return surface_.value(a);
            };
            const bool sign = valueAt(from) > 0.0;
            if ((valueAt(to) > 0.0) == sign) continue;
            for (int j = 0; j < 50; ++j) {
                const double middle = 0.5 * (from + to);
                ((valueAt(middle) > 0.0) == sign ? from : to) = middle;
            }
            a[axis] = from;
            points_.push_back(a);
        }
    }

    void addWall(int axis, bool top) {
        Vec3 low = low_;
        Vec3 high = high_;
        low[axis] = high[axis] = top ? high_[axis] : low_[axis];
        Fixed fixed{};
        fixed[static_cast<std::size_t>(axis)] = true;
        const double area = (high_[(axis + 1) % 3] - low_[(axis + 1) % 3]) *
                            (high_[(axis + 2) % 3] - low_[(axis + 2) % 3]);
        const double length = measure(low, high, fixed, area);
        fill(low, high, fixed, static_cast<std::size_t>(std::round(length / spacing_)));
    }
    void addInterior() {
        const Vec3 size = high_ - low_;
        const double area = measure(low_, high_, {}, size.x * size.y * size.z);
        // A wall point covers half of what one inside covers.
        const double count =
            area / (0.866 * spacing_ * spacing_) - 0.5 * static_cast<double>(points_.size());
        fill(low_, high_, {}, static_cast<std::size_t>(std::round(count)));
    }

    Vec3 gradient(const Vec3& x, const Fixed& fixed) const {
        Vec3 g = surface_.gradient(x);
        for (int i = 0; i < 3; ++i) {
            if (fixed[static_cast<std::size_t>(i)]) g[i] = 0.0;
        }
        return g;
    }
    double distance(const Vec3& x, const Fixed& fixed) const {
        const Vec3 g = gradient(x, fixed);
        return std::abs(surface_.value(x)) / std::max(std::sqrt(glm::dot(g, g)), 1e-9);
    }
    Vec3 randomIn(const Vec3& low, const Vec3& high) {
        const double x = random_.between(low.x, high.x);
        const double y = random_.between(low.y, high.y);
        return {x, y, random_.between(low.z, high.z)};
    }
    /// Length or area of the surface within a box that measures `whole`, from a thin shell.
    double measure(const Vec3& low, const Vec3& high, const Fixed& fixed, double whole) {
        constexpr int kTries = 100000;
        const double reach = 0.1 * spacing_;
        int near = 0;
        for (int i = 0; i < kTries; ++i) near += distance(randomIn(low, high), fixed) < reach;
        return whole * near / kTries / (2.0 * reach);
    }
    /// Onto the surface, along the free axes, and off the walls.
    Vec3 keep(Vec3 x, const Vec3& low, const Vec3& high, const Fixed& fixed) const {
        const double margin = 0.45 * spacing_;
        for (int round = 0; round < 6; ++round) {
            for (int i = 0; i < 3; ++i) {
                const double free = fixed[static_cast<std::size_t>(i)] ? 0.0 : margin;
                x[i] = std::clamp(x[i], low[i] + free, high[i] - free);
            }
            for (int i = 0; i < 3; ++i) {
                const Vec3 g = gradient(x, fixed);
                x -= surface_.value(x) / std::max(glm::dot(g, g), 1e-9) * g;
            }
        }
        return x;
    }
    void fill(const Vec3& low, const Vec3& high, const Fixed& fixed, std::size_t count) {
        const std::size_t before = points_.size();
        while (points_.size() < before + count) {
            const Vec3 x = randomIn(low, high);
            if (distance(x, fixed) < 0.3 * spacing_) points_.push_back(keep(x, low, high, fixed));
        }
        for (int step = 0; step < 60; ++step) relax(before, low, high, fixed);
    }
    void relax(std::size_t before, const Vec3& low, const Vec3& high, const Fixed& fixed) {
        const double reach = 1.7 * spacing_;
        std::vector<Vec3> push(points_.size(), Vec3(0.0));
        for (std::size_t a = before; a < points_.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const Vec3 d = points_[a] - points_[b];
                const double lengthSq = glm::dot(d, d);
                if (lengthSq >= reach * reach || lengthSq == 0.0) continue;
                const double length = std::sqrt(lengthSq);
                const double closeness = 1.0 - length / reach;
                push[a] += closeness * closeness / length * d;
                push[b] -= closeness * closeness / length * d;
            }
        }
        for (std::size_t i = before; i < points_.size(); ++i) {
            const double length = std::sqrt(glm::dot(push[i], push[i]));
            const Vec3 move = 0.5 * spacing_ / (1.0 + 3.0 * length) * push[i];
            points_[i] = keep(points_[i] + move, low, high, fixed);
        }
    }

    PointFile file() const {
        PointFile file;
        file.positionType = file.normalType = ScalarType::Double;
        for (const Vec3& x : points_) {
            const Vec3 g = surface_.gradient(x);
            unsigned faces = 0;
            for (unsigned i = 0; i < 3; ++i) {
                const auto axis = static_cast<int>(i);
                if (x[axis] == high_[axis]) faces |= 1U << i;
                if (x[axis] == low_[axis]) faces |= 8U << i;
            }
            file.position.push_back(x);
            file.normal.push_back(g / std::sqrt(glm::dot(g, g)));
            file.type.push_back(withCornerBit(static_cast<std::uint8_t>(faces)));
        }
        return file;
    }

    const ImplicitSurface& surface_;
    Vec3 low_, high_;
    double spacing_;
    Random random_;
    std::vector<Vec3> points_;
};

/// About evenly spaced points of the surface within the box, typed by wall.
inline PointFile sampleBoxed(const ImplicitSurface& surface, const Vec3& low, const Vec3& high,
                             double spacing, std::uint64_t seed) {
    return BoxSampler(surface, low, high, spacing, seed).sample();
}

}  // namespace se::test
