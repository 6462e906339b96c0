#include "scene/picking.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "open_session.h"
#include "session/selection_facts.h"

using namespace se;
using namespace se::view;
using test::OpenSession;

namespace {

constexpr glm::vec2 kSize{640.0F, 480.0F};

/// Two points behind each other as seen from the front, and one on either side.
Model smallModel() {
    Model model;
    model.points.position = {{0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
    model.points.normal = {{0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
    model.points.type = {0, 0, 0, 0};
    for (int i = 0; i < 4; ++i) model.points.neighbors.append({});
    placeModel(model);
    return model;
}

CameraMatrices front() {
    Camera camera;
    camera.setPose({glm::vec3(0.0F), 4.0633F});
    camera.set(ViewPreset::Front);
    return camera.matrices(kSize.x / kSize.y);
}

/// Among all points.
Index pickPoint(const Model& model, const CameraMatrices& camera, glm::vec2 pixel, float radius) {
    std::vector<Index> all(model.place.size());
    std::iota(all.begin(), all.end(), Index{0});
    return pickAmong(model, all, camera, kSize, pixel, radius);
}

const std::vector<glm::vec2> kAll{{0, 0}, {640, 0}, {640, 480}, {0, 480}};

}  // namespace

TEST_CASE("The nearer of two points behind each other is picked") {
    const Model model = smallModel();
    const CameraMatrices camera = front();
    const glm::vec2 pixel(project(camera, model.place[0], kSize));
    CHECK(pickPoint(model, camera, pixel, 6.0F) == 0);
    CHECK(pickPoint(model, camera, pixel + glm::vec2(4.0F, 0.0F), 6.0F) == 0);
}

TEST_CASE("Nothing is picked where nothing is") {
    const Model model = smallModel();
    CHECK(pickPoint(model, front(), {5.0F, 5.0F}, 6.0F) == kNone);
}

TEST_CASE("Points that cannot be drawn are not picked") {
    Model model = smallModel();
    model.drawable[0] = false;
    const CameraMatrices camera = front();
    const glm::vec2 pixel(project(camera, model.place[0], kSize));
    CHECK(pickPoint(model, camera, pixel, 6.0F) == 1);
}

TEST_CASE("Every point of a sphere is found where it is drawn, if it faces the eye") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    const CameraMatrices camera = front();
    int found = 0;
    int facing = 0;
    for (Index p = 0; p < model->points.size(); ++p) {
        if (glm::dot(camera.eye - model->place[p], model->normal[p]) < 0.3F) continue;
        ++facing;
        const glm::vec2 pixel(project(camera, model->place[p], kSize));
        found += pickPoint(*model, camera, pixel, 1.0F) == p ? 1 : 0;
    }
    CHECK(facing > 100);
    CHECK(found == facing);
}

namespace {

/// A whole sphere of triangles, seen from the front.
struct WholeSphere {
    test::OpenSession open;
    CameraMatrices camera = front();

    WholeSphere() {
        open.session.moves().toEnd();
        open.session.waitUntilDone();
    }
    const Model& model() const { return open.session.model(); }
    const glm::vec3& at(Index p) const { return model().place[p]; }
    glm::vec3 middle(const Triangle& t) const { return (at(t.a) + at(t.b) + at(t.c)) / 3.0F; }
    Pick pickAt(const glm::vec3& place, bool indexed = true) const {
        const PickScene scene{model(), true, open.session.shownTriangles(),
                              indexed ? &open.session.meshIndex() : nullptr,
                              open.session.picture().rings};
        return pick(scene, {camera, kSize, glm::vec2(project(camera, place, kSize)), 4.0F});
    }
    /// The surface is facing the eye enough there to distinguish things.
    bool faces(const glm::vec3& place) const {
        return glm::dot(glm::normalize(camera.eye - place), glm::normalize(place)) > 0.6F;
    }
};

}  // namespace

TEST_CASE("A triangle is found at its middle, and one behind the front never") {
    const WholeSphere sphere;
    int facing = 0;
    for (const Triangle& t : sphere.open.session.triangles()) {
        const glm::vec3 middle = sphere.middle(t);
        const Pick found = sphere.pickAt(middle);
        if (sphere.faces(middle)) {
            ++facing;
            CHECK(found.what == Selection::ofTriangle(t));
            CHECK(glm::distance(found.place, middle) < 1e-3F);
        } else if (found.what.kind == SelectionKind::Triangle) {
            const glm::vec3 seen = sphere.middle(found.what.triangle());
            CHECK(glm::distance(sphere.camera.eye, seen) <
                  glm::distance(sphere.camera.eye, glm::vec3(0.0F)));
        }
    }
    CHECK(facing > 100);
}

TEST_CASE("An edge is found at its middle, a point at its position") {
    const WholeSphere sphere;
    int facing = 0;
    for (const Triangle& t : sphere.open.session.triangles()) {
        const glm::vec3 middle = 0.5F * (sphere.at(t.a) + sphere.at(t.b));
        if (!sphere.faces(middle) || !sphere.faces(sphere.at(t.c))) continue;
        CHECK(sphere.pickAt(sphere.at(t.c)).what == Selection::ofPoint(t.c));
        // In triangles of a few pixels the points come first.
        const Selection found = sphere.pickAt(middle).what;
        if (found.kind == SelectionKind::Point) continue;
        ++facing;
        CHECK(found == Selection::ofEdge(t.a, t.b));
    }
    CHECK(facing > 100);
}

TEST_CASE("The far side of the surface is hidden by its front, without triangles it is not") {
    const WholeSphere sphere;
    int hidden = 0;
    for (Index p = 0; p < sphere.model().points.size(); ++p) {
        const glm::vec3& place = sphere.at(p);
        if (glm::dot(glm::normalize(sphere.camera.eye), place) > -0.8F) continue;
        ++hidden;
        CHECK_FALSE(sphere.pickAt(place).what == Selection::ofPoint(p));
        CHECK(sphere.pickAt(place).what.kind != SelectionKind::None);
    }
    CHECK(hidden > 10);
    const PickScene points{sphere.model()};
    const Pick back = pick(points, {sphere.camera, kSize, {5.0F, 5.0F}, 4.0F});
    CHECK(back.what.kind == SelectionKind::None);
}

TEST_CASE("The index of triangles finds the same as a search of all of them") {
    const WholeSphere sphere;
    int compared = 0;
    for (std::size_t i = 0; i < sphere.open.session.triangles().size(); i += 11) {
        const Triangle& t = sphere.open.session.triangles()[i];
        for (const glm::vec3& place :
             {sphere.middle(t), 0.7F * sphere.at(t.a) + 0.3F * sphere.at(t.b)}) {
            CHECK(sphere.pickAt(place, true).what == sphere.pickAt(place, false).what);
            ++compared;
        }
    }
    CHECK(compared > 40);
}

TEST_CASE("Only things present at the cursor are picked, steps of rings are edges as well") {
    test::OpenSession open;
    open.session.moves().goToPivot(40);
    open.session.waitUntilDone();
    const CameraMatrices camera = front();
    const PickScene scene{open.session.model(), false, open.session.shownTriangles(),
                          &open.session.meshIndex(), open.session.picture().rings};
    int rings = 0;
    const auto& ring = open.session.picture().rings.front().points;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Index a = ring[i];
        const Index b = ring[(i + 1) % ring.size()];
        const glm::vec3 middle =
            0.5F * (open.session.model().place[a] + open.session.model().place[b]);
        if (glm::dot(camera.eye - middle, middle) < 0.5F) continue;
        const Pick found =
            pick(scene, {camera, kSize, glm::vec2(project(camera, middle, kSize)), 4.0F});
        CHECK(found.what == Selection::ofEdge(a, b));
        ++rings;
    }
    const std::size_t shown = open.session.shownTriangles().size();
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    CHECK(open.session.triangles().size() > shown);
}

TEST_CASE("The selection is a value: sides and corners in any order, it survives moves") {
    CHECK(Selection::ofEdge(7, 3) == Selection::ofEdge(3, 7));
    CHECK(Selection::ofTriangle({5, 9, 2}) == Selection::ofTriangle({2, 5, 9}));
    CHECK_FALSE(Selection::ofTriangle({5, 9, 2}) == Selection::ofTriangle({5, 2, 9}));
    CHECK(Selection::ofPoint(kNone) == Selection{});
    CHECK(selectionText(Selection::ofTriangle({5, 9, 2})) == "triangle 2, 5, 9");
    test::OpenSession open;
    open.session.select(Selection::ofEdge(3, 7));
    open.session.moves().goToPivot(20);
    open.session.waitUntilDone();
    CHECK(open.session.selection() == Selection::ofEdge(3, 7));
    CHECK(open.session.selected() == kNone);
    open.session.select(7);
    CHECK(open.session.selection() == Selection::ofPoint(7));
    CHECK(open.session.selected() == 7);
}

TEST_CASE("Facts of a triangle: its number, its pivot, its angles, and its presence") {
    test::OpenSession open;
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    const RunOverview& run = open.session.overview();
    for (const std::size_t number : {0UL, 17UL, 100UL}) {
        const Triangle t = open.session.triangles()[number];
        const auto pivot = pivotOfTriangle(run, number);
        REQUIRE(pivot.has_value());
        CHECK(run.triangles[*pivot - 1] > number);
        if (*pivot > 1) CHECK(run.triangles[*pivot - 2] <= number);
        open.session.moves().goToPivot(*pivot - 1);
        open.session.waitUntilDone();
        SelectionFacts facts = factsOf(open.session, Selection::ofTriangle(t));
        CHECK_FALSE(facts.present);
        CHECK(facts.number == number);
        CHECK(facts.degrees[0] + facts.degrees[1] + facts.degrees[2] == doctest::Approx(180.0));
        CHECK(facts.area > 0.0);
        open.session.moves().goToPivot(*pivot);
        open.session.waitUntilDone();
        facts = factsOf(open.session, Selection::ofTriangle(t));
        CHECK(facts.present);
        const SelectionFacts edge = factsOf(open.session, Selection::ofEdge(t.a, t.b));
        CHECK(edge.present);
        CHECK(edge.triangles.size() == 2);
        CHECK(edge.number <= number);
    }
    CHECK_FALSE(pivotOfTriangle(run, run.triangles.back()).has_value());
}

TEST_CASE("An edge of the ring is reported as such, an edge of nothing is not present") {
    test::OpenSession open;
    open.session.moves().goToPivot(30);
    open.session.waitUntilDone();
    const RingPath ring = open.session.picture().rings.front();
    const Selection edge = Selection::ofEdge(ring.points[0], ring.points[1]);
    CHECK(factsOf(open.session, edge).ring == "a, active");
    CHECK(factsOf(open.session, edge).present);
    const Index far = open.session.model().points.neighbors[0].back() == 200 ? 201 : 200;
    const SelectionFacts none = factsOf(open.session, Selection::ofEdge(0, far));
    CHECK_FALSE(none.present);
    CHECK(none.triangles.empty());
    CHECK_FALSE(none.number.has_value());
}

TEST_CASE("Creation: every triangle was made by its decision emit") {
    for (const char* scene : {"scene:sphere", "scene:torus", "scene:long-lists"}) {
        OpenSession open(scene);
        const RunOverview& run = open.session.overview();
        for (std::uint32_t pivot = 1; pivot <= std::min(60U, run.lastPivot); ++pivot) {
            open.session.moves().goToPivot(pivot);
            open.session.waitUntilDone();
            for (const Event& event : open.session.record().events) {
                const auto* emit = std::get_if<EmitEvidence>(&event.evidence);
                if (emit == nullptr) continue;
                const auto origin = originOfTriangle(run, emit->triangle);
                REQUIRE(origin.has_value());
                CHECK(toString(*origin) == toString(event.address));
            }
        }
    }
}

TEST_CASE("A line around everything encloses only the points that face the eye") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    const CameraMatrices camera = front();
    const std::vector<Index> points = pointsWithin(*model, camera, kSize, kAll);
    std::size_t facing = 0;
    for (Index p = 0; p < model->place.size(); ++p)
        facing += glm::dot(camera.eye - model->place[p], model->normal[p]) >= 0.0F ? 1 : 0;
    CHECK(points.size() == facing);
    CHECK(facing > 100);
    CHECK(std::is_sorted(points.begin(), points.end()));
}

TEST_CASE("At all depths, points that face away are enclosed as well") {
    const auto model = test::sphereModel();
    const std::vector<Index> points = pointsInside(*model, front(), kSize, kAll);
    CHECK(points.size() == model->place.size());
    CHECK(points.size() > pointsWithin(*model, front(), kSize, kAll).size());
    CHECK(pointsInside(*model, front(), kSize, std::span(kAll).first(2)).empty());
}

TEST_CASE("Points left of a line are not enclosed by one around the right half") {
    const auto model = test::sphereModel();
    const CameraMatrices camera = front();
    const std::vector<glm::vec2> right{{320, 0}, {640, 0}, {640, 480}, {320, 480}};
    const auto points = pointsWithin(*model, camera, kSize, right);
    CHECK_FALSE(points.empty());
    CHECK(points.size() < pointsWithin(*model, camera, kSize, kAll).size());
    for (const Index p : points) CHECK(project(camera, model->place[p], kSize).x >= 320.0F);
}

TEST_CASE("A concave line excludes the points in its notch, two corners enclose nothing") {
    const auto model = test::sphereModel();
    const CameraMatrices camera = front();
    // A U open at the top: the middle is outside.
    const std::vector<glm::vec2> hollow{{0, 0},   {280, 0}, {280, 400}, {360, 400},
                                        {360, 0}, {640, 0}, {640, 480}, {0, 480}};
    for (const Index p : pointsWithin(*model, camera, kSize, hollow)) {
        const glm::vec3 at = project(camera, model->place[p], kSize);
        CHECK((at.x <= 280.0F || at.x >= 360.0F || at.y >= 400.0F));
    }
    CHECK(pointsWithin(*model, camera, kSize, std::span(kAll).first(2)).empty());
}
