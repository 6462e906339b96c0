/// Sentences about meshes and points that `run` and `info` share.
#pragma once

#include <string>

#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::cli {

/// "366 triangles in 2 components, 64 boundary edges in 4 loops, Euler characteristic 1".
std::string meshSentence(const MeshReport& mesh);
/// "4 loops, the widest 0.12 across (42 edges)": what stays open; empty if nothing does.
std::string openSentence(const MeshReport& mesh);
/// "2 non-manifold edges, 1 flipped triangle"; empty if there is none.
std::string defectSentence(const MeshReport& mesh);
/// "15 not finite, 50 duplicates"; empty if nothing was set aside.
std::string setAsideSentence(const PrepareReport& report);
/// "x y z red green blue (columns 4 to 6 are whole numbers from 0 to 255: colors)".
std::string columnsSentence(const ColumnReading& columns);
/// "1 edge", "2 edges".
std::string counted(std::size_t count, const std::string& noun, const std::string& plural = "");
/// Appends `part` to `list` after a comma.
void appendPart(std::string& list, const std::string& part);

}  // namespace se::cli
