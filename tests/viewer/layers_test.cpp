#include "layers/layer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "rig.h"

using namespace se;
using namespace se::view;

namespace {

/// The draw list at an address, with only the given layers.
DrawList drawn(test::OpenSession& open, const Address& address, std::initializer_list<LayerId> ids,
               Index selected = kNone) {
    open.session.goTo(address);
    open.session.settle();
    LayerSwitches on;
    for (const LayerId id : ids) on.set(static_cast<std::size_t>(id));
    const LayerInput in{open.session.model(), open.session.picture(), paletteOf(Theme::Dark),
                        selected, kNone};
    DrawList list;
    fillDrawList(in, on, list);
    return list;
}

/// One layer of what the session shows, at a moment of its motion.
DrawList drawnAt(const test::OpenSession& open, const Moment& moment,
                 void (*add)(const LayerInput&, DrawList&)) {
    LayerInput in{open.session.model(), open.session.picture(), paletteOf(Theme::Dark)};
    in.triangles = open.session.triangles();
    in.meshIndex = &open.session.meshIndex();
    in.moment = moment;
    DrawList list;
    add(in, list);
    return list;
}

constexpr Moment kPaper{Moment::Kind::Paper, 0.0, false};

constexpr Address kWhole{30, Stage::Pivot, 0};

std::size_t count(const DrawList& list, Shape shape) {
    return static_cast<std::size_t>(
        std::count_if(list.sprites.begin(), list.sprites.end(),
                      [&](const Sprite& s) { return s.style.shape == shape; }));
}

}  // namespace

TEST_CASE("The table has every layer once, in the place of its id") {
    std::set<std::string_view> names;
    REQUIRE(layers().size() == kLayerCount);
    for (const Layer& layer : layers()) CHECK(names.insert(layer.name).second);
    std::set<LayerId> ids;
    for (const Layer& layer : layers()) CHECK(ids.insert(layer.id).second);
}

TEST_CASE("With no layer on nothing is drawn") {
    test::OpenSession open;
    const DrawList list = drawn(open, kWhole, {});
    CHECK_FALSE(list.cloudVisible);
    CHECK_FALSE(list.meshVisible);
    CHECK(list.lines.empty());
    CHECK(list.faces.empty());
    CHECK(list.sprites.empty());
    CHECK(list.labels.empty());
}

TEST_CASE("Points have a style by status and type") {
    test::OpenSession open("scene:sheet");
    const DrawList list = drawn(open, kWhole, {LayerId::Points});
    const Model& model = open.session.model();
    REQUIRE(list.cloudStyleOf.size() == model.points.size());
    for (Index p = 0; p < model.points.size(); ++p) {
        const PointStyle& style = list.cloudStyles.styles[list.cloudStyleOf[p]];
        const PointStatus status = open.session.picture().status[p];
        const Palette& c = paletteOf(Theme::Dark);
        const Color& color = status == kUnused ? c.unused : status > 0 ? c.used : c.done;
        CHECK(style.color == color.withAlpha(style.color.a));
        const std::uint8_t type = model.points.type[p];
        if (isCorner(type)) {
            CHECK((style.shape == Shape::Diamond || style.shape == Shape::OpenDiamond));
        } else if (isBoundary(type)) {
            CHECK((style.shape == Shape::Square || style.shape == Shape::OpenSquare));
        }
    }
}

TEST_CASE("Finished triangles are counted, those of the pivot are new") {
    test::OpenSession open;
    const DrawList list = drawn(open, kWhole, {LayerId::Triangles});
    const PivotRecord& record = open.session.record();
    CHECK(list.finishedTriangles == record.before.triangleCount);
    CHECK(list.faces.size() == record.after.triangleCount - record.before.triangleCount);
    for (const Face& face : list.faces) CHECK(face.hatched);
}

TEST_CASE("The active ring is closed and has arrows; stacked rings are dashed and numbered") {
    test::OpenSession open("scene:torus");
    std::uint32_t pivot = 0;
    const RunOverview& run = open.session.overview();
    while (pivot < run.stackDepth.size() && run.stackDepth[pivot] == 0) ++pivot;
    REQUIRE(pivot < run.stackDepth.size());
    const Address address{pivot + 1, Stage::Pivot, 0};
    const DrawList active = drawn(open, address, {LayerId::EdgeRing});
    REQUIRE(active.lines.size() == open.session.picture().rings[0].points.size());
    for (std::size_t i = 0; i < active.lines.size(); ++i) {
        CHECK(active.lines[i].to == active.lines[(i + 1) % active.lines.size()].from);
    }
    CHECK(std::any_of(active.lines.begin(), active.lines.end(),
                      [](const Line& l) { return l.arrow > 0.0F; }));
    const DrawList stacked = drawn(open, address, {LayerId::StackedRings});
    CHECK_FALSE(stacked.lines.empty());
    for (const Line& line : stacked.lines) {
        CHECK(line.dash > 0.0F);
        CHECK(line.width < active.lines[0].width);
    }
    REQUIRE_FALSE(stacked.labels.empty());
    CHECK(stacked.labels[0].text == "#1");
}

TEST_CASE("The sphere of a test passes through p, s and t, in view space") {
    test::OpenSession open;
    const DrawList list = drawn(open, {30, Stage::Sphere, 1}, {LayerId::Spheres});
    REQUIRE(open.session.picture().sphere.has_value());
    const SphereEvidence& test = *open.session.picture().sphere;
    REQUIRE(list.spheres.size() == 1);
    for (const Index point : {open.session.picture().pivot, test.s, test.t}) {
        const float distance =
            glm::distance(list.spheres[0].center, open.session.model().place[point]);
        CHECK(distance == doctest::Approx(list.spheres[0].radius).epsilon(1e-4));
    }
    CHECK(drawn(open, {30, Stage::Sort, 1}, {LayerId::Spheres}).spheres.empty());
}

TEST_CASE("A pivot has its marks while it is worked on, and only its own afterwards") {
    test::OpenSession open;
    const DrawList during = drawn(open, {30, Stage::Emit, 1}, {LayerId::NeighborRing});
    CHECK(count(during, Shape::Forward) >= 1);
    CHECK(count(during, Shape::Back) >= 1);
    CHECK(count(during, Shape::RingedDisc) >= 1);
    const DrawList after = drawn(open, kWhole, {LayerId::NeighborRing});
    CHECK(count(after, Shape::RingedDisc) == 1);
    CHECK(count(after, Shape::Forward) == 0);
    CHECK(count(after, Shape::Cross) == 0);
}

TEST_CASE("Labels stand only at the pivot, its candidates and the selection, one each") {
    test::OpenSession open;
    const DrawList list = drawn(open, {30, Stage::Sphere, 1}, {LayerId::Labels}, 7);
    const Picture& picture = open.session.picture();
    CHECK(list.labels.size() <= picture.candidates.size() + 6);
    std::set<std::string> texts;
    for (const Label& label : list.labels) CHECK(texts.insert(label.text).second);
    CHECK(texts.contains("7"));
    CHECK(texts.contains("p " + std::to_string(picture.pivot)));
}

TEST_CASE("Links are the neighbor list of the pivot") {
    test::OpenSession open;
    const DrawList list = drawn(open, kWhole, {LayerId::Links});
    const Index pivot = open.session.picture().pivot;
    CHECK(list.lines.size() == open.session.model().points.neighbors[pivot].size());
}

TEST_CASE("Entering a stage shows its layers, leaving it hides them again") {
    const LayerModes automatic{};
    const auto shown = [&](LayerId id, std::optional<Stage> stage) {
        return shownLayers(automatic, stage).test(static_cast<std::size_t>(id));
    };
    for (const auto& [id, stage] : {std::pair{LayerId::Seed, Stage::Seed},
                                    {LayerId::Walls, Stage::Insert},
                                    {LayerId::Walls, Stage::Skip},
                                    {LayerId::SortAngles, Stage::Sort},
                                    {LayerId::Limits, Stage::Limits},
                                    {LayerId::Convexity, Stage::Convex},
                                    {LayerId::Reciprocal, Stage::Reciprocal},
                                    {LayerId::HolePlane, Stage::Hole},
                                    {LayerId::Spheres, Stage::Sphere},
                                    {LayerId::TwoPoint, Stage::TwoPoint},
                                    {LayerId::Fan, Stage::Emit},
                                    {LayerId::RingChange, Stage::Ring},
                                    {LayerId::Exchange, Stage::Split},
                                    {LayerId::Exchange, Stage::Join},
                                    {LayerId::Advance, Stage::Advance},
                                    {LayerId::Component, Stage::Done}}) {
        CAPTURE(std::string(stageName(stage)));
        CHECK(shown(id, stage));
        CHECK_FALSE(shown(id, Stage::Pivot));
        CHECK_FALSE(shown(id, std::nullopt));
    }
    for (const LayerId id : {LayerId::Points, LayerId::Triangles, LayerId::EdgeRing}) {
        CHECK(shown(id, std::nullopt));
        CHECK(shown(id, Stage::Sphere));
    }
    CHECK_FALSE(shown(LayerId::Normals, Stage::Sort));
}

TEST_CASE("A pinned layer stays whatever the stage, until its pin is taken out") {
    LayerModes modes{};
    const auto shown = [&](Stage stage) {
        return shownLayers(modes, stage).test(static_cast<std::size_t>(LayerId::Spheres));
    };
    toggleLayer(modes, LayerId::Spheres, Stage::Sort);
    CHECK(modeOf(modes, LayerId::Spheres) == LayerMode::PinnedOn);
    CHECK(shown(Stage::Sort));
    CHECK(shown(Stage::Advance));
    toggleLayer(modes, LayerId::Spheres, Stage::Advance);
    CHECK(modeOf(modes, LayerId::Spheres) == LayerMode::Automatic);
    toggleLayer(modes, LayerId::Spheres, Stage::Sphere);
    CHECK(modeOf(modes, LayerId::Spheres) == LayerMode::PinnedOff);
    CHECK_FALSE(shown(Stage::Sphere));
    toggleLayer(modes, LayerId::Spheres, Stage::Sort);
    CHECK(modeOf(modes, LayerId::Spheres) == LayerMode::PinnedOn);
}

TEST_CASE("A layer that is pinned on goes on showing the last test of its stage") {
    test::OpenSession open;
    CHECK(drawn(open, {30, Stage::Sphere, 1}, {LayerId::Spheres}).spheres.size() == 1);
    CHECK(drawn(open, {30, Stage::Emit, 1}, {LayerId::Spheres}).spheres.size() == 1);
    CHECK_FALSE(drawn(open, {30, Stage::Emit, 1}, {LayerId::SortAngles}).lines.empty());
}

TEST_CASE("Names of the three states of a layer are read as they are written") {
    for (const LayerMode mode : {LayerMode::Automatic, LayerMode::PinnedOn, LayerMode::PinnedOff}) {
        CHECK(layerModeFromName(layerModeName(mode)) == mode);
    }
    CHECK(layerModeFromName("maybe") == std::nullopt);
}

// What the table of docs/viewer.md says of every stage.

namespace {

bool says(const DrawList& list, std::string_view part) {
    return std::any_of(list.labels.begin(), list.labels.end(), [&](const Label& label) {
        return label.text.find(part) != std::string::npos;
    });
}

bool hasLine(const DrawList& list, const glm::vec3& from, const glm::vec3& to) {
    return std::any_of(list.lines.begin(), list.lines.end(), [&](const Line& line) {
        return (glm::distance(line.from, from) < 1e-5F && glm::distance(line.to, to) < 1e-5F) ||
               (glm::distance(line.from, to) < 1e-5F && glm::distance(line.to, from) < 1e-5F);
    });
}

/// The address of the first event of a run of which `wanted` is true.
template <typename Kind>
Address firstWhere(test::OpenSession& open, bool (*wanted)(const Kind&)) {
    Timeline timeline(open.session.model().points, open.session.model().params);
    for (std::uint32_t pivot = 1; pivot < 130; ++pivot) {
        const auto record = recordPivot(timeline, pivot);
        for (const Event& event : record->events) {
            const auto* evidence = std::get_if<Kind>(&event.evidence);
            if (evidence != nullptr && wanted(*evidence)) return event.address;
        }
    }
    return {};
}

}  // namespace

TEST_CASE("Drawn for insert: the walls that p touches, their vectors and the place on the ring") {
    test::OpenSession open("scene:figure-14");
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
    CHECK(says(list, "after p"));
    CHECK(count(list, Shape::Circle) >= 1);
}

TEST_CASE("A wall is a whole face of the box, in the plane of the points that lie on it") {
    test::OpenSession open("scene:sheet");
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
    test::OpenSession open;
    const Address kept = firstWhere<SortEvidence>(
        open, [](const SortEvidence& e) { return e.verdict == Verdict::Kept && e.degrees > 20.0; });
    const DrawList list = drawn(open, kept, {LayerId::SortAngles});
    CHECK(list.sheets.size() == 2);
    CHECK(says(list, "z"));
    CHECK(says(list, "1."));
    CHECK(says(list, "\xC2\xB0"));
    const Picture& picture = open.session.picture();
    const glm::vec3 tested = open.session.model().place[picture.underTest];
    CHECK(std::any_of(list.lines.begin(), list.lines.end(),
                      [&](const Line& line) { return line.from == tested && line.dash > 0.0F; }));
}

TEST_CASE("Drawn for limits: the concave corner filled, the letter on its way") {
    test::OpenSession open("scene:figure-4");
    const Address moved = firstWhere<LimitEvidence>(
        open, [](const LimitEvidence& e) { return e.verdict == Verdict::Moved; });
    const DrawList list = drawn(open, moved, {LayerId::Limits});
    CHECK_FALSE(list.sheets.empty());
    CHECK(says(list, "concave"));
    CHECK(says(list, "moves here"));
}

TEST_CASE("Drawn for convex: a hollow corner and the way along the ring") {
    test::OpenSession open("scene:figure-5");
    const Address behind = firstWhere<DropEvidence>(
        open, [](const DropEvidence& e) { return e.verdict == Verdict::BehindConvex; });
    const DrawList list = drawn(open, behind, {LayerId::Convexity});
    CHECK(list.sheets.empty());
    CHECK(says(list, "convex"));
    CHECK(says(list, "along the ring"));
    CHECK(says(list, "height"));
}

TEST_CASE("Drawn for reciprocal: a second disc at e, its range and the line to p") {
    test::OpenSession open("scene:figure-6");
    const Address refused = firstWhere<ReciprocalEvidence>(
        open, [](const ReciprocalEvidence& e) { return e.verdict == Verdict::NotReciprocal; });
    const DrawList list = drawn(open, refused, {LayerId::Reciprocal});
    const Picture& picture = open.session.picture();
    const auto& place = open.session.model().place;
    CHECK_FALSE(list.sheets.empty());
    CHECK(hasLine(list, place[picture.underTest], place[picture.pivot]));
    CHECK(says(list, "outside"));
}

TEST_CASE("Drawn for hole: the plane through start and end and the side of p") {
    test::OpenSession open("scene:figure-7");
    const DrawList list =
        drawn(open, firstWhere<HoleEvidence>(open, [](const auto&) { return true; }),
              {LayerId::HolePlane});
    CHECK(list.sheets.size() == 3);
    CHECK(says(list, "side of p"));
    CHECK(says(list, "far side"));
}

TEST_CASE("Drawn for sphere: three great circles, the radius and the limit of the gap") {
    test::OpenSession open;
    const DrawList list = drawn(open, {30, Stage::Sphere, 1}, {LayerId::Spheres, LayerId::Labels});
    REQUIRE(list.spheres.size() == 1);
    const Sphere& sphere = list.spheres[0];
    const auto onShell = std::count_if(list.lines.begin(), list.lines.end(), [&](const Line& l) {
        return std::abs(glm::distance(l.from, sphere.center) - sphere.radius) < 1e-4F &&
               std::abs(glm::distance(l.to, sphere.center) - sphere.radius) < 1e-4F;
    });
    CHECK(onShell >= 96 + 2 * 64);
    const Picture& picture = open.session.picture();
    CHECK(hasLine(list, sphere.center, open.session.model().place[picture.pivot]));
    CHECK(hasLine(list, sphere.center, open.session.model().place[picture.sphere->q]));
    for (const char* text : {"c", "r", "d ", "q ", "s", "t"}) CHECK(says(list, text));
}

TEST_CASE("Drawn for twopoint: the one triangle hatched, its angle against 180 degrees") {
    test::OpenSession open("scene:figure-9");
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
    test::OpenSession open;
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
    test::OpenSession open("scene:figure-12");
    const DrawList split = drawn(open, {45, Stage::Split, 1}, {LayerId::Exchange});
    CHECK(says(split, "cut"));
    CHECK(says(split, "a: "));
    CHECK(says(split, "b: "));
    const DrawList join = drawn(open, {74, Stage::Join, 1}, {LayerId::Exchange});
    CHECK(says(join, "bridge"));
    CHECK(says(join, "b was #1"));
}

TEST_CASE(
    "Several splits in one pivot: each shows the loops that it cut, not what is left at the end") {
    test::OpenSession open("scene:figure-12");
    const DrawList first = drawn(open, {35, Stage::Split, 1}, {LayerId::Exchange});
    CHECK(says(first, "a: 19 entries"));
    CHECK(says(first, "b: 13 entries"));
    CHECK(open.session.picture().rings.size() == 2);
    CHECK(open.session.picture().rings[0].points.size() == 19);
    const DrawList second = drawn(open, {35, Stage::Split, 2}, {LayerId::Exchange});
    CHECK(says(second, "a: 17 entries"));
    CHECK(says(second, "b: 2 entries"));
    CHECK(open.session.picture().rings.size() == 3);
    const DrawList last = drawn(open, {35, Stage::Split, 3}, {LayerId::Exchange});
    CHECK(says(last, "a: 15 entries"));
    // A pinned layer goes on showing the last one.
    CHECK(says(drawn(open, {35, Stage::Advance, 1}, {LayerId::Exchange}), "a: 15 entries"));
}

TEST_CASE("A join and a split in one pivot show the point of the later one") {
    test::OpenSession open("scene:torus");
    CHECK(says(drawn(open, {560, Stage::Join, 1}, {LayerId::Exchange}), "b was #2"));
    CHECK(says(drawn(open, {560, Stage::Split, 1}, {LayerId::Exchange}), "a: 60 entries"));
}

TEST_CASE("Drawn for seed, advance and done") {
    test::OpenSession open("scene:linked-tori");
    const auto& place = open.session.model().place;
    const DrawList seed = drawn(open, {1, Stage::Seed, 1}, {LayerId::Seed});
    CHECK(says(seed, "start point"));
    CHECK(seed.lines.size() == 1);
    const DrawList advance = drawn(open, {20, Stage::Advance, 1}, {LayerId::Advance});
    const Picture& picture = open.session.picture();
    CHECK(std::any_of(advance.lines.begin(), advance.lines.end(),
                      [&](const Line& l) { return l.to == place[picture.nextPivot]; }));
    open.session.goTo({536, Stage::Done, 1});
    open.session.settle();
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

TEST_CASE("A seed lights up what was passed over, once; on paper for good") {
    test::OpenSession open;
    const Model& model = open.session.model();
    const auto nearest = model.points.neighbors[50];
    // As if the run had come to point 50, with two of its neighbors DONE.
    Picture picture = open.session.picture();
    for (Index p = 0; p < 50; ++p) picture.status.set(p, kDone);
    for (std::size_t i = 0; i < 2; ++i) picture.status.set(nearest[i], kDone);
    picture.latest = {{{9, Stage::Seed, 1}, SeedEvidence{50, nearest[2], 0.1}}};
    LayerInput in{model, picture, paletteOf(Theme::Dark)};
    in.seedBefore = 20;
    const auto at = [&](const Moment& moment) {
        in.moment = moment;
        DrawList list;
        addSeed(in, list);
        return list;
    };
    CHECK(count(at(Moment{}), Shape::Dot) == 0);
    CHECK_FALSE(says(at(Moment{}), "passed over"));
    const DrawList lit = at({Moment::Kind::Moving, 0.1, false});
    CHECK(count(lit, Shape::Dot) == 30 + 2);
    CHECK(says(lit, "30 DONE, passed over"));
    CHECK(count(at(kPaper), Shape::Dot) == 30 + 2);
    CHECK(count(at({Moment::Kind::Moving, 0.7, false}), Shape::Dot) == 0);
}

TEST_CASE("A point that nothing can be begun with is crossed and says why") {
    test::OpenSession open;
    open.session.goTo({425, Stage::Strand, 1});
    open.session.settle();
    const DrawList list = drawnAt(open, Moment{}, addSeed);
    CHECK(count(list, Shape::Cross) == 1);
    CHECK(says(list, "no neighbor left"));
}

TEST_CASE("The last fan fades as a new one comes in") {
    test::OpenSession open;
    open.session.goTo({30, Stage::Emit, 1});
    open.session.settle();
    const Palette& c = paletteOf(Theme::Dark);
    const auto fading = [&](const Moment& moment) {
        std::vector<Color> colors;
        for (const Face& face : drawnAt(open, moment, addTriangles).faces) {
            if (!face.hatched) colors.push_back(face.color);
        }
        return colors;
    };
    CHECK(fading(Moment{}).empty());
    const auto early = fading({Moment::Kind::Moving, 0.05, true});
    const auto late = fading({Moment::Kind::Moving, 0.4, true});
    REQUIRE_FALSE(early.empty());
    REQUIRE(late.size() == early.size());
    const auto fromGray = [&](const Color& color) { return color.r - c.mesh.r; };
    CHECK(fromGray(early[0]) > fromGray(late[0]));
    CHECK(fading(kPaper).size() == early.size());
    // They are those of one pivot, the last ones.
    const auto finished = open.session.triangles();
    const std::size_t count = open.session.picture().finishedTriangles;
    CHECK(finished[count - early.size()].a == finished[count - 1].a);
    CHECK(finished[count - early.size() - 1].a != finished[count - 1].a);
}

TEST_CASE("The old path of the ring fades, and what joins it pops up in order") {
    test::OpenSession open;
    open.session.goTo({30, Stage::Ring, 3});
    open.session.settle();
    const auto alphaOfOld = [&](const Moment& moment) {
        for (const Line& line : drawnAt(open, moment, addRingChange).lines) {
            if (line.dash > 0.0F) return line.color.a;
        }
        return 0.0F;
    };
    CHECK(alphaOfOld({Moment::Kind::Moving, 0.0, false}) == doctest::Approx(1.0));
    CHECK(alphaOfOld({Moment::Kind::Moving, 0.3, false}) < 1.0F);
    CHECK(alphaOfOld(Moment{}) == doctest::Approx(0.5));
    CHECK(alphaOfOld(kPaper) == doctest::Approx(0.5));
    const auto joined = [&](const Moment& moment) {
        return count(drawnAt(open, moment, addRingChange), Shape::RingedDisc);
    };
    const std::size_t all = joined(Moment{});
    CHECK(all >= 1);
    CHECK(joined({Moment::Kind::Moving, 0.0, false}) < all);
    CHECK(joined({Moment::Kind::Moving, 0.49, false}) == all);
    CHECK(joined({Moment::Kind::Moving, 0.0, true}) == all);
}

TEST_CASE("What a refused triangle would cover is filled, and it alone") {
    test::OpenSession open("scene:figure-9");
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
    open.session.goTo({42, Stage::Reciprocal, 1});
    open.session.settle();
    const Picture& p = open.session.picture();
    const float whole =
        areaOfPicture(p.pivot, p.underTest, p.start) + areaOfPicture(p.pivot, p.underTest, p.end);
    const float covered = hatched(addReciprocal);
    CHECK(covered > 0.3F * whole);
    CHECK(covered < 0.9F * whole);

    open.session.goTo({87, Stage::TwoPoint, 1});
    open.session.settle();
    CHECK(hatched(addTwoPoint) > 0.5F * areaOfPicture(p.pivot, p.first, p.last));
    // A hole covers nothing.
    open.session.goTo({15, Stage::TwoPoint, 1});
    open.session.settle();
    CHECK(hatched(addTwoPoint) == 0.0F);
}

TEST_CASE("A triangle that the reciprocal test keeps covers next to nothing") {
    test::OpenSession open("scene:figure-12");
    const Address kept = firstWhere<ReciprocalEvidence>(
        open, [](const ReciprocalEvidence& e) { return e.verdict == Verdict::Kept; });
    REQUIRE(kept.pivot > 0);
    open.session.goTo(kept);
    open.session.settle();
    CHECK_FALSE(says(drawnAt(open, Moment{}, addReciprocal), "overlap"));
}
