/// The input doctor: looks for what will upset the algorithm in the points of a file, before they
/// are prepared, and mends what can be mended without guessing (docs/doctor.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se {

/// How bad a finding is. Warnings and errors accuse; a note is a fact worth knowing that good
/// inputs have, too.
enum class Severity : std::uint8_t {
    Note,
    Warning,  ///< The points are used, but the mesh may suffer.
    Error,    ///< The points cannot be used as they are.
};
/// "note", "warning", "error".
std::string_view severityName(Severity severity);

struct Finding;
struct Patient;  // What the checks look at; made by examine().

/// What its command does to the points before the run, for who does it without the command.
enum class Cure : std::uint8_t {
    None,       ///< Nothing: the command only looks, or there is none.
    Mend,       ///< treat(), without guessing.
    Drop,       ///< treat(), and the points that were found go, too.
    Orient,     ///< NormalSource::Oriented.
    NewLists,   ///< The 12 nearest, whatever the file says.
    Symmetric,  ///< NeighborOptions::symmetric.
    Walls,      ///< Types of the walls of the box around all points.
    Rim,        ///< PrepareOptions::rim.
};

/// One row of the table of checks: a new check is one function and one row.
struct DoctorCheck {
    std::string_view name;     ///< As in JSON: `flipped_normals`.
    std::string_view section;  ///< Of the paper, with the rule that is upset: "6.1".
    std::string_view upsets;   ///< What happens there, as a sentence.
    /// The command that helps, IN in place of the input; empty if there is none.
    std::string_view remedy;
    Cure cure;
    /// Nothing if the patient does not have it.
    std::optional<Finding> (*find)(const Patient& patient);

    /// treat() mends it.
    bool mended() const { return cure == Cure::Mend; }
};

/// All checks, in the order of the report.
std::span<const DoctorCheck> doctorChecks();
/// Null if there is none of that name.
const DoctorCheck* findDoctorCheck(std::string_view name);

/// Something that is wrong with a file, or worth knowing about it.
struct Finding {
    const DoctorCheck* check = nullptr;
    Severity severity = Severity::Warning;
    std::size_t count = 0;      ///< Of points, or of list entries, as `text` says.
    std::vector<Index> points;  ///< Where, ascending; empty if it is the file as a whole.
    std::string text;           ///< One sentence with the numbers.

    bool accuses() const { return severity != Severity::Note; }
};

/// The command that helps, with the input in place of IN and the file that it writes in place of
/// OUT.ply; empty if there is none.
std::string remedyFor(const DoctorCheck& check, std::string_view input,
                      std::string_view output = "OUT.ply");

/// The findings: errors, then warnings, then notes; equals in the order of doctorChecks().
using Diagnosis = std::vector<Finding>;
/// True if some finding accuses.
bool accuses(const Diagnosis& diagnosis);

/// Runs all checks. Fails if the columns of the file differ in length, or if cancelled.
/// Deterministic. O(points log points); a million points take some seconds.
Result<Diagnosis> examine(const PointFile& file, const Progress& progress = {});

/// One thing that treat() did.
struct Repair {
    std::string_view name;  ///< Of the check that would have found it; "dropped" for `alsoDrop`.
    std::size_t count = 0;
    std::string text;  ///< One sentence.
};

struct Treatment {
    PointFile file;
    std::vector<Repair> repairs;  ///< Empty: the file is as it was.
};

/// Mends what can be mended without guessing, which is what prepare() does for itself every time:
/// drops points that are not finite, have no direction or are exact copies; scales normals;
/// corrects corner bits; puts lists in order and drops entries that name no other point. Normals
/// that are all zero go as a whole, so that they are derived. `alsoDrop` (ascending) are points
/// that the caller decided to leave out. The order of points, attributes and faces is kept; faces
/// on a copy move to its original, and faces on other dropped points go. Requires what examine()
/// checks.
Treatment treat(const PointFile& file, std::span<const Index> alsoDrop = {});

}  // namespace se
