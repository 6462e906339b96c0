/// Drawings of each stage of a pivot (pictures: docs/images/stage-*.png).
#include "drawn.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "spiraling_edge/scenes/figures.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

TEST_CASE(
    "Drawn for insert: the walls that p touches, their vectors and the position on the ring") {
    OpenSession open("scene:figure-14");
    const DrawList list = drawn(open, {1, Stage::Insert, 1}, {LayerId::Walls});
    const Index pivot = open.session.picture().pivot;
    int walls = 0;
    for (unsigned face = 0; face < 6; ++face) {
        walls += open.session.model().points.type[pivot] >> face & 1U;
    }
    CHECK(walls > 0);
    CHECK(list.sheets.size() == 2U * static_cast<unsigned>(walls));
    CHECK(says(list, "wall "));
    CHECK(says(list, "N \xC3\x97 v"));
    CHECK(says(list, "after the pivot"));
    CHECK(count(list, view::Shape::Circle) >= 1);
}

TEST_CASE("A wall is a whole face of the box, in the plane of the points on it") {
    OpenSession open("scene:sheet");
    constexpr Address skipped{12, Stage::Skip, 1};
    const DrawList list = drawn(open, skipped, {LayerId::Walls});
    const Model& model = open.session.model();
    const Index pivot = open.session.picture().pivot;
    const std::uint8_t type = model.points.type[pivot];
    REQUIRE(open.session.picture().evidence<InsertEvidence>(Stage::Insert) == nullptr);
    REQUIRE_FALSE(list.sheets.empty());
    std::size_t sheet = 0;
    for (int face = 0; face < 6; ++face) {
        if ((type >> static_cast<unsigned>(face) & 1U) == 0) continue;
        CAPTURE(face);
        REQUIRE(list.sheets.size() >= sheet + 2);
        for (int axis = 0; axis < 3; ++axis) {
            float low = 1e9F;
            float high = -1e9F;
            for (std::size_t i = sheet; i < sheet + 2; ++i) {
                for (const glm::vec3& corner : list.sheets[i].corners) {
                    low = std::min(low, corner[axis]);
                    high = std::max(high, corner[axis]);
                }
            }
            if (axis == face % 3) {
                CHECK(low == doctest::Approx(model.place[pivot][axis]));
                CHECK(high == doctest::Approx(low));
            } else {
                CHECK(high >= model.boxHalf[axis] - 1e-4F);
                CHECK(low <= -model.boxHalf[axis] + 1e-4F);
            }
        }
        sheet += 2;
    }
    CHECK(sheet == list.sheets.size());
}

TEST_CASE("Drawn for sort: the slicing plane, the drop line and the angle") {
    OpenSession open;
    const Address kept = firstWhere<SortEvidence>(
        open, [](const SortEvidence& e) { return e.verdict == Verdict::Kept && e.degrees > 20.0; });
    const DrawList list = drawn(open, kept, {LayerId::SortAngles});
    CHECK(list.sheets.size() == 2);
    CHECK(says(list, "z"));
    CHECK(says(list, "1."));
    CHECK(says(list, "\xC2\xB0"));
    const DecisionState& picture = open.session.picture();
    const glm::vec3 tested = open.session.model().place[picture.underTest];
    CHECK(std::any_of(list.lines.begin(), list.lines.end(),
                      [&](const Line& line) { return line.from == tested && line.dash > 0.0F; }));
}

TEST_CASE("Drawn for limits: the concave corner filled, the limit on its way") {
    OpenSession open("scene:figure-8");
    const Address moved = firstWhere<LimitEvidence>(
        open, [](const LimitEvidence& e) { return e.verdict == Verdict::Moved; });
    const DrawList list = drawn(open, moved, {LayerId::Limits});
    CHECK_FALSE(list.sheets.empty());
    CHECK(says(list, "concave"));
    CHECK(says(list, "moves here"));
}

TEST_CASE("Drawn for convex: a hollow corner and the path along the ring") {
    OpenSession open("scene:small-torus");
    const Address behind = firstWhere<DropEvidence>(
        open, [](const DropEvidence& e) { return e.verdict == Verdict::BeyondConvex; });
    const DrawList list = drawn(open, behind, {LayerId::Convexity});
    CHECK(list.sheets.empty());
    CHECK(says(list, "convex"));
    CHECK(says(list, "along the ring"));
    CHECK(says(list, "height"));
}

TEST_CASE("Drawn for reciprocal: a second disc at e, its range and the line to p") {
    OpenSession open("scene:small-sheet");
    const Address refused = firstWhere<ReciprocalEvidence>(
        open, [](const ReciprocalEvidence& e) { return e.verdict == Verdict::NotReciprocal; });
    const DrawList list = drawn(open, refused, {LayerId::Reciprocal});
    const DecisionState& picture = open.session.picture();
    const auto& place = open.session.model().place;
    CHECK_FALSE(list.sheets.empty());
    CHECK(hasLine(list, place[picture.underTest], place[picture.pivot]));
    CHECK(says(list, "outside"));
}

TEST_CASE(
    "Figure 6: the first of e is the point after it on the ring, as the paper's letters have it") {
    for (const char* rules : {"paper", "printed"}) {
        CAPTURE(rules);
        OpenSession open("scene:figure-6", rules);
        const DrawList list =
            drawn(open, {1, Stage::Reciprocal, 1}, {LayerId::Reciprocal, LayerId::Labels});
        const auto* test = open.session.picture().evidence<ReciprocalEvidence>(Stage::Reciprocal);
        REQUIRE(test != nullptr);
        const Model& model = open.session.model();
        const auto isAt = [&](const char* text, Index point) {
            return std::any_of(list.labels.begin(), list.labels.end(), [&](const Label& label) {
                return label.text == text &&
                       glm::distance(label.position, model.place[point]) < 1e-6F;
            });
        };
        CHECK(isAt("efirst", test->succ));
        CHECK(isAt("elast", test->pred));
        // The sector begins at the last of e, as printed at the first.
        const bool printed = std::string(rules) == "printed";
        const glm::vec3 from = model.place[printed ? test->succ : test->pred];
        CHECK(std::any_of(list.lines.begin(), list.lines.end(),
                          [&](const Line& line) { return line.to == from && line.arrow > 0.0F; }));
    }
}

TEST_CASE("A point that is not listed is called neither convex nor concave: it was not measured") {
    OpenSession open("scene:figure-8");
    const DrawList list = drawn(open, {9, Stage::Limits, 2}, {LayerId::Limits});
    CHECK(says(list, "not listed"));
    CHECK_FALSE(says(list, "convex"));
    CHECK_FALSE(says(list, "concave"));
}

TEST_CASE("Figure 14: the triangle of the unmodified neighbor ring is drawn along the wall") {
    OpenSession open("scene:figure-14");
    const DrawList list = drawn(open, {1, Stage::Insert, 1}, {LayerId::Walls});
    const auto* insert = open.session.picture().evidence<InsertEvidence>(Stage::Insert);
    REQUIRE(insert != nullptr);
    const std::vector<glm::vec3>& place = open.session.model().place;
    CHECK(hasLine(list, place[insert->third], place[insert->other]));
    CHECK(says(list, "without area"));
}

TEST_CASE("Drawn for hole: the plane through start and end and the side of p") {
    OpenSession open("scene:long-lists");
    const DrawList list =
        drawn(open, firstWhere<HoleEvidence>(open, [](const auto&) { return true; }),
              {LayerId::HolePlane});
    CHECK(list.sheets.size() == 3);
    CHECK(says(list, "side of the pivot"));
    CHECK(says(list, "far side"));
}

TEST_CASE("Drawn for sphere: one circle, the radius and the limit of the gap") {
    OpenSession open;
    const DrawList list = drawn(open, {30, Stage::Sphere, 1}, {LayerId::Spheres, LayerId::Labels});
    REQUIRE(list.spheres.size() == 1);
    const Sphere& sphere = list.spheres[0];
    const auto onShell = std::count_if(list.lines.begin(), list.lines.end(), [&](const Line& l) {
        return std::abs(glm::distance(l.from, sphere.center) - sphere.radius) < 1e-4F &&
               std::abs(glm::distance(l.to, sphere.center) - sphere.radius) < 1e-4F;
    });
    CHECK(onShell >= 96);
    CHECK(onShell < 96 + 64);
    const DecisionState& picture = open.session.picture();
    CHECK(hasLine(list, sphere.center, open.session.model().place[picture.pivot]));
    CHECK(hasLine(list, sphere.center, open.session.model().place[picture.sphere->q]));
    for (const char* text : {"c", "r", "d "}) CHECK(says(list, text));
}

TEST_CASE("Drawn for twopoint: the one triangle hatched, its angle against 180 degrees") {
    OpenSession open("scene:coarse-torus");
    const DrawList list =
        drawn(open, firstWhere<TwoPointEvidence>(open, [](const auto&) { return true; }),
              {LayerId::TwoPoint});
    CHECK(list.sheets.size() == 1);
    CHECK(list.lines.size() > 9);
    CHECK(says(list, "hole: filled"));
    CHECK(says(list, "180\xC2\xB0"));
    const DrawList over =
        drawn(open,
              firstWhere<TwoPointEvidence>(
                  open, [](const TwoPointEvidence& e) { return e.verdict == Verdict::Discarded; }),
              {LayerId::TwoPoint});
    CHECK(says(over, "overlap: dropped"));
}

TEST_CASE("Drawn for emit and ring: numbers of triangles, the old path dashed, the new one bold") {
    OpenSession open;
    const DrawList fan = drawn(open, {30, Stage::Emit, 2}, {LayerId::Fan});
    CHECK(says(fan, "1"));
    CHECK(says(fan, "2"));
    const DrawList ring = drawn(open, {30, Stage::Ring, 3}, {LayerId::RingChange});
    CHECK(says(ring, "leaves"));
    CHECK(says(ring, "joins"));
    CHECK(std::any_of(ring.lines.begin(), ring.lines.end(),
                      [](const Line& l) { return l.dash > 0.0F; }));
    CHECK(std::any_of(ring.lines.begin(), ring.lines.end(),
                      [](const Line& l) { return l.dash == 0.0F && l.width > 0.3F; }));
}

TEST_CASE("Drawn for split and join: both loops and a mark where they meet") {
    OpenSession open("scene:figure-12");
    const DrawList split = drawn(open, {45, Stage::Split, 1}, {LayerId::Exchange});
    CHECK(says(split, "cut"));
    CHECK(says(split, ": 7 entries, continues"));
    CHECK(says(split, ": 10 entries, waits on the stack"));
    const DrawList join = drawn(open, {74, Stage::Join, 1}, {LayerId::Exchange});
    CHECK(says(join, "bridge"));
    CHECK(says(join, ", was on the stack"));
}

TEST_CASE(
    "Several splits in one pivot: each shows the loops that it cut, not what is left at the end") {
    OpenSession open("scene:figure-12");
    const DrawList first = drawn(open, {35, Stage::Split, 1}, {LayerId::Exchange});
    CHECK(says(first, "ring a: 19 entries"));
    CHECK(says(first, "ring b: 13 entries"));
    CHECK(open.session.picture().rings.size() == 2);
    CHECK(open.session.picture().rings[0].points.size() == 19);
    const DrawList second = drawn(open, {35, Stage::Split, 2}, {LayerId::Exchange});
    CHECK(says(second, "ring a: 17 entries"));
    CHECK(says(second, "ring c: 2 entries"));
    CHECK(open.session.picture().rings.size() == 3);
    const DrawList last = drawn(open, {35, Stage::Split, 3}, {LayerId::Exchange});
    CHECK(says(last, "ring a: 15 entries"));
    // A pinned layer keeps showing the last one.
    CHECK(says(drawn(open, {35, Stage::Advance, 1}, {LayerId::Exchange}), "ring a: 15 entries"));
}

TEST_CASE("A join and a split in one pivot show the point of the later one") {
    OpenSession open("scene:torus");
    const DrawList join = drawn(open, {560, Stage::Join, 1}, {LayerId::Exchange});
    CHECK(says(join, "e + b: bridge here"));
    CHECK(says(drawn(open, {560, Stage::Split, 1}, {LayerId::Exchange}), "ring e: 60 entries"));
}

TEST_CASE("Drawn for seed, advance and done") {
    OpenSession open("scene:linked-tori");
    const auto& place = open.session.model().place;
    const DrawList seed = drawn(open, {1, Stage::Seed, 1}, {LayerId::Seed});
    CHECK(says(seed, "start point"));
    CHECK(seed.lines.size() == 1);
    const DrawList advance = drawn(open, {20, Stage::Advance, 1}, {LayerId::Advance});
    const DecisionState& picture = open.session.picture();
    CHECK(std::any_of(advance.lines.begin(), advance.lines.end(),
                      [&](const Line& l) { return l.to == place[picture.nextPivot]; }));
    open.session.moves().goTo({536, Stage::Done, 1});
    open.session.waitUntilDone();
    LayerInput in{open.session.model(), open.session.picture(), paletteOf(Theme::Dark)};
    in.component = shapeAt(open.session.overview().shapes, 536);
    REQUIRE(in.component != nullptr);
    DrawList done;
    addComponent(in, done);
    REQUIRE(done.meshStretches.size() == 2);
    CHECK(done.meshStretches[0].first == 0);
    CHECK(done.meshStretches[1].first == 1488);
    CHECK_FALSE(done.meshStretches[0].color == done.meshStretches[1].color);
    CHECK(done.lines.empty());  // Closed: no rim.
    CHECK(says(done, "component 1"));
}

TEST_CASE("A point that cannot begin a ring is crossed, with the reason") {
    OpenSession open;
    open.session.moves().goTo({425, Stage::Strand, 1});
    open.session.waitUntilDone();
    const DrawList list = drawnAt(open, Moment{}, addSeed);
    CHECK(count(list, view::Shape::Cross) == 1);
    CHECK(says(list, "no neighbor left"));
}

TEST_CASE("The overlap of a refused triangle is filled, and it alone") {
    OpenSession open("scene:coarse-torus");
    const auto hatched = [&](void (*add)(const LayerInput&, DrawList&)) {
        const DrawList list = drawnAt(open, Moment{}, add);
        float area = 0.0F;
        for (const Sheet& sheet : list.sheets) {
            if (!sheet.hatched) continue;
            CHECK(sheet.color == paletteOf(Theme::Dark).rejected.withAlpha(sheet.color.a));
            area += 0.5F * glm::length(glm::cross(sheet.corners[1] - sheet.corners[0],
                                                  sheet.corners[2] - sheet.corners[0]));
        }
        CHECK(says(list, "overlap") == (area > 0.0F));
        return area;
    };
    const auto areaOfPicture = [&](Index a, Index b, Index c) {
        const auto& place = open.session.model().place;
        return 0.5F * glm::length(glm::cross(place[b] - place[a], place[c] - place[a]));
    };
    open.session.moves().goTo({42, Stage::Reciprocal, 1});
    open.session.waitUntilDone();
    const DecisionState& p = open.session.picture();
    const float whole =
        areaOfPicture(p.pivot, p.underTest, p.start) + areaOfPicture(p.pivot, p.underTest, p.end);
    const float covered = hatched(addReciprocal);
    CHECK(covered > 0.3F * whole);
    CHECK(covered < 0.9F * whole);

    open.session.moves().goTo({87, Stage::TwoPoint, 1});
    open.session.waitUntilDone();
    CHECK(hatched(addTwoPoint) > 0.5F * areaOfPicture(p.pivot, p.first, p.last));
    // A hole covers nothing.
    open.session.moves().goTo({15, Stage::TwoPoint, 1});
    open.session.waitUntilDone();
    CHECK(hatched(addTwoPoint) == 0.0F);
}

TEST_CASE("A triangle that the reciprocal test keeps covers next to nothing") {
    OpenSession open("scene:figure-12");
    const Address kept = firstWhere<ReciprocalEvidence>(
        open, [](const ReciprocalEvidence& e) { return e.verdict == Verdict::Kept; });
    REQUIRE(kept.pivot > 0);
    open.session.moves().goTo(kept);
    open.session.waitUntilDone();
    CHECK_FALSE(says(drawnAt(open, Moment{}, addReciprocal), "overlap"));
}
