#include "spiraling_edge/sampling/sampler.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "spiraling_edge/base/random.h"
#include "spiraling_edge/sampling/volume.h"
#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;

namespace {

SamplerOptions points(std::size_t count, std::uint64_t seed = 1) {
    SamplerOptions options;
    options.count = count;
    options.seed = seed;
    return options;
}

PointFile sampled(const Field& field, const SamplerOptions& options) {
    Result<PointFile> file = sample(field, options);
    REQUIRE_MESSAGE(file.ok(), (file.ok() ? "" : file.error().message));
    return std::move(file.value());
}
PointFile sampled(const char* shape, const SamplerOptions& options) {
    return sampled(fieldOf(*findShape(shape)), options);
}

/// Distance of each point to the nearest other one that faces its way. Plain arithmetic: tests are
/// not optimized under sanitizers.
std::vector<double> nearest(const PointFile& file) {
    const std::size_t count = file.position.size();
    const Vec3* const x = file.position.data();
    const Vec3* const n = file.normal.data();
    std::vector<double> distance(count);
    for (std::size_t i = 0; i < count; ++i) {
        double best = 1e300;
        for (std::size_t j = 0; j < count; ++j) {
            const double dx = x[i].x - x[j].x;
            const double dy = x[i].y - x[j].y;
            const double dz = x[i].z - x[j].z;
            const double squared = dx * dx + dy * dy + dz * dz;
            if (squared >= best || i == j) continue;
            if (n[i].x * n[j].x + n[i].y * n[j].y + n[i].z * n[j].z > 0.0) best = squared;
        }
        distance[i] = std::sqrt(best);
    }
    return distance;
}

struct Spacing {
    double mean = 0.0;
    double variation = 0.0;  ///< Standard deviation over mean.
};
/// Spacing of the interior points.
Spacing spacingOf(const PointFile& file) {
    const std::vector<double> all = nearest(file);
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (isBoundary(file.type[i])) continue;
        sum += all[i];
        squares += all[i] * all[i];
        count += 1.0;
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0)) / mean};
}

std::uint8_t facesOf(const Field& field, const Vec3& x) {
    unsigned faces = 0;
    for (unsigned i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        if (x[axis] == field.high[axis]) faces |= 1U << i;
        if (x[axis] == field.low[axis]) faces |= 8U << i;
    }
    return withCornerBit(static_cast<std::uint8_t>(faces));
}

bool inBox(const Field& field, const Vec3& x) { return glm::clamp(x, field.low, field.high) == x; }

}  // namespace

TEST_CASE("particles have the requested number, on the surface, even and in the box" *
          doctest::test_suite("long")) {
    for (const Shape& shape : shapes()) {
        CAPTURE(shape.id);
        const Field field = fieldOf(shape);
        const PointFile file = sampled(field, points(1500));
        REQUIRE(file.position.size() == 1500);
        const Spacing spacing = spacingOf(file);
        CHECK(spacing.variation < 0.10);
        double farthest = 0.0;
        bool inside = true;
        for (const Vec3& x : file.position) {
            const Vec3 g = field.gradient(x);
            const double off = field.value(x) - field.isovalue;
            farthest = std::max(farthest, std::abs(off) / std::sqrt(glm::dot(g, g)));
            inside = inside && inBox(field, x);
        }
        CHECK(farthest < 1e-4 * spacing.mean);
        CHECK(inside);
    }
}

TEST_CASE("particles are even on a rough volume too, where tips are as fine as the spacing") {
    // A ball of noise: values between samples bend the surface by a right angle and more.
    constexpr std::size_t kSide = 24;
    Volume ball;
    ball.size = {kSide, kSide, kSide};
    SplitMix random(1);
    for (std::size_t i = 0; i < kSide * kSide * kSide; ++i) {
        const Vec3 x(i % kSide, i / kSide % kSide, i / kSide / kSide);
        const double noise = 2.0 * random.unit() - 1.0;
        ball.value.push_back(static_cast<float>(8.0 - glm::length(x - 11.5) + noise));
    }
    const PointFile file =
        sampled(fieldOf(std::make_shared<const Volume>(ball), 0.0), points(1200));
    REQUIRE(file.position.size() == 1200);
    CHECK(spacingOf(file).variation < 0.10);
}

TEST_CASE("particles carry unit normals and the bits of their walls") {
    for (const Shape& shape : shapes()) {
        CAPTURE(shape.id);
        const Field field = fieldOf(shape);
        const PointFile file = sampled(field, points(300));
        bool normals = true;
        bool types = true;
        for (std::size_t i = 0; i < file.position.size(); ++i) {
            normals = normals &&
                      glm::length(file.normal[i] - field.normal(file.position[i])) < 1e-12 &&
                      std::abs(glm::length(file.normal[i]) - 1.0) < 1e-12;
            types = types && file.type[i] == facesOf(field, file.position[i]);
        }
        CHECK(normals);
        CHECK(types);
    }
}

TEST_CASE("curves on the walls are divided like the surface, with a point at every corner") {
    const PointFile file = sampled("plane", points(900));
    const auto corners = std::count_if(file.type.begin(), file.type.end(), isCorner);
    CHECK(corners == 4);
    // A square of side 2: area 4 = 0.866 h^2 (inside + walls / 2 + corners / 4), in triangles.
    const double h = std::sqrt(4.0 / 0.866 / 900.0);
    const auto walls =
        static_cast<double>(std::count_if(file.type.begin(), file.type.end(), isBoundary));
    CHECK(std::abs(walls - 8.0 / h) < 0.06 * 8.0 / h);
    const std::vector<double> all = nearest(file);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!isBoundary(file.type[i])) continue;
        CHECK(all[i] > 0.7 * h);
        CHECK(all[i] < 1.15 * h);
    }
}

TEST_CASE("no interior particle is on a wall or next to it") {
    const Field field = fieldOf(*findShape("monkey-saddle"));
    const PointFile file = sampled(field, points(800));
    const double spacing = spacingOf(file).mean;
    double least = 1e300;
    for (std::size_t i = 0; i < file.position.size(); ++i) {
        if (isBoundary(file.type[i])) continue;
        const Vec3 x = file.position[i];
        // The saddle meets these walls steeply enough; z is another matter.
        least = std::min(
            {least, x.x - field.low.x, field.high.x - x.x, x.y - field.low.y, field.high.y - x.y});
    }
    CHECK(least > 0.2 * spacing);
}

TEST_CASE("all parts of a surface are covered by their share") {
    const auto share = [](const PointFile& file, auto&& belongs) {
        return static_cast<double>(
                   std::count_if(file.position.begin(), file.position.end(), belongs)) /
               static_cast<double>(file.position.size());
    };
    const PointFile tori = sampled("two-tori", points(1000));
    const auto onFirst = [](const Vec3& x) {
        const double across = std::sqrt(x.x * x.x + x.y * x.y) - 1.0;
        return std::abs(std::sqrt(across * across + x.z * x.z) - 0.4) < 1e-6;
    };
    CHECK(std::abs(share(tori, onFirst) - 0.5) < 0.01);
    const PointFile sheets = sampled("hyperboloid-two-sheets", points(700));
    CHECK(std::abs(share(sheets, [](const Vec3& x) { return x.z > 0.0; }) - 0.5) < 0.01);
    const PointFile hydrogen = sampled("hydrogen", points(1000));
    const auto above = [](const Vec3& x) {
        const Vec3 v = x - 31.5;
        return v.z > 0.0 && 3.0 * v.z * v.z > glm::dot(v, v);
    };
    const double lobe = share(hydrogen, above);
    CHECK(lobe > 0.2);
    CHECK(std::abs(share(hydrogen, [&](const Vec3& x) { return above(63.0 - x); }) - lobe) < 0.02);
}

TEST_CASE("equal seeds give equal particles, whatever the number of threads" *
          doctest::test_suite("long")) {
    SamplerOptions options = points(6000, 7);
    options.threads = 1;
    const PointFile one = sampled("gyroid", options);
    options.threads = 3;
    const PointFile three = sampled("gyroid", options);
    CHECK(one.position == three.position);
    CHECK(one.normal == three.normal);
    CHECK(one.type == three.type);
    options.seed = 8;
    CHECK(sampled("gyroid", options).position != one.position);
}

TEST_CASE("a spacing gives as many particles as fit" * doctest::test_suite("long")) {
    for (const char* shape : {"sphere", "torus", "plane", "hyperboloid-one-sheet"}) {
        CAPTURE(shape);
        SamplerOptions options;
        options.spacing = 0.1;
        const PointFile file = sampled(shape, options);
        // The nearest of six neighbors is a little nearer than all of them on average.
        const double mean = spacingOf(file).mean;
        CHECK(mean > 0.088);
        CHECK(mean < 0.1);
    }
    SamplerOptions options;
    options.spacing = 0.1;
    const double count = 4.0 * test::kPi / (0.866 * 0.01);
    CHECK(std::abs(static_cast<double>(sampled("sphere", options).position.size()) - count) <
          0.01 * count);
}

TEST_CASE("with influence of the curvature particles crowd where the surface bends") {
    SamplerOptions options = points(1500);
    options.curvature = 1.0;
    const PointFile file = sampled("hyperboloid-one-sheet", options);
    REQUIRE(file.position.size() == 1500);
    const std::vector<double> all = nearest(file);
    const auto mean = [&](double low, double high) {
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double z = std::abs(file.position[i].z);
            if (isBoundary(file.type[i]) || z < low || z >= high) continue;
            sum += all[i];
            count += 1.0;
        }
        return sum / count;
    };
    CHECK(mean(0.0, 0.1) < 0.75 * mean(0.8, 1.0));
    const PointFile even = sampled("hyperboloid-one-sheet", points(1500));
    CHECK(spacingOf(even).variation < 0.5 * spacingOf(file).variation);
}

TEST_CASE("the sampler advances by single steps with visible states") {
    const Field field = fieldOf(*findShape("torus"));
    Result<Sampler> begun = Sampler::begin(field, points(500));
    REQUIRE(begun.ok());
    Sampler& sampler = begun.value();
    const double h = sampler.spacing();
    const Spacing first = spacingOf(sampler.points());
    double share = sampler.share();
    CHECK(share == 0.0);
    std::size_t steps = 0;
    while (!sampler.done()) {
        sampler.step();
        ++steps;
        CHECK(sampler.share() > share);
        share = sampler.share();
        REQUIRE(sampler.positions().size() == sampler.types().size());
        for (const Vec3& x : sampler.positions()) {
            CHECK(std::abs(field.value(x)) < 1e-3 * h);  // a distance, for the torus
            CHECK(inBox(field, x));
        }
        REQUIRE(steps < 1000);
    }
    CHECK(share == 1.0);
    const PointFile last = sampler.points();
    CHECK(spacingOf(last).variation < 0.2 * first.variation);
    sampler.step();
    CHECK(sampler.points().position == last.position);
    CHECK(sampled(field, points(500)).position == last.position);
}

TEST_CASE(
    "sampling ends soon when it is cancelled, while particles are scattered and in each step") {
    const Field field = fieldOf(*findShape("torus"));
    double last = 0.0;
    REQUIRE(sample(field, points(6000), [&](double share) {
                CHECK(share >= last);
                last = share;
                return true;
            }).ok());
    CHECK(last > 0.95);
    // Scattered in batches of several thousand, and at most one batch after a cancellation.
    std::size_t calls = 0;
    REQUIRE(Sampler::begin(field, points(60000), [&](double) { return ++calls > 0; }).ok());
    CHECK(calls > 12);
    for (std::size_t until = 1; until < calls; ++until) {
        std::size_t seen = 0;
        const auto goOn = [&](double) { return ++seen < until; };
        CHECK_FALSE(Sampler::begin(field, points(60000), goOn).ok());
        CHECK(seen == until);
    }
    Result<Sampler> begun = Sampler::begin(field, points(6000));
    REQUIRE(begun.ok());
    CHECK_FALSE(begun.value().step([](double) { return false; }));
    CHECK(begun.value().steps() == 0);
}

TEST_CASE("what cannot be sampled is an error in words") {
    const auto problem = [](Field field, const SamplerOptions& options) {
        const Result<PointFile> file = sample(field, options);
        REQUIRE_FALSE(file.ok());
        return file.error().message;
    };
    const auto says = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    const Field sphere = fieldOf(*findShape("sphere"));
    Field nothing = sphere;
    nothing.isovalue = 100.0;
    CHECK(says(problem(nothing, points(100)), "no surface"));
    Field flat = sphere;
    flat.high.z = flat.low.z;
    CHECK(says(problem(flat, points(100)), "box"));
    CHECK(says(problem(sphere, {}), "spacing"));
    SamplerOptions options;
    options.spacing = 1e-9;
    CHECK(says(problem(sphere, options), "too small"));
    CHECK(says(problem(sphere, points(1'000'000'000)), "particles"));
    CHECK(says(problem(fieldOf(*findShape("gyroid")), points(20)), "walls"));
    options = points(100);
    options.curvature = -1.0;
    CHECK(says(problem(sphere, options), "curvature"));
    const Result<PointFile> cancelled = sample(sphere, points(100), [](double) { return false; });
    REQUIRE_FALSE(cancelled.ok());
    CHECK(says(cancelled.error().message, "cancelled"));
}

TEST_CASE("sampled shapes are triangulated to the last point" * doctest::test_suite("long")) {
    // Closed: V - E + F = Euler number; open: one boundary edge per point on a wall.
    struct Expected {
        const char* shape;
        long long euler;
    };
    for (const Expected& e : {Expected{"sphere", 2},
                              {"torus", 0},
                              {"genus-2", -2},
                              {"hydrogen", 4},
                              {"plane", 1},
                              {"monkey-saddle", 1},
                              {"hyperboloid-one-sheet", 0},
                              {"hyperboloid-two-sheets", 2},
                              {"hyperboloid", 2},
                              {"blast-wave", 1}}) {
        CAPTURE(e.shape);
        const PointFile file = sampled(e.shape, points(900));
        const PointSet set = test::prepared(file);
        const test::Run run = test::runAll(set, *paramsByName("robust"));
        CHECK(run.mesh.unusedPoints == 0);
        CHECK(run.mesh.eulerCharacteristic == e.euler);
        CHECK(run.mesh.nonManifoldEdges == 0);
        const auto walls = std::count_if(file.type.begin(), file.type.end(), isBoundary);
        CHECK(run.mesh.boundaryEdges == static_cast<std::size_t>(walls));
        CHECK(test::describeFaults(set, run.state.mesh()).empty());
    }
}
