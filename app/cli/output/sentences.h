/// Sentences about meshes and points that `run` and `info` share.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "answer.h"
#include "input.h"
#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::cli {

/// "366 triangles in 2 components, 64 boundary edges in 4 loops, Euler characteristic 1".
std::string meshSentence(const MeshReport& mesh);
/// "4 loops, the widest 0.12 across (42 edges)": what stays open; empty if nothing does.
std::string openSentence(const MeshReport& mesh);
/// A defect that a mesh can have: its key in JSON, its noun, its count.
struct MeshDefect {
    std::string_view key;
    std::string_view noun;
    std::size_t MeshReport::*count;
};
std::span<const MeshDefect> meshDefects();
/// "2 non-manifold edges, 1 flipped triangle"; empty if there is none.
std::string defectSentence(const MeshReport& mesh);
/// A reason to set points aside: its key in JSON, its words, its count.
struct SetAside {
    std::string_view key;
    std::string_view words;
    std::size_t PrepareReport::*count;
};
std::span<const SetAside> setAsides();
/// "15 not finite, 50 duplicates"; empty if nothing was set aside.
std::string setAsideSentence(const PrepareReport& report);
/// "12345 of 1000000 points: crop, thin 0.5"; empty for a whole file.
std::string keptSentence(const KeptPoints& points);
/// The same with the box; null for a whole file.
Json keptJson(const KeptPoints& points);
/// The notes of a reader, each on a line of its own under "read".
void addNotes(const std::vector<std::string>& notes, Answer& answer);
/// "x y z red green blue (columns 4 to 6 are whole numbers from 0 to 255: colors)".
std::string columnsSentence(const ColumnReading& columns);
/// Appends `part` to `list` after a comma.
void appendPart(std::string& list, const std::string& part);

}  // namespace se::cli
