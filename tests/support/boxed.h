/// Even samples of surfaces cut by a box, with points on its walls and edges, in time proportional
/// to their number: 43,000 take less than a second.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "spiraling_edge/geometry/implicit_surfaces.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/io/read_points.h"
#include "support/oracles.h"

namespace se::test {

/// Two linked tori, their gap 0.44 wide: as few as 215 points separate them.
inline ImplicitSurface linkedRings() {
    static constexpr auto value = [](const Vec3& x) {
        const double across = std::sqrt(x.x * x.x + x.y * x.y) - 1.0;
        return std::sqrt(across * across + x.z * x.z) - 0.28;
    };
    static constexpr auto gradient = [](const Vec3& x) {
        const double rho = std::sqrt(x.x * x.x + x.y * x.y);
        return glm::normalize(Vec3(x.x * (rho - 1.0) / rho, x.y * (rho - 1.0) / rho, x.z));
    };
    static constexpr auto toSecond = [](const Vec3& x) { return Vec3(x.x - 1.0, x.z, -x.y); };
    return {[](const Vec3& x) { return std::min(value(x), value(toSecond(x))); },
            [](const Vec3& x) {
                if (value(x) <= value(toSecond(x))) return gradient(x);
                const Vec3 g = gradient(toSecond(x));
                return Vec3(g.x, -g.z, g.y);
            },
            Vec3(-1.6), Vec3(2.6, 1.6, 1.6)};
}

inline double lengthOf(const Vec3& v) { return std::sqrt(glm::dot(v, v)); }

/// Places points first where edges of the box meet the surface, then at equal steps along its
/// curves on the walls, then inside, where they repel each other.
class BoxSampler {
  public:
    BoxSampler(const ImplicitSurface& surface, const Vec3& low, const Vec3& high, double points,
               std::uint64_t seed)
        : surface_(surface),
          low_(low),
          high_(high),
          random_(seed),
          count_(points),
          spacing_(std::sqrt(measure() / (kHexagonal * points))) {}

    PointFile sample() {
        addCorners();
        corners_ = points_.size();
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool top : {false, true}) addWall(axis, top ? high_[axis] : low_[axis]);
        }
        addInterior();
        return file();
    }

  private:
    static constexpr int kNoWall = -1;
    /// Half the thickness of the shell whose points are random on the surface.
    static constexpr double kShell = 0.1;
    /// Area per point in squares of the spacing, for equilateral triangles.
    static constexpr double kHexagonal = 0.86602540378443865;

    // ---- the domain ----

    /// Of the surface, or of its curve on a wall across `axis`.
    Vec3 gradient(const Vec3& x, int axis) const {
        Vec3 g = surface_.gradient(x);
        if (axis != kNoWall) g[axis] = 0.0;
        return g;
    }
    Vec3 project(Vec3 x, int axis, int steps) const {
        for (int i = 0; i < steps; ++i) {
            const Vec3 g = gradient(x, axis);
            x -= surface_.value(x) / std::max(glm::dot(g, g), 1e-9) * g;
        }
        return x;
    }
    bool inside(const Vec3& x, double margin) const {
        for (int i = 0; i < 3; ++i) {
            if (x[i] < low_[i] + margin || x[i] > high_[i] - margin) return false;
        }
        return true;
    }
    bool inShell(const Vec3& x) const {
        return std::abs(surface_.value(x)) < kShell * lengthOf(surface_.gradient(x));
    }
    Vec3 randomInside() {
        const double x = random_.between(low_.x, high_.x);
        const double y = random_.between(low_.y, high_.y);
        return {x, y, random_.between(low_.z, high_.z)};
    }

    // ---- edges of the box ----

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

    // ---- walls ----

    /// The curves that run from edge to edge, then the closed ones.
    void addWall(int axis, double level) {
        std::vector<Vec3> seen;
        const auto isSeen = [&](const Vec3& x) {
            return std::any_of(seen.begin(), seen.end(),
                               [&](const Vec3& y) { return lengthOf(x - y) < 0.5 * spacing_; });
        };
        const auto add = [&](const Vec3& start, double sign) {
            const std::vector<Vec3> line = trace(start, axis, sign);
            seen.insert(seen.end(), line.begin(), line.end());
            divide(line, axis);
        };
        std::vector<bool> reached(corners_, false);
        for (std::size_t i = 0; i < corners_; ++i) {
            const Vec3 x = points_[i];
            if (x[axis] != level || reached[i]) continue;
            const bool forward = inside(x + 1e-6 * spacing_ * along(x, axis), 0.0);
            add(x, forward ? 1.0 : -1.0);
            reached[nearestCorner(seen.back())] = true;
        }
        for (const Vec3& x : rootsOn(axis, level)) {
            if (inside(x, 0.0) && !isSeen(x)) add(x, 1.0);
        }
    }
    /// Places of the surface on a wall, on lines across it.
    std::vector<Vec3> rootsOn(int axis, double level) const {
        constexpr int kLines = 64;
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        std::vector<Vec3> roots;
        for (int i = 0; i < kLines; ++i) {
            Vec3 x(level);
            x[u] = low_[u] + (i + 0.5) / kLines * (high_[u] - low_[u]);
            bool before = false;
            for (int j = 0; j < kLines; ++j) {
                x[v] = low_[v] + (j + 0.5) / kLines * (high_[v] - low_[v]);
                const bool now = surface_.value(x) > 0.0;
                if (j > 0 && now != before) roots.push_back(project(x, axis, 6));
                before = now;
            }
        }
        return roots;
    }
    /// Direction of the curve on the wall.
    Vec3 along(const Vec3& x, int axis) const {
        Vec3 across(0.0);
        across[axis] = 1.0;
        const Vec3 t = glm::cross(across, gradient(x, axis));
        return t / std::max(lengthOf(t), 1e-9);
    }
    /// Short steps along a curve until it leaves the box, at an edge, or is back at its start.
    std::vector<Vec3> trace(const Vec3& start, int axis, double sign) const {
        const double step = spacing_ / 8;
        std::vector<Vec3> line{start};
        for (;;) {
            const Vec3& x = line.back();
            const Vec3 middle = x + 0.5 * sign * step * along(x, axis);
            const Vec3 next = project(x + sign * step * along(middle, axis), axis, 3);
            if (!inside(next, 0.0)) {
                line.push_back(points_[nearestCorner(next)]);
                return line;
            }
            const bool back = line.size() > 2 && lengthOf(next - start) < 0.75 * step;
            line.push_back(back ? start : next);
            if (back) return line;
        }
    }
    std::size_t nearestCorner(const Vec3& x) const {
        std::size_t best = 0;
        for (std::size_t i = 1; i < corners_; ++i) {
            if (lengthOf(points_[i] - x) < lengthOf(points_[best] - x)) best = i;
        }
        return best;
    }
    /// Adds points at equal distances along the line, but for its ends if they are corners.
    void divide(const std::vector<Vec3>& line, int axis) {
        const auto lengthTo = [&](std::size_t i) { return lengthOf(line[i] - line[i - 1]); };
        double length = 0.0;
        for (std::size_t i = 1; i < line.size(); ++i) length += lengthTo(i);
        const int pieces = std::max(static_cast<int>(std::round(length / spacing_)), 1);
        double before = 0.0;
        std::size_t i = 1;
        for (int piece = line.front() == line.back() ? 0 : 1; piece < pieces; ++piece) {
            const double at = piece * length / pieces;
            while (before + lengthTo(i) < at && i + 1 < line.size()) before += lengthTo(i++);
            const Vec3 x = line[i - 1] + (at - before) / lengthTo(i) * (line[i] - line[i - 1]);
            points_.push_back(project(x, axis, 4));
        }
    }

    // ---- inside ----

    /// Area of the surface within the box.
    double measure() {
        constexpr int kTries = 60000;
        int near = 0;
        for (int i = 0; i < kTries; ++i) near += inShell(randomInside()) ? 1 : 0;
        const Vec3 size = high_ - low_;
        return size.x * size.y * size.z * near / kTries / (2.0 * kShell);
    }
    void addInterior() {
        const std::size_t onWalls = points_.size();
        // A wall point covers half of what one inside covers.
        const double inside = std::max(count_ - 0.5 * static_cast<double>(onWalls), 0.0);
        scatter(onWalls + static_cast<std::size_t>(inside));
        relax(onWalls);
    }
    /// Random points, not too close to one another.
    void scatter(std::size_t count) {
        double apart = 0.6 * spacing_;
        CellGrid grid(low_, high_, apart);
        for (const Vec3& x : points_) grid.add(x);
        for (int refused = 0; points_.size() < count;) {
            Vec3 x = randomInside();
            if (!inShell(x)) continue;
            x = project(x, kNoWall, 3);
            bool free = inside(x, margin());
            grid.near(x, [&](Index p) { free = free && lengthOf(points_[p] - x) > apart; });
            refused = free ? 0 : refused + 1;
            if (refused % 1000 == 999) apart *= 0.9;
            if (!free) continue;
            points_.push_back(x);
            grid.add(x);
        }
    }
    double margin() const { return 0.45 * spacing_; }
    Vec3 keep(Vec3 x) const {
        x = project(x, kNoWall, 1);
        for (int round = 0; round < 6 && !inside(x, margin()); ++round) {
            x = project(glm::clamp(x, low_ + margin(), high_ - margin()), kNoWall, 2);
        }
        return x;
    }
    void relax(std::size_t fixed) {
        constexpr int kSteps = 12;
        constexpr int kStepsPerSearch = 6;
        const double reach = 1.7 * spacing_;
        std::vector<std::array<Index, 2>> pairs;
        std::vector<Vec3> push(points_.size());
        for (int step = 0; step < kSteps; ++step) {
            if (step % kStepsPerSearch == 0) pairs = pairsWithin(reach + 0.3 * spacing_, fixed);
            std::fill(push.begin(), push.end(), Vec3(0.0));
            for (const auto& [a, b] : pairs) {
                const Vec3 d = points_[a] - points_[b];
                const double length = lengthOf(d);
                if (length >= reach || length == 0.0) continue;
                const double closeness = 1.0 - length / reach;
                const Vec3 force = closeness * closeness / length * d;
                push[a] += force;
                push[b] -= force;
            }
            for (std::size_t i = fixed; i < points_.size(); ++i) {
                const double scale = 0.5 * spacing_ / (1.0 + 3.0 * lengthOf(push[i]));
                points_[i] = keep(points_[i] + scale * push[i]);
            }
        }
        for (std::size_t i = fixed; i < points_.size(); ++i) {
            points_[i] = project(points_[i], kNoWall, 3);
        }
    }
    /// Pairs of points with a movable one.
    std::vector<std::array<Index, 2>> pairsWithin(double reach, std::size_t fixed) const {
        std::vector<std::array<Index, 2>> pairs;
        CellGrid grid(low_, high_, reach);
        for (Index a = 0; a < points_.size(); ++a) {
            const Vec3 x = points_[a];
            if (a >= fixed) {
                grid.near(x, [&](Index b) {
                    const Vec3 d = points_[b] - x;
                    if (glm::dot(d, d) < reach * reach) pairs.push_back({a, b});
                });
            }
            grid.add(x);
        }
        return pairs;
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
            file.normal.push_back(g / lengthOf(g));
            file.type.push_back(withCornerBit(static_cast<std::uint8_t>(faces)));
        }
        return file;
    }

    const ImplicitSurface& surface_;
    Vec3 low_, high_;
    Random random_;
    double count_, spacing_;
    std::vector<Vec3> points_;
    std::size_t corners_ = 0;  ///< The number of first points that lie on edges of the box.
};

/// About `count` evenly spaced points of the surface within the box, typed by wall, plus half the
/// number on the walls. None has a type if the box holds the whole surface.
inline PointFile sampleBoxed(const ImplicitSurface& surface, const Vec3& low, const Vec3& high,
                             double points, std::uint64_t seed) {
    return BoxSampler(surface, low, high, points, seed).sample();
}

}  // namespace se::test
