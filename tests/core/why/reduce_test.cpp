#include "spiraling_edge/why/reduce.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/mesh/inspection.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// True for points whose run ends with a failure of this class.
std::function<bool(const PointFile&)> failsBy(std::string_view name) {
    return [name](const PointFile& file) {
        const PointSet points = prepared(file);
        if (points.empty()) return false;
        const Run run = runAll(points, paper());
        const auto failures = inspectMesh(points, run.state.mesh());
        return std::any_of(failures.begin(), failures.end(),
                           [&](const MeshFailure& f) { return f.kind->name == name; });
    };
}

/// Reduces without a limit of the effort.
Result<Reduced> reduceFully(const PointFile& file, const Vec3& place,
                            const std::function<bool(const PointFile&)>& fails,
                            const Progress& progress = {}) {
    const auto tried = [&](const PointFile& part) { return ReduceTry{fails(part), 0}; };
    return reduceInput(file, place, tried, 1, progress);
}

}  // namespace

TEST_CASE("reduce: what stays still fails, and no single point of it can go") {
    PointFile file = closedFamilies(3.0)[0].sample(4);
    const Index planted = 100;
    file.normal[planted] = -file.normal[planted];
    const auto fails = failsBy("lost_points");
    REQUIRE(fails(file));
    const auto reduced = reduceFully(file, file.position[planted], fails);
    REQUIRE(reduced.ok());
    const Reduced& small = reduced.value();
    CHECK(small.file.position.size() == small.kept.size());
    CHECK(small.kept.size() < 30);
    CHECK(fails(small.file));
    for (std::size_t i = 0; i < small.kept.size(); ++i) {
        CHECK(small.file.position[i] == file.position[small.kept[i]]);
        PointFile without = small.file;
        without.position.erase(without.position.begin() + static_cast<std::ptrdiff_t>(i));
        without.normal.erase(without.normal.begin() + static_cast<std::ptrdiff_t>(i));
        CHECK_FALSE(fails(without));
    }
}

TEST_CASE("reduce: three points back to back are distinguished from a failure within a surface") {
    MeshFailure pair;
    pair.triangles = {0, 1};
    const std::vector<Triangle> alone{{0, 1, 2}, {2, 1, 0}};
    CHECK(isBackToBack(pair, alone));
    const std::vector<Triangle> apart{{0, 1, 2}, {2, 1, 0}, {3, 4, 5}};
    CHECK(isBackToBack(pair, apart));
    const std::vector<Triangle> within{{0, 1, 2}, {2, 1, 0}, {2, 1, 3}};
    CHECK_FALSE(isBackToBack(pair, within));
    CHECK_FALSE(isBackToBack(pair, std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
    CHECK_FALSE(isBackToBack(MeshFailure{}, alone));
}

TEST_CASE("reduce: an input that does not fail, and a cancelled one") {
    const PointFile file = closedFamilies()[0].sample(1);
    CHECK_FALSE(reduceFully(file, Vec3(0.0), [](const PointFile&) { return false; }).ok());
    const auto always = [](const PointFile&) { return true; };
    CHECK_FALSE(reduceFully(file, Vec3(0.0), always, [](double) { return false; }).ok());
    const auto one = reduceFully(file, Vec3(0.0), always);
    REQUIRE(one.ok());
    CHECK(one.value().kept.size() == 1);
}

TEST_CASE("reduce: it ends when the effort is used up, with the best so far") {
    const PointFile file = closedFamilies()[0].sample(1);
    // Any part with the first and the last point fails.
    const auto fails = [&](const PointFile& part) {
        const auto has = [&](const Vec3& x) {
            return std::find(part.position.begin(), part.position.end(), x) != part.position.end();
        };
        const bool both = has(file.position.front()) && has(file.position.back());
        return ReduceTry{both, part.position.size()};
    };
    std::size_t before = file.position.size();
    for (const std::uint64_t effort : {1U, 320U}) {
        CAPTURE(effort);
        const auto reduced = reduceInput(file, file.position.front(), fails, effort);
        REQUIRE(reduced.ok());
        CHECK_FALSE(reduced.value().complete);
        CHECK(fails(reduced.value().file).fails);
        CHECK(reduced.value().kept.size() <= before);
        before = reduced.value().kept.size();
        CHECK(reduceInput(file, file.position.front(), fails, effort).value().kept ==
              reduced.value().kept);
    }
    const auto whole = reduceInput(file, file.position.front(), fails, 100'000'000);
    REQUIRE(whole.ok());
    CHECK(whole.value().complete);
    CHECK(whole.value().kept.size() == 2);
}
