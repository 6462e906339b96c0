/// Points on curves, where no surface is to be found, and lines of points that may be a surface.
#include <glm/geometric.hpp>
#include <numbers>

#include "doctor_support.h"

using namespace se;
using namespace se::test;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Adds `count` points of an arc about a center in the plane z = 0, with normals in that plane.
void addArc(PointFile& file, int count, double radius, const Vec3& center = Vec3(0.0),
            double angle = kTurn) {
    for (int i = 0; i < count; ++i) {
        const double t = angle * i / count;
        const Vec3 n(std::cos(t), std::sin(t), 0.0);
        file.position.push_back(center + radius * n);
        file.normal.push_back(n);
    }
}

PointFile doubles() {
    PointFile file;
    file.positionType = ScalarType::Double;
    return file;
}

/// Circles that cross each other, as drawn in a plane.
PointFile circles() {
    PointFile file = doubles();
    addArc(file, 300, 1.0);
    addArc(file, 200, 0.5, Vec3(0.9, 0.3, 0.0));
    addArc(file, 40, 0.1, Vec3(-0.2, 0.1, 0.0));
    return file;
}

/// The points in another plane.
PointFile tilted(PointFile file) {
    const Vec3 u = glm::normalize(Vec3(1.0, 2.0, 3.0));
    const Vec3 v = glm::normalize(glm::cross(u, Vec3(0.0, 0.0, 1.0)));
    const Vec3 w = glm::cross(u, v);
    const auto turned = [&](const Vec3& x) { return x.x * u + x.y * v + x.z * w; };
    for (Vec3& x : file.position) x = turned(x) + Vec3(5.0);
    for (Vec3& n : file.normal) n = turned(n);
    return file;
}

PointFile withoutNormals(PointFile file) {
    file.normal.clear();
    return file;
}

/// Straight lines of points one apart, `ratio` apart from each other, in the plane z = 0.
PointFile rows(int lines, int perLine, double ratio, const Vec3& normal) {
    PointFile file = doubles();
    for (int j = 0; j < lines; ++j) {
        for (int i = 0; i < perLine; ++i) {
            file.position.emplace_back(i + 0.37 * (j % 3), ratio * j, 0.0);
            file.normal.push_back(normal);
        }
    }
    return file;
}

/// The outline of a polygon with these corners, its points one apart.
PointFile outline(const std::vector<Vec3>& corners, bool closed) {
    PointFile file = doubles();
    const std::size_t sides = corners.size() - (closed ? 0 : 1);
    for (std::size_t k = 0; k < sides; ++k) {
        const Vec3 d = corners[(k + 1) % corners.size()] - corners[k];
        const int steps = static_cast<int>(glm::length(d));
        for (int i = 0; i < steps; ++i)
            file.position.push_back(corners[k] + d * (static_cast<double>(i) / steps));
    }
    return file;
}

bool areCurves(const PointFile& file) { return findingOf(examined(file), "curves") != nullptr; }

/// Checks that curves are all that is said of the points.
void checkCurvesAlone(const PointFile& file) {
    const Diagnosis diagnosis = examined(file);
    REQUIRE(diagnosis.findings.size() == 1);
    const Finding& finding = diagnosis.findings.front();
    CHECK(finding.check->name == "curves");
    CHECK(finding.severity == Severity::Error);
    CHECK(finding.count == file.position.size());
    CHECK(finding.text.find("no surface") != std::string::npos);
    CHECK_FALSE(finding.hasRemedy());
}

}  // namespace

TEST_CASE("doctor: of curves in a plane with normals in it nothing else is said") {
    checkCurvesAlone(circles());
    checkCurvesAlone(tilted(circles()));
    PointFile arc = doubles();
    addArc(arc, 60, 1.0, Vec3(0.0), kTurn / 4.0);
    checkCurvesAlone(arc);
}

TEST_CASE("doctor: curves are found in noise of several distances between their points") {
    PointFile file = doubles();
    Random random(3);
    addArc(file, 2000, 1.0);
    for (Index p = 0; p < file.position.size(); ++p)
        file.position[p] *= 1.0 + random.between(-3.0, 3.0) * kTurn / 2000.0;
    checkCurvesAlone(file);
}

TEST_CASE("doctor: one curve in a plane without normals is found, with corners, open or closed") {
    PointFile circle = doubles();
    addArc(circle, 100, 1.0);
    checkCurvesAlone(withoutNormals(tilted(circle)));
    PointFile arc = doubles();
    addArc(arc, 100, 1.0, Vec3(0.0), kTurn / 4.0);
    checkCurvesAlone(withoutNormals(arc));
    const std::vector<Vec3> corners{{0, 0, 0}, {60, 0, 0}, {60, 40, 0}, {0, 40, 0}};
    checkCurvesAlone(outline(corners, true));
    checkCurvesAlone(outline(corners, false));
}

TEST_CASE("doctor: one curve is found though its normals are zero") {
    PointFile circle = doubles();
    addArc(circle, 100, 1.0);
    for (Vec3& n : circle.normal) n = Vec3(0.0);
    CHECK(areCurves(circle));
}

TEST_CASE("doctor: lines that can be those of a scan are no curves") {
    for (const double ratio : {4.0, 6.0, 15.0, 60.0, 100.0}) {
        for (const int lines : {2, 3, 12}) {
            CAPTURE(ratio);
            CAPTURE(lines);
            const PointFile scan = rows(lines, 300, ratio, Vec3(0.0, 0.0, 1.0));
            CHECK_FALSE(areCurves(scan));
            CHECK_FALSE(areCurves(withoutNormals(scan)));
            // Wrong normals, of other axes.
            CHECK_FALSE(areCurves(rows(lines, 300, ratio, Vec3(0.0, 1.0, 0.0))));
            PointFile rings = doubles();
            PointFile slices = doubles();
            for (int j = 0; j < lines; ++j) {
                addArc(rings, static_cast<int>(kTurn * (30.0 + ratio * j)), 30.0 + ratio * j);
                addArc(slices, 300, 300.0 / kTurn, Vec3(0.0, 0.0, ratio * j));
            }
            CHECK_FALSE(areCurves(withoutNormals(rings)));
            CHECK_FALSE(areCurves(slices));
            CHECK_FALSE(areCurves(withoutNormals(slices)));
        }
    }
}

TEST_CASE("doctor: one path that goes to and fro over a plane is no curve") {
    std::vector<Vec3> turns;
    for (int j = 0; j < 8; ++j) {
        turns.emplace_back(j % 2 == 0 ? 0.0 : 200.0, 20.0 * j, 0.0);
        turns.emplace_back(j % 2 == 0 ? 200.0 : 0.0, 20.0 * j, 0.0);
    }
    CHECK_FALSE(areCurves(outline(turns, false)));
}

TEST_CASE("doctor: a plane full of points is no curve, whatever its normals") {
    PointFile sheet = flatLattice(25, 0.3);
    CHECK_FALSE(areCurves(sheet));
    CHECK_FALSE(areCurves(withoutNormals(sheet)));
    for (Index p = 0; p < sheet.position.size(); ++p)
        sheet.normal[p] = glm::normalize(Vec3(-4.0, 9.5, 0.0) - sheet.position[p]);
    CHECK_FALSE(areCurves(sheet));
}

TEST_CASE("doctor: the rim of a disc or cone with a point at its center is no curve") {
    for (const double height : {0.0, 1.0}) {
        PointFile file = doubles();
        addArc(file, 100, 1.0);
        file.position.emplace_back(0.0, 0.0, height);
        CHECK_FALSE(areCurves(withoutNormals(file)));
    }
}

TEST_CASE("doctor: a curve in space can be a scan, and is not accused") {
    PointFile helix = doubles();
    for (int i = 0; i < 1000; ++i) {
        const double t = kTurn * i / 100.0;
        helix.position.emplace_back(10.0 * std::cos(t), 10.0 * std::sin(t), t);
    }
    CHECK_FALSE(areCurves(helix));
}
