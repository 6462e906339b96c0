/// The repairs of the doctor that need no guess.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "doctor_support.h"
#include "spiraling_edge/io/write_mesh.h"
#include "support/random_points.h"

using namespace se;
using namespace se::test;

namespace {

std::map<std::string, std::size_t> repairsOf(const FixedFile& fixed) {
    std::map<std::string, std::size_t> counts;
    for (const AppliedFix& fix : fixed.fixes) counts[std::string(fix.name)] = fix.count;
    return counts;
}

/// A file with everything that can be repaired.
PointFile flawedFile() {
    PointFile file = withLists(ball());
    file.type.assign(file.position.size(), kInterior);
    Attribute number{"number", ScalarType::Int32, {}};
    for (std::size_t p = 0; p < file.position.size(); ++p)
        number.values.push_back(static_cast<double>(p));
    file.attributes.push_back(number);
    file.position[10].x = std::numeric_limits<double>::quiet_NaN();
    file.normal[20] = Vec3(0.0);
    file.position[30] = file.position[31];  // The copy is the later one: 31.
    file.normal[40] *= 17.0;
    file.type[50] = kCorner;
    std::vector<Index> list = listOf(file, 60);
    std::reverse(list.begin(), list.end());
    list.push_back(60);
    list.push_back(9999);
    setList(file, 60, list);
    return file;
}

}  // namespace

TEST_CASE("doctor: a healthy file is left as it is") {
    for (const PointFile& file : {ball(), withLists(ball()), sampleSheet(wavySheet(), 9, 90, 1)}) {
        const FixedFile fixed = applyFixes(file);
        CHECK(fixed.fixes.empty());
        CHECK(meshPlyBytes(fixed.file, fixed.file.faces) == meshPlyBytes(file, file.faces));
    }
}

TEST_CASE("doctor: repairs are listed, and the problems gone") {
    const FixedFile fixed = applyFixes(flawedFile());
    const auto counts = repairsOf(fixed);
    CHECK(counts.at("non_finite") == 1);
    CHECK(counts.at("zero_normals") == 1);
    CHECK(counts.at("duplicates") == 1);
    CHECK(counts.at("unscaled_normals") == 1);
    CHECK(counts.at("corner_bits") == 1);
    CHECK(counts.at("entries_outside") == 1);
    CHECK(counts.at("repeated_entries") == 1);
    CHECK(counts.at("unsorted_lists") >= 1);
    const Diagnosis left = examined(fixed.file);
    for (const Finding& finding : left.findings) CHECK_FALSE(finding.check->hasSafeFix());
    CHECK(applyFixes(fixed.file).fixes.empty());
}

TEST_CASE("doctor: points keep their order and everything that belongs to them") {
    const PointFile before = flawedFile();
    const PointFile after = applyFixes(before).file;
    std::vector<double> kept;
    for (Index p = 0; p < before.position.size(); ++p) {
        if (p != 10 && p != 31) kept.push_back(p);
    }
    REQUIRE(after.attributes.size() == 1);
    CHECK(after.attributes[0].values == kept);
    REQUIRE(after.position.size() == kept.size());
    REQUIRE(after.neighbors.size() == kept.size());
    for (Index p = 0; p < kept.size(); ++p) {
        const auto old = static_cast<Index>(kept[p]);
        CHECK(after.position[p] == before.position[old]);
        // Every list names the same points as before, except those that were dropped.
        std::vector<Index> names;
        for (const Index q : listOf(after, p)) names.push_back(static_cast<Index>(kept[q]));
        std::vector<Index> wanted;
        for (const Index q : listOf(before, old)) {
            if (q != old && q < before.position.size() && q != 10 && q != 31) wanted.push_back(q);
        }
        std::sort(names.begin(), names.end());
        std::sort(wanted.begin(), wanted.end());
        CHECK(names == wanted);
    }
}

TEST_CASE("doctor: mending changes nothing for the algorithm, which does so for itself") {
    PointFile file = flawedFile();
    setList(file, 60,
            listOf(withLists(ball()), 60));  // prepare() refuses entries that point outside
    const PointFile repaired = applyFixes(file).file;
    const std::vector<double>& number = repaired.attributes[0].values;
    const Run before = runAll(prepared(file), *paramsByName("paper"));
    const Run after = runAll(prepared(repaired), *paramsByName("paper"));
    REQUIRE(before.state.mesh().size() == after.state.mesh().size());
    for (std::size_t t = 0; t < after.state.mesh().size(); ++t) {
        const Triangle& a = before.state.mesh()[t];
        const Triangle& b = after.state.mesh()[t];
        CHECK(a == Triangle{static_cast<Index>(number[b.a]), static_cast<Index>(number[b.b]),
                            static_cast<Index>(number[b.c])});
    }
}

TEST_CASE("doctor: where copies are dropped, their normals count in the mean of the place") {
    PointFile file = withLists(ball());
    file.neighbors = {};
    const std::size_t own = file.position.size();
    for (std::size_t p = 0; p < own; p += 3) {
        file.position.push_back(file.position[p]);
        file.normal.push_back(glm::normalize(file.normal[p] + Vec3(0.3, 0.0, 0.0)));
        if (!file.type.empty()) file.type.push_back(file.type[p]);
        for (Attribute& column : file.attributes) column.values.push_back(column.values[p]);
    }
    const PointFile repaired = applyFixes(file).file;
    CHECK(repaired.position.size() == own);
    CHECK(runAll(prepared(file), paper()).state.mesh() ==
          runAll(prepared(repaired), paper()).state.mesh());
}

TEST_CASE("doctor: faces move from copies to their originals, and go with dropped points") {
    PointFile soup;  // Two triangles with corners of their own, as from STL, and a third one.
    soup.position = {{0, 0, 0},
                     {1, 0, 0},
                     {0, 1, 0},
                     {1, 0, 0},
                     {1, 1, 0},
                     {0, 1, 0},
                     {5, 5, std::numeric_limits<double>::infinity()}};
    soup.normal.assign(soup.position.size(), Vec3(0, 0, 1));
    soup.faces = {{0, 1, 2}, {3, 4, 5}, {4, 5, 6}};
    const FixedFile fixed = applyFixes(soup);
    CHECK(fixed.file.position.size() == 4);
    CHECK(fixed.file.faces == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
    CHECK(repairsOf(fixed).at("faces") == 1);
}

TEST_CASE("doctor: normals that are all zero are taken out, not the points") {
    PointFile file = ball();
    file.normal.assign(file.position.size(), Vec3(0.0));
    const FixedFile fixed = applyFixes(file);
    CHECK_FALSE(fixed.file.hasNormals());
    CHECK(fixed.file.position == file.position);
    CHECK(repairsOf(fixed).at("zero_normals") == file.position.size());
}

TEST_CASE("doctor: a normal without a direction is derived, and its point stays") {
    for (const Vec3& none : {Vec3(0.0), Vec3(std::numeric_limits<double>::quiet_NaN()),
                             Vec3(0.0, std::numeric_limits<double>::infinity(), 1.0)}) {
        PointFile file = ball();
        const std::vector<Vec3> right = file.normal;
        for (Index p = 0; p < 40; ++p) file.normal[p] = none;
        const FixedFile some = applyFixes(file);
        CHECK(some.file.position == file.position);
        CHECK(repairsOf(some) == std::map<std::string, std::size_t>{{"zero_normals", 40}});
        for (Index p = 0; p < right.size(); ++p)
            CHECK(glm::dot(some.file.normal[p], right[p]) > 0.9);
        file.normal.assign(file.position.size(), none);
        const FixedFile all = applyFixes(file);
        CHECK_FALSE(all.file.hasNormals());
        CHECK(all.file.position == file.position);
    }
}

TEST_CASE("doctor: fixes that leave fewer than half of the places are refused") {
    const std::vector<Vec3> three{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    std::vector<Vec3> copies(20, three[0]);
    copies.push_back(three[1]);
    copies.push_back(three[2]);
    copies.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
    CHECK(requireMostLeft(copies, three, {}).ok());
    CHECK(requireMostLeft(copies, std::vector<Vec3>{three[0], three[1]}, {}).ok());
    const std::vector<std::string> done{"2 points dropped"};
    const Status one = requireMostLeft(copies, std::vector<Vec3>{three[0]}, done);
    REQUIRE_FALSE(one.ok());
    CHECK(one.error().message ==
          "the fixes would leave 1 of 3 distinct finite positions, fewer than half (2 points "
          "dropped)");
    CHECK_FALSE(requireMostLeft(copies, {}, done).ok());
    CHECK_FALSE(requireMostLeft(std::vector<Vec3>{copies.back()}, {}, done).ok());
    CHECK(requireMostLeft({}, {}, {}).ok());
}

TEST_CASE("doctor: guesses are left to the user, by a list of points to drop") {
    PointFile file = ball();
    file.position.push_back(Vec3(40, 0, 0));
    file.normal.push_back(Vec3(1, 0, 0));
    file.normal[5] = -file.normal[5];
    CHECK(applyFixes(file).fixes.empty());
    const Finding stray = findingIn(file, "isolated_points");
    const FixedFile fixed = applyFixes(file, stray.points);
    CHECK(repairsOf(fixed) == std::map<std::string, std::size_t>{{"dropped", 1}});
    CHECK(problemNames(fixed.file) == "flipped_normals ");
}

TEST_CASE("doctor: whatever the input, what can be fixed is fixed at once") {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const PointSet points = randomPoints(seed);
        Random random(seed);
        PointFile file;
        file.position = points.position;
        file.normal = points.normal;
        file.type = points.type;
        const auto n = static_cast<Index>(file.position.size());
        for (Index p = 0; p < n; ++p) {
            std::vector<Index> list(points.neighbors[p].begin(), points.neighbors[p].end());
            if (random.below(4) == 0) std::reverse(list.begin(), list.end());
            if (random.below(9) == 0) list.push_back(static_cast<Index>(random.below(2 * n)));
            file.neighbors.append(list);
            switch (random.below(30)) {
                case 0:
                    file.position[p].y = std::numeric_limits<double>::quiet_NaN();
                    break;
                case 1:
                    file.normal[p] = Vec3(0.0);
                    break;
                case 2:
                    file.normal[p] *= random.between(0.0, 1e9);
                    break;
                case 3:
                    file.position[p] = file.position[random.below(n)];
                    break;
                case 4:
                    file.type[p] = static_cast<std::uint8_t>(random.below(256));
                    break;
                default:
                    break;
            }
        }
        const FixedFile once = applyFixes(file);
        const Diagnosis left = examined(once.file);
        for (const Finding& finding : left.findings)
            CHECK_MESSAGE(!finding.check->hasSafeFix(), finding.check->name, ", seed ", seed);
        CHECK(applyFixes(once.file).fixes.empty());
        REQUIRE(prepare(once.file, {}).ok());
        CHECK(prepare(once.file, {}).value().report.unscaledNormals == 0);
    }
}

TEST_CASE("doctor: nothing is left of what holds nothing") {
    CHECK(applyFixes({}).file.position.empty());
    PointFile file;
    file.position.assign(4, Vec3(std::numeric_limits<double>::quiet_NaN()));
    CHECK(applyFixes(file).file.position.empty());
}
