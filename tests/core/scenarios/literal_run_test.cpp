/// The set `printed` against the paper's sentences once more (support/literal_run.h), pivot for
/// pivot.
#include "support/literal_run.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "spiraling_edge/run/sweep.h"
#include "support/clouds.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// The pivots of the stepper under `printed`.
std::vector<PivotTriangles> printedRun(const PointSet& points, const GivenStart& start) {
    Params params = printed();
    params.start = start;
    std::vector<PivotTriangles> pivots;
    sweep(points, params, [&](const SweptPivot& pivot) {
        if (pivot.point == kNone) return;  // Points that cannot begin a ring, and the end.
        pivots.push_back({pivot.point, {}});
        for (const Event& event : pivot.events) {
            if (const auto* made = std::get_if<EmitEvidence>(&event.evidence))
                pivots.back().triangles.push_back(made->corners);
        }
    });
    return pivots;
}

std::string textOf(const std::vector<PivotTriangles>& pivots, std::size_t i) {
    if (i >= pivots.size()) return "the run has ended";
    std::string text = "at point " + std::to_string(pivots[i].point) + ":";
    for (const Triangle& t : pivots[i].triangles)
        text += " (" + std::to_string(t.a) + " " + std::to_string(t.b) + " " + std::to_string(t.c) +
                ")";
    return text;
}

/// Compares the two runs, with a row of the table that the test prints. Returns the number of
/// pivots compared.
std::size_t compareRuns(const std::string& name, const PointSet& points,
                        const GivenStart& start = {}) {
    const std::vector<PivotTriangles> ours = printedRun(points, start);
    const std::vector<PivotTriangles> literal = literalRun(points, start);
    const auto differing =
        std::mismatch(ours.begin(), ours.end(), literal.begin(), literal.end()).first;
    const auto equal = static_cast<std::size_t>(differing - ours.begin());
    const bool agree = equal == ours.size() && equal == literal.size();
    std::size_t triangles = 0;
    for (const PivotTriangles& each : ours) triangles += each.triangles.size();
    std::printf("  %-32s %8zu %10zu  %s\n", name.c_str(), ours.size(), triangles,
                agree ? "agree" : ("differ at pivot " + std::to_string(equal + 1)).c_str());
    CHECK_MESSAGE(agree, name, ", pivot ", equal + 1, ": printed ", textOf(ours, equal),
                  ", the letter ", textOf(literal, equal));
    return ours.size();
}

}  // namespace

TEST_CASE("printed and the paper's sentences agree pivot for pivot on every scene") {
    std::printf("  scene                              pivots  triangles\n");
    std::size_t pivots = 0;
    const auto compareScene = [&](const Scene& scene) {
        pivots += compareRuns(std::string(scene.id), prepared(scene.build(), reach(12, false)),
                              startOfScene(scene.id));
    };
    for (const Scene& scene : scenes()) compareScene(scene);
    for (const FailureScene& each : failureScenes()) compareScene(each.scene);
    MESSAGE("pivots compared: ", pivots);
    CHECK(pivots > 9'000);
}

TEST_CASE("printed and the paper's sentences agree pivot for pivot on shared sets") {
    std::error_code none;
    std::vector<std::filesystem::path> files;
    for (const char* folder : {"points", "hazards"}) {
        for (const auto& entry : std::filesystem::directory_iterator(sharedFile(folder), none))
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::size_t pivots = 0;
    for (const auto& path : files) {
        const auto file = readPoints(path);
        if (!file) continue;
        const PointSet points = prepared(file.value(), reach(12, false));
        if (points.empty() || (kSanitized && points.size() > 5000)) continue;
        pivots += compareRuns(path.filename().string(), points);
    }
    MESSAGE("pivots compared: ", pivots);
}
