/// The coarsest closed surfaces, whose neighbors oppose each other; and surfaces cut by the walls
/// of a box so that strips of them are narrower than their points are apart.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/spec/run_spec.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// A run by a named set of rules, as the command line prepares it.
struct NamedRun {
    MeshReport mesh;
    bool sound;
};
NamedRun runOn(const PointFile& file, const std::string& rules) {
    const Params params = *paramsByName(rules);
    const auto points = prepare(file, prepareOptionsOf({}, params, file).value());
    REQUIRE(points.ok());
    const Run run = runAll(points.value().points, params);
    const MeshInspection found = inspectWithTotals(points.value().points, run.state.mesh());
    return {run.mesh, isSound(found.totals, run.mesh.triangles)};
}

/// Points with their normals away from the middle.
PointFile solid(std::vector<Vec3> corners) {
    Vec3 middle(0.0);
    for (const Vec3& x : corners) middle += x / static_cast<double>(corners.size());
    PointFile file;
    for (const Vec3& x : corners) file.normal.push_back(glm::normalize(x - middle));
    file.position = std::move(corners);
    return file;
}

const std::vector<Vec3> kTetrahedron{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
const std::vector<Vec3> kOctahedron{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                    {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
const std::vector<Vec3> kPyramid{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
const std::vector<Vec3> kCube{{-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1},
                              {1, -1, -1},  {1, -1, 1},  {1, 1, -1},  {1, 1, 1}};

PointFile sampledSphere(const Vec3& low, const Vec3& high, std::size_t count, std::uint64_t seed) {
    SamplerOptions options;
    options.count = count;
    options.seed = seed;
    Result<PointFile> file = sample(inBox(fieldOf(*findShape("sphere")), low, high), options);
    REQUIRE(file.ok());
    return std::move(file.value());
}

}  // namespace

TEST_CASE("coarse solids: a tetrahedron is built by every set of rules") {
    for (const std::string rules : {"printed", "paper", "corrected", "robust"}) {
        CAPTURE(rules);
        const NamedRun run = runOn(solid(kTetrahedron), rules);
        CHECK(run.mesh.triangles == 4);
        CHECK(run.mesh.closedManifold());
        CHECK(run.sound);
    }
}

TEST_CASE("coarse solids: robust builds an octahedron, a pyramid and a cube") {
    for (const auto& corners : {kOctahedron, kPyramid, kCube}) {
        CAPTURE(corners.size());
        const NamedRun run = runOn(solid(corners), "robust");
        CHECK(run.mesh.triangles == 2 * corners.size() - 4);
        CHECK(run.mesh.closedManifold());
        CHECK(run.sound);
    }
}

TEST_CASE("walls: a strip that ends in a point between two walls is sound with robust") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        CAPTURE(seed);
        for (const std::size_t count : {500, 900}) {
            const PointFile file =
                sampledSphere({-0.8, -0.7, -0.6}, {0.75, 0.65, 0.55}, count, seed);
            CHECK(runOn(file, "robust").sound);
        }
    }
}

TEST_CASE("walls: pieces that they cut off are kept") {
    // Two corners of the box hold pieces of 8 and 3 points.
    const PointFile file =
        sampledSphere({-0.5792, -0.847, -0.614}, {0.549, 0.5848, 0.5022}, 987, 2);
    CHECK(runOn(file, "robust").mesh.unusedPoints == 0);
}
