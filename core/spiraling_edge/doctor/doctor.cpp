/// The table of checks and the run over it. The examined file (checks.h) holds the values that
/// checks share; its neighbor search takes about half of the time.
#include "spiraling_edge/doctor/doctor.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <utility>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/doctor/checks.h"

namespace se {
namespace {

constexpr std::string_view kBest = "--best";
constexpr std::string_view kScale = "--scale-by X,Y,Z";

constexpr std::array kChecks{
    DoctorCheck{"non_finite", "3",
                "A point needs a place, three finite coordinates: these are set aside.",
                Fix::Repair, findNonFinite},
    DoctorCheck{"duplicates", "3",
                "\"There is only one point at any particular location\": copies are set aside.",
                Fix::Repair, findDuplicates},
    DoctorCheck{"sentinels", "3",
                "Lists and sizes would reach to a place where no surface is: these are set aside.",
                Fix::Repair, findSentinels},
    DoctorCheck{"too_few_points", "4",
                "An edge ring begins with two points, and a triangle needs a third.", Fix::None,
                findTooFewPoints},
    DoctorCheck{
        "near_duplicates", "6.1",
        "The direction to so near a point is chance, and so is its place in the angle sort.",
        Fix::Drop, findNearDuplicates},
    DoctorCheck{"isolated_points", "4",
                "No point has them in its list, so no fan takes them: noise, as the paper says.",
                Fix::Drop, findIsolatedPoints},
    DoctorCheck{"in_line", "6.3", "Three points in line have no circle, and no plane to sort in.",
                Fix::Drop, findInLine},
    DoctorCheck{"mixed_units", "3",
                "The nearest points are not those about a point: convert the coordinates to one "
                "unit first.",
                Fix::None, findMixedUnits, kScale},
    DoctorCheck{"extreme_size", "6.3",
                "The rules of robust compute products of up to six lengths, which overflow or "
                "vanish: scale the points by a power of two, without rounding.",
                Fix::None, findExtremeSize, kScale},
    DoctorCheck{"lost_digits", "3",
                "Points were moved by up to half a step: write the file again with more digits, or "
                "subtract an offset first.",
                Fix::None, findLostDigits},
    DoctorCheck{"curves", "3",
                "A mesh needs points all over a surface: scan the surface itself, or add slices "
                "near these.",
                Fix::None, findCurves},
    DoctorCheck{"twins", "6.1",
                "The order about a point is chance where another is so near: keep one of each "
                "pair.",
                Fix::Drop, findTwins},
    DoctorCheck{"lines", "3",
                "Lists of the nearest points do not reach from one line to the next: thin the "
                "points along the lines.",
                Fix::Drop, findLines},
    DoctorCheck{"uneven_spacing", "3",
                "Lists of a fixed radius are too long here and empty there: take the nearest.",
                Fix::None, findUnevenSpacing, kBest},
    DoctorCheck{"noise", "6.1",
                "Each point becomes a corner, so the mesh follows the noise: smooth the points "
                "first, thin them, or use a method that approximates.",
                Fix::Drop, findNoise},
    DoctorCheck{"two_layers", "6.1",
                "Triangles jump from one layer to the other: register the scans first, keep one of "
                "them, or thin them.",
                Fix::Drop, findTwoLayers},
    DoctorCheck{"ties", "6.3",
                "Points exactly on the circle of three others: which diagonal is taken depends on "
                "the order alone.",
                Fix::None, findTies, kBest},
    DoctorCheck{"no_normals", "3", "The normals are derived from the positions.", Fix::None,
                findNoNormals, kBest},
    DoctorCheck{"zero_normals", "6.1",
                "Angles are measured about the normal: one without a direction is derived from the "
                "positions.",
                Fix::Repair, findZeroNormals},
    DoctorCheck{"unscaled_normals", "6.2",
                "The plane of a hole adds up normals: long ones would outweigh the others.",
                Fix::Repair, findUnscaledNormals},
    DoctorCheck{"unfit_normals", "6.1",
                "The sort by angle takes place about the normal: the order about one that is not "
                "the surface's is wrong.",
                Fix::Derive, findUnfitNormals},
    DoctorCheck{"flipped_normals", "6.1",
                "Seen from the other side the ring runs clockwise: holes and overlaps follow.",
                Fix::Orient, findFlippedNormals},
    DoctorCheck{"inside_out", "3", "The triangles will face inwards.", Fix::Orient, findInsideOut},
    DoctorCheck{"close_sheets", "3",
                "Lists reach through to the other sheet: what opposes must be left out, and short "
                "lists are better.",
                Fix::None, findCloseSheets, kBest},
    DoctorCheck{"entries_outside", "3", "A list names points that do not exist.", Fix::Repair,
                findEntriesOutside},
    DoctorCheck{"repeated_entries", "3",
                "A list names its own point, or another one twice: these entries are dropped.",
                Fix::Repair, findRepeatedEntries},
    DoctorCheck{"unsorted_lists", "4",
                "The nearest neighbor begins the ring, so lists must begin with it.", Fix::Repair,
                findUnsortedLists},
    DoctorCheck{"short_lists", "6.4", "A closed fan needs three neighbors; at a wall two.",
                Fix::NewLists, findShortLists},
    DoctorCheck{"unsymmetric_lists", "6.1",
                "A point may be a candidate where the pivot is none in turn; the k nearest always "
                "are so.",
                Fix::Symmetric, findUnsymmetricLists},
    DoctorCheck{"corner_bits", "4",
                "\"Two or more of these subtypes also sets the corner bit\": it is corrected.",
                Fix::Repair, findCornerBits},
    DoctorCheck{"types_off_box", "7.1",
                "Wall points are passed over, and corners turned, by their types.", Fix::Walls,
                findTypesOffBox},
    DoctorCheck{"open_border", "7",
                "A ring ends at boundary points; without their types an opening looks like a hole, "
                "and is closed.",
                Fix::Rim, findOpenBorder},
};

/// Checks whose findings follow from a greater cause: where that is found, they would say the same
/// in other words, with remedies that do not help.
struct Consequences {
    std::string_view cause;
    std::array<std::string_view, 15> checks;
};
constexpr std::array kConsequences{
    Consequences{"mixed_units",
                 {"near_duplicates", "isolated_points", "in_line", "curves", "twins", "lines",
                  "uneven_spacing", "noise", "two_layers", "ties", "unfit_normals",
                  "flipped_normals", "inside_out", "close_sheets"}},
    Consequences{"curves",
                 {"near_duplicates", "isolated_points", "in_line", "twins", "lines",
                  "uneven_spacing", "noise", "two_layers", "ties", "no_normals", "unfit_normals",
                  "flipped_normals", "inside_out", "close_sheets", "open_border"}},
    Consequences{"lines", {"open_border"}},
    Consequences{"lost_digits", {"near_duplicates", "twins", "lines", "noise", "two_layers"}},
};

void leaveOutConsequences(std::vector<Finding>& findings) {
    const auto isFound = [&](std::string_view name) {
        return std::any_of(findings.begin(), findings.end(),
                           [&](const Finding& finding) { return finding.check->name == name; });
    };
    for (const Consequences& row : kConsequences) {
        if (!isFound(row.cause)) continue;
        std::erase_if(findings, [&](const Finding& finding) {
            return isAmong(finding.check->name, row.checks);
        });
    }
}

/// Share of the search for the nearest points in the whole work.
constexpr double kSearchShare = 0.5;

constexpr std::size_t kAround = 6;

/// Median of the values above zero, 0 without any.
double medianAboveZero(std::vector<double> values) {
    values.erase(std::remove(values.begin(), values.end(), 0.0), values.end());
    if (values.empty()) return 0.0;
    return medianOf(values);
}

/// True if normals are off by little more than those that fit: of noise, not wrong ones.
bool isRough(const NormalFit& fit) {
    constexpr double kMedianCosine = 0.94551857559931696;  // 19 degrees
    return fit.normals > 0 && fit.medianCosine >= kMedianCosine &&
           static_cast<double>(fit.near) >= kFitLimits.nearShare * static_cast<double>(fit.places);
}

}  // namespace

std::string_view severityName(Severity severity) {
    constexpr std::array<std::string_view, 3> kNames{"note", "warning", "error"};
    return kNames[static_cast<std::size_t>(severity)];
}

std::string_view optionOf(Fix fix) {
    // In the order of the enum.
    constexpr std::string_view kOptions[] = {"",
                                             "",
                                             "",
                                             "--orient",
                                             "--derive-normals",
                                             "--neighbors 12",
                                             "--symmetric",
                                             "--box auto",
                                             "--derive-rim"};
    static_assert(std::size(kOptions) == static_cast<std::size_t>(Fix::Rim) + 1);
    return kOptions[static_cast<std::size_t>(fix)];
}

std::string DoctorCheck::remedy() const {
    if (fix == Fix::Repair || fix == Fix::Drop) {
        const std::string command = "spiraling-edge doctor IN --fix OUT.ply";
        return fix == Fix::Repair ? command : command + " --drop " + std::string(name);
    }
    const std::string_view option = fix == Fix::None ? advice : optionOf(fix);
    return option.empty() ? "" : "spiraling-edge run IN " + std::string(option) + " -o OUT.ply";
}

std::span<const DoctorCheck> doctorChecks() { return kChecks; }

const DoctorCheck* findDoctorCheck(std::string_view name) { return findNamed(kChecks, name); }

namespace {

void replaceOnce(std::string& text, std::string_view placeholder, std::string_view word) {
    const std::size_t at = text.find(placeholder);
    if (at != std::string::npos) text.replace(at, placeholder.size(), word);
}

}  // namespace

bool Finding::hasRemedy() const {
    const bool lacksFactors = check->advice == kScale && !scale;
    return !check->remedy().empty() && !dropsAll() && !lacksFactors;
}

std::string commandOf(const Finding& finding, std::string_view input, std::string_view output) {
    std::string command = finding.check->remedy();
    if (finding.scale) replaceOnce(command, "X,Y,Z", plainNumbers(*finding.scale));
    // From the end, since the name of the input may contain the placeholder.
    replaceOnce(command, "OUT.ply", output);
    replaceOnce(command, "IN", input);
    return command;
}

std::string remedyFor(const Finding& finding, std::string_view input, std::string_view output) {
    if (!finding.hasRemedy() || (finding.tried && !finding.tried->helps)) return {};
    std::string command = commandOf(finding, input, output);
    if (finding.dropsMost()) command.append(" ").append(kForceOption);
    return command;
}

bool hasProblem(const Diagnosis& diagnosis) {
    return std::any_of(diagnosis.findings.begin(), diagnosis.findings.end(),
                       [](const Finding& finding) { return finding.isProblem(); });
}

ProposedDrop proposedDrop(const Diagnosis& diagnosis, std::span<const std::string> checks) {
    ProposedDrop drop;
    for (const Finding& finding : diagnosis.findings) {
        if (!isAmong(finding.check->name, checks)) continue;
        drop.points.insert(drop.points.end(), finding.toDrop().begin(), finding.toDrop().end());
        if (drop.reason.find(finding.dropReason) != std::string::npos) continue;
        drop.reason.append(drop.reason.empty() ? "" : ", ").append(finding.dropReason);
    }
    sortUnique(drop.points);
    return drop;
}

double ExaminedFile::distance(Index p, Index q) const {
    return std::sqrt(distanceSquared(file.position[p], file.position[q]));
}

std::vector<Index> ExaminedFile::presentPoints() const {
    return pointsWhere(size(), [this](Index p) { return present()[p]; });
}

Result<ExaminedFile> examineFile(const PointFile& file, const Progress& progress) {
    ExaminedFile examined{file};
    Result<Intake> intake = takeIn(file, progress);
    if (!intake) return intake.error();
    examined.intake = std::move(intake.value());
    examined.presentCount = static_cast<std::size_t>(
        std::count(examined.present().begin(), examined.present().end(), true));
    examined.spacing.resize(file.position.size(), 0.0);
    for (Index p = 0; p < examined.size(); ++p) {
        const auto list = examined.nearest()[p];
        if (list.empty()) continue;
        examined.spacing[p] = examined.distance(p, list[std::min(kAround, list.size()) - 1]);
    }
    examined.middleSpacing = medianAboveZero(examined.spacing);
    examined.normalsNear = examined.normalsFit() || isRough(examined.intake.fit);
    if (examined.normalsNear) {
        examined.sides =
            sidesOf({file.position, examined.normal(), examined.present(), examined.nearest()});
    } else {
        examined.sides = {std::vector<Index>(file.position.size(), kNone),
                          std::vector<bool>(file.position.size(), false)};
    }
    examined.units = mixedUnitsOf(examined);
    examined.roughness = roughnessOf(examined);
    examined.layers = layersOf(examined);
    return examined;
}

std::optional<Finding> findingAt(std::vector<Index> points, Severity severity,
                                 const std::string& what, std::string_view noun) {
    if (points.empty()) return std::nullopt;
    const std::size_t count = points.size();
    return Finding{nullptr, severity, count, std::move(points), counted(count, noun) + " " + what};
}

Result<Diagnosis> examine(const PointFile& file, const Progress& progress) {
    const Result<ExaminedFile> examined = examineFile(file, partOf(progress, 0.0, kSearchShare));
    if (!examined) return examined.error();
    Diagnosis diagnosis{{}, examined.value().intake.judge->facts};
    for (std::size_t i = 0; i < kChecks.size(); ++i) {
        const double done = static_cast<double>(i) / static_cast<double>(kChecks.size());
        if (progress && !progress(kSearchShare + (1.0 - kSearchShare) * done))
            return Error{"the examination was cancelled"};
        std::optional<Finding> finding = kChecks[i].find(examined.value());
        if (!finding) continue;
        finding->check = &kChecks[i];
        finding->present = examined.value().presentCount;
        diagnosis.findings.push_back(std::move(*finding));
    }
    leaveOutConsequences(diagnosis.findings);
    std::stable_sort(diagnosis.findings.begin(), diagnosis.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
    if (progress) progress(1.0);
    return diagnosis;
}

}  // namespace se
