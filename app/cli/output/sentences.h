/// Sentences about meshes and points that `run` and `info` share.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "input.h"
#include "output.h"
#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/points/input_facts.h"
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
/// "15 not finite, 50 copies of another point": numbers of points by Aside; empty if all are 0.
std::string setAsideSentence(const std::array<std::size_t, kAsides>& aside);
/// An object with those numbers by reason.
Json setAsideJson(const std::array<std::size_t, kAsides>& aside);
/// The record of the input as lines: spacing, normals, points set aside, twins, pieces; in JSON as
/// `facts`. `givenNormals`: the file has a column of normals.
void addInputFacts(const InputFacts& facts, bool givenNormals, Answer& answer);
Json inputFactsJson(const InputFacts& facts);
/// "12345 of 1000000 points: crop, thin 0.5, scale 1,1,0.001"; empty for a whole file as it is.
std::string keptSentence(const InputPiece& read);
/// The content of keptSentence() as JSON, with the box; null for a whole file.
Json keptJson(const InputPiece& read);
/// The notes of a reader, each on a line of its own under "read".
void addNotes(const std::vector<std::string>& notes, Answer& answer);
/// "x y z red green blue (columns 4 to 6 are whole numbers from 0 to 255: colors)".
std::string columnsSentence(const ColumnReading& columns);
/// Appends `part` to `list` after a comma.
void appendPart(std::string& list, const std::string& part);

}  // namespace se::cli
