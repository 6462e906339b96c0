#include "doctor_fixes.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

namespace {

bool has(const std::vector<std::string>& fixes, Fix kind) {
    return std::any_of(fixes.begin(), fixes.end(), [kind](const std::string& name) {
        const DoctorCheck* check = findDoctorCheck(name);
        return check != nullptr && check->fix == kind;
    });
}

/// The file as read back after the doctor's command wrote it, with all numbers rounded to the types
/// they have there, so that the run equals that of the command.
PointFile asWritten(PointFile file) {
    Result<PointFile> read = readPoints(meshPlyBytes(file, file.faces), "mended.ply");
    return read ? std::move(read.value()) : std::move(file);
}

/// A column that follows the points through a repair, which keeps all columns.
constexpr std::string_view kNumberColumn = "spiraling_edge_number";

void numberPoints(PointFile& file) {
    Attribute numbers{std::string(kNumberColumn), ScalarType::UInt32, {}};
    numbers.values.resize(file.position.size());
    for (std::size_t p = 0; p < numbers.values.size(); ++p)
        numbers.values[p] = static_cast<double>(p);
    file.attributes.push_back(std::move(numbers));
}

/// The numbers of the points that are left, without their column.
std::vector<Index> takeNumbers(PointFile& file) {
    std::vector<Index> numbers;
    const auto at = std::find_if(file.attributes.begin(), file.attributes.end(),
                                 [](const Attribute& each) { return each.name == kNumberColumn; });
    assert(at != file.attributes.end());
    for (const double value : at->values) numbers.push_back(static_cast<Index>(value));
    file.attributes.erase(at);
    return numbers;
}

/// The positions without those of `dropped`, which ascend.
std::vector<Vec3> withoutPoints(const std::vector<Vec3>& position,
                                const std::vector<Index>& dropped) {
    std::vector<Vec3> left;
    for (Index p = 0; p < position.size(); ++p) {
        if (!std::binary_search(dropped.begin(), dropped.end(), p)) left.push_back(position[p]);
    }
    return left;
}

/// Repairs the file as the doctor does, and drops the points of `drop`, for the fix `name`. Fails
/// if most of the points at `places`, those of the input, would be gone then.
Status repair(const std::string& name, const ProposedDrop& drop, std::span<const Vec3> places,
              PointFile& file, FixesDone& done) {
    PointFile before = std::move(file);
    numberPoints(before);
    FixedFile fixed = applyFixes(before, drop.points, drop.reason);
    for (std::string& text : fixed.texts()) done.texts.push_back(std::move(text));
    const Status most = requireMostLeft(places, fixed.file.position, done.texts);
    if (!most) {
        return Error{"Not fixed: " + most.error().message +
                     ". Correct the file at its source, or let spiraling-edge doctor write it " +
                     "with " + std::string(kForceOption) + "."};
    }
    file = asWritten(std::move(fixed.file));
    const std::vector<Index> left = takeNumbers(file);
    std::vector<bool> keep(before.position.size(), false);
    for (const Index p : left) keep[p] = true;
    AsidePoints dropped = leftOutOf(before, keep, name);
    if (dropped.count > 0) done.dropped.push_back(std::move(dropped));
    for (std::size_t i = 0; i < left.size(); ++i) done.kept[i] = done.kept[left[i]];
    done.kept.resize(left.size());
    return success();
}

}  // namespace

bool canFix(const DoctorCheck& check) { return check.fix != Fix::None; }

std::string_view fixText(Fix fix) {
    // In the order of the enum.
    constexpr std::string_view kTexts[] = {
        "",
        "Repairs all that needs no guessing, and runs the result.",
        "Drops the points that are too many, and repairs all that needs no guessing.",
        "Flips normals so that they agree, outward on closed parts.",
        "Replaces the normals of the file by those derived from the positions.",
        "Replaces the neighbor lists of the file by the 12 nearest points.",
        "Makes neighbor lists symmetric.",
        "Replaces the walls of the file by the box around all points.",
        "Marks points where the surface ends without a wall as boundary points.",
    };
    static_assert(std::size(kTexts) == static_cast<std::size_t>(Fix::Rim) + 1);
    return kTexts[static_cast<std::size_t>(fix)];
}

std::vector<std::string> safeFixes(std::span<const Finding> findings) {
    std::vector<std::string> fixes;
    for (const Fix kind : {Fix::Repair, Fix::Orient, Fix::Derive}) {
        const auto is = [kind](const Finding& each) { return each.check->fix == kind; };
        if (const Finding* found = rowWhere(findings, is)) fixes.emplace_back(found->check->name);
    }
    return fixes;
}

Result<FixesDone> fixInput(PointFile& file, const std::vector<std::string>& fixes,
                           const Progress& progress) {
    FixesDone done;
    std::vector<Vec3> places = fixes.empty() ? std::vector<Vec3>{} : file.position;
    done.kept.resize(file.position.size());
    std::iota(done.kept.begin(), done.kept.end(), Index{0});
    for (const std::string& name : fixes) {
        const DoctorCheck* check = findDoctorCheck(name);
        if (check == nullptr || !canFix(*check))
            return Error{"The doctor has no fix called " + inQuotes(name) + "."};
        if (check->fix != Fix::Repair && check->fix != Fix::Drop) continue;
        ProposedDrop drop;
        bool agreed = false;
        if (check->fix == Fix::Drop) {
            const Result<Diagnosis> found = examine(file, progress);
            if (!found) return found.error();
            drop = proposedDrop(found.value(), {&name, 1});
            const std::vector<Finding>& all = found.value().findings;
            agreed = std::any_of(all.begin(), all.end(), [&](const Finding& each) {
                return each.check == check && each.dropsMost() && !each.dropsAll();
            });
        }
        // Else later fixes are measured by the points that the user wanted to be dropped.
        if (agreed) places = withoutPoints(file.position, drop.points);
        if (const Status fixed = repair(name, drop, places, file, done); !fixed)
            return fixed.error();
    }
    return done;
}

std::vector<std::string> storeFixed(const Prepared& prepared, const PrepareOptions& options,
                                    const std::vector<std::string>& fixes, PointFile& file) {
    std::vector<std::string> done;
    const PointSet& points = prepared.points;
    if (has(fixes, Fix::Orient) && options.normals == NormalSource::Oriented) {
        file.normal = points.normal;
        done.push_back(
            counted(prepared.report.derived.turnedNormals, "normal flipped", "normals flipped"));
    }
    if (has(fixes, Fix::Derive) && options.normals == NormalSource::Derived) {
        file.normal = points.normal;
        done.emplace_back("normals derived from the positions");
    }
    if (has(fixes, Fix::Walls)) {
        file.type = points.type;
        done.emplace_back("types taken from the box around all points");
    }
    if (has(fixes, Fix::Rim)) {
        file.type = points.type;
        done.push_back(counted(prepared.report.derived.rimChains, "rim", "rims") +
                       " taken as boundaries");
    }
    const bool newLists = has(fixes, Fix::NewLists);
    if (!newLists && !has(fixes, Fix::Symmetric)) return done;
    file.neighbors = points.neighbors;
    done.emplace_back(newLists ? "lists of the 12 nearest points" : "lists made symmetric");
    return done;
}

}  // namespace se::view
