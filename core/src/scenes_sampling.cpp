#include "scenes_sampling.h"

#include <algorithm>
#include <cmath>

namespace se {
namespace {

/// SplitMix64; the distributions of the standard library differ between libraries.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// In [0, 1).
    double unit() {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
    }
    Vec3 inBox(const Vec3& low, const Vec3& high) {
        const double x = unit();
        const double y = unit();
        const double z = unit();
        return low + (high - low) * Vec3(x, y, z);
    }

  private:
    std::uint64_t state_;
};

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

/// Moves all points but the first `fixed` apart, `keep` bringing each back to where it may be.
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

// ---- surfaces -----------------------------------------------------------------------------------

constexpr double kTube = 0.4;

/// Signed distance to a torus about the z axis.
double torusValue(const Vec3& x) {
    const double across = std::sqrt(x.x * x.x + x.y * x.y) - 1.0;
    return std::sqrt(across * across + x.z * x.z) - kTube;
}
Vec3 torusGradient(const Vec3& x) {
    const double rho = std::max(std::sqrt(x.x * x.x + x.y * x.y), 1e-9);
    const double across = rho - 1.0;
    const double length = std::max(std::sqrt(across * across + x.z * x.z), 1e-9);
    return Vec3(x.x / rho * across, x.y / rho * across, x.z) / length;
}

/// The same torus moved along x and turned about it: a link of the first one's chain.
Vec3 toSecondLink(const Vec3& x) { return {x.x - 1.0, x.z, -x.y}; }
Vec3 fromSecondLink(const Vec3& v) { return {v.x, -v.z, v.y}; }

/// Two tori side by side, squared distances multiplied: a level above zero melts them into one.
constexpr double kApart = 1.2;
constexpr double kMelt = 0.03;
double squareTorus(const Vec3& x) {
    const double across = std::sqrt(x.x * x.x + x.y * x.y) - 1.0;
    return across * across + x.z * x.z - kTube * kTube;
}
Vec3 squareTorusGradient(const Vec3& x) {
    const double rho = std::max(std::sqrt(x.x * x.x + x.y * x.y), 1e-9);
    const double across = 2.0 * (rho - 1.0) / rho;
    return {x.x * across, x.y * across, 2.0 * x.z};
}
const Vec3 kLeft(-kApart, 0.0, 0.0);

double wave(const Vec3& x) { return 0.25 * x.x * (1.5 - 2.0 * x.x * x.x) + 0.2 * x.y * x.y; }

}  // namespace

ImplicitSurface unitSphere() {
    return {[](const Vec3& x) { return glm::dot(x, x) - 1.0; },
            [](const Vec3& x) { return 2.0 * x; }, Vec3(-1.3), Vec3(1.3)};
}

ImplicitSurface torus() {
    return {torusValue, torusGradient, Vec3(-1.6, -1.6, -0.6), Vec3(1.6, 1.6, 0.6)};
}

ImplicitSurface linkedTori() {
    const auto value = [](const Vec3& x) {
        return std::min(torusValue(x), torusValue(toSecondLink(x)));
    };
    const auto gradient = [](const Vec3& x) {
        const Vec3 y = toSecondLink(x);
        return torusValue(x) <= torusValue(y) ? torusGradient(x) : fromSecondLink(torusGradient(y));
    };
    return {value, gradient, Vec3(-1.6, -1.6, -1.6), Vec3(2.6, 1.6, 1.6)};
}

ImplicitSurface doubleTorus() {
    const auto value = [](const Vec3& x) {
        return squareTorus(x - kLeft) * squareTorus(x + kLeft) - kMelt;
    };
    const auto gradient = [](const Vec3& x) {
        return squareTorusGradient(x - kLeft) * squareTorus(x + kLeft) +
               squareTorusGradient(x + kLeft) * squareTorus(x - kLeft);
    };
    return {value, gradient, Vec3(-2.8, -1.6, -0.6), Vec3(2.8, 1.6, 0.6)};
}

ImplicitSurface flatSheet() {
    return {[](const Vec3& x) { return x.z; }, [](const Vec3&) { return Vec3(0.0, 0.0, 1.0); },
            Vec3(-1.0, -1.0, 0.0), Vec3(1.0, 1.0, 0.0)};
}

ImplicitSurface wavySheet() {
    return {[](const Vec3& x) { return x.z - wave(x); },
            [](const Vec3& x) { return Vec3(-0.25 * (1.5 - 6.0 * x.x * x.x), -0.4 * x.y, 1.0); },
            Vec3(-1.0, -1.0, -1.0), Vec3(1.0, 1.0, 1.0)};
}

// ---- sampling -----------------------------------------------------------------------------------

PointFile sampleClosed(const ImplicitSurface& surface, std::size_t count, double spacing,
                       std::uint64_t seed) {
    Random random(seed);
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
    Random random(seed);
    for (std::size_t i = 0; i < interior; ++i) {
        const Vec3 x = random.inBox(low + margin, high - margin);
        position.push_back(drop(x.x, x.y));
    }
    relax(position, rim, spacing, [&](const Vec3& x) {
        return drop(std::clamp(x.x, low.x + margin, high.x - margin),
                    std::clamp(x.y, low.y + margin, high.y - margin));
    });
    PointFile file = fileOf(sheet, std::move(position));
    for (const Vec3& x : file.position) {
        unsigned faces = 0;
        if (x.x == high.x) faces |= kPositiveX;
        if (x.y == high.y) faces |= kPositiveY;
        if (x.x == low.x) faces |= kNegativeX;
        if (x.y == low.y) faces |= kNegativeY;
        file.type.push_back(withCornerBit(static_cast<std::uint8_t>(faces)));
    }
    return file;
}

}  // namespace se
