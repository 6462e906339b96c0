/// Even samples without files: random points in a thin shell are projected onto the surface and
/// relaxed by mutual repulsion, with + - * / and sqrt alone, so that every machine gets the same
/// points.
#include "spiraling_edge/scenes/surface_scenes.h"

#include <algorithm>
#include <cmath>

#include "spiraling_edge/base/random.h"

namespace se {
namespace {

Vec3 project(const ImplicitSurface& surface, Vec3 x) {
    for (int i = 0; i < 4; ++i) {
        const Vec3 g = surface.gradient(x);
        x -= surface.value(x) / std::max(glm::dot(g, g), 1e-12) * g;
    }
    return x;
}

/// Distance to the surface, to first order.
double distanceTo(const ImplicitSurface& surface, const Vec3& x) {
    const Vec3 g = surface.gradient(x);
    return std::abs(surface.value(x)) / std::sqrt(std::max(glm::dot(g, g), 1e-12));
}

struct Pair {
    Index a, b;
};

std::vector<Pair> pairsWithin(const std::vector<Vec3>& x, double reach) {
    std::vector<Pair> pairs;
    const auto n = static_cast<Index>(x.size());
    for (Index a = 0; a < n; ++a) {
        for (Index b = a + 1; b < n; ++b) {
            const Vec3 d = x[a] - x[b];
            if (glm::dot(d, d) < reach * reach) pairs.push_back({a, b});
        }
    }
    return pairs;
}

/// Moves all points but the first `fixed` apart; `keep` projects each back to its domain.
template <typename Keep>
void relax(std::vector<Vec3>& x, std::size_t fixed, double spacing, Keep&& keep) {
    constexpr int kSteps = 48;
    constexpr int kStepsPerSearch = 4;
    const double reach = 1.7 * spacing;
    std::vector<Pair> pairs;
    std::vector<Vec3> push(x.size());
    for (int step = 0; step < kSteps; ++step) {
        if (step % kStepsPerSearch == 0) pairs = pairsWithin(x, reach + 0.5 * spacing);
        std::fill(push.begin(), push.end(), Vec3(0.0));
        for (const Pair& pair : pairs) {
            const Vec3 d = x[pair.a] - x[pair.b];
            const double length = std::sqrt(glm::dot(d, d));
            if (length >= reach || length == 0.0) continue;
            const double closeness = 1.0 - length / reach;
            const Vec3 force = closeness * closeness / length * d;
            push[pair.a] += force;
            push[pair.b] -= force;
        }
        for (std::size_t i = fixed; i < x.size(); ++i) {
            const double length = std::sqrt(glm::dot(push[i], push[i]));
            const double scale = 0.5 * spacing / (1.0 + 3.0 * length);
            x[i] = keep(x[i] + scale * push[i]);
        }
    }
}

PointFile fileOf(const ImplicitSurface& surface, std::vector<Vec3> position) {
    PointFile file;
    file.positionType = file.normalType = ScalarType::Double;
    for (const Vec3& x : position) {
        const Vec3 g = surface.gradient(x);
        file.normal.push_back(g / std::sqrt(glm::dot(g, g)));
    }
    file.position = std::move(position);
    return file;
}

}  // namespace

PointFile sampleClosed(const ImplicitSurface& surface, std::size_t count, double spacing,
                       std::uint64_t seed) {
    SplitMix random(seed);
    std::vector<Vec3> position;
    while (position.size() < count) {
        const Vec3 x = random.inBox(surface.low, surface.high);
        // Random in a thin shell is random on the surface.
        if (distanceTo(surface, x) < 0.4 * spacing) position.push_back(project(surface, x));
    }
    relax(position, 0, spacing, [&](const Vec3& x) { return project(surface, x); });
    return fileOf(surface, std::move(position));
}

PointFile sampleSheet(const ImplicitSurface& sheet, std::size_t perSide, std::size_t interior,
                      std::uint64_t seed) {
    // Straight up or down onto the sheet: value(x) = x.z - f(x.x, x.y).
    const auto drop = [&](double x, double y) { return Vec3(x, y, -sheet.value(Vec3(x, y, 0.0))); };
    const Vec3& low = sheet.low;
    const Vec3& high = sheet.high;
    std::vector<Vec3> position;
    const std::size_t steps = perSide + 1;
    for (std::size_t i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(steps);
        const double x = low.x + t * (high.x - low.x);
        const double y = low.y + t * (high.y - low.y);
        position.push_back(drop(x, low.y));
        position.push_back(drop(high.x, y));
        position.push_back(drop(low.x + high.x - x, high.y));
        position.push_back(drop(low.x, low.y + high.y - y));
    }
    const std::size_t rim = position.size();
    const double spacing = (high.x - low.x) / static_cast<double>(steps);
    const double margin = 0.6 * spacing;
    SplitMix random(seed);
    for (std::size_t i = 0; i < interior; ++i) {
        const Vec3 x = random.inBox(low + margin, high - margin);
        position.push_back(drop(x.x, x.y));
    }
    relax(position, rim, spacing, [&](const Vec3& x) {
        return drop(std::clamp(x.x, low.x + margin, high.x - margin),
                    std::clamp(x.y, low.y + margin, high.y - margin));
    });
    PointFile file = fileOf(sheet, std::move(position));
    for (const Vec3& x : file.position) file.type.push_back(wallsAt(x, low, high));
    return file;
}

std::uint8_t wallsAt(const Vec3& x, const Vec3& low, const Vec3& high) {
    unsigned faces = 0;
    if (x.x == high.x) faces |= kPositiveX;
    if (x.y == high.y) faces |= kPositiveY;
    if (x.x == low.x) faces |= kNegativeX;
    if (x.y == low.y) faces |= kNegativeY;
    return withCornerBit(static_cast<std::uint8_t>(faces));
}

PointFile withNeighborLists(PointFile file, const NeighborOptions& reach) {
    const std::vector<bool> usable(file.position.size(), true);
    auto lists = findNeighbors(file.position, file.normal, usable, reach);
    if (lists.ok()) file.neighbors = std::move(lists.value());
    return file;
}

PointFile movedToBack(PointFile file, std::ptrdiff_t count) {
    const auto rotate = [count](auto& values) {
        std::rotate(values.begin(), values.begin() + count, values.end());
    };
    rotate(file.position);
    rotate(file.normal);
    rotate(file.type);
    return file;
}

PointFile smallSheet(const ImplicitSurface& sheet, std::uint64_t seed, std::size_t k) {
    constexpr std::size_t kPerSide = 5;
    constexpr std::ptrdiff_t kRim = 4 * (kPerSide + 1);
    return withNeighborLists(movedToBack(sampleSheet(sheet, kPerSide, 26, seed), kRim),
                             {KNearest{k}});
}

PointFile torusOf160(std::uint64_t seed, std::size_t k) {
    return withNeighborLists(sampleClosed(torus(), 160, 0.3375, seed), {KNearest{k}});
}

}  // namespace se
