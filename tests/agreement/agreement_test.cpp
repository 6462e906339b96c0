/// Whether se::inspectMesh() finds what CGAL finds, on the meshes of all scenes under two sets of
/// rules and on meshes with a planted failure; and whether distances from them agree within 1 %.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "spiraling_edge/mesh/fidelity.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/rig.h"

namespace {

namespace Pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

struct NamedMesh {
    std::string name;
    se::PointSet points;
    std::vector<se::Triangle> triangles;
};

/// The common verdict on a mesh.
struct Verdict {
    bool manifold = false;      ///< At most two triangles per edge, wound alike; one fan per point.
    bool intersecting = false;  ///< For manifold meshes only: CGAL's check works on those.
    bool operator==(const Verdict&) const = default;
};

Verdict verdictOfCgal(const NamedMesh& mesh) {
    std::vector<Kernel::Point_3> points;
    for (const se::Vec3& x : mesh.points.position) points.emplace_back(x.x, x.y, x.z);
    std::vector<std::array<std::size_t, 3>> soup;
    for (const se::Triangle& t : mesh.triangles) soup.push_back({t.a, t.b, t.c});
    if (!Pmp::is_polygon_soup_a_polygon_mesh(soup)) return {};
    Surface surface;
    Pmp::polygon_soup_to_polygon_mesh(points, soup, surface);
    return {.manifold = true, .intersecting = Pmp::does_self_intersect(surface)};
}

Verdict ourVerdict(const NamedMesh& mesh) {
    const std::vector<se::MeshFailure> failures = se::inspectMesh(mesh.points, mesh.triangles);
    const auto has = [&](std::string_view name) {
        return std::any_of(failures.begin(), failures.end(),
                           [&](const se::MeshFailure& f) { return f.kind->name == name; });
    };
    if (has("non_manifold_edges") || has("non_manifold_vertices") || has("inconsistent_edges"))
        return {};
    return {.manifold = true, .intersecting = has("intersecting_triangles")};
}

NamedMesh meshOf(const se::Scene& scene, const char* rules) {
    NamedMesh mesh{std::string(scene.id) + " " + rules, se::test::prepared(scene.build()), {}};
    mesh.triangles =
        se::test::runAll(mesh.points, se::test::withStartOf(scene, *se::paramsByName(rules)))
            .state.mesh();
    return mesh;
}

std::vector<NamedMesh> meshesOfScenes() {
    std::vector<NamedMesh> meshes;
    for (const char* rules : {"paper", "robust"}) {
        for (const se::Scene& scene : se::scenes()) meshes.push_back(meshOf(scene, rules));
        for (const se::FailureScene& each : se::failureScenes())
            meshes.push_back(meshOf(each.scene, rules));
    }
    return meshes;
}

/// A closed octahedron, and variants with one failure each.
std::vector<NamedMesh> plantedMeshes() {
    se::PointSet points;
    points.position = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1},
                       {0, 0, -1}, {3, 0, 0},  {2, 1, 0}, {2, -1, 0}, {0.1, 0.1, 3}};
    const std::vector<se::Triangle> whole{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                          {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    std::vector<NamedMesh> meshes;
    const auto with = [&](const char* name, const se::Triangle& more) {
        meshes.push_back({name, points, whole});
        meshes.back().triangles.push_back(more);
    };
    meshes.push_back({"whole", points, whole});
    with("a third triangle at an edge", {0, 2, 6});
    with("a second fan at a point", {0, 7, 8});
    meshes.push_back({"one turned over", points, whole});
    std::swap(meshes.back().triangles[0].b, meshes.back().triangles[0].c);
    meshes.push_back({"one taken out", points, whole});
    meshes.back().triangles.pop_back();
    meshes.push_back({"a corner drawn through the other side", points, whole});
    meshes.back().points.position[4] = {0.1, 0.1, -3};
    with("a piece that stands in it", {7, 8, 9});
    meshes.back().points.position[7] = {0.5, 1, 0};
    meshes.back().points.position[8] = {-0.5, -1, 0};
    meshes.push_back({"two sheets folded onto each other", points, {{0, 1, 2}, {1, 0, 7}}});
    meshes.back().points.position[7] = {0, 0.5, 0};
    return meshes;
}

Kernel::Triangle_3 triangleOf(const se::PointSet& points, const se::Triangle& t) {
    const auto at = [&](se::Index p) {
        const se::Vec3& x = points.position[p];
        return Kernel::Point_3(x.x, x.y, x.z);
    };
    return {at(t.a), at(t.b), at(t.c)};
}

/// The distances of all points by CGAL's tree of boxes. Requires triangles, none degenerate.
se::Fidelity fidelityOfCgal(const se::PointSet& points, const std::vector<se::Triangle>& mesh) {
    using Soup = std::vector<Kernel::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, Soup::const_iterator>;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
    Soup soup;
    for (const se::Triangle& t : mesh) soup.push_back(triangleOf(points, t));
    Tree tree(soup.cbegin(), soup.cend());
    tree.accelerate_distance_queries();
    se::Fidelity found;
    double sum = 0.0;
    for (const se::Vec3& x : points.position) {
        const double distance =
            std::sqrt(std::max(0.0, tree.squared_distance(Kernel::Point_3(x.x, x.y, x.z))));
        found.greatestDistance = std::max(found.greatestDistance, distance);
        sum += distance;
    }
    found.meanDistance = sum / static_cast<double>(points.size());
    return found;
}

}  // namespace

TEST_CASE("distances of points from the mesh agree with CGAL's within 1 %") {
    std::size_t apart = 0;
    for (NamedMesh& mesh : meshesOfScenes()) {
        CAPTURE(mesh.name);
        // A third of the mesh leaves many points out.
        std::erase_if(mesh.triangles, [&](const se::Triangle& t) {
            return triangleOf(mesh.points, t).is_degenerate();
        });
        mesh.triangles.resize(mesh.triangles.size() / 3);
        if (mesh.triangles.empty()) continue;
        const se::Fidelity ours = se::fidelityOf(mesh.points, mesh.triangles);
        const se::Fidelity theirs = fidelityOfCgal(mesh.points, mesh.triangles);
        const auto near = [](double a, double b) { return std::abs(a - b) <= 0.01 * b + 1e-12; };
        CHECK(near(ours.greatestDistance, theirs.greatestDistance));
        CHECK(near(ours.meanDistance, theirs.meanDistance));
        apart += ours.greatestDistance > 0.0 ? 1 : 0;
    }
    CHECK(apart > 10);
}

TEST_CASE("the checks of meshes agree with CGAL's") {
    std::vector<NamedMesh> meshes = meshesOfScenes();
    for (NamedMesh& mesh : plantedMeshes()) meshes.push_back(std::move(mesh));
    CHECK(meshes.size() >= 20);
    std::size_t manifold = 0;
    std::size_t intersecting = 0;
    for (const NamedMesh& mesh : meshes) {
        CAPTURE(mesh.name);
        const Verdict ours = ourVerdict(mesh);
        const Verdict theirs = verdictOfCgal(mesh);
        CHECK(ours.manifold == theirs.manifold);
        // CGAL requires that no triangle is degenerate, and says that such a one intersects itself.
        const bool degenerate = std::any_of(
            mesh.triangles.begin(), mesh.triangles.end(),
            [&](const se::Triangle& t) { return triangleOf(mesh.points, t).is_degenerate(); });
        if (degenerate) continue;
        CHECK(ours.intersecting == theirs.intersecting);
        manifold += theirs.manifold ? 1 : 0;
        intersecting += theirs.intersecting ? 1 : 0;
    }
    MESSAGE(meshes.size(), " meshes, ", manifold, " manifold, ", intersecting,
            " of them intersect themselves");
    CHECK(manifold < meshes.size());
    CHECK(intersecting > 0);
    CHECK(intersecting < manifold);
}
