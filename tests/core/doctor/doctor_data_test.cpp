/// The doctor on the data sets: every planted fault is found, and no problem is found in a clean
/// set.
#include <algorithm>
#include <filesystem>
#include <map>

#include "doctor_support.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// The diagnosis of each shared set, by its name: examined once, since that takes seconds.
const std::map<std::string, Diagnosis>& diagnosesOfSets() {
    static std::map<std::string, Diagnosis> diagnoses;
    const std::filesystem::path folder = sharedFile("points");
    if (!diagnoses.empty() || folder.empty()) return diagnoses;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const auto file = readPoints(entry.path());
        REQUIRE_MESSAGE(file.ok(), name);
        diagnoses.emplace(name, examined(file.value()));
    }
    return diagnoses;
}

}  // namespace

TEST_CASE("doctor: no clean set has a problem" * doctest::test_suite("long")) {
    for (const auto& [name, diagnosis] : diagnosesOfSets()) {
        // As their README says: copies and no normals, noise of 0.4 spacings, a single point,
        // points on a half-grid, normals of both sides. Of the bones that nearly touch one point is
        // named.
        const std::map<std::string, std::string> known{
            {"cactus_no_normals.ply", "duplicates no_normals "},
            {"desk_no_normals.ply", "no_normals "},
            {"sphere_noisy.ply", "noise "},
            {"seven_parts.ply", "isolated_points "},
            {"brain_piece.ply", "ties "},
            {"bones.ply", "flipped_normals "},
            {"street_lidar.ply", "isolated_points flipped_normals "}};
        const auto problems = known.find(name);
        const std::string expected = problems == known.end() ? "" : problems->second;
        CHECK_MESSAGE(problemNames(diagnosis) == expected, name);
    }
}

TEST_CASE("doctor: openings are noted on the sets that have some, and on no closed one" *
          doctest::test_suite("long")) {
    // As the rims of docs/choices.md.
    const std::map<std::string, std::string> open{
        {"bunny", "5 rims"},           {"nefertiti", "1 rim "},
        {"three_peaks", "1 rim "},     {"blobs", "4 rims"},
        {"mannequin_devil", "1 rim "}, {"hippo", "5 rims"},
        {"fin90", "1 rim "},           {"oni", "1 rim "},
        {"coupling", "15 rims"},  // Its points lie on its edges alone.
        {"table1_lobster", "4 rims"},  {"street_lidar", "1 rim "}};
    for (const auto& [set, diagnosis] : diagnosesOfSets()) {
        const std::string name = std::filesystem::path(set).stem().string();
        const Finding* finding = findingOf(diagnosis, "open_border");
        CHECK_MESSAGE((finding != nullptr) == (open.count(name) > 0), name);
        if (finding == nullptr || open.count(name) == 0) continue;
        CHECK_MESSAGE(finding->text.find(open.at(name)) != std::string::npos, finding->text);
        CHECK(finding->severity == Severity::Note);
    }
}

TEST_CASE("doctor: every planted fault is found, and no other") {
    const std::map<std::string, std::string> planted{
        {"collinear", "in_line "},
        {"duplicates", "duplicates near_duplicates "},
        {"empty", "too_few_points "},
        {"flipped_normals", "flipped_normals "},
        {"no_normals", "no_normals "},
        {"not_finite", "non_finite "},
        {"one_point", "too_few_points "},
        {"plane_grid", "ties "},
        {"same_point", "too_few_points duplicates "},
        {"stray_points", "isolated_points "},
        {"three_points", "too_few_points "},
        {"two_close_sheets", "ties close_sheets "},
        {"two_points", "too_few_points "},
        {"unscaled_normals", "unscaled_normals "},
        {"zero_normals", "zero_normals "},
    };
    for (const auto& [name, names] : planted) {
        const auto file = sharedPoints("hazards/" + name + ".ply");
        if (!file) return;
        CHECK_MESSAGE(problemNames(*file) == names, name);
    }
}

TEST_CASE("doctor: planted faults are found in full") {
    const auto good = sharedPoints("points/sphere_even.ply");
    if (!good) return;
    const std::map<std::string, std::size_t> counts{
        {"duplicates", 50},   {"near_duplicates", 20},  {"non_finite", 15},
        {"zero_normals", 30}, {"flipped_normals", 100}, {"isolated_points", 10}};
    for (const auto& [check, count] : counts) {
        std::string name = check == "near_duplicates"   ? "duplicates"
                           : check == "non_finite"      ? "not_finite"
                           : check == "isolated_points" ? "stray_points"
                                                        : check;
        const auto file = sharedPoints("hazards/" + name + ".ply");
        REQUIRE(file);
        const Diagnosis diagnosis = examined(*file);
        REQUIRE(findingOf(diagnosis, check) != nullptr);
        CHECK_MESSAGE(findingOf(diagnosis, check)->count == count, check);
    }
    const auto flipped = sharedPoints("hazards/flipped_normals.ply");
    std::vector<Index> wrong;
    for (Index p = 0; p < good->position.size(); ++p) {
        if (glm::dot(flipped->normal[p], good->normal[p]) < 0.0) wrong.push_back(p);
    }
    const Diagnosis diagnosis = examined(*flipped);
    CHECK(findingOf(diagnosis, "flipped_normals")->points == wrong);
}
