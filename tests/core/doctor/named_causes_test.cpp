/// Causes with a name of their own, each planted at three strengths on five shapes.
#include <array>
#include <cmath>
#include <numbers>

#include "doctor_support.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// Even points with normals: four closed shapes, and a wavy sheet.
std::vector<PointFile> shapes(std::uint64_t seed) {
    std::vector<PointFile> files;
    for (const Family& family : closedFamilies(kTubesApart)) files.push_back(family.sample(seed));
    files.push_back(sampleSheet(wavySheet(), 24, 900, seed));
    files.back().type.clear();
    return files;
}

/// A cause, planted into a file at strength 0, 1 or 2.
struct Cause {
    std::string name;
    void (*plant)(PointFile& file, std::size_t strength, Random& random);
    std::string words;  ///< That the finding must have.
};

/// Share of the planted files in which the check alone is found, in percent, and its words are
/// said.
double shareFound(const std::string& check, const std::vector<Cause>& causes) {
    int count = 0;
    int right = 0;
    Random random(5);
    for (const Cause& cause : causes) {
        for (std::size_t strength = 0; strength < 3; ++strength) {
            std::size_t shape = 0;
            for (PointFile& file : shapes(strength + 1)) {
                cause.plant(file, strength, random);
                const Diagnosis diagnosis = examined(file);
                const Finding* finding = findingOf(diagnosis, check);
                const bool found = finding != nullptr && problemNames(diagnosis) == check + " " &&
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

TEST_CASE("doctor: the five shapes as they are have no cause with a name") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        for (const PointFile& file : shapes(seed)) CHECK(problemNames(file) == "");
    }
}

// ---- normals that do not fit --------------------------------------------------------------------

namespace {

/// A unit vector at this angle to another one, by chance about it.
Vec3 tilted(const Vec3& normal, double degrees, Random& random) {
    const Vec3 across = glm::normalize(glm::cross(normal, random.direction()));
    const double angle = degrees * std::numbers::pi / 180.0;
    return std::cos(angle) * normal + std::sin(angle) * across;
}

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

TEST_CASE("doctor: normals that do not fit are found, with their kind, in 95 of 100 files") {
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
            const Diagnosis diagnosis = examined(withNormals(shape, plantBytes, strength));
            const Finding* finding = findingOf(diagnosis, "unfit_normals");
            REQUIRE(finding != nullptr);
            CHECK(finding->text.ends_with(strength == 0 ? "they fit as 2 v / 255 - 1"
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
    const Diagnosis rough = examined(file);
    const Finding* finding = findingOf(rough, "unfit_normals");
    REQUIRE(finding != nullptr);
    CHECK(finding->severity == Severity::Note);
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
