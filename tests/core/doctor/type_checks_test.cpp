/// The doctor's check of openings without walls or types.
#include "doctor_support.h"
#include "support/open_surfaces.h"

using namespace se;
using namespace se::test;

TEST_CASE("doctor: open_border notes the rims of an open surface, until they have types") {
    for (const Open& open : {sphereWithHoles({{1, 0, 0}, {0, 0, 1}}, 0.45, 1), cylinder()}) {
        CAPTURE(open.name);
        const Diagnosis diagnosis = examined(open.file);
        CHECK(problemNames(diagnosis) == "");
        const Finding* finding = findingOf(diagnosis, "open_border");
        REQUIRE(finding != nullptr);
        CHECK(finding->severity == Severity::Note);
        CHECK(finding->text.find("along " + std::to_string(open.rims) + " rims") !=
              std::string::npos);
        for (const Index p : finding->points)
            CHECK(open.toRim(open.file.position[p]) < 1.5 * open.spacing);
        // The advised remedy works: --derive-rim.
        CHECK(finding->check->remedy().find("--derive-rim") != std::string::npos);
        PrepareOptions options;
        options.rim = true;
        PointFile marked = open.file;
        marked.type = prepare(open.file, options).value().points.type;
        CHECK(findingOf(examined(marked), "open_border") == nullptr);
    }
}

TEST_CASE("doctor: open_border finds nothing on closed surfaces, nor at walls") {
    for (const Family& family : closedFamilies(1.5))
        CHECK_MESSAGE(findingOf(examined(family.sample(1)), "open_border") == nullptr, family.name);
    PointFile file = sampleSheet(wavySheet(), 12, 160, 1);  // typed
    CHECK(findingOf(examined(file), "open_border") == nullptr);
    // The same sheet without its types has no known border.
    file.type.clear();
    CHECK(findingOf(examined(file), "open_border") != nullptr);
    // Sides that are wrong, or unknown, make no border.
    PointFile flipped = ball();
    for (Index p = 0; p < 20; ++p) flipped.normal[7 * p] = -flipped.normal[7 * p];
    CHECK(findingOf(examined(flipped), "open_border") == nullptr);
    file.normal.clear();
    CHECK(findingOf(examined(file), "open_border") == nullptr);
}
