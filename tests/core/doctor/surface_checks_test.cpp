/// Noise, two layers and outliers, planted in all combinations on two shapes.
#include <algorithm>
#include <cmath>

#include "doctor_support.h"
#include "spiraling_edge/mesh/inspection.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Distances in spacings of one layer.
struct Plant {
    int shape = 0;
    double layers = 0.0;    ///< Offset of a second layer; 0: none.
    double noise = 0.0;     ///< Standard deviation along each axis.
    double outliers = 0.0;  ///< Share of the points.
};

double gaussian(Random& random) {
    double sum = 0.0;
    for (int i = 0; i < 12; ++i) sum += random.between(-0.5, 0.5);
    return sum;
}

/// A point of a sphere or of a torus, by chance, and its normal.
std::pair<Vec3, Vec3> pointOf(int shape, Random& random) {
    constexpr double kPi = 3.14159265358979;
    if (shape == 0) {
        const double z = random.between(-1.0, 1.0);
        const double a = random.between(-kPi, kPi);
        const double r = std::sqrt(1.0 - z * z);
        const Vec3 x(r * std::cos(a), r * std::sin(a), z);
        return {x, x};
    }
    for (;;) {
        const double a = random.between(-kPi, kPi);
        const double b = random.between(-kPi, kPi);
        if (random.between(0.0, 1.4) > 1.0 + 0.4 * std::cos(b)) continue;
        const Vec3 out(std::cos(a), std::sin(a), 0.0);
        const Vec3 normal = std::cos(b) * out + Vec3(0.0, 0.0, std::sin(b));
        return {out + 0.4 * normal, normal};
    }
}

constexpr int kPoints = 3000;

/// Distance to the sixth nearest of kPoints on that shape.
double spacingOf(int shape) {
    const double area = shape == 0 ? 12.566 : 15.791;
    return std::sqrt(6.0 * area / (3.14159 * kPoints));
}

PointFile planted(const Plant& plant) {
    Random random(11);
    const double spacing = spacingOf(plant.shape);
    PointFile file;
    file.positionType = ScalarType::Double;
    for (int layer = 0; layer < (plant.layers > 0.0 ? 2 : 1); ++layer) {
        for (int i = 0; i < kPoints; ++i) {
            const auto [x, normal] = pointOf(plant.shape, random);
            const double dx = gaussian(random);
            const double dy = gaussian(random);
            const Vec3 noise(dx, dy, gaussian(random));
            file.position.push_back(x + spacing * (layer * plant.layers * normal) +
                                    spacing * plant.noise * noise);
        }
    }
    const auto outliers =
        static_cast<int>(plant.outliers * static_cast<double>(file.position.size()));
    for (int i = 0; i < outliers; ++i) {
        const double x = random.between(-1.8, 1.8);
        const double y = random.between(-1.8, 1.8);
        file.position.emplace_back(x, y, random.between(-1.8, 1.8));
    }
    return file;
}

/// The verdicts that differ from what was planted. Layers nearer than four times the noise of each
/// are noise to any method; there, and at the bounds of a verdict, either answer is right.
std::string misjudged(const Plant& plant, const Diagnosis& diagnosis) {
    std::string wrong;
    const bool layered = findingOf(diagnosis, "two_layers") != nullptr;
    if (layered != (plant.layers > 0.0) && plant.layers >= 3.99 * plant.noise) wrong += "layers ";
    const bool noisy = findingOf(diagnosis, "noise") != nullptr;
    const bool distinct = plant.layers == 0.0 || plant.layers >= 3.99 * plant.noise;
    if (distinct && plant.noise != 0.1 && noisy != (plant.noise >= 0.2)) wrong += "noise ";
    const bool outliers = findingOf(diagnosis, "isolated_points") != nullptr;
    if (outliers != (plant.outliers > 0.0)) wrong += "outliers ";
    return wrong;
}

}  // namespace

TEST_CASE("doctor: layers, noise and outliers are judged right in 95 of 100 planted clouds" *
          doctest::test_suite("long")) {
    int count = 0;
    int wrong = 0;
    for (const int shape : {0, 1}) {
        for (const double layers : {0.0, 0.4, 0.6, 0.8}) {
            for (const double noise : {0.0, 0.05, 0.1, 0.2, 0.4}) {
                for (const double outliers : {0.0, 0.01, 0.05}) {
                    const Plant plant{shape, layers, noise, outliers};
                    const std::string errors = misjudged(plant, examined(planted(plant)));
                    ++count;
                    wrong += errors.empty() ? 0 : 1;
                    INFO("shape ", shape, ", layers ", layers, ", noise ", noise, ", outliers ",
                         outliers, ": ", errors);
                    CHECK((errors.empty() || wrong <= 6));
                }
            }
        }
    }
    CHECK(count == 120);
    CHECK(wrong * 20 <= count);
}

TEST_CASE("doctor: the distance of two layers and the noise are those planted") {
    const Diagnosis layers = examined(planted({0, 0.6, 0.05, 0.0}));
    const Finding* apart = findingOf(layers, "two_layers");
    REQUIRE(apart != nullptr);
    CHECK(apart->severity == Severity::Warning);
    CHECK(apart->points.size() > 5000);
    // The spacing of both layers together is smaller: 0.71.
    CHECK(apart->text.find("about 0.7") != std::string::npos);
    const Finding noise = findingIn(planted({1, 0.0, 0.2, 0.0}), "noise");
    CHECK(noise.severity == Severity::Note);
    CHECK(noise.text.starts_with("noise of 0.1"));
    const Diagnosis coarse = examined(planted({1, 0.0, 0.45, 0.0}));
    REQUIRE(findingOf(coarse, "noise") != nullptr);
    CHECK(findingOf(coarse, "noise")->severity == Severity::Warning);
}

TEST_CASE("doctor: two layers are dropped down to one surface, and a sound mesh follows") {
    const PointFile layered = planted({1, 0.5, 0.0, 0.0});
    const Finding finding = findingIn(layered, "two_layers");
    CHECK(finding.toDrop().size() < finding.points.size());
    const FixedFile fixed = applyFixes(layered, finding.toDrop(), finding.dropReason);
    REQUIRE(fixed.fixes.size() == 1);
    CHECK(fixed.fixes[0].text ==
          std::to_string(finding.toDrop().size()) + " of " +
              std::to_string(layered.position.size()) +
              " points dropped: the rest are 4.5 times the thickness of the layers apart");
    const PointFile& single = fixed.file;
    CHECK(findingOf(examined(single), "two_layers") == nullptr);
    const auto faultsOf = [](const PointFile& file) {
        PrepareOptions options;
        options.setNoiseAside = true;
        const PointSet points = prepare(file, options).value().points;
        return inspectMesh(points, runAll(points, robust()).state.mesh()).size();
    };
    CHECK(faultsOf(layered) > 100);
    CHECK(faultsOf(single) <= 2);
}

TEST_CASE("doctor: of two layers with a gap between them one is dropped") {
    for (const int shape : {0, 1}) {
        for (const double apart : {0.4, 0.8}) {
            const PointFile layered = planted({shape, apart, 0.0, 0.0});
            const Finding finding = findingIn(layered, "two_layers");
            std::size_t dropped[2] = {};
            for (const Index p : finding.toDrop()) ++dropped[p < kPoints ? 0 : 1];
            CAPTURE(apart);
            CHECK(std::max(dropped[0], dropped[1]) > 0.995 * kPoints);
            CHECK(std::min(dropped[0], dropped[1]) < kPoints);
        }
    }
}

TEST_CASE(
    "doctor: noise that is equally likely in a range is no second layer, few points are one") {
    Random random(6);
    PointFile range = flatLattice(50, 0.4);
    PointFile few = range;
    for (Vec3& x : range.position) x.z = random.between(-0.4, 0.4);
    CHECK(findingOf(examined(range), "two_layers") == nullptr);
    CHECK(findingOf(examined(range), "noise") != nullptr);
    for (Vec3& x : few.position)
        x.z = (random.below(4) == 0 ? 0.7 : 0.0) + random.between(-0.1, 0.1);
    CHECK(findingOf(examined(few), "two_layers") != nullptr);
}

TEST_CASE("doctor: thin parts with normals are no second layer") {
    // Two sides of a plate, half a spacing apart, that face away from each other.
    PointFile plate = flatLattice(40, 0.4, 1);
    PointFile below = flatLattice(40, 0.4, 2);
    for (std::size_t p = 0; p < below.position.size(); ++p) {
        below.position[p].z -= 0.5;
        below.normal[p] = -below.normal[p];
    }
    append(plate, below);
    CHECK(findingOf(examined(plate), "two_layers") == nullptr);
    // The same points without normals could be either.
    plate.normal.clear();
    CHECK(findingOf(examined(plate), "two_layers") != nullptr);
}

TEST_CASE("doctor: layers are said from one point in ten on") {
    const auto withSecondLayer = [](std::size_t points) {
        PointFile sheet = flatLattice(60, 0.4, 1);
        const PointFile above = flatLattice(60, 0.4, 2);
        for (std::size_t p = 0; p < points; ++p) {
            sheet.position.push_back(above.position[p] + Vec3(0.0, 0.0, 0.5));
            sheet.normal.push_back(above.normal[p]);
        }
        return sheet;
    };
    CHECK(findingOf(examined(withSecondLayer(1200)), "two_layers") != nullptr);
    CHECK(findingOf(examined(withSecondLayer(90)), "two_layers") == nullptr);
}

TEST_CASE("doctor: scattered points are said from five on, and only if no usual point lists them") {
    const auto withPointsAbove = [](int count) {
        PointFile sheet = flatLattice(60, 0.3);
        sheet.normal.clear();
        for (int i = 0; i < count; ++i) sheet.position.emplace_back(5.0 + 8.0 * i, 30.0, 5.0);
        return sheet;
    };
    CHECK(findingOf(examined(withPointsAbove(4)), "isolated_points") == nullptr);
    const Diagnosis six = examined(withPointsAbove(6));
    REQUIRE(findingOf(six, "isolated_points") != nullptr);
    CHECK(findingOf(six, "isolated_points")->points ==
          std::vector<Index>{3600, 3601, 3602, 3603, 3604, 3605});
    // Beside small parts, whose lists hold them.
    PointFile parts = flatLattice(60, 0.3);
    parts.normal.clear();
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < 10; ++k) parts.position.emplace_back(k % 5, 40.0 * i + k / 5, 60.0);
        parts.position.emplace_back(14.5, 40.0 * i + 0.5, 60.0);
    }
    CHECK(findingOf(examined(parts), "isolated_points") == nullptr);
}

TEST_CASE("doctor: the spacing and the extent are in the units of the file") {
    PointFile file = flatLattice(10, 0.0);
    for (Vec3& x : file.position) x *= 0.25;
    const Diagnosis diagnosis = examined(file);
    CHECK(diagnosis.facts.extent() == Vec3(2.25, 2.25, 0.0));
    CHECK(diagnosis.facts.nearestMedian == doctest::Approx(0.25));
    CHECK(sizeText(diagnosis.facts) == "0.25 between points, 2.25 x 2.25 x 0");
    CHECK(sizeText(InputFacts{}).empty());
}
