#include <cstdio>

#include "spiraling_edge/spiraling_edge.h"

namespace {

int fail(const std::string& message, int exitCode) {
    std::fprintf(stderr, "%s\n", message.c_str());
    return exitCode;
}

void print(const char* title, const std::vector<se::RingPoint>& ring) {
    std::printf("%s:", title);
    for (const auto& [point, degrees] : ring) std::printf("  %u at %.1f", point, degrees);
    std::puts(" degrees");
}

}  // namespace

int main(int argc, char** argv) {
    // Points from a file or of a scene; then normals and neighbor lists, unless the file has some.
    const auto file = argc > 1 ? se::readPoints(std::filesystem::path(argv[1]))
                               : se::Result<se::PointFile>(se::findScene("torus")->build());
    if (!file) return fail(file.error().message, 3);
    const auto prepared = se::prepare(file.value(), {});
    if (!prepared) return fail(prepared.error().message, 3);
    const se::PointSet& points = prepared.value().points;
    const se::Params params = se::paramsByName("paper").value();

    // To an address: the third sphere test of pivot 134, and the neighbor ring before and after it.
    se::RunCursor cursor(points, params);
    if (!cursor.goTo({134, se::Stage::Sphere, 3})) return fail("pivot 134 has no such test", 1);
    print("before", cursor.stateBefore().neighborRing());
    const auto* test = se::as<se::SphereEvidence>(*cursor.event());
    std::printf("point %u is %.4f from the center, the radius is %.4f: %s\n", test->q,
                test->distance, test->radius, std::string(se::verdictText(test->verdict)).c_str());
    print("after", cursor.state().neighborRing());

    // Back to the end of the pivot before, where the edge ring is as that pivot left it.
    cursor.back(se::StepUnit::Pivot);
    std::printf("%zu points on the edge ring\n", cursor.state().rings.front().points.size());

    // On to the next decision that meets a condition.
    const auto query = se::DecisionQuery::parse("stage=sphere refused margin<0.01");
    if (!query) return fail(query.error().message, 2);
    if (cursor.runUntil(query.value()))
        std::printf("stopped at %s\n", se::toString(cursor.event()->address).c_str());

    // The same run with another rule, and where the two part.
    se::Params changed = params;
    const std::vector<se::RuleValue> values{{"maxgap", 100.0}};
    if (const auto set = se::applyRuleValues(values, changed); !set)
        return fail(set.error().message, 2);
    const auto runs = se::compareRuns({points, params}, {points, changed});
    if (runs && runs.value().first) std::puts(runs.value().first->words.c_str());

    // The finished mesh.
    cursor.goToEnd();
    const std::vector<se::Triangle>& mesh = cursor.timeline().state().mesh();
    const se::MeshReport report = se::reportMesh(points, mesh);
    std::printf("%zu points, %zu triangles, Euler characteristic %lld\n", report.points,
                report.triangles, report.eulerCharacteristic);
    if (argc <= 2) return 0;
    return se::writeMeshPly(argv[2], file.value(), mesh).ok() ? 0 : 5;
}
