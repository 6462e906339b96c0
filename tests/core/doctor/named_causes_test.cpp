/// Causes with a name of their own, each planted at three strengths on five shapes.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "doctor_support.h"
#include "spiraling_edge/base/median.h"
#include "spiraling_edge/prepare/piece.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Even points with normals: four closed shapes, and a wavy sheet. Sampled once, since that takes
/// longer than to examine them.
const std::vector<PointFile>& shapes(std::uint64_t seed) {
    static std::map<std::uint64_t, std::vector<PointFile>> sampled;
    std::vector<PointFile>& files = sampled[seed];
    if (!files.empty()) return files;
    for (const Family& family : closedFamilies(kTubesApart)) files.push_back(family.sample(seed));
    files.push_back(sampleSheet(wavySheet(), 24, 900, seed));
    files.back().type.clear();
    return files;
}

/// A cause, planted into a file at strength 0, 1 or 2.
struct Cause {
    std::string name;
    void (*plant)(PointFile& file, std::size_t strength, Random& random);
    std::string words;   ///< That the finding must have.
    std::string also{};  ///< Another check that may be right as well.
};

/// Share of the planted files, in percent, in which this check alone finds a problem, and its text
/// has the words of the cause.
double shareFound(const std::string& check, const std::vector<Cause>& causes) {
    int count = 0;
    int right = 0;
    Random random(5);
    for (const Cause& cause : causes) {
        for (std::size_t strength = 0; strength < 3; ++strength) {
            std::size_t shape = 0;
            for (PointFile file : shapes(strength + 1)) {
                cause.plant(file, strength, random);
                const Diagnosis diagnosis = examined(file);
                const Finding* finding = findingOf(diagnosis, check);
                const std::string names = problemNames(diagnosis);
                const bool alone = names == check + " " || names == check + " " + cause.also + " ";
                const bool found = finding != nullptr && alone &&
                                   finding->text.find(cause.words) != std::string::npos;
                ++count;
                right += found ? 1 : 0;
                if (!found) {
                    MESSAGE(cause.name, " ", strength, " on shape ", shape, ": ",
                            problemNames(diagnosis), finding == nullptr ? "" : finding->text);
                }
                ++shape;
            }
        }
    }
    MESSAGE(check, ": ", right, " of ", count, " planted files judged right");
    return 100.0 * right / count;
}

}  // namespace

TEST_CASE("doctor: the five shapes as they are have no cause with a name" *
          doctest::test_suite("long")) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        for (const PointFile& file : shapes(seed)) CHECK(problemNames(file) == "");
    }
}

// ---- normals that do not fit --------------------------------------------------------------------

namespace {

void plantTilt(PointFile& file, std::size_t strength, Random& random) {
    constexpr std::array kDegrees{20.0, 30.0, 45.0};
    for (Vec3& n : file.normal) n = tilted(n, kDegrees[strength], random);
}

void plantChance(PointFile& file, std::size_t /*strength*/, Random& random) {
    for (Vec3& n : file.normal) n = random.direction();
}

void plantSomeChance(PointFile& file, std::size_t strength, Random& random) {
    constexpr std::array kShare{0.25, 0.4, 0.6};
    for (Vec3& n : file.normal) {
        if (random.between(0.0, 1.0) < kShare[strength]) n = random.direction();
    }
}

void plantOneDirection(PointFile& file, std::size_t strength, Random& random) {
    constexpr std::array kDegrees{0.0, 2.0, 6.0};
    for (Vec3& n : file.normal) n = tilted(Vec3(0.6, 0.8, 0.0), kDegrees[strength], random);
}

void plantSight(PointFile& file, std::size_t strength, Random& /*random*/) {
    const std::array kPlaces{Vec3(2.5, 1.0, 0.3), Vec3(-3.0, 2.0, 0.2), Vec3(4.0, -3.0, -0.3)};
    for (std::size_t p = 0; p < file.position.size(); ++p)
        file.normal[p] = glm::normalize(kPlaces[strength] - file.position[p]);
}

void plantSwap(PointFile& file, std::size_t strength, Random& /*random*/) {
    for (Vec3& n : file.normal) {
        n = std::array{Vec3(n.x, n.z, n.y), Vec3(n.z, n.x, n.y), Vec3(n.x, -n.z, n.y)}[strength];
    }
}

void plantBytes(PointFile& file, std::size_t strength, Random& /*random*/) {
    for (Vec3& n : file.normal) {
        const Vec3 share = 0.5 * (n + Vec3(1.0));
        const Vec3 byte = glm::round(255.0 * share);
        n = std::array{byte, share, byte / 255.0}[strength];
    }
}

PointFile withNormals(PointFile file, void (*plant)(PointFile&, std::size_t, Random&),
                      std::size_t strength) {
    Random random(3);
    plant(file, strength, random);
    return file;
}

}  // namespace

TEST_CASE("doctor: normals that do not fit are found, with their kind, in 95 of 100 files" *
          doctest::test_suite("long")) {
    CHECK(shareFound("unfit_normals", {{"tilt", plantTilt, "they are tilted"},
                                       {"chance", plantChance, "they look random"},
                                       {"some chance", plantSomeChance, "do not fit"},
                                       {"one direction", plantOneDirection, "they are alike"},
                                       {"sight", plantSight, "lines of sight"},
                                       {"axes", plantSwap, "they fit"}}) >= 95.0);
}

TEST_CASE("doctor: normals that were read as unsigned numbers are recognized") {
    for (std::size_t strength = 0; strength < 3; ++strength) {
        for (const PointFile& shape : shapes(2)) {
            const Finding finding =
                findingIn(withNormals(shape, plantBytes, strength), "unfit_normals");
            CHECK(finding.text.ends_with(strength == 0 ? "they fit as 2 v / 255 - 1"
                                                       : "they fit as 2 v - 1"));
        }
    }
}

TEST_CASE("doctor: normals that do not fit are said with their angles, and are not turned") {
    const Diagnosis diagnosis = examined(withNormals(fibonacciSphere(600), plantTilt, 1));
    CHECK(problemNames(diagnosis) == "unfit_normals ");
    const Finding* finding = findingOf(diagnosis, "unfit_normals");
    REQUIRE(finding != nullptr);
    CHECK(finding->points.empty());
    CHECK(finding->text.starts_with("the normals do not fit the points: they are 30 degrees off"));
    CHECK(remedyFor(*finding, "a.ply") == "spiraling-edge run a.ply --derive-normals -o OUT.ply");
    // Half of them, at random, are also against those around them: --orient would not help.
    PointFile turned = withNormals(fibonacciSphere(600), plantTilt, 2);
    turn(turned, [&](Index p) { return turned.position[p].z > 0.0; });
    CHECK(problemNames(turned) == "unfit_normals ");
}

TEST_CASE("doctor: rough normals are a note, and still tell flipped ones") {
    PointFile file = fibonacciSphere(600);
    Random random(4);
    for (Vec3& n : file.normal) n = tilted(n, 17.5, random);
    const Finding finding = findingIn(file, "unfit_normals");
    CHECK(finding.severity == Severity::Note);
    turn(file, [&](Index p) { return file.position[p].z > 0.6; });
    CHECK(problemNames(file) == "flipped_normals ");
}

TEST_CASE("doctor: normals that fit roughly, or at too few places, are not accused") {
    for (const PointFile& shape : shapes(3)) {
        Random random(8);
        PointFile file = shape;
        for (Vec3& n : file.normal) n = tilted(n, random.between(0.0, 18.0), random);
        CHECK(findingOf(examined(file), "unfit_normals") == nullptr);
    }
    // The edges of a box alone are no surface.
    PointFile edges;
    for (int i = 0; i < 90; ++i) {
        for (const double side : {0.0, 30.0}) {
            edges.position.emplace_back(i / 3.0, side, 0.0);
            edges.normal.push_back(glm::normalize(Vec3(1.0, side - 15.0, 4.0)));
        }
    }
    CHECK(findingOf(examined(edges), "unfit_normals") == nullptr);
}

namespace {

/// A sheet of so few points that it bends between them, with its normals.
PointFile coarseSheet(int side, Random& random) {
    PointFile file;
    const Vec3 phase(random.between(0.0, 6.0), random.between(0.0, 6.0), 0.0);
    for (int i = 0; i < side * side; ++i) {
        const double x = (i % side + random.between(-0.3, 0.3)) / (side - 1) + phase.x;
        const double y = (i / side + random.between(-0.3, 0.3)) / (side - 1) + phase.y;
        file.position.emplace_back(x, y, 0.35 * std::sin(3.0 * x) * std::cos(2.5 * y));
        file.normal.push_back(
            glm::normalize(Vec3(-1.05 * std::cos(3.0 * x) * std::cos(2.5 * y),
                                0.875 * std::sin(3.0 * x) * std::sin(2.5 * y), 1.0)));
    }
    return file;
}

}  // namespace

TEST_CASE("doctor: the normals of a few points are accused only where they are far off") {
    Random random(11);
    for (const int side : {3, 4, 5, 6, 7}) {
        for (int i = 0; i < 30; ++i) {
            const PointFile sheet = coarseSheet(side, random);
            CHECK(findingOf(examined(sheet), "unfit_normals") == nullptr);
        }
    }
    for (const std::size_t points : {150U, 200U}) {
        const PointFile sphere = fibonacciSphere(points);
        CHECK(problemNames(sphere) == "");
        CHECK(problemNames(withNormals(sphere, plantOneDirection, 0)) == "unfit_normals ");
        CHECK(problemNames(withNormals(sphere, plantChance, 0)) == "unfit_normals ");
    }
    CHECK(problemNames(withNormals(fibonacciSphere(150), plantTilt, 1)) == "unfit_normals ");
    PointFile few = coarseSheet(6, random);
    for (Vec3& x : few.position) x.z *= 0.1;
    few.normal.assign(few.position.size(), glm::normalize(Vec3(1.0, 1.0, 0.2)));
    CHECK(findingOf(examined(few), "unfit_normals") != nullptr);
}

// ---- pairs and lines ----------------------------------------------------------------------------

namespace {

/// Distance of the nearest points of shapes(), about.
double nearestOf(const PointFile& file) {
    const NeighborLists lists = nearestLists(file.position, 1);
    std::vector<double> distances;
    for (Index p = 0; p < file.position.size(); ++p)
        distances.push_back(glm::distance(file.position[p], file.position[lists[p].front()]));
    return medianOf(distances);
}

constexpr std::array kPairApart{0.01, 0.05, 0.15};

/// Each point once more, moved by chance.
void plantPairs(PointFile& file, std::size_t strength, Random& random) {
    const double apart = kPairApart[strength] * nearestOf(file);
    const PointFile first = file;
    append(file, first);
    for (std::size_t p = first.position.size(); p < file.position.size(); ++p)
        file.position[p] += apart * random.direction();
}

/// Each point once more, all moved alike, and in another order.
void plantShifted(PointFile& file, std::size_t strength, Random& random) {
    const Vec3 by = kPairApart[strength] * nearestOf(file) * random.direction();
    PointFile second = moved(file, by);
    std::reverse(second.position.begin(), second.position.end());
    std::reverse(second.normal.begin(), second.normal.end());
    append(file, second);
}

/// Three of four points once more.
void plantSomePairs(PointFile& file, std::size_t strength, Random& random) {
    const std::size_t first = file.position.size();
    plantPairs(file, strength, random);
    file.position.resize(first + 3 * first / 4);
    file.normal.resize(file.position.size());
}

/// A point of a surface by two parameters in [0, 1): lines run along the second one.
Vec3 onSurface(std::size_t shape, double u, double v) {
    const double turn = 2.0 * std::numbers::pi * v;
    const Vec3 round(std::cos(turn), std::sin(turn), 0.0);
    const Vec3 up(0.0, 0.0, 1.0);
    if (shape == 0) {
        const double a = std::numbers::pi * (0.1 + 0.8 * u);
        return std::sin(a) * round - std::cos(a) * up;
    }
    if (shape == 1) {
        const double a = 2.0 * std::numbers::pi * u;
        return (2.0 + round.x) * Vec3(std::cos(a), std::sin(a), 0.0) + round.y * up;
    }
    if (shape == 2) return round + 3.0 * u * up;
    if (shape == 3) return Vec3(4.0 * v, 3.0 * u, 0.3 * std::sin(4.0 * v) * std::cos(3.0 * u));
    return (0.5 + u) * round + 2.0 * u * up;
}

/// About `lines` lines, with points nearer by `ratio` along them. No normals.
PointFile scanned(std::size_t shape, int lines, double ratio, Random& random) {
    PointFile file;
    file.positionType = ScalarType::Double;
    const double across =
        glm::distance(onSurface(shape, 0.5, 0.3), onSurface(shape, 0.5 + 1.0 / lines, 0.3));
    constexpr int kSteps = 400;
    for (int line = 0; line < lines; ++line) {
        const double u = static_cast<double>(line) / lines;
        double length = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            length += glm::distance(onSurface(shape, u, static_cast<double>(i) / kSteps),
                                    onSurface(shape, u, static_cast<double>(i + 1) / kSteps));
        }
        const double count = std::floor(length * ratio / across);
        const double phase = random.between(0.0, 1.0);
        for (double i = 0; i < count; ++i) {
            const double v = (i + phase + random.between(-0.1, 0.1)) / count;
            // Neither circles nor straight lines are exact.
            file.position.push_back(onSurface(shape, u, v) + 1e-4 * across * random.direction());
        }
    }
    return file;
}

}  // namespace

TEST_CASE("doctor: pairs of points are found in 95 of 100 files" * doctest::test_suite("long")) {
    CHECK(shareFound("twins", {{"pairs", plantPairs, "in pairs"},
                               {"shifted", plantShifted, "in pairs", "two_layers"},
                               {"some pairs", plantSomePairs, "in pairs"}}) >= 95.0);
}

TEST_CASE("doctor: pairs are thinned to one point of each, and a sound mesh follows") {
    PointFile file = fibonacciSphere(600);
    Random random(2);
    plantPairs(file, 1, random);
    const Finding finding = findingIn(file, "twins");
    CHECK(finding.points.size() == 1200);
    CHECK(finding.toDrop().size() == 600);
    CHECK(finding.text.ends_with("leaves 600 points"));
    CHECK(remedyFor(finding, "a.ply") == "spiraling-edge doctor a.ply --fix OUT.ply --drop twins");
    const PointFile thinned = applyFixes(file, finding.toDrop()).file;
    CHECK(problemNames(thinned) == "");
    const PointSet points = prepared(thinned);
    CHECK(runAll(points, robust()).state.mesh().size() == 1196);
}

TEST_CASE("doctor: pairs are said if they are more than half of the points") {
    for (const std::size_t pairs : {180U, 230U}) {
        PointFile file = fibonacciSphere(600);
        Random random(2);
        plantPairs(file, 1, random);
        file.position.resize(600 + pairs);
        file.normal.resize(600 + pairs);
        CHECK((findingOf(examined(file), "twins") != nullptr) == (2 * 2 * pairs > 600 + pairs));
    }
}

TEST_CASE("doctor: short lines are no pairs") {
    PointFile lines;
    for (int i = 0; i < 24; ++i) lines.position.emplace_back(2.0 * (i / 4), 0.3 * (i % 4), 0.0);
    CHECK(findingOf(examined(lines), "twins") == nullptr);
}

TEST_CASE("doctor: the corners of a beam are no pairs") {
    PointFile beam;
    for (const double x : {0.0, 0.4})
        for (const double y : {0.0, 4.0})
            for (const double z : {0.0, 4.0}) beam.position.emplace_back(x, y, z);
    CHECK(findingOf(examined(beam), "twins") == nullptr);
}

TEST_CASE("doctor: lines are found in 95 of 100 files, with their distances" *
          doctest::test_suite("long")) {
    int count = 0;
    int right = 0;
    Random random(6);
    for (std::size_t shape = 0; shape < 5; ++shape) {
        for (const int lines : {16, 32}) {
            for (const double ratio : {5.5, 8.0, 12.0, 20.0}) {
                const PointFile file = scanned(shape, lines, ratio, random);
                const Diagnosis diagnosis = examined(file);
                const bool found = problemNames(diagnosis) == "lines no_normals ";
                ++count;
                right += found ? 1 : 0;
                if (!found) {
                    MESSAGE("shape ", shape, ", ", lines, " lines, ", ratio, ": ",
                            problemNames(diagnosis));
                }
            }
        }
    }
    MESSAGE("lines: ", right, " of ", count, " planted files judged right");
    CHECK(right * 20 >= count * 19);
}

TEST_CASE("doctor: lines are thinned to a surface that can be followed") {
    // 36 lines 0.2 apart, with 160 points 0.02 apart.
    PointFile file;
    file.positionType = ScalarType::Double;
    for (int line = 0; line < 36; ++line) {
        for (int i = 0; i < 160; ++i) {
            const double y = 0.2 * line;
            file.position.emplace_back(0.02 * i + 0.003 * (line % 4), y, 0.02 * std::sin(y));
            file.normal.push_back(glm::normalize(Vec3(0.0, -0.02 * std::cos(y), 1.0)));
        }
    }
    const Finding finding = findingIn(file, "lines");
    CHECK(finding.text.starts_with(
        "the points lie in lines: 0.02 apart along them, and 0.2 across; --thin 0.18 leaves "));
    CHECK(remedyFor(finding, "a.ply") ==
          "spiraling-edge doctor a.ply --fix OUT.ply --drop lines --force");
    const FixedFile fixed = applyFixes(file, finding.toDrop());
    const PointSet points = prepared(fixed.file);
    CHECK(points.size() == file.position.size() - finding.toDrop().size());
    CHECK(describeFaults(points, runAll(points, robust()).state.mesh()) == "");
}

TEST_CASE("doctor: lines as far apart as their points, or by twice as much, are none" *
          doctest::test_suite("long")) {
    Random random(7);
    for (std::size_t shape = 0; shape < 5; ++shape) {
        for (const double ratio : {1.0, 1.5, 2.0, 3.0})
            CHECK(findingOf(examined(scanned(shape, 30, ratio, random)), "lines") == nullptr);
    }
}

// ---- units --------------------------------------------------------------------------------------

TEST_CASE("doctor: axes with different units are found, and taken for nothing else" *
          doctest::test_suite("long")) {
    int count = 0;
    int right = 0;
    for (const double degrees : {1.0 / 111000.0, 1e-4, 1e-3}) {
        for (const PointFile& shape : shapes(2)) {
            PointFile file = shape;
            file.positionType = ScalarType::Double;
            file.normal.clear();
            for (Vec3& x : file.position)
                x = Vec3(11.57 + degrees * x.x, 48.13 + 0.67 * degrees * x.y, 520.0 + x.z);
            const Diagnosis diagnosis = examined(file);
            const Finding* finding = findingOf(diagnosis, "mixed_units");
            const bool found = finding != nullptr && findingOf(diagnosis, "twins") == nullptr &&
                               findingOf(diagnosis, "lines") == nullptr;
            ++count;
            right += found ? 1 : 0;
            if (!found) MESSAGE("degrees ", degrees, ": ", problemNames(diagnosis));
            if (finding == nullptr) continue;
            // Points of one height are neighbors, across the whole shape.
            CHECK(finding->lines.size() >= 300);
            const auto across = std::count_if(
                finding->lines.begin(), finding->lines.end(), [&](const EvidenceLine& line) {
                    const Vec3 way = glm::abs(line.to - line.from) / diagnosis.facts.extent();
                    return !line.asItShouldBe && std::max(way.x, way.y) > 3.0 * way.z;
                });
            CHECK(20 * static_cast<std::size_t>(across) > 9 * finding->lines.size());
            // With equal spans they are farther away in height.
            double height[] = {0.0, 0.0};
            for (const EvidenceLine& line : finding->lines)
                height[line.asItShouldBe ? 1 : 0] += std::abs(line.to.z - line.from.z);
            CHECK(height[1] > 5.0 * height[0]);
        }
    }
    MESSAGE("mixed_units: ", right, " of ", count, " planted files judged right");
    CHECK(right * 20 >= count * 19);
}

TEST_CASE("doctor: long thin parts and flat ones have one unit" * doctest::test_suite("long")) {
    for (const Vec3& scale : {Vec3(400.0, 1.0, 1.0), Vec3(1.0, 1.0, 0.002), Vec3(3.0, 2.0, 1.0)}) {
        // A tube, its points as far apart along it as around.
        PointFile file;
        file.positionType = ScalarType::Double;
        const int rings = static_cast<int>(10.0 * scale.x);
        for (int ring = 0; ring < rings; ++ring) {
            for (int i = 0; i < 20; ++i) {
                const double a = 2.0 * std::numbers::pi * (i + 0.5 * (ring % 2)) / 20.0;
                file.position.emplace_back(0.3 * ring, scale.y * std::cos(a),
                                           scale.z * std::sin(a));
            }
        }
        CHECK(findingOf(examined(file), "mixed_units") == nullptr);
    }
}

namespace {

constexpr double kLatitude = 48.13;

/// The meters of a shape as degrees around a place, longitude first.
PointFile inDegrees(PointFile file) {
    const double east = 111320.0 * std::cos(kLatitude * std::numbers::pi / 180.0);
    file.positionType = ScalarType::Double;
    file.normal.clear();
    for (Vec3& x : file.position)
        x = Vec3(11.57 + x.x / east, kLatitude + x.y / 111132.0, 520.0 + x.z);
    return file;
}

void swapXY(PointFile& file) {
    for (Vec3& x : file.position) std::swap(x.x, x.y);
}

std::string unitRemedy(const PointFile& file) {
    const Diagnosis diagnosis = examined(file);
    const Finding* finding = findingOf(diagnosis, "mixed_units");
    return finding == nullptr ? "no finding" : remedyFor(*finding, "a.xyz");
}

}  // namespace

TEST_CASE("doctor: degrees beside meters are converted, in the order that spreads points evenly") {
    for (const PointFile& shape : shapes(3)) {
        PointFile file = inDegrees(shape);
        CHECK(unitRemedy(file) == "spiraling-edge run a.xyz --scale-by 74300,111132,1 -o OUT.ply");
        const PointFile converted = scaled(file, Vec3(74300.0, 111132.0, 1.0));
        CHECK(problemNames(converted) == "no_normals ");
        swapXY(file);
        CHECK(unitRemedy(file) == "spiraling-edge run a.xyz --scale-by 111132,74300,1 -o OUT.ply");
    }
}

TEST_CASE("doctor: the sentence on mixed units says what they are converted to") {
    PointFile file = inDegrees(shapes(3).front());
    const auto text = [](const PointFile& points) {
        return findingOf(examined(points), "mixed_units")->text;
    };
    CHECK(text(file).find("; with x and y as degrees of longitude and latitude, in meters, ") !=
          std::string::npos);
    CHECK(text(file).find("if x is") == std::string::npos);
    swapXY(file);
    CHECK(text(file).find("as degrees of latitude and longitude, in meters, ") !=
          std::string::npos);
    // On a grid of degrees the points do not tell the order.
    PointFile grid;
    grid.positionType = ScalarType::Double;
    for (int i = 0; i < 30; ++i) {
        for (int j = 0; j < 30; ++j)
            grid.position.emplace_back(11.5 + 1e-5 * i, 48.1 + 1e-5 * j,
                                       500.0 + 2.0 * std::sin(0.2 * i) + 2.0 * std::cos(0.2 * j));
    }
    CHECK(
        text(grid).ends_with(" are (if x is the latitude in degrees: --scale-by 111132,109085,1)"));
}

TEST_CASE("doctor: millimeters beside meters are converted, on each axis") {
    const std::array factors{"0.001,1,1", "1,0.001,1", "1,1,0.001"};
    int found = 0;
    for (const PointFile& shape : shapes(2)) {
        for (int axis = 0; axis < 3; ++axis) {
            PointFile file = shape;
            file.positionType = ScalarType::Double;
            file.normal.clear();
            for (Vec3& x : file.position) {
                x += 1000.0;
                x[axis] *= 1000.0;
            }
            const std::string remedy = unitRemedy(file);
            // Not every shape is found on every axis: see the planted files above.
            if (remedy == "no finding") continue;
            ++found;
            CHECK(remedy == "spiraling-edge run a.xyz --scale-by " +
                                std::string(factors[static_cast<std::size_t>(axis)]) +
                                " -o OUT.ply");
        }
    }
    CHECK(found >= 14);
}

TEST_CASE("doctor: kilometers beside meters are no degrees, though both make a surface") {
    for (const Vec3& origin : {Vec3(0.0), Vec3(2.0, 3.0, 50.0), Vec3(691.2, 5335.4, 520.0)}) {
        PointFile hills;
        hills.positionType = ScalarType::Double;
        Random random(4);
        for (int p = 0; p < 2500; ++p) {
            const double x = 0.04 * (p % 50) + random.between(-0.01, 0.01);
            const double y = 0.04 * (p / 50) + random.between(-0.01, 0.01);
            hills.position.push_back(origin +
                                     Vec3(x, y, 150.0 * std::sin(2.0 * x) * std::cos(1.5 * y)));
        }
        const Finding finding = findingIn(hills, "mixed_units");
        // Where gentle hills can be either, both are said.
        const bool isFirst = remedyFor(finding, "a.xyz") ==
                             "spiraling-edge run a.xyz --scale-by 1,1,0.001 -o OUT.ply";
        CHECK((isFirst || finding.text.find("if they are kilometers beside meters: --scale-by "
                                            "1,1,0.001") != std::string::npos));
        if (origin == Vec3(0.0) || origin.x > 180.0) CHECK(isFirst);
    }
}

TEST_CASE("doctor: heights in feet beside meters are recognized by normals that fit in one unit") {
    PointFile file = fibonacciSphere(1500);
    for (Vec3& x : file.position) x.z /= 0.3048;
    const Finding finding = findingIn(file, "unfit_normals");
    CHECK(
        finding.text.ends_with("they fit the points in one unit: --scale-by 1,1,0.3048 "
                               "--derive-normals"));
}

TEST_CASE("doctor: units without a conversion that makes a surface have advice alone") {
    PointFile file = inDegrees(fibonacciSphere(600));
    for (Vec3& x : file.position) x.x += 300.0;
    const Finding finding = findingIn(file, "mixed_units");
    CHECK_FALSE(finding.hasRemedy());
    CHECK(remedyFor(finding, "a.xyz").empty());
    CHECK(finding.text.ends_with(" with equal spans"));
}

TEST_CASE("doctor: an extreme size is noted, with a power of two that robust works with as usual") {
    PointFile usual = fibonacciSphere(600);
    Random random(12);
    for (Vec3& x : usual.position) x *= random.between(0.98, 1.02);
    const auto meshOf = [](const PointFile& file) {
        const PointSet points = prepared(file);
        const auto run = runAll(points, robust());
        return std::vector<Triangle>(run.state.mesh().begin(), run.state.mesh().end());
    };
    CHECK(findingOf(examined(usual), "extreme_size") == nullptr);
    for (const int power : {-500, -120, 120, 500}) {
        const PointFile extreme = scaled(usual, Vec3(std::ldexp(1.0, power)));
        const Finding finding = findingIn(extreme, "extreme_size");
        CHECK(finding.severity == Severity::Note);
        CHECK(meshOf(scaled(extreme, *finding.scale)) == meshOf(usual));
    }
}

// ---- digits -------------------------------------------------------------------------------------

namespace {

/// The points scaled to this distance of the nearest, at map coordinates, without normals.
PointFile onMap(PointFile file, double distance) {
    const double scale = distance / nearestOf(file);
    file.positionType = ScalarType::Double;
    file.normal.clear();
    for (Vec3& x : file.position) x = Vec3(691000.0, 5335000.0, 520.0) + scale * x;
    return file;
}

void roundToFloats(PointFile& file) {
    constexpr int kBits = 23;
    for (Vec3& x : file.position) {
        for (int axis = 0; axis < 3; ++axis) {
            const double step = std::ldexp(1.0, std::ilogb(x[axis]) - kBits);
            x[axis] = std::round(x[axis] / step) * step;
        }
    }
}

void roundToSixDigits(PointFile& file) {
    for (Vec3& x : file.position) {
        for (int axis = 0; axis < 3; ++axis) {
            const double step = std::pow(10.0, std::floor(std::log10(x[axis])) - 5.0);
            x[axis] = std::round(x[axis] / step) * step;
        }
    }
}

}  // namespace

TEST_CASE("doctor: lost digits are found in 95 of 100 files, and no others" *
          doctest::test_suite("long")) {
    struct Rounding {
        void (*round)(PointFile&);
        std::array<double, 3> lost;  ///< Distances of the nearest.
        double kept;
        const char* words;
    };
    // Steps of y: 0.5 and 10.
    const std::array roundings{
        Rounding{roundToFloats, {0.3, 0.6, 1.0}, 5.0, "y keeps steps of 0.5: digits were lost"},
        Rounding{roundToSixDigits, {3.0, 10.0, 20.0}, 100.0, "y keeps steps of 10: digits"}};
    int count = 0;
    int right = 0;
    const auto judge = [&](bool isRight, const Diagnosis& diagnosis) {
        ++count;
        right += isRight ? 1 : 0;
        const Finding* finding = findingOf(diagnosis, "lost_digits");
        if (!isRight) {
            MESSAGE("spacing ", diagnosis.facts.nearestMedian, ": ", problemNames(diagnosis),
                    finding == nullptr ? "" : finding->text);
        }
    };
    for (const PointFile& shape : shapes(3)) {
        for (const Rounding& rounding : roundings) {
            for (const double distance : rounding.lost) {
                PointFile file = onMap(shape, distance);
                CHECK(findingOf(examined(file), "lost_digits") == nullptr);
                rounding.round(file);
                const Diagnosis diagnosis = examined(file);
                const Finding* finding = findingOf(diagnosis, "lost_digits");
                judge(finding != nullptr && finding->text.find(rounding.words) != std::string::npos,
                      diagnosis);
            }
            PointFile fine = onMap(shape, rounding.kept);
            rounding.round(fine);
            const Diagnosis diagnosis = examined(fine);
            judge(findingOf(diagnosis, "lost_digits") == nullptr, diagnosis);
        }
    }
    MESSAGE("lost_digits: ", right, " of ", count, " planted files judged right");
    CHECK(right * 20 >= count * 19);
}

TEST_CASE("doctor: a grid whose steps are those of the points lost no digits") {
    PointFile field;
    PointFile voxels;
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x) {
            const double z = 3.0 * std::sin(0.3 * x) * std::cos(0.2 * y);
            field.position.emplace_back(691000.0 + x, 5335000.0 + y, 520.0 + z);
            voxels.position.emplace_back(691000.0 + x, 5335000.0 + y, 52000.0 + std::round(z));
        }
    }
    for (const PointFile& file : {field, voxels})
        CHECK(findingOf(examined(file), "lost_digits") == nullptr);
}

TEST_CASE("doctor: a grid of any width at any offset lost no digits, rounded in one axis it did") {
    for (const double step : {0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 7.0}) {
        for (const double offset : {0.0, 0.5}) {
            CAPTURE(step);
            PointFile grid;
            PointFile scattered;
            Random random(5);
            for (int i = 0; i < 900; ++i) {
                const double x = i % 30;
                const double y = i / 30;
                const double z = std::round(100.0 * step * std::sin(0.3 * x) * std::cos(0.2 * y));
                const Vec3 origin(500000.0 + offset, 5400000.0 + offset, 0.01 * z);
                grid.position.push_back(origin + step * Vec3(x, y, 0.0));
                const Vec3 moved(x + random.between(-0.4, 0.4), y + random.between(-0.4, 0.4), 0.0);
                scattered.position.push_back(origin + step * moved);
                scattered.position.back().y =
                    2.0 * step * std::round(scattered.position.back().y / (2.0 * step));
            }
            CHECK(findingOf(examined(grid), "lost_digits") == nullptr);
            const bool rounded = step == 0.25 || step == 0.5;  // To steps of floats.
            if (rounded) CHECK(findingOf(examined(scattered), "lost_digits") != nullptr);
        }
    }
}

TEST_CASE("doctor: the two sides of a thin plate are no twins, since their normals oppose") {
    PointFile plate;
    for (int i = 0; i < 400; ++i) {
        for (const double side : {-1.0, 1.0}) {
            plate.position.emplace_back(i % 20, i / 20, 0.05 * side);
            plate.normal.emplace_back(0.0, 0.0, side);
        }
    }
    CHECK(findingOf(examined(plate), "twins") == nullptr);
    plate.normal.clear();
    CHECK(findingOf(examined(plate), "twins") != nullptr);
}

// ---- sentinels ----------------------------------------------------------------------------------

namespace {

/// Gives every n-th point another place.
template <typename Place>
void replaceEvery(std::size_t n, PointFile& file, Place&& place) {
    for (std::size_t p = 1; p < file.position.size(); p += n) place(file.position[p]);
}

/// One point in this many, by strength: a few, one in fifty, one in four.
std::size_t everyOf(const PointFile& file, std::size_t strength) {
    return std::array<std::size_t, 3>{file.position.size() / 3, 50, 4}[strength];
}

/// Zeros, as of a camera that the surface lies in front of.
void plantZeros(PointFile& file, std::size_t strength, Random& /*random*/) {
    for (Vec3& x : file.position) x += Vec3(0.0, 0.0, 3.0);
    replaceEvery(everyOf(file, strength), file, [](Vec3& x) { x = Vec3(0.0); });
}

/// Heights where a raster has none.
void plantHeights(PointFile& file, std::size_t strength, Random& /*random*/) {
    for (Vec3& x : file.position) x = 300.0 * x + Vec3(4e5, 5e6, 500.0);
    replaceEvery(everyOf(file, strength), file, [](Vec3& x) { x.z = -9999.0; });
}

/// The greatest value of sixteen bits, in millimeters.
void plantGreatest(PointFile& file, std::size_t strength, Random& /*random*/) {
    for (Vec3& x : file.position) x = 1000.0 * x + Vec3(0.0, 0.0, 3000.0);
    replaceEvery(everyOf(file, strength), file, [](Vec3& x) { x.z = 65535.0; });
}

/// The least float, as rasters have it.
void plantFloat(PointFile& file, std::size_t strength, Random& /*random*/) {
    replaceEvery(everyOf(file, strength), file, [](Vec3& x) { x.z = -3.4028234663852886e38; });
}

/// Huge values, each point another one.
void plantHuge(PointFile& file, std::size_t strength, Random& random) {
    const double size = std::array{1e7, 1e10, 3.4e38}[strength];
    for (std::size_t p = 0; p < 5; ++p) file.position[40 * p] = size * random.direction();
}

}  // namespace

TEST_CASE("doctor: missing values are found in 95 of 100 files, and the rest is as without them" *
          doctest::test_suite("long")) {
    CHECK(shareFound("sentinels", {{"zeros", plantZeros, "(0, 0, 0)"},
                                   {"float", plantFloat, "-3.4028234663852886e+38"},
                                   {"heights", plantHeights, "-9999"},
                                   {"greatest", plantGreatest, "65535"},
                                   {"huge", plantHuge, "far off"}}) >= 95.0);
}

TEST_CASE("doctor: missing values are set aside, and the rest is measured without them") {
    Random random(2);
    for (std::size_t strength = 0; strength < 3; ++strength) {
        PointFile file = shapes(1).front();
        plantZeros(file, strength, random);
        PointFile without = file;
        std::erase(without.position, Vec3(0.0));
        without.normal.resize(without.position.size());
        const Diagnosis diagnosis = examined(file);
        const InputFacts& facts = diagnosis.facts;
        CHECK(facts.count(Aside::Sentinel) == file.position.size() - without.position.size());
        without.normal.clear();
        const InputFacts right = examined(without).facts;
        CHECK(facts.extent() == right.extent());
        CHECK(facts.nearestMost == right.nearestMost);
        const FixedFile fixed = applyFixes(file);
        CHECK(fixed.file.position == without.position);
    }
}

TEST_CASE("doctor: parts of a scan are no missing values, wherever they lie") {
    // A level plane at a round height, alone and as most of the points; a wall at a round value.
    PointFile plane = flatLattice(20, 0.0);
    for (Vec3& x : plane.position) x.z = 10000.0;
    CHECK(examined(plane).facts.count(Aside::Sentinel) == 0);
    PointFile beside = plane;
    append(beside, moved(ball(), Vec3(10.0, 10.0, 50.0)));
    CHECK(examined(beside).facts.count(Aside::Sentinel) == 0);
    PointFile millimeters = moved(fibonacciSphere(4000), Vec3(8000.0, 8000.0, 8000.0), 1500.0);
    for (std::size_t p = 0; p < 200; ++p)
        millimeters.position[p] = Vec3(8000.0 + 100.0 * static_cast<double>(p % 20),
                                       8000.0 + 100.0 * static_cast<double>(p / 20), 10000.0);
    CHECK(examined(millimeters).facts.count(Aside::Sentinel) == 0);
    // A second scan, 3,000 radii away.
    PointFile far = fibonacciSphere(4700);
    append(far, moved(fibonacciSphere(240), Vec3(3000.0, 0.0, 0.0)));
    CHECK(examined(far).facts.count(Aside::Sentinel) == 0);
    // The apex of a cone whose triangles do not share their corners.
    PointFile cone;
    for (int i = 0; i < 300; ++i) {
        for (const double turn : {i / 300.0, (i + 1) / 300.0}) {
            const double angle = 2.0 * std::numbers::pi * turn;
            cone.position.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        }
        cone.position.emplace_back(0.0, 0.0, 1.0);
    }
    CHECK(examined(cone).facts.count(Aside::Sentinel) == 0);
    // A single point in a hollow one.
    PointFile hollow = fibonacciSphere(600);
    hollow.position.emplace_back(0.0, 0.0, 0.0);
    hollow.normal.emplace_back(0.0, 0.0, 1.0);
    CHECK(examined(hollow).facts.count(Aside::Sentinel) == 0);
}

TEST_CASE("doctor: a point at the origin, or at a place of several, is none where others are") {
    for (PointFile file : shapes(2)) {
        const Vec3 first = file.position.front();
        for (Vec3& x : file.position) x -= first;
        for (int i = 0; i < 5; ++i) {
            file.position.push_back(file.position[9]);
            file.normal.push_back(file.normal[9]);
        }
        CHECK(examined(file).facts.count(Aside::Sentinel) == 0);
    }
}
