/// Closed pieces of a mesh that face in. A piece within another one is the wall of a cavity where
/// the given normals say so, which the check of flipped triangles compares.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "spiraling_edge/geometry/box.h"
#include "spiraling_edge/mesh/inspection_checks.h"

namespace se::inspect {
namespace {

/// A closed piece: every edge is of two triangles that pass it in opposite directions.
struct ClosedPiece {
    std::vector<Index> triangles;
    Box box{Vec3(0.0)};
    double volume = 0.0;  ///< Six times; above 0 where it faces out.
};

/// The closed pieces, by their least points.
std::map<Index, ClosedPiece> closedPieces(const InspectedMesh& mesh) {
    std::vector<bool> open(mesh.points.size(), false);
    for (const std::span<const TriangleSide> edge : mesh.topology.irregularEdges)
        open[mesh.topology.component[edge.front().low]] = true;
    std::map<Index, ClosedPiece> pieces;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const Index name = mesh.topology.component[t.a];
        if (open[name]) continue;
        ClosedPiece& piece = pieces[name];
        // Relative to a point of the piece: far from the origin little would be left.
        const Vec3& origin = mesh.points.position[name];
        if (piece.triangles.empty()) piece.box = Box(origin);
        piece.triangles.push_back(static_cast<Index>(i));
        const Vec3 a = mesh.points.position[t.a] - origin;
        const Vec3 b = mesh.points.position[t.b] - origin;
        const Vec3 c = mesh.points.position[t.c] - origin;
        piece.volume += glm::dot(a, glm::cross(b, c));
        for (const Index p : {t.a, t.b, t.c}) piece.box.add(mesh.points.position[p]);
    }
    return pieces;
}

/// True if `x` is within a closed piece, by the solid angle of its triangles (van Oosterom and
/// Strackee 1983).
bool isWithin(const InspectedMesh& mesh, const ClosedPiece& piece, const Vec3& x) {
    double angle = 0.0;
    for (const Index i : piece.triangles) {
        const Triangle& t = mesh.triangles[i];
        const Vec3 a = mesh.points.position[t.a] - x;
        const Vec3 b = mesh.points.position[t.b] - x;
        const Vec3 c = mesh.points.position[t.c] - x;
        const double la = glm::length(a);
        const double lb = glm::length(b);
        const double lc = glm::length(c);
        angle += std::atan2(
            glm::dot(a, glm::cross(b, c)),
            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return std::abs(angle) > std::numbers::pi;
}

bool contains(const Box& outer, const Box& inner) {
    return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
           glm::all(glm::lessThanEqual(inner.high, outer.high));
}

}  // namespace

void inwardPieces(const InspectedMesh& mesh, Failures& failures) {
    const std::map<Index, ClosedPiece> pieces = closedPieces(mesh);
    for (const auto& [name, piece] : pieces) {
        if (!(piece.volume < 0.0)) continue;
        const Vec3& x = mesh.points.position[name];
        const bool nested = std::any_of(pieces.begin(), pieces.end(), [&](const auto& other) {
            return other.first != name && contains(other.second.box, piece.box) &&
                   isWithin(mesh, other.second, x);
        });
        if (nested && (mesh.judge == nullptr || mesh.judge->fit)) continue;
        const Index first = piece.triangles.front();
        const Triangle& t = mesh.triangles[first];
        failures.push_back(mesh.at({t.a, t.b, t.c}, {first}));
    }
}

}  // namespace se::inspect
