// Three-dimensional alpha shape: H. Edelsbrunner and E. P. Muecke, ACM TOG 1994; CGAL. The radius
// is twice the mean distance to the nearest point. The surface is the boundary of the shape:
// triangles with no cell on one side (regular) or on both (singular).
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "cloud_facts.h"
#include "method.h"

namespace se::peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Numbered = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using VertexBase = CGAL::Fixed_alpha_shape_vertex_base_3<Kernel, Numbered>;
using CellBase = CGAL::Fixed_alpha_shape_cell_base_3<Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel,
                                   CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Shape = CGAL::Fixed_alpha_shape_3<Delaunay>;

constexpr double kRadiusPerSpacing = 2.0;

}  // namespace

Outcome alphaShape(const PointFile& points, std::size_t) {
    Outcome outcome;
    StopWatch watch;
    const double radius = kRadiusPerSpacing * meanSpacing(points);
    std::vector<std::pair<Kernel::Point_3, Index>> numbered;
    numbered.reserve(points.position.size());
    for (const Vec3& p : points.position)
        numbered.emplace_back(Kernel::Point_3(p.x, p.y, p.z), static_cast<Index>(numbered.size()));
    Delaunay delaunay(numbered.begin(), numbered.end());
    outcome.searchSeconds = watch.lap();

    const Shape shape(delaunay, radius * radius);  // takes the triangulation over
    for (auto facet = shape.finite_facets_begin(); facet != shape.finite_facets_end(); ++facet) {
        const auto side = shape.classify(*facet);
        if (side != Shape::REGULAR && side != Shape::SINGULAR) continue;
        const auto& [cell, opposite] = *facet;
        outcome.triangles.push_back({cell->vertex((opposite + 1) & 3)->info(),
                                     cell->vertex((opposite + 2) & 3)->info(),
                                     cell->vertex((opposite + 3) & 3)->info()});
    }
    outcome.reconstructSeconds = watch.lap();
    orientEach(points, outcome.triangles);
    return outcome;
}

}  // namespace se::peers
