/// The input doctor: finds problems in the points of a file that upset the algorithm, before they
/// are prepared, and repairs those that need no guess (docs/doctor.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/points/input_facts.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se {

/// Severity of a finding. Warnings and errors are problems; notes also occur on good inputs.
enum class Severity : std::uint8_t {
    Note,
    Warning,  ///< The points are used, but the mesh may suffer.
    Error,    ///< The points cannot be used as they are.
};
/// "note", "warning", "error".
std::string_view severityName(Severity severity);

struct Finding;
struct ExaminedFile;  // The input of the checks; made by examine().

/// The fix as data, for callers that apply it without the command line.
enum class Fix : std::uint8_t {
    None,       ///< Nothing: the command only reports, or there is none.
    Repair,     ///< applyFixes(), without guessing.
    Drop,       ///< applyFixes(), which also drops the points that were found.
    Orient,     ///< NormalSource::Oriented.
    Derive,     ///< NormalSource::Derived.
    NewLists,   ///< The 12 nearest, even if the file has lists.
    Symmetric,  ///< NeighborOptions::symmetric.
    Walls,      ///< Types of the walls of the box around all points.
    Rim,        ///< PrepareOptions::rim.
};

/// The option of a run that makes a fix: "--orient"; empty if the file is changed, or nothing is.
std::string_view optionOf(Fix fix);

/// One row of the table of checks: a new check is one function and one row.
struct DoctorCheck {
    std::string_view name;     ///< As in JSON: `flipped_normals`.
    std::string_view section;  ///< Of the paper, with the rule that is upset: "6.1".
    std::string_view upsets;   ///< The consequence there, as a sentence.
    Fix fix;
    /// Nothing if the file does not have the problem.
    std::optional<Finding> (*find)(const ExaminedFile& examined);
    /// Without a fix: the option of a run that helps, X,Y,Z in place of Finding::scale; empty if
    /// there is none.
    std::string_view advice = {};

    /// True if applyFixes() repairs it.
    bool hasSafeFix() const { return fix == Fix::Repair; }
    /// The command that helps, IN in place of the input, X,Y,Z of Finding::scale; empty if there is
    /// none.
    std::string remedy() const;
};

/// All checks, in the order of the report.
std::span<const DoctorCheck> doctorChecks();
/// Null if there is none of that name.
const DoctorCheck* findDoctorCheck(std::string_view name);

/// A line in space that shows a finding: in the unit of the file.
struct EvidenceLine {
    Vec3 from, to;
    bool asItShouldBe = false;  ///< Not what is wrong, but what the points say instead.
    friend bool operator==(const EvidenceLine&, const EvidenceLine&) = default;
};

/// The effect of a command that was tried on the file (why/tried_fixes.h).
struct TriedFix {
    bool helps = false;
    std::string text;  ///< A piece of a sentence: "by paper sound (before 4 points amiss)".
};

/// The beginning of the part of Finding::text about Finding::scale.
inline constexpr std::string_view kWithFactors = "; with ";

/// A problem of a file, or a fact worth knowing about it.
struct Finding {
    const DoctorCheck* check = nullptr;
    Severity severity = Severity::Warning;
    std::size_t count = 0;  ///< Of points, or of list entries, as `text` says.
    /// The points concerned, ascending; empty if it is the file as a whole.
    std::vector<Index> points;
    std::string text;  ///< One sentence with the numbers.
    /// The points to drop, ascending, if they are others than `points`: of points in layers or
    /// noise, those that leave the rest far enough apart.
    std::optional<std::vector<Index>> surplus{};
    /// Reason for dropping these points, a piece of a sentence.
    std::string dropReason = "as requested";

    /// The points that Fix::Drop leaves out.
    const std::vector<Index>& toDrop() const { return surplus ? *surplus : points; }
    /// Lines that show it, at some of the places: given normals beside those of the planes, pairs,
    /// the way to the farthest of a list in lines and in mixed units, steps of rounded coordinates.
    /// At most 1,000.
    std::vector<EvidenceLine> lines{};
    std::optional<TriedFix> tried{};  ///< Nothing: not tried, or no command.
    std::size_t present = 0;          ///< Points with a place of their own, in the whole file.
    /// True if Fix::Drop would leave fewer than half of the points: see requireMostLeft().
    bool dropsMost() const { return check->fix == Fix::Drop && 2 * toDrop().size() > present; }
    /// True if Fix::Drop would leave none: no remedy.
    bool dropsAll() const { return check->fix == Fix::Drop && toDrop().size() >= present; }
    /// Factors by which the axes get one unit (Piece::scale). Nothing: a command with --scale-by
    /// has none.
    std::optional<Vec3> scale{};
    /// True if there is a command, whether or not it was tried.
    bool hasRemedy() const;
    bool isProblem() const { return severity != Severity::Note; }
};

/// The command of a finding's check, with the factors of the finding, the input in place of IN and
/// the file that it writes in place of OUT.ply, both as words of a shell (shellPath()); also one
/// without gain; empty if there is none.
std::string commandOf(const Finding& finding, std::string_view input,
                      std::string_view output = "OUT.ply");

/// The command that helps with a finding, with kForceOption where it drops most of the points;
/// empty also if it would drop all, has no factors, or was tried and does not help.
std::string remedyFor(const Finding& finding, std::string_view input,
                      std::string_view output = "OUT.ply");

/// The result of examine().
struct Diagnosis {
    /// Errors, then warnings, then notes; equals in the order of doctorChecks().
    std::vector<Finding> findings;
    InputFacts facts;  ///< Of the points, with or without findings.
};
/// True if some finding is a problem.
bool hasProblem(const Diagnosis& diagnosis);

/// Points to drop, ascending, with the reason as a piece of a sentence.
struct ProposedDrop {
    std::vector<Index> points;
    std::string reason;
};
/// The points that the findings of these checks propose to drop (Finding::toDrop()).
ProposedDrop proposedDrop(const Diagnosis& diagnosis, std::span<const std::string> checks);

/// Runs all checks. Fails if the columns of the file differ in length, or if cancelled.
/// Deterministic. O(points log points); a million points take some seconds.
Result<Diagnosis> examine(const PointFile& file, const Progress& progress = {});

/// One change that applyFixes() made.
struct AppliedFix {
    std::string_view name;  ///< The check that would have found it; "dropped" for `alsoDrop`.
    std::size_t count = 0;
    std::string text;  ///< One sentence.
};

struct FixedFile {
    PointFile file;
    std::vector<AppliedFix> fixes;  ///< Empty: the file is unchanged.

    /// The sentences of the fixes.
    std::vector<std::string> texts() const;
};

/// Makes the repairs that need no guess, the same that every prepare() makes: drops points whose
/// position is not finite or is that of a point before; derives normals that are zero or not finite
/// (completeNormals(); if most are, all normals are removed, so that they are derived); scales
/// normals; corrects corner bits; puts lists in order and drops entries that name no other point.
/// `alsoDrop` (ascending) names points to leave out as well.
/// The order of points, attributes and faces is kept; faces on a copy move to its original, and
/// faces on other dropped points are removed. Requires columns of equal length, as examine()
/// checks. `reason`: of these, a piece of a sentence, as Finding::dropReason.
FixedFile applyFixes(const PointFile& file, std::span<const Index> alsoDrop = {},
                     std::string_view reason = "as requested");

/// Fails if the fixes leave fewer than half of the distinct finite positions, or no point at all of
/// some: what is wrong then is not in the points that they drop. `done` has the text of each fix;
/// the error has these and what would be left, as a piece of a sentence. O(points).
Status requireMostLeft(std::span<const Vec3> before, std::span<const Vec3> after,
                       std::span<const std::string> done);

}  // namespace se
