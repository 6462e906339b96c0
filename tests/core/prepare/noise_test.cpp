/// Noise along the normal (docs/robust.md, "Before the run"): where it is as wide as the spacing,
/// points over and under others are set aside, and the rest is a surface; elsewhere no point is.
#include "spiraling_edge/prepare/noise.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/clouds.h"
#include "support/oracles.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// Points at random on the unit sphere, moved along the normal by about `width` spacings, with
/// normals that are off by up to 17 degrees.
PointFile noisySphere(std::size_t count, double width, std::uint64_t seed) {
    Random random(seed);
    const double spacing = std::sqrt(4 * kPi / static_cast<double>(count));
    PointFile file;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 out = random.direction();
        // The sum of three uniform numbers in [-1, 1] has variance 1.
        const Vec3 a = random.inCube(), b = random.inCube();
        const double height = a.x + a.y + a.z;
        file.position.push_back(out * (1.0 + height * width * spacing));
        file.normal.push_back(glm::normalize(out + 0.3 * b));
    }
    return file;
}

}  // namespace

TEST_CASE("noise: smooth surfaces have little, however they bend, and lose no point") {
    for (const Family& family : closedFamilies()) {
        const PointFile file = family.sample(1);
        const Prepared prepared = preparedBy("robust", file);
        CHECK_MESSAGE(prepared.report.noise < 0.35, family.name);
        CHECK_MESSAGE(prepared.report.count(Aside::Noise) == 0, family.name);
        CHECK(prepared.points.normal == preparedBy("paper", file).points.normal);
    }
}

TEST_CASE("noise: is the height of the neighbors in spacings") {
    // Every second point of a lattice one spacing higher: of a point's twelve nearest about as many
    // are on its level as on the other.
    PointFile file;
    for (int i = 0; i < 30; ++i) {
        for (int j = 0; j < 30; ++j) file.position.emplace_back(i, j, (i + j) % 2 == 0 ? 0 : 0.5);
    }
    file.normal.assign(file.position.size(), Vec3(0, 0, 1));
    const double noise = preparedBy("robust", file).report.noise;
    CHECK(noise > 0.2);
    CHECK(noise < 0.4);
    for (Vec3& x : file.position) x *= 1e6;
    CHECK(preparedBy("robust", file).report.noise == doctest::Approx(noise).epsilon(1e-9));
}

TEST_CASE("noise: long lists do not make a surface noisy") {
    const PointFile file = closedFamilies()[1].sample(1);
    PrepareOptions options;
    options.setNoiseAside = true;
    const double noise = preparedBy("robust", file).report.noise;
    for (const std::size_t k : {16U, 24U, 48U}) {
        options.neighbors.reach = KNearest{k};
        const auto result = prepare(file, options);
        REQUIRE(result.ok());
        CHECK(result.value().report.noise == doctest::Approx(noise).epsilon(0.05));
        CHECK(result.value().report.count(Aside::Noise) == 0);
    }
}

TEST_CASE("noise: a sphere in noise wider than its spacing gets a whole and sound mesh") {
    for (const double width : {1.0, 1.5, 2.0}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const PointFile file = noisySphere(6000, width, seed);
            const Prepared prepared = preparedBy("robust", file);
            const PointSet& points = prepared.points;
            CAPTURE(width);
            CAPTURE(seed);
            CHECK(prepared.report.noise > kNoisy);
            CHECK(prepared.report.count(Aside::Noise) > 0);
            CHECK(prepared.report.count(Aside::Noise) < file.position.size());
            CHECK(points.position == file.position);
            const Run run = runAll(points, *paramsByName("robust"));
            CHECK(run.mesh.closedManifold());
            CHECK(run.mesh.eulerCharacteristic == 2);
            CHECK(describeFaults(points, run.state.mesh()) == "");
        }
    }
    // Not so where all points stay.
    const PointFile fewer = noisySphere(500, 1.0, 1);
    const Run all = runAll(preparedBy("paper", fewer).points, *paramsByName("robust"));
    CHECK_FALSE(all.mesh.closedManifold());
}

TEST_CASE("noise: points that fill space are no surface, and all stay") {
    Random random(5);
    PointFile file;
    for (int i = 0; i < 2000; ++i) {
        file.position.push_back(random.inCube());
        file.normal.push_back(random.direction());
    }
    const Prepared prepared = preparedBy("robust", file);
    CHECK(prepared.report.count(Aside::Noise) == 0);
    CHECK(prepared.points.normal == preparedBy("paper", file).points.normal);
    const RunSpec without = withRule(withSet({}, "robust"), "noise", 0.0);
    CHECK(prepared.points.neighbors.ids == preparedBy(without, file).points.neighbors.ids);
}

TEST_CASE("noise: lists from the file are taken as they are") {
    PointFile file = noisySphere(2000, 1.5, 1);
    file.neighbors = preparedBy("paper", file).points.neighbors;
    const Prepared prepared = preparedBy("robust", file);
    CHECK(prepared.report.count(Aside::Noise) == 0);
    CHECK(prepared.points.neighbors.ids == file.neighbors.ids);
}

TEST_CASE("noise: of scans whose noise is narrower than their spacing all points stay") {
    for (const char* name : {"fin90", "oni", "elephant", "hippo"}) {
        const auto file = sharedPoints(std::string("points/") + name + ".ply");
        if (!file) return;
        CHECK_MESSAGE(preparedBy("robust", *file).report.count(Aside::Noise) == 0, name);
    }
}

TEST_CASE("noise: all of the work reports progress, and can be cancelled at any time" *
          doctest::test_suite("long")) {
    PointFile file = noisySphere(2000, 1.0, 5);
    file.normal.clear();
    PrepareOptions options;
    options.setNoiseAside = true;
    options.neighbors.threads = 1;
    std::vector<double> shares;
    const auto run = [&](std::size_t limit) {
        shares.clear();
        return prepare(file, options, [&](double share) {
            shares.push_back(share);
            return shares.size() < limit;
        });
    };
    const Result<Prepared> whole = run(1'000'000);
    REQUIRE(whole.ok());
    CHECK(whole.value().report.derived.normals);
    CHECK(whole.value().report.noise > kNoisy);
    CHECK(std::is_sorted(shares.begin(), shares.end()));
    CHECK(shares.back() == 1.0);
    // Planes, sides, and each of the searches after the first report their progress.
    const auto between = [&](double low, double high) {
        return std::count_if(shares.begin(), shares.end(),
                             [=](double share) { return share > low && share < high; });
    };
    CHECK(between(0.3, 0.35) > 0);
    CHECK(between(0.35, 0.5) > 0);
    CHECK(between(0.75, 1.0) > 3);
    std::size_t beforeEnd = 0;
    while (shares[beforeEnd] < 0.99) ++beforeEnd;
    for (std::size_t limit = 1; limit < beforeEnd; ++limit) {
        CAPTURE(limit);
        CHECK_FALSE(run(limit).ok());
        CHECK(shares.size() <= limit + 2);  // the end of a part of the work does not report
    }
}

namespace {

/// Points that all list each other, and the patches of `width` with these heights; returns which
/// stay.
std::vector<bool> thinned(const std::vector<Vec3>& position, const std::vector<double>& height,
                          const std::vector<double>& width) {
    NeighborLists lists;
    std::vector<NoisePatch> patches;
    for (Index p = 0; p < position.size(); ++p) {
        std::vector<Index> list;
        for (Index q = 0; q < position.size(); ++q) {
            if (q != p) list.push_back(q);
        }
        lists.append(list);
        patches.push_back({Vec3(0, 0, 1), width[p], height[p]});
    }
    std::vector<bool> usable(position.size(), true);
    const std::size_t aside = setNoiseAside(position, patches, lists, usable);
    CHECK(aside == static_cast<std::size_t>(std::count(usable.begin(), usable.end(), false)));
    return usable;
}

}  // namespace

TEST_CASE("noise: the point nearest the middle stays, and those over and under it do not") {
    const std::vector<Vec3> stack{{0, 0, 0.3}, {0, 0, 0}, {0, 0, -0.3}};
    CHECK(thinned(stack, {0.3, 0.0, 0.3}, {1, 1, 1}) == std::vector<bool>{false, true, false});
}

TEST_CASE("noise: beyond six widths over or under, or two along, another part of it lies") {
    const std::vector<Vec3> places{{0, 0, 0},    {0, 0, 5.9}, {0, 0, 6.1}, {0, 0, -5.9},
                                   {0, 0, -6.1}, {1.9, 0, 0}, {2.1, 0, 0}};
    // The others are narrow, and set nothing aside.
    CHECK(thinned(places, {0, 1, 1, 1, 1, 1, 1}, {1, 0, 0, 0, 0, 0, 0}) ==
          std::vector<bool>{true, false, true, false, true, false, true});
}

TEST_CASE("noise: a point that was chosen stays, though a later one reaches it") {
    const std::vector<Vec3> two{{0, 0, 0}, {0.5, 0, 0}};
    CHECK(thinned(two, {0.0, 0.1}, {0.1, 1.0}) == std::vector<bool>{true, true});
}

TEST_CASE("noise: points that stay get the mean normal of their patch, the others keep theirs") {
    const PointFile file = noisySphere(1000, 1.0, 1);
    const Prepared prepared = preparedBy("robust", file);
    REQUIRE(prepared.report.count(Aside::Noise) > 0);
    const std::vector<bool> all(file.position.size(), true);
    const auto lists =
        findNeighbors(file.position, file.normal, all, {KNearest{kNoisePatch}, true, false});
    REQUIRE(lists.ok());
    std::size_t wrong = 0;
    for (Index p = 0; p < file.position.size(); ++p) {
        Vec3 expected = file.normal[p];
        if (!prepared.points.isAside(p)) {
            for (const Index q : lists.value()[p]) expected += file.normal[q];
        }
        expected = glm::normalize(expected);
        wrong += glm::distance(prepared.points.normal[p], expected) < 1e-9 ? 0U : 1U;
    }
    CHECK(wrong == 0);
}

TEST_CASE("noise: its amount and middle are the same for any number of threads") {
    const PointFile file = noisySphere(20000, 0.5, 3);
    const NeighborLists lists = nearestLists(file.position);
    std::vector<bool> usable(file.position.size(), true);
    usable[5] = false;
    const double noise = noiseAlongNormals(file.position, file.normal, lists, Sheets::Apart, 1);
    const auto one = noisePatches(file.position, file.normal, lists, usable, 1);
    for (const unsigned threads : {0U, 2U, 3U}) {
        CHECK(noiseAlongNormals(file.position, file.normal, lists, Sheets::Apart, threads) ==
              noise);
        const auto patches = noisePatches(file.position, file.normal, lists, usable, threads);
        bool same = patches.size() == one.size();
        for (std::size_t p = 0; p < one.size(); ++p) {
            same = same && patches[p].normal == one[p].normal && patches[p].width == one[p].width &&
                   patches[p].height == one[p].height;
        }
        CHECK(same);
        CHECK(patches[5].width == 0.0);
    }
}

TEST_CASE("noise: two clean sheets that face the same way are two surfaces, and lose no point") {
    for (const double apart : {1.5, 2.0}) {
        PointFile file;
        Random random(4);
        for (int i = 0; i < 1800; ++i) {
            const double x = i % 30 + random.between(-0.2, 0.2);
            const double y = i / 30 % 30 + random.between(-0.2, 0.2);
            file.position.emplace_back(x, y, i < 900 ? 0.0 : apart);
            file.normal.emplace_back(0.0, 0.0, 1.0);
        }
        const Prepared prepared = preparedBy("robust", file);
        CHECK(prepared.report.noise < 0.1);
        CHECK(prepared.report.count(Aside::Noise) == 0);
        // Noise as wide as they are apart is noise.
        for (Vec3& x : file.position) x.z += random.between(-apart, apart);
        CHECK(preparedBy("robust", file).report.noise > kNoisy);
    }
}

TEST_CASE("noise: heights over wrong normals are none that leaves a surface, and no point goes") {
    const auto file = sharedPoints("cases/normals_are_ray_directions.ply");
    if (!file) return;
    const Prepared prepared = preparedBy("robust", *file);
    CHECK(prepared.report.noise > kNoisy);
    CHECK(prepared.report.count(Aside::Noise) == 0);
}
