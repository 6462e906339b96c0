#include "spiraling_edge/mesh/fault_fields.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/fidelity.h"
#include "spiraling_edge/points/usable_points.h"
#include "support/clouds.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

MeshFailure faultOf(std::string_view kind, std::vector<Index> points) {
    MeshFailure failure;
    failure.kind = findFailureClass(kind);
    failure.points = std::move(points);
    return failure;
}

/// The number of a class, by its place in the table.
double numberOf(std::string_view kind) {
    const auto classes = failureClasses();
    for (std::size_t i = 0; i < classes.size(); ++i) {
        if (classes[i].name == kind) return static_cast<double>(i + 1);
    }
    return -1.0;
}

const Attribute& columnOf(const PointFile& file, std::string_view name) {
    const auto found = std::find_if(file.attributes.begin(), file.attributes.end(),
                                    [&](const Attribute& each) { return each.name == name; });
    REQUIRE(found != file.attributes.end());
    return *found;
}

}  // namespace

TEST_CASE("fault fields: the most severe fault of a point, by its class from 1, and 0 for none") {
    std::vector<MeshFailure> failures{faultOf("flipped_triangles", {0, 1, 2}),
                                      faultOf("holes", {1, 3}), faultOf("folded_edges", {2}),
                                      faultOf("slivers", {4})};
    const std::vector<double> expected{numberOf("flipped_triangles"), numberOf("holes"),
                                       numberOf("folded_edges"), numberOf("holes"), 0.0};
    CHECK(faultNumbers(5, failures) == expected);
    std::reverse(failures.begin(), failures.end());
    CHECK(faultNumbers(5, failures) == expected);
}

TEST_CASE("fault fields: the numbers of the classes are those of docs/file-formats.md") {
    const auto numbered = {"non_manifold_edges",
                           "non_manifold_vertices",
                           "inconsistent_edges",
                           "duplicate_triangles",
                           "degenerate_triangles",
                           "intersecting_triangles",
                           "folded_edges",
                           "second_layers",
                           "flipped_triangles",
                           "holes",
                           "small_components",
                           "lost_points",
                           "isolated_points",
                           "inward_pieces",
                           "spikes"};
    double number = 0.0;
    for (const char* each : numbered) CHECK(numberOf(each) == ++number);
}

TEST_CASE("fault fields: names are scalars of CloudCompare, and match none of its other columns") {
    for (const std::string_view name : {kFaultField, kDistanceField}) {
        CHECK(name.starts_with("scalar_se_"));
        for (const char* part : {"red", "green", "blue", "nx", "ny", "nz", "intensity", "gray",
                                 "grey", "face", "tri"}) {
            CHECK_MESSAGE(name.find(part) == std::string_view::npos, name, " ", part);
        }
    }
}

TEST_CASE("fault fields: a PLY has them, for all points and for used points, and reads them back") {
    const TemporaryFolder folder;
    PointFile file = findScene("stranded-point")->build();
    const PointSet points = prepared(file);
    const auto mesh = runAll(points, paper()).state.mesh();
    const std::vector<MeshFailure> failures = inspectMesh(points, mesh);
    REQUIRE(std::any_of(failures.begin(), failures.end(),
                        [](const MeshFailure& each) { return each.kind->name == "lost_points"; }));
    // Those of an earlier mesh are replaced.
    file.attributes = {
        {std::string(kFaultField), ScalarType::Double, std::vector<double>(points.size(), 99.0)},
        {"kept", ScalarType::Float, std::vector<double>(points.size(), 7.0)}};
    setFaultFields(file, points, mesh, failures);
    CHECK(file.attributes.size() == 3);

    REQUIRE(writeMesh(folder / "all.ply", file, mesh).ok());
    const PointFile all = readPoints(folder / "all.ply").value();
    CHECK(columnOf(all, kFaultField).type == ScalarType::UInt8);
    CHECK(columnOf(all, kFaultField).values == faultNumbers(points.size(), failures));
    CHECK(columnOf(all, "kept").values.front() == 7.0);
    const std::vector<double> distances = distancesFromMesh(points, mesh);
    const std::vector<double>& written = columnOf(all, kDistanceField).values;
    const std::vector<bool> used = usedPoints(points.size(), mesh);
    for (std::size_t p = 0; p < points.size(); ++p) {
        CHECK(written[p] == doctest::Approx(distances[p]));
        CHECK((written[p] == 0.0) == used[p]);
    }

    const PointFile some = withUsedPoints(file, mesh);
    REQUIRE(writeMesh(folder / "used.ply", some, some.faces).ok());
    const PointFile back = readPoints(folder / "used.ply").value();
    CHECK(back.position.size() < all.position.size());
    for (const double each : columnOf(back, kDistanceField).values) CHECK(each == 0.0);
}
