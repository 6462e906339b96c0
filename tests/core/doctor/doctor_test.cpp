/// Each check of the doctor: a problem planted alone is found, where it was planted, and no other
/// is found.
#include "spiraling_edge/doctor/doctor.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "doctor_support.h"
#include "spiraling_edge/scenes/scenes.h"

using namespace se;
using namespace se::test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A wavy sheet in a box, typed.
PointFile sheet() { return sampleSheet(wavySheet(), 12, 160, 1); }

Index firstOfType(const PointFile& file, std::uint8_t type) {
    const auto found = std::find(file.type.begin(), file.type.end(), type);
    REQUIRE(found != file.type.end());
    return static_cast<Index>(found - file.type.begin());
}

}  // namespace

// ---- clean inputs -------------------------------------------------------------------------------

TEST_CASE("doctor: even samples of closed surfaces are not accused") {
    for (const Family& family : closedFamilies(1.5)) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
            CHECK_MESSAGE(problemNames(family.sample(seed)) == "", family.name, ", seed ", seed);
    }
}

TEST_CASE("doctor: of the built-in scenes only the exact lattice is accused") {
    for (const Scene& scene : scenes()) {
        // A dozen points, most of them without lists.
        if (scene.start != nullptr) continue;
        CHECK_MESSAGE(problemNames(scene.build()) == (scene.id == "grid" ? "ties " : ""), scene.id);
    }
}

TEST_CASE("doctor: of few points, heights over a fit are the shape, and no noise or layers") {
    for (const std::size_t count : {20U, 40U, 60U, 100U, 140U}) {
        for (const double flatness : {1.0, 0.35}) {
            for (const bool given : {true, false}) {
                PointFile file = fibonacciSphere(count);
                for (Vec3& x : file.position) x.z *= flatness;
                for (Vec3& n : file.normal) n = glm::normalize(n / Vec3(1.0, 1.0, flatness));
                if (!given) file.normal.clear();
                const Diagnosis diagnosis = examined(file);
                CHECK(findingOf(diagnosis, "two_layers") == nullptr);
                const Finding* noise = findingOf(diagnosis, "noise");
                CHECK((noise == nullptr || noise->severity == Severity::Note));
            }
        }
    }
}

TEST_CASE("doctor: noise, rough normals and missing points are no faults") {
    Random random(7);
    for (const Family& family : closedFamilies(1.5)) {
        PointFile file = family.sample(4);
        PointFile rough;
        for (Index p = 0; p < file.position.size(); ++p) {
            if (random.below(7) == 0) continue;
            // A fifth of the spacing; 20 degrees.
            rough.position.push_back(file.position[p] + 0.03 * random.inCube());
            rough.normal.push_back(glm::normalize(file.normal[p] + 0.36 * random.direction()));
        }
        CHECK_MESSAGE(problemNames(rough) == "", family.name);
    }
}

TEST_CASE("doctor: findings depend on shape, not on size or place") {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        CHECK(problemNames(moved(ball(), Vec3(0.0), scale)) == "");
        CHECK(problemNames(moved(ball(), 100.0 * scale * Vec3(1, 2, 3), scale)) == "");
    }
}

// ---- single points ------------------------------------------------------------------------------

TEST_CASE("doctor: non_finite finds positions, zero_normals finds normals, each value by itself") {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double value : {kNan, kInfinity, -kInfinity}) {
            PointFile file = ball();
            file.position[5][axis] = value;
            checkAlone(file, "non_finite", {5}, Severity::Error);
            file = ball();
            file.normal[9][axis] = value;
            checkAlone(file, "zero_normals", {9}, Severity::Warning);
        }
    }
}

TEST_CASE("doctor: duplicates are the later ones of points at one place") {
    PointFile file = ball();
    const auto first = static_cast<Index>(file.position.size());
    for (const Index p : {17U, 3U, 17U}) {
        file.position.push_back(file.position[p]);
        file.normal.push_back(file.normal[p]);
    }
    checkAlone(file, "duplicates", {first, first + 1, first + 2}, Severity::Warning);
}

TEST_CASE("doctor: near_duplicates are nearer than a thousandth of the spacing") {
    // The spacing of 300 points on the unit sphere is 0.22.
    for (const double distance : {1e-9, 1e-5, 1.5e-4, 1e-3, 2e-2}) {
        PointFile file = ball();
        const auto twin = static_cast<Index>(file.position.size());
        const Vec3 aside = glm::normalize(glm::cross(file.normal[8], Vec3(1, 2, 3)));
        file.position.push_back(file.position[8] + distance * aside);
        file.normal.push_back(file.normal[8]);
        if (distance < 2e-4) {
            checkAlone(file, "near_duplicates", {twin}, Severity::Warning);
        } else {
            CHECK(problemNames(file) == "");
        }
    }
}

TEST_CASE("doctor: too_few_points distinguishes no triangle and one triangle") {
    for (const std::size_t count : {0U, 1U, 2U, 3U, 4U}) {
        PointFile file;
        const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1.3, 1.1, 0.2}};
        file.position.assign(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(count));
        file.normal.assign(count, Vec3(0, 0, 1));
        if (count == 4) {
            CHECK(problemNames(file) == "");
        } else {
            checkAlone(file, "too_few_points", {},
                       count == 3 ? Severity::Warning : Severity::Error);
        }
    }
}

// ---- spacing ------------------------------------------------------------------------------------

TEST_CASE("doctor: isolated_points are single ones and pairs that no list would take") {
    PointFile file = ball();
    const auto first = static_cast<Index>(file.position.size());
    for (const Vec3& x : {Vec3(9, 0, 0), Vec3(-20, 3, 0), Vec3(-20, 3.3, 0)}) {
        file.position.push_back(x);
        file.normal.emplace_back(0, 0, 1);
    }
    checkAlone(file, "isolated_points", {first, first + 1, first + 2}, Severity::Warning);
}

TEST_CASE("doctor: small components are not isolated points") {
    PointFile file = ball();
    append(file, moved(ball(), Vec3(50, 0, 0)));
    PointFile corner = moved(ball(2), Vec3(0, 50, 0));
    corner.position.resize(14);
    corner.normal.resize(14);
    CHECK(problemNames(file) == "");
}

TEST_CASE("doctor: in_line finds a line, whichever way it runs") {
    PointFile file;
    file.positionType = ScalarType::Double;
    for (int i = 0; i < 30; ++i) {
        file.position.push_back((1.0 + i * 0.37) * Vec3(1, -2, 0.5));
        file.normal.emplace_back(0, 0, 1);
    }
    checkAlone(file, "in_line", allOf(file), Severity::Error);
}

TEST_CASE("doctor: uneven_spacing is a note") {
    PointFile file = closedFamilies(3.0)[0].sample(1);
    const auto first = static_cast<Index>(file.position.size());
    append(file, moved(ball(), Vec3(3, 0, 0), 0.05));
    checkAlone(file, "uneven_spacing", allOf(file, first), Severity::Note);
    CHECK(findingOf(examined(closedFamilies(3.0)[0].sample(1)), "uneven_spacing") == nullptr);
}

TEST_CASE("doctor: ties are found on exact lattices, turned ones too, and not after a jitter") {
    PointFile file = flatLattice(12, 0.0);
    checkAlone(file, "ties", allOf(file), Severity::Warning);
    const Vec3 u(0.6, 0.8, 0.0);
    const Vec3 v(-0.8, 0.6, 0.0);
    for (Vec3& x : file.position) x = Vec3(5.0) + x.x * u + x.y * v;
    checkAlone(file, "ties", allOf(file), Severity::Warning);
    CHECK(findingOf(examined(flatLattice(12, 1e-3)), "ties") == nullptr);
}

TEST_CASE("doctor: ties in a part of the set are a note") {
    PointFile file = flatLattice(12, 0.2);
    for (Index p = 0; p < 72; ++p) file.position[p] = flatLattice(12, 0.0).position[p];
    const Diagnosis diagnosis = examined(file);
    REQUIRE(findingOf(diagnosis, "ties") != nullptr);
    CHECK(findingOf(diagnosis, "ties")->severity == Severity::Note);
    CHECK(problemNames(diagnosis) == "");
}

// ---- normals ------------------------------------------------------------------------------------

TEST_CASE("doctor: no_normals, zero_normals and unscaled_normals") {
    PointFile file = ball();
    file.normal.clear();
    checkAlone(file, "no_normals", {}, Severity::Warning);
    file = ball();
    file.normal[4] = file.normal[11] = Vec3(0.0);
    checkAlone(file, "zero_normals", {4, 11}, Severity::Warning);
    file = ball();
    file.normal[2] *= 1e-200;
    file.normal[3] *= 1.01;
    file.normal[4] *= 1.0005;  // Few digits in a file do no harm.
    file.normal[5] *= 1e200;
    checkAlone(file, "unscaled_normals", {2, 3, 5}, Severity::Warning);
}

TEST_CASE("doctor: flipped_normals finds single points and scattered ones") {
    // So dense that no point has its neighbors on another tube.
    for (const Family& family : closedFamilies(3.0)) {
        PointFile file = family.sample(1);
        const auto one = turn(file, [](Index p) { return p == 77; });
        checkAlone(file, "flipped_normals", one, Severity::Warning);
        file = family.sample(1);
        Random random(3);
        const auto tenth = turn(file, [&](Index) { return random.below(10) == 0; });
        checkAlone(file, "flipped_normals", tenth, Severity::Warning);
    }
}

TEST_CASE("doctor: flipped_normals finds patches, and what is right within them is right") {
    const PointFile good = closedFamilies(3.0)[0].sample(1);
    const auto height = [&](Index p) { return good.position[p].z; };
    for (const double from : {0.9, 0.5, 0.1}) {
        PointFile file = good;
        const auto cap = turn(file, [&](Index p) { return height(p) > from; });
        checkAlone(file, "flipped_normals", cap, Severity::Warning);
    }
    PointFile file = good;
    const auto ring = turn(file, [&](Index p) { return height(p) > 0.2 && height(p) < 0.8; });
    checkAlone(file, "flipped_normals", ring, Severity::Warning);
}

TEST_CASE("doctor: the sides of a plate thinner than the spacing are none flipped") {
    for (const double thick : {0.3, 0.4}) {
        for (const bool isSlot : {false, true}) {
            PointFile plate = flatLattice(30, 0.3, 1);
            PointFile below = flatLattice(30, 0.3, 2);
            for (std::size_t p = 0; p < below.position.size(); ++p) {
                below.position[p].z += isSlot ? thick : -thick;
                below.normal[p] = -below.normal[p];
            }
            append(plate, below);
            CHECK(findingOf(examined(plate), "flipped_normals") == nullptr);
        }
    }
}

TEST_CASE("doctor: unfit_normals finds a patch of normals by chance, or along the surface") {
    Random random(8);
    for (const double share : {0.02, 0.08}) {
        for (const bool byChance : {true, false}) {
            PointFile file = fibonacciSphere(3000);
            std::vector<Index> patch;
            for (Index p = 0; p < 3000; ++p) {
                if (file.position[p].x < 1.0 - 2.0 * share) continue;
                patch.push_back(p);
                const Vec3 along = glm::cross(file.normal[p], Vec3(0.0, 0.6, 0.8));
                file.normal[p] = byChance ? random.direction() : glm::normalize(along);
            }
            const Diagnosis diagnosis = examined(file);
            CHECK(diagnosis.facts.normalsFit);
            const Finding* finding = findingOf(diagnosis, "unfit_normals");
            REQUIRE(finding != nullptr);
            CHECK(2 * finding->points.size() > patch.size());
            CHECK(std::includes(patch.begin(), patch.end(), finding->points.begin(),
                                finding->points.end()));
            // They are of one sheet, whatever they say.
            const Finding* sheets = findingOf(diagnosis, "close_sheets");
            CHECK((sheets == nullptr || 20 * sheets->points.size() < patch.size()));
        }
    }
}

TEST_CASE("doctor: flipped_normals finds the part of an open sheet, up to its rim") {
    for (const int columns : {1, 4, 9}) {
        PointFile file = flatLattice(20, 0.2);
        const auto side = turn(file, [&](Index p) { return static_cast<int>(p % 20) < columns; });
        checkAlone(file, "flipped_normals", side, Severity::Warning);
    }
}

TEST_CASE("doctor: sharp edges, thin sheets and the end of a sheet flip nothing") {
    PointFile slab;  // Two sides and a sharp rim, thinner than the spacing.
    for (const double side : {1.0, -1.0}) {
        PointFile face = flatLattice(16, 0.2, side > 0 ? 1 : 2);
        for (Vec3& x : face.position) x.z = 0.3 * side;
        for (Vec3& n : face.normal) n.z = side;
        append(slab, face);
    }
    CHECK(findingOf(examined(slab), "flipped_normals") == nullptr);
    PointFile cube;
    for (int face = 0; face < 6; ++face) {
        const PointFile flat = flatLattice(9, 0.15, static_cast<std::uint64_t>(face));
        const int axis = face / 2;
        const double sign = face % 2 == 0 ? 1.0 : -1.0;
        for (const Vec3& x : flat.position) {
            Vec3 place(4.5 * sign);
            place[(axis + 1) % 3] = x.x - 4.0;
            place[(axis + 2) % 3] = x.y - 4.0;
            Vec3 normal(0.0);
            normal[axis] = sign;
            cube.position.push_back(place);
            cube.normal.push_back(normal);
        }
    }
    CHECK(problemNames(cube) == "");
}

TEST_CASE("doctor: inside_out finds closed components with normals inward") {
    PointFile file = ball();
    const auto all = turn(file, [](Index) { return true; });
    checkAlone(file, "inside_out", all, Severity::Warning);

    file = ball();
    const auto first = static_cast<Index>(file.position.size());
    append(file, moved(ball(2), Vec3(4, 0, 0)));
    const auto second = turn(file, [&](Index p) { return p >= first; });
    checkAlone(file, "inside_out", second, Severity::Warning);
}

TEST_CASE("doctor: of components whose side their shape does not tell the number is given") {
    const auto textOf = [](const PointFile& file, const char* name) {
        const Diagnosis diagnosis = examined(file);
        const Finding* found = findingOf(diagnosis, name);
        return found == nullptr ? std::string{} : found->text;
    };
    PointFile sheet = flatLattice(14, 0.2, 1);
    PointFile file = ball();
    turn(file, [](Index) { return true; });
    append(file, moved(sheet, Vec3(9, 0, 0)));
    CHECK(textOf(file, "inside_out").ends_with("which side faces out is unknown for 1 of 2 parts"));
    sheet.normal.clear();
    CHECK(textOf(sheet, "no_normals") ==
          "the file has no normals; which side faces out is unknown");
    file = ball();
    file.normal.clear();
    CHECK(textOf(file, "no_normals") == "the file has no normals");
}

TEST_CASE("doctor: cavities and open sheets may have normals inward") {
    PointFile file = ball();
    const auto first = static_cast<Index>(file.position.size());
    append(file, moved(ball(2), Vec3(0.1, 0, 0), 0.6));
    turn(file, [&](Index p) { return p >= first; });
    CHECK(problemNames(file) == "");

    PointFile bowl;
    const PointFile whole = closedFamilies(2.0)[0].sample(1);
    for (Index p = 0; p < whole.position.size(); ++p) {
        if (whole.position[p].z > 0.1) continue;
        bowl.position.push_back(whole.position[p]);
        bowl.normal.push_back(-whole.normal[p]);
    }
    CHECK(problemNames(bowl) == "");
}

TEST_CASE("doctor: close_sheets accuses if it is the set as a whole") {
    PointFile file = flatLattice(14, 0.2, 1);
    PointFile below = flatLattice(14, 0.2, 2);
    for (Vec3& x : below.position) x.z = -0.2;
    for (Vec3& n : below.normal) n.z = -1;
    append(file, below);
    const Diagnosis diagnosis = examined(file);
    CHECK(problemNames(diagnosis) == "close_sheets ");

    // As a small part of a larger set, the same sheets are a fact of its shape, and no problem.
    append(file, moved(flatLattice(40, 0.2, 3), Vec3(100, 0, 0)));
    const Diagnosis thinPart = examined(file);
    CHECK(problemNames(thinPart) == "");
    REQUIRE(findingOf(thinPart, "close_sheets") != nullptr);
    CHECK(findingOf(thinPart, "close_sheets")->points ==
          findingOf(diagnosis, "close_sheets")->points);
}

// ---- lists --------------------------------------------------------------------------------------

TEST_CASE(
    "doctor: lists of the nearest points are not accused, that they are unsymmetric is noted") {
    const PointFile file = withLists(ball());
    const Diagnosis diagnosis = examined(file);
    CHECK(problemNames(diagnosis) == "");
    const Finding* finding = findingOf(diagnosis, "unsymmetric_lists");
    REQUIRE(finding != nullptr);
    std::size_t unanswered = 0;
    for (Index p = 0; p < file.position.size(); ++p) {
        for (const Index q : listOf(file, p)) {
            const auto back = listOf(file, q);
            if (std::find(back.begin(), back.end(), p) == back.end()) ++unanswered;
        }
    }
    CHECK(finding->count == unanswered);
}

TEST_CASE("doctor: lists that point outside, repeat, are unsorted or short") {
    PointFile file = withLists(ball());
    std::vector<Index> list = listOf(file, 6);
    list.push_back(static_cast<Index>(file.position.size()));
    setList(file, 6, list);
    checkAlone(file, "entries_outside", {6}, Severity::Error);

    file = withLists(ball());
    list = listOf(file, 6);
    list.insert(list.begin(), 6);  // Itself, at distance 0: still in order.
    setList(file, 6, list);
    list = listOf(file, 9);
    list.push_back(list.back());
    setList(file, 9, list);
    checkAlone(file, "repeated_entries", {6, 9}, Severity::Warning);

    file = withLists(ball());
    list = listOf(file, 20);
    std::swap(list[0], list[9]);
    setList(file, 20, list);
    checkAlone(file, "unsorted_lists", {20}, Severity::Warning);

    file = withLists(ball());
    list = listOf(file, 30);
    list.resize(2);
    setList(file, 30, list);
    setList(file, 31, {});
    checkAlone(file, "short_lists", {30, 31}, Severity::Warning);
}

TEST_CASE("doctor: a point that is set aside anyway may have a short list") {
    PointFile file = withLists(ball());
    file.position.push_back(file.position[7]);
    file.normal.push_back(file.normal[7]);
    file.neighbors.append({});
    const Diagnosis diagnosis = examined(file);
    CHECK(findingOf(diagnosis, "duplicates") != nullptr);
    CHECK(findingOf(diagnosis, "short_lists") == nullptr);
}

TEST_CASE("doctor: a far point that others list is not isolated") {
    // Of eleven points each lists all others, the far one too; of many none does.
    for (const int side : {3, 8}) {
        PointFile file = flatLattice(side, 0.1);
        file.position.emplace_back(100, 100, 0);
        file.normal.emplace_back(0, 0, 1);
        const Diagnosis diagnosis = examined(file);
        CHECK((findingOf(diagnosis, "isolated_points") != nullptr) == (side == 8));
    }
}

TEST_CASE("doctor: a component that walls cut may have normals inward") {
    PointFile file = ball();
    for (Vec3& n : file.normal) n = -n;
    file.type.assign(file.position.size(), kInterior);
    CHECK(problemNames(file).find("inside_out") != std::string::npos);
    file.type[5] = kPositiveX;
    CHECK(problemNames(file).find("inside_out") == std::string::npos);
}

TEST_CASE("doctor: fewer than twelve points enclose nothing") {
    // The six extremes of a ball in a row, each next to the one after it, and a point between each
    // two of them.
    const std::vector<Vec3> extremes{{1, 0, 0}, {0, 1, 0},  {-1, 0, 0},
                                     {0, 0, 1}, {0, -1, 0}, {0, 0, -1}};
    PointFile file;
    for (std::size_t i = 0; i < 6; ++i) {
        Vec3 out = extremes[i];
        if (i > 0) out += 0.1 * extremes[i - 1];
        if (i < 5) out += 0.1 * extremes[i + 1];
        file.position.push_back(extremes[i]);
        file.normal.push_back(-glm::normalize(out));
    }
    for (std::size_t i = 0; i + 1 < 6; ++i) {
        file.position.push_back(glm::normalize(extremes[i] + extremes[i + 1]));
        file.normal.push_back(glm::normalize(file.normal[i] + file.normal[i + 1]));
    }
    CHECK(problemNames(file).find("inside_out") == std::string::npos);
    file.position.push_back(glm::normalize(Vec3(0.3, 1, 0)));
    file.normal.push_back(-file.position.back());
    CHECK(problemNames(file).find("inside_out") != std::string::npos);
}

TEST_CASE("doctor: close_sheets is a warning from half of the points on, else a note") {
    for (const int rows : {2, 4, 6, 8, 10}) {
        CAPTURE(rows);
        PointFile file = flatLattice(10, 0.1);
        for (int i = 0; i < 10 * rows; ++i) {
            file.position.push_back(file.position[static_cast<std::size_t>(i)] + Vec3(0, 0, 0.3));
            file.normal.emplace_back(0, 0, -1);
        }
        const Finding finding = findingIn(file, "close_sheets");
        CHECK(finding.points.size() == static_cast<std::size_t>(20 * rows));
        // Two for each point of the second sheet, of 10 * (10 + rows).
        CHECK(finding.isProblem() == (4 * rows >= 10 + rows));
    }
}

TEST_CASE("doctor: at a wall two entries are enough for a fan, elsewhere three") {
    const auto found = [](unsigned type, std::size_t entries) {
        PointFile file = withLists(ball());
        file.type.assign(file.position.size(), kInterior);
        file.type[30] = static_cast<std::uint8_t>(type);
        std::vector<Index> list = listOf(file, 30);
        list.resize(entries);
        setList(file, 30, list);
        const Diagnosis diagnosis = examined(file);
        return findingOf(diagnosis, "short_lists") != nullptr;
    };
    CHECK_FALSE(found(kInterior, 3));
    CHECK(found(kInterior, 2));
    CHECK_FALSE(found(kPositiveX, 2));
    CHECK_FALSE(found(kRimPoint, 2));
    CHECK(found(kPositiveX, 1));
}

TEST_CASE("doctor: equal distances may be in any order") {
    PointFile file = withLists(flatLattice(12, 0.0), 8);
    for (Index p = 0; p < file.position.size(); ++p) {
        std::vector<Index> list = listOf(file, p);
        std::swap(list[0], list[1]);
        setList(file, p, list);
    }
    CHECK(findingOf(examined(file), "unsorted_lists") == nullptr);
}

// ---- types --------------------------------------------------------------------------------------

TEST_CASE("doctor: types that agree with the box are not accused") {
    CHECK(problemNames(sheet()) == "");
}

TEST_CASE("doctor: types_off_box finds bits too many, bits too few and points beyond") {
    PointFile file = sheet();
    Index p = firstOfType(file, kPositiveX);
    file.type[p] = kInterior;
    checkAlone(file, "types_off_box", {p}, Severity::Warning);

    file = sheet();
    p = firstOfType(file, kInterior);
    file.type[p] = kNegativeY;
    checkAlone(file, "types_off_box", {p}, Severity::Warning);

    file = sheet();
    p = firstOfType(file, kPositiveX);
    file.type[p] = kPositiveY;
    checkAlone(file, "types_off_box", {p}, Severity::Warning);

    file = sheet();
    p = firstOfType(file, kPositiveX);
    file.position[p].x += 0.01;
    checkAlone(file, "types_off_box", {p}, Severity::Warning);
}

TEST_CASE("doctor: a surface may touch a wall without ending there") {
    PointFile file = ball();
    const auto top = static_cast<Index>(file.position.size());
    file.position.emplace_back(0, 0, 1);
    file.normal.emplace_back(0, 0, 1);
    file.type.assign(file.position.size(), kInterior);
    PointFile upright = flatLattice(12, 0.2);  // Ends at the wall that the ball touches.
    for (Index p = 0; p < upright.position.size(); ++p) {
        const Vec3 x = upright.position[p];
        upright.position[p] = Vec3(0.2 * x.x, 4.0, p < 12 ? 1.0 : 1.0 - 0.2 * x.y);
        upright.normal[p] = Vec3(0, -1, 0);
        upright.type.push_back(p < 12 ? kPositiveZ : kInterior);
    }
    append(file, upright);
    CHECK(problemNames(file) == "");
    file.normal[top] = Vec3(1, 0, 0);
    checkAlone(file, "types_off_box", {top}, Severity::Warning);
}

TEST_CASE("doctor: corner_bits must be set exactly at two walls") {
    PointFile file = sheet();
    const Index corner = firstOfType(file, kPositiveX | kPositiveY | kCorner);
    const Index wall = firstOfType(file, kPositiveX);
    const Index inside = firstOfType(file, kInterior);
    file.type[corner] &= kFaceBits;
    file.type[wall] |= kCorner;
    file.type[inside] |= kCorner;
    const Index both = firstOfType(file, kPositiveY);  // No rim where a wall is.
    file.type[both] |= kRimPoint;
    std::vector<Index> points{corner, wall, inside, both};
    std::sort(points.begin(), points.end());
    checkAlone(file, "corner_bits", points, Severity::Warning);
}

// ---- the table, progress, errors ----------------------------------------------------------------

TEST_CASE("doctor: every check has a name of its own, a section and a sentence") {
    std::vector<std::string_view> names;
    for (const DoctorCheck& check : doctorChecks()) {
        CHECK((check.find != nullptr));
        CHECK(std::all_of(check.name.begin(), check.name.end(),
                          [](char c) { return c == '_' || (c >= 'a' && c <= 'z'); }));
        CHECK(check.section.size() >= 1);
        CHECK(check.upsets.back() == '.');
        CHECK((!check.hasSafeFix() || check.remedy().find("--fix") != std::string::npos));
        CHECK(findDoctorCheck(check.name) == &check);
        names.push_back(check.name);
    }
    std::sort(names.begin(), names.end());
    CHECK(std::unique(names.begin(), names.end()) == names.end());
    CHECK(findDoctorCheck("no_such") == nullptr);
}

TEST_CASE("doctor: the same file gives the same findings, errors first, then as in the table") {
    PointFile file = withLists(ball());
    file.normal[3] = Vec3(0.0);
    file.position[9] = Vec3(kNan);
    const std::vector<Finding> a = examined(file).findings;
    const std::vector<Finding> b = examined(file).findings;
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(a[i].text == b[i].text);
        CHECK(a[i].points == b[i].points);
        if (i == 0) continue;
        CHECK(a[i - 1].severity >= a[i].severity);
        if (a[i - 1].severity == a[i].severity) CHECK(a[i - 1].check < a[i].check);
    }
}

TEST_CASE("doctor: progress ascends from 0 to 1, and no ends the examination") {
    const PointFile file = closedFamilies(3.0)[3].sample(1);
    double last = 0.0;
    REQUIRE(examine(file, [&](double share) {
                CHECK(share >= last);
                last = share;
                return true;
            }).ok());
    CHECK(last == 1.0);
    for (const double until : {0.0, 0.6, 0.9}) {
        const auto cancelled = examine(file, [&](double share) { return share < until; });
        REQUIRE_FALSE(cancelled.ok());
        CHECK(cancelled.error().message.find("cancelled") != std::string::npos);
    }
}

TEST_CASE("doctor: columns that differ in length are an error") {
    PointFile file = ball();
    file.normal.pop_back();
    CHECK_FALSE(examine(file).ok());
}
