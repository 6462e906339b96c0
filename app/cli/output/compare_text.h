/// Reports of `compare`, as text and as JSON.
#pragma once

#include <string>

#include "spiraling_edge/explain/run_compare.h"
#include "spiraling_edge/mesh/mesh_compare.h"

namespace se::cli {

/// One of the two meshes that were compared.
struct ComparedSide {
    std::string title;  ///< "--rules paper", or the name of a file.
    MadeMesh mesh;      ///< Of a file: `made` is empty.
};

/// Everything that the comparison found.
struct Comparison {
    std::string input;
    std::size_t points = 0;
    ComparedSide a, b;
    MeshDifference meshes;
    /// Course of two runs; empty for a mesh from a file.
    std::optional<RunComparison> runs;
    std::vector<Index> unmatchedVertices;  ///< Vertices of the file that lie on no point.
};

/// Text with at most `most` regions.
std::string comparisonText(const Comparison& comparison, std::size_t limit);
std::string comparisonJson(const Comparison& comparison);

}  // namespace se::cli
