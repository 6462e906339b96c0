// Crust: N. Amenta, M. Bern and M. Kamvysselis, A New Voronoi-Based Surface Reconstruction
// Algorithm, SIGGRAPH 1998, sections 3.2 (poles and crust) and 3.3 (filtering by normals), written
// here on CGAL's Delaunay triangulation. The paper's last step, which trims the result to a
// manifold, is left out: slivers of flat or crowded points keep both their sides.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cloud_facts.h"
#include "method.h"

namespace se::peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<
    Kernel,
    CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>,
                                         CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;
using Numbered = std::vector<std::pair<Kernel::Point_3, Index>>;

// The paper's theta: the largest angle allowed between a triangle's normal and the direction to a
// pole at the corner of the triangle's largest angle; 1.5 times that at the others.
constexpr double kTheta = 45.0 * std::numbers::pi / 180.0;

/// The two poles of a sample, as directions; a zero vector is none.
struct Poles {
    Vec3 plus{0.0};
    Vec3 minus{0.0};
};

Vec3 toVec(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

Kernel::Point_3 toPoint(const Vec3& v) { return {v.x, v.y, v.z}; }

bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The mean outward normal of the hull triangles among the cells around a vertex.
Vec3 hullNormal(const Delaunay& delaunay, const std::vector<Delaunay::Cell_handle>& cells) {
    Vec3 sum(0.0);
    for (const Delaunay::Cell_handle& cell : cells) {
        if (!delaunay.is_infinite(cell)) continue;
        const int infinite = cell->index(delaunay.infinite_vertex());
        std::array<Vec3, 3> corner;
        for (int i = 0; i < 3; ++i)
            corner[static_cast<std::size_t>(i)] =
                toVec(cell->vertex(Delaunay::vertex_triple_index(infinite, i))->point());
        Vec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        // Away from the finite tetrahedron on the other side.
        const auto inner = cell->neighbor(infinite);
        const Vec3 apex = toVec(inner->vertex(inner->index(cell))->point());
        if (glm::dot(normal, apex - corner[0]) > 0.0) normal = -normal;
        if (glm::dot(normal, normal) > 0.0) sum += glm::normalize(normal);
    }
    return sum;
}

/// The farthest Voronoi vertices of a sample: of all, and of those on the other side.
Poles polesOf(const Delaunay& delaunay, Delaunay::Vertex_handle vertex, bool& onHull) {
    std::vector<Delaunay::Cell_handle> cells;
    delaunay.incident_cells(vertex, std::back_inserter(cells));
    const Vec3 here = toVec(vertex->point());
    const auto farthest = [&](const Vec3& against) {
        Vec3 best(0.0);
        for (const auto& cell : cells) {
            if (delaunay.is_infinite(cell)) continue;
            const Vec3 away = toVec(delaunay.dual(cell)) - here;
            if (isFinite(away) && glm::dot(away, against) <= 0.0 &&
                glm::dot(away, away) > glm::dot(best, best))
                best = away;
        }
        return best;
    };
    onHull = std::any_of(cells.begin(), cells.end(),
                         [&](const auto& cell) { return delaunay.is_infinite(cell); });
    Poles poles;
    poles.plus = onHull ? hullNormal(delaunay, cells) : farthest(Vec3(0.0));
    poles.minus = farthest(poles.plus);
    return poles;
}

/// The angle between a line along `normal` and a direction, in [0, pi / 2].
double lineAngle(const Vec3& normal, const Vec3& direction) {
    const double lengths = glm::length(normal) * glm::length(direction);
    if (lengths == 0.0) return 0.0;
    return std::acos(std::min(1.0, std::abs(glm::dot(normal, direction)) / lengths));
}

bool passesNormals(const PointFile& points, const std::vector<Poles>& poles,
                   const std::array<Index, 3>& corner) {
    std::array<Vec3, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = points.position[corner[i]];
    const Vec3 normal = glm::cross(at[1] - at[0], at[2] - at[0]);
    const auto opposite = [&](std::size_t i) {
        const Vec3 side = at[(i + 2) % 3] - at[(i + 1) % 3];
        return glm::dot(side, side);
    };
    const std::size_t largest = opposite(0) > opposite(1) ? (opposite(0) > opposite(2) ? 0 : 2)
                                                          : (opposite(1) > opposite(2) ? 1 : 2);
    for (std::size_t i = 0; i < 3; ++i) {
        const double most = i == largest ? kTheta : 1.5 * kTheta;
        if (lineAngle(normal, poles[corner[i]].plus) > most) return false;
        if (lineAngle(normal, poles[corner[i]].minus) > most) return false;
    }
    return true;
}

/// Adds the poles of all samples to `sites`, marked as no samples.
std::vector<Poles> addPoles(const PointFile& points, const Delaunay& delaunay, Numbered& sites) {
    std::vector<Poles> poles(points.position.size());
    for (const auto& vertex : delaunay.finite_vertex_handles()) {
        bool onHull = false;
        const Poles found = polesOf(delaunay, vertex, onHull);
        poles[vertex->info()] = found;
        const Vec3 here = toVec(vertex->point());
        const auto add = [&](const Vec3& away) {
            if (glm::dot(away, away) > 0.0) sites.emplace_back(toPoint(here + away), kNone);
        };
        if (!onHull) add(found.plus);  // on the hull it is a direction without a place
        add(found.minus);
    }
    return poles;
}

}  // namespace

Outcome crust(const PointFile& points, std::size_t) {
    Outcome outcome;
    StopWatch watch;
    Numbered sites;
    for (const Vec3& p : points.position)
        sites.emplace_back(toPoint(p), static_cast<Index>(sites.size()));
    const Delaunay samples(sites.begin(), sites.end());
    outcome.searchSeconds = watch.lap();

    const std::vector<Poles> poles = addPoles(points, samples, sites);
    const Delaunay both(sites.begin(), sites.end());
    for (auto facet = both.finite_facets_begin(); facet != both.finite_facets_end(); ++facet) {
        const auto& [cell, opposite] = *facet;
        const std::array<Index, 3> corner{cell->vertex((opposite + 1) & 3)->info(),
                                          cell->vertex((opposite + 2) & 3)->info(),
                                          cell->vertex((opposite + 3) & 3)->info()};
        if (std::find(corner.begin(), corner.end(), kNone) != corner.end()) continue;
        if (passesNormals(points, poles, corner))
            outcome.triangles.push_back({corner[0], corner[1], corner[2]});
    }
    outcome.reconstructSeconds = watch.lap();
    orientEach(points, outcome.triangles);
    return outcome;
}

}  // namespace se::peers
