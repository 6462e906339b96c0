#include "spiraling_edge/prepare/prepare.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "neighbor_oracle.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInf = std::numeric_limits<double>::infinity();

Lists find(const OraclePoints& points, const NeighborOptions& options) {
    const auto lists = findNeighbors(points.position, points.normal, points.usable, options);
    REQUIRE_MESSAGE(lists.ok(), lists.error().message);
    return toVectors(lists.value());
}

/// Twelve points on a circle, normals outwards, lists naming the two beside each point.
PointFile makeCircle() {
    PointFile file;
    for (int i = 0; i < 12; ++i) {
        const double angle = i * 0.5235987755982988;
        file.position.emplace_back(std::cos(angle), std::sin(angle), 0);
        file.normal.push_back(file.position.back());
    }
    return file;
}

Prepared mustPrepare(const PointFile& file, const NeighborOptions& options = {}) {
    Result<Prepared> prepared = prepare(file, {options});
    REQUIRE_MESSAGE(prepared.ok(), prepared.error().message);
    CHECK(validate(prepared.value().points).ok());
    return prepared.value();
}

std::string errorOf(const PointFile& file, const NeighborOptions& options = {}) {
    const Result<Prepared> prepared = prepare(file, {options});
    return prepared.ok() ? "none" : prepared.error().message;
}

/// True if point p has an empty list and is in no list.
bool isSetAside(const PointSet& points, Index p) {
    const auto& ids = points.neighbors.ids;
    return points.neighbors[p].empty() && std::count(ids.begin(), ids.end(), p) == 0;
}

}  // namespace

TEST_CASE("symmetricLists: every entry has its inverse, nearest first, and none is lost") {
    // Dense on one side, sparse on the other: sparse points list dense ones that do not list them.
    OraclePoints points = makeRandom(400);
    for (Vec3& x : points.position) x.x = x.x * x.x * x.x;
    const auto lists = findNeighbors(points.position, {}, points.usable, nearest(6, false));
    REQUIRE(lists.ok());
    const auto both = symmetricLists(points.position, lists.value());
    REQUIRE(both.ok());
    const Lists before = toVectors(lists.value());
    const Lists after = toVectors(both.value());
    const auto has = [](const std::vector<Index>& list, Index p) {
        return std::find(list.begin(), list.end(), p) != list.end();
    };
    std::size_t added = 0;
    for (Index p = 0; p < after.size(); ++p) {
        for (const Index q : before[p]) CHECK(has(after[p], q));
        for (const Index q : after[p]) {
            CHECK(has(after[q], p));
            CHECK((has(before[p], q) || has(before[q], p)));
        }
        const auto farther = [&](Index a, Index b) {
            const double da = glm::length(points.position[a] - points.position[p]);
            const double db = glm::length(points.position[b] - points.position[p]);
            return da < db || (da == db && a < b);
        };
        CHECK(std::is_sorted(after[p].begin(), after[p].end(), farther));
        added += after[p].size() - before[p].size();
    }
    CHECK(added > 100);
    const auto again = symmetricLists(points.position, both.value());
    REQUIRE(again.ok());
    CHECK(again.value().ids == both.value().ids);
}

TEST_CASE("prepare: symmetric lists on request, computed or from the file") {
    PointFile file = makeCircle();
    file.neighbors = {};
    for (Index p = 0; p < 12; ++p) file.neighbors.append(std::vector<Index>{(p + 1) % 12});
    NeighborOptions options;
    CHECK(mustPrepare(file, options).points.neighbors[3].size() == 1);
    options.symmetric = true;
    const PointSet points = mustPrepare(file, options).points;
    std::vector<Index> list(points.neighbors[3].begin(), points.neighbors[3].end());
    std::sort(list.begin(), list.end());  // Both are as far up to rounding.
    CHECK(list == std::vector<Index>{2, 4});
}

TEST_CASE("findNeighbors: a radius takes all points up to and at its length") {
    const OraclePoints lattice = makeLattice(6);
    const OraclePoints cloud = makeRandom(300);
    for (const double radius : {0.05, 0.2, 1.0, 1.5, 2.0, 1e200, kInf}) {
        for (const bool drop : {false, true}) {
            CHECK(find(lattice, within(radius, drop)) == bruteForce(lattice, within(radius, drop)));
            CHECK(find(cloud, within(radius, drop)) == bruteForce(cloud, within(radius, drop)));
        }
    }
    CHECK(find(lattice, within(1.0, false))[0] == std::vector<Index>{1, 6, 36});
}

TEST_CASE("findNeighbors: a point at exactly the radius is listed, one beyond it is not") {
    const OraclePoints two{{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 0, 1}}, {true, true}};
    CHECK(find(two, within(1.0, true)) == Lists{{1}, {0}});
    CHECK(find(two, within(0.999999, true)) == Lists{{}, {}});
}

TEST_CASE("findNeighbors: none, one and two points") {
    CHECK(find({}, nearest(3, true)).empty());
    const OraclePoints one{{{1, 2, 3}}, {{0, 0, 1}}, {true}};
    CHECK(find(one, nearest(3, true)) == Lists{{}});
    CHECK(find(one, within(3, true)) == Lists{{}});
    OraclePoints two{{{1, 2, 3}, {0, 0, 0}}, {{0, 0, 1}, {0, 0, 1}}, {true, true}};
    CHECK(find(two, nearest(3, true)) == Lists{{1}, {0}});
    two.usable[1] = false;
    CHECK(find(two, nearest(3, true)) == Lists{{}, {}});
    two.usable[0] = false;
    CHECK(find(two, nearest(3, true)) == Lists{{}, {}});
}

TEST_CASE("findNeighbors: a move without rounding changes nothing") {
    OraclePoints points = makeRandom(600);
    constexpr double kUnit = 1.0 / 1048576.0;
    for (Vec3& p : points.position) p = glm::floor(p * 1024.0) * kUnit;  // many ties, tiny extent
    const Lists atOrigin = find(points, nearest(12, true));
    const Lists reach = find(points, within(64 * kUnit, false));
    CHECK(atOrigin == bruteForce(points, nearest(12, true)));
    for (Vec3& p : points.position) p += Vec3(1e6, -2e6, 3e6 + 5 * kUnit);
    CHECK(find(points, nearest(12, true)) == atOrigin);
    CHECK(find(points, within(64 * kUnit, false)) == reach);
}

TEST_CASE("findNeighbors: extreme but finite coordinates do not confuse it") {
    OraclePoints points = makeRandom(100);
    points.usable.assign(100, true);
    Lists expected = find(points, nearest(5, true));
    points.position.emplace_back(1e300, -1e308, 1e308);
    points.position.emplace_back(-1e308, 0, 0);
    points.normal.resize(102, Vec3(0, 0, 1));
    points.usable.resize(102, true);
    expected.resize(102);
    CHECK(find(points, nearest(5, true)) == expected);
}

TEST_CASE("findNeighbors: progress grows from 0 to 1, and false cancels") {
    const OraclePoints points = makeRandom(10000);
    std::vector<double> shares;
    const auto run = [&](std::size_t limit) {
        shares.clear();
        return findNeighbors(points.position, points.normal, points.usable, {}, [&](double share) {
            shares.push_back(share);
            return shares.size() < limit;
        });
    };
    CHECK(run(1000).ok());
    CHECK(shares.size() >= 3);
    CHECK(shares.front() == 0.0);
    CHECK(shares.back() == 1.0);
    CHECK(std::is_sorted(shares.begin(), shares.end()));
    const auto cancelled = run(2);
    REQUIRE_FALSE(cancelled.ok());
    CHECK(cancelled.error().message == "the search for neighbors was cancelled");
    CHECK(shares.size() == 2);
}

TEST_CASE("findNeighbors: what does not fit together is refused") {
    const OraclePoints p = makeRandom(5);
    CHECK_FALSE(findNeighbors(p.position, p.normal, {true}, {}).ok());
    CHECK_FALSE(findNeighbors(p.position, {}, p.usable, {}).ok());
    CHECK(findNeighbors(p.position, {}, p.usable, nearest(3, false)).ok());
    CHECK_FALSE(findNeighbors(p.position, p.normal, p.usable, nearest(0, false)).ok());
    CHECK_FALSE(findNeighbors(p.position, p.normal, p.usable, within(0.0, false)).ok());
}

TEST_CASE("prepare: good points pass unchanged and get lists") {
    const PointFile file = makeCircle();
    const Prepared prepared = mustPrepare(file, nearest(2, true));
    CHECK(prepared.points.position == file.position);
    CHECK(prepared.report.neighborsComputed);
    CHECK(prepared.points.type == std::vector<std::uint8_t>(12, kInterior));
    auto list = toVectors(prepared.points.neighbors)[5];
    std::sort(list.begin(), list.end());
    CHECK(list == std::vector<Index>{4, 6});
}

TEST_CASE("prepare: no points at all are no error") { CHECK(mustPrepare({}).points.empty()); }

TEST_CASE("prepare: a reach of nothing fails, even if the file has lists") {
    PointFile file = makeCircle();
    file.neighbors.offset.assign(13, 0);
    CHECK(errorOf(file, nearest(0, true)).find("must be positive") != std::string::npos);
    for (const double radius : {0.0, -1.0, kNan}) {
        CHECK(errorOf(file, within(radius, true)).find("must be positive") != std::string::npos);
    }
}

TEST_CASE("prepare: columns of different length fail") {
    PointFile file = makeCircle();
    file.type = {0};
    CHECK(errorOf(file).find("not as many") != std::string::npos);
}

TEST_CASE("prepare: points that are not finite are set aside") {
    PointFile file = makeCircle();
    file.position[3].x = kNan;
    file.position[4].z = kInf;
    const Prepared prepared = mustPrepare(file);
    CHECK(prepared.report.count(Aside::NotFinite) == 2);
    CHECK(prepared.points.size() == 12);
    CHECK(isSetAside(prepared.points, 3));
    CHECK(isSetAside(prepared.points, 4));
    CHECK_FALSE(isSetAside(prepared.points, 5));
}

TEST_CASE("prepare: normals without direction are derived, on the side of the others") {
    for (const double side : {1.0, -1.0}) {  // Also against what faces outward.
        PointFile file = findScene("sphere")->build();
        file.neighbors = {};
        for (Vec3& normal : file.normal) normal *= side;
        const std::vector<Vec3> right = file.normal;
        file.normal[0] = Vec3(0);
        file.normal[1].y = kNan;
        file.normal[2].z = -kInf;
        // A patch, of which some have no neighbor with a normal.
        for (Index p = 0; p < file.position.size(); ++p) {
            if (file.position[p].z > 0.7) file.normal[p] = Vec3(kNan);
        }
        const Prepared prepared = mustPrepare(file);
        CHECK(prepared.report.count(Aside::NoNormal) == 0);
        CHECK(prepared.report.derived.completedNormals > 80);
        CHECK_FALSE(prepared.report.derived.normals);
        for (Index p = 0; p < file.position.size(); ++p) {
            CHECK_FALSE(isSetAside(prepared.points, p));
            CHECK(glm::dot(prepared.points.normal[p], right[p]) > 0.97);
            if (isFinite(file.normal[p]) && file.normal[p] != Vec3(0.0))
                CHECK(prepared.points.normal[p] == right[p]);
        }
        storeDerived(prepared.points, prepared.report, file);
        for (const Vec3& normal : file.normal) CHECK(isFinite(normal));
    }
}

TEST_CASE("prepare: normals of which most have no direction are all derived") {
    for (const Vec3& none : {Vec3(0.0), Vec3(kNan), Vec3(0.0, kInf, 0.0)}) {
        PointFile file = findScene("sphere")->build();
        file.neighbors = {};
        PointFile bare = file;
        bare.normal.clear();
        const auto n = static_cast<Index>(file.position.size());
        for (Index p = 0; 2 * p <= n; ++p) file.normal[p] = none;
        const Prepared most = mustPrepare(file);
        CHECK(most.report.derived.normals);
        CHECK(most.points.normal == mustPrepare(bare).points.normal);
        file.normal.assign(n, none);
        CHECK(mustPrepare(file).points.normal == most.points.normal);
    }
}

TEST_CASE("prepare: where no plane fits, a normal without direction sets its point aside") {
    PointFile file;
    for (int i = 0; i < 30; ++i) {
        file.position.emplace_back(i, 0.0, 0.0);
        file.normal.emplace_back(0.0, 0.0, i == 15 ? 0.0 : 1.0);
    }
    const Prepared prepared = mustPrepare(file);
    CHECK(prepared.report.count(Aside::NoNormal) == 1);
    CHECK(prepared.report.derived.completedNormals == 0);
    CHECK(isSetAside(prepared.points, 15));
    CHECK_FALSE(isSetAside(prepared.points, 14));
}

TEST_CASE("prepare: of points at one place the first stays") {
    PointFile file = makeCircle();
    file.position[7] = file.position[2] = file.position[5];
    file.position[8] = Vec3(0.0, 0.0, 0.0);
    file.position[9] = Vec3(-0.0, 0.0, -0.0);
    const Prepared prepared = mustPrepare(file);
    CHECK(prepared.report.count(Aside::Copy) == 3);
    CHECK_FALSE(isSetAside(prepared.points, 2));
    CHECK(isSetAside(prepared.points, 5));
    CHECK(isSetAside(prepared.points, 7));
    CHECK_FALSE(isSetAside(prepared.points, 8));
    CHECK(isSetAside(prepared.points, 9));
}

TEST_CASE("prepare: places whose copies have other normals are counted") {
    PointFile file = makeCircle();
    file.position[7] = file.position[2];
    file.position[8] = file.position[3];
    file.normal[7] = glm::normalize(file.normal[2] + Vec3(0.5, 0.0, 0.0));
    file.normal[8] = 2.0 * file.normal[3];
    const Prepared prepared = mustPrepare(file);
    CHECK(prepared.report.averagedNormals == 1);
    CHECK(averagedText(1) == "1 place with several normals: the mean of them is used");
    CHECK(averagedText(0).empty());
    PrepareOptions options;
    options.normals = NormalSource::Derived;
    CHECK(prepare(file, options).value().report.averagedNormals == 0);
}

TEST_CASE("prepare: normals are scaled to unit length once") {
    PointFile file = makeCircle();
    file.normal[0] *= 100.0;
    file.normal[1] *= 1e-310;
    file.normal[2] *= 1e300;
    file.normal[3] *= 1.0 + 1e-7;  // as rounded to float: corrected, not reported
    const Prepared prepared = mustPrepare(file);
    CHECK(prepared.report.unscaledNormals == 3);
    for (const Vec3& normal : prepared.points.normal) {
        CHECK(std::abs(glm::length(normal) - 1.0) < 1e-12);
    }
    PointFile again = file;
    again.normal = prepared.points.normal;
    CHECK(mustPrepare(again).points.normal == prepared.points.normal);
}

TEST_CASE("prepare: the corner bit follows from the face bits") {
    PointFile file = makeCircle();
    file.type.assign(12, kInterior);
    file.type[0] = kPositiveX | kNegativeZ;
    file.type[1] = kPositiveX | kCorner;
    const Prepared prepared = mustPrepare(file);
    CHECK(prepared.points.type[0] == (kPositiveX | kNegativeZ | kCorner));
    CHECK(prepared.points.type[1] == kPositiveX);
}

TEST_CASE("prepare: lists from the file are cleaned and put in order") {
    PointFile file = makeCircle();
    file.position[11] = Vec3(kNan);
    file.position[10] = file.position[9];
    const Lists given = {{2, 1, 2, 0, 11, 1}, {}, {1, 3}, {6, 4, 2, 5}, {9, 10, 3}};
    for (const auto& list : given) file.neighbors.append(list);
    while (file.neighbors.size() < 12) file.neighbors.append({});
    NeighborOptions options = nearest(12, false);
    const Prepared kept = mustPrepare(file, options);
    CHECK_FALSE(kept.report.neighborsComputed);
    Lists expected = {{1, 2}, {}, {1, 3}, {4, 2, 5, 6}, {3, 9}};
    expected.resize(12);
    CHECK(toVectors(kept.points.neighbors) == expected);
    CHECK(kept.report.droppedListEntries == 5);

    options.dropOpposingNormals = true;
    // Point 6 faces the other way by 90 degrees and a rounding; so does 9, but neither it nor 4 has
    // three that agree.
    expected[3] = {4, 2, 5};
    file.normal[6] = -file.normal[3];
    const Prepared filtered = mustPrepare(file, options);
    CHECK(toVectors(filtered.points.neighbors) == expected);
    CHECK(filtered.report.droppedListEntries == 6);

    options.recompute = true;
    CHECK(mustPrepare(file, options).report.neighborsComputed);
}

TEST_CASE("prepare: equal distances in lists from the file are put in order of index") {
    PointFile file;
    file.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    file.normal.assign(5, Vec3(0, 0, 1));
    file.neighbors.append(std::vector<Index>{4, 2, 3, 1});
    for (int i = 0; i < 4; ++i) file.neighbors.append({});
    CHECK(toVectors(mustPrepare(file).points.neighbors)[0] == std::vector<Index>{1, 2, 3, 4});
}

TEST_CASE("prepare: offsets that do not divide the entries of the lists fail") {
    const std::string error = "the offsets of the neighbor lists do not divide their entries";
    PointFile file = makeCircle();
    for (Index p = 0; p < 12; ++p) file.neighbors.append(std::vector<Index>{(p + 1) % 12});
    CHECK(errorOf(file) == "none");
    for (const auto& [at, offset] : {std::pair(3U, 1U << 30U), {3U, 5U}, {12U, 11U}, {0U, 1U}}) {
        PointFile wrong = file;
        wrong.neighbors.offset[at] = offset;
        CHECK(errorOf(wrong) == error);
    }
    file.neighbors.ids.resize(3);
    CHECK(errorOf(file) == error);
    file.neighbors = {{}, {}};
    CHECK(errorOf(file) != "none");
}

TEST_CASE("prepare: a list that names a point that does not exist is an error") {
    PointFile file = makeCircle();
    file.neighbors.append(std::vector<Index>{1, 12});
    for (int i = 0; i < 11; ++i) file.neighbors.append({});
    CHECK(errorOf(file).find("of point 0 names point 12") != std::string::npos);
}

TEST_CASE("prepare: the shared files with hazards pass, and the report counts what is in them") {
    const auto folder = sharedFile("hazards");
    if (folder.empty()) return;
    const auto report = [&](const char* name) {
        const Result<PointFile> file = readPoints(folder / name);
        REQUIRE_MESSAGE(file.ok(), file.error().message);
        return mustPrepare(file.value()).report;
    };
    CHECK(report("duplicates.ply").count(Aside::Copy) == 50);
    CHECK(report("not_finite.ply").count(Aside::NotFinite) == 15);
    CHECK(report("zero_normals.ply").count(Aside::NoNormal) == 0);
    CHECK(report("zero_normals.ply").derived.completedNormals == 30);
    CHECK(report("unscaled_normals.ply").unscaledNormals > 1000);
    CHECK(report("same_point.ply").count(Aside::Copy) == 19);
    for (const char* name : {"empty.ply", "one_point.ply", "two_points.ply", "collinear.ply",
                             "two_close_sheets.ply", "stray_points.ply"}) {
        (void)report(name);
    }
}

TEST_CASE("prepare: points to leave out are set aside, and the rest is as in a file without them") {
    const PointFile whole = findScene("torus")->build();
    PrepareOptions options;
    options.neighbors.recompute = true;
    options.leaveOut = {3, 10, 11};
    const Prepared left = prepare(whole, options).value();
    CHECK(left.report.count(Aside::LeftOut) == 3);
    std::vector<bool> keep(whole.position.size(), true);
    for (const Index p : options.leaveOut) keep[p] = false;
    const std::vector<Index> number = keptNumbers(keep);
    PointFile rest = whole;
    rest.neighbors = {};
    keepColumns(rest, keep);
    options.leaveOut.clear();
    const Prepared without = prepare(rest, options).value();
    for (Index p = 0; p < whole.position.size(); ++p) {
        CHECK(left.points.isAside(p) == !keep[p]);
        if (!keep[p]) {
            CHECK(left.points.neighbors[p].empty());
            continue;
        }
        const auto list = without.points.neighbors[number[p]];
        const auto same = left.points.neighbors[p];
        CHECK(std::equal(same.begin(), same.end(), list.begin(), list.end(),
                         [&](Index a, Index b) { return number[a] == b; }));
    }
}

TEST_CASE(
    "prepare: points whose squared distances are no numbers, or zero, are refused by their size") {
    PointFile file = findScene("sphere")->build();
    file.neighbors = {};
    file.type.clear();
    const auto scaledBy = [&](double factor) {
        PointFile scaled = file;
        for (Vec3& x : scaled.position) x *= factor;
        return prepare(scaled, {});
    };
    CHECK(scaledBy(1e150).ok());
    const Result<Prepared> large = scaledBy(1e300);
    REQUIRE_FALSE(large.ok());
    CHECK(large.error().message.find("coordinates are too large") != std::string::npos);
    CHECK(scaledBy(1e-161).ok());
    for (const double factor : {1e-163, 1e-300, 1e-310}) {
        const Result<Prepared> small = scaledBy(factor);
        REQUIRE_FALSE(small.ok());
        CHECK(small.error().message.starts_with("coordinates are too small: below 1e-162"));
    }
    // One place that stands for no value does not make the others too large.
    file.position[0] = Vec3(1e300);
    CHECK(scaledBy(1.0).ok());
}
