// Advancing front surface reconstruction: D. Cohen-Steiner and F. Da, The Visual Computer 2004;
// CGAL, with its default bounds (radius ratio 5, beta 0.52).
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>

#include "cloud_facts.h"
#include "method.h"

namespace se::peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Kernel>;
using CellBase = CGAL::Advancing_front_surface_reconstruction_cell_base_3<Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel,
                                   CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

}  // namespace

Outcome advancingFront(const PointFile& points, std::size_t) {
    Outcome outcome;
    StopWatch watch;
    std::vector<std::pair<Kernel::Point_3, std::size_t>> numbered;
    numbered.reserve(points.position.size());
    for (const Vec3& p : points.position)
        numbered.emplace_back(Kernel::Point_3(p.x, p.y, p.z), numbered.size());
    Delaunay delaunay(numbered.begin(), numbered.end());
    outcome.searchSeconds = watch.lap();

    CGAL::Advancing_front_surface_reconstruction<Delaunay> front(delaunay);
    front.run(5.0, 0.52);
    std::vector<std::array<std::size_t, 3>> triples;
    CGAL::write_triple_indices(std::back_inserter(triples), front);
    for (const auto& [a, b, c] : triples)
        outcome.triangles.push_back(
            {static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
    outcome.reconstructSeconds = watch.lap();
    orientPieces(points, outcome.triangles);
    return outcome;
}

}  // namespace se::peers
