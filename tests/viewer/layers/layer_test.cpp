#include "layers/layer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "drawn.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

TEST_CASE("The table has every layer once") {
    std::set<std::string_view> names;
    REQUIRE(layers().size() == kLayerCount);
    for (const Layer& layer : layers()) CHECK(names.insert(layer.name).second);
    std::set<LayerId> ids;
    for (const Layer& layer : layers()) CHECK(ids.insert(layer.id).second);
}

TEST_CASE("With no layer on nothing is drawn") {
    OpenSession open;
    const DrawList list = drawn(open, kWhole, {});
    CHECK_FALSE(list.cloudVisible);
    CHECK_FALSE(list.meshVisible);
    CHECK(list.lines.empty());
    CHECK(list.faces.empty());
    CHECK(list.sprites.empty());
    CHECK(list.labels.empty());
}

TEST_CASE("Points have a style by status and type") {
    OpenSession open("scene:sheet");
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
            CHECK((style.shape == view::Shape::Diamond || style.shape == view::Shape::OpenDiamond));
        } else if (isBoundary(type)) {
            CHECK((style.shape == view::Shape::Square || style.shape == view::Shape::OpenSquare));
        }
    }
}

TEST_CASE("Finished triangles are counted, those of the pivot are new") {
    OpenSession open;
    const DrawList list = drawn(open, kWhole, {LayerId::Triangles});
    const PivotRecord& record = open.session.record();
    CHECK(list.finishedTriangles == record.before.triangleCount);
    CHECK(list.faces.size() == record.after.triangleCount - record.before.triangleCount);
    for (const Face& face : list.faces) CHECK(face.hatched);
}

TEST_CASE("The active ring is closed and has arrows, stacked rings are dashed and numbered") {
    OpenSession open("scene:torus");
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
    CHECK(stacked.labels[0].text == "ring b");
}

TEST_CASE("A ring keeps its name while others split, join and close") {
    OpenSession open("scene:torus");
    const auto onPivot = [&](std::uint32_t pivot) {
        open.session.moves().goTo({pivot, Stage::Pivot, 0});
        open.session.waitUntilDone();
        return open.session.picture().rings;
    };
    using Names = std::set<std::string>;
    const auto names = [&](std::uint32_t pivot) {
        Names found;
        for (const RingPath& ring : onPivot(pivot))
            CHECK(found.insert(ringName(ring.number)).second);
        return found;
    };
    // The ring that splits goes on as a, and leaves b and c on the stack; d is closed at once.
    CHECK(names(190) == Names{"a"});
    for (std::uint32_t pivot = 210; pivot < 410; pivot += 20) {
        CHECK(names(pivot) == Names{"a", "b", "c"});
        CHECK(ringName(onPivot(pivot).front().number) == "a");
    }
    // Most of a is split off as e, and the rest is closed.
    CHECK(names(430) == Names{"b", "c", "e"});
    CHECK(ringName(onPivot(430).front().number) == "e");
}

TEST_CASE("The lanes of the run have the names of its rings") {
    OpenSession open("scene:torus");
    std::vector<Index> numbers;
    for (const LaneChange& change : open.session.overview().laneChanges) {
        if (beginsLane(change.kind)) numbers.push_back(change.ring);
    }
    REQUIRE(numbers.size() >= 3);
    for (std::size_t i = 0; i < numbers.size(); ++i) CHECK(numbers[i] == i);
}

TEST_CASE("The sphere of a test passes through p, s and t, in view space") {
    OpenSession open;
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

TEST_CASE("A pivot has its marks during its tests, and only its own afterwards") {
    OpenSession open;
    const DrawList during = drawn(open, {30, Stage::Emit, 1}, {LayerId::NeighborRing});
    CHECK(count(during, view::Shape::Forward) >= 1);
    CHECK(count(during, view::Shape::Back) >= 1);
    CHECK(count(during, view::Shape::RingedDisc) >= 1);
    const DrawList after = drawn(open, kWhole, {LayerId::NeighborRing});
    CHECK(count(after, view::Shape::RingedDisc) == 1);
    CHECK(count(after, view::Shape::Forward) == 0);
    CHECK(count(after, view::Shape::Cross) == 0);
}

TEST_CASE("Labels are only at the pivot, its candidates and the selection, one each") {
    OpenSession open;
    const DrawList list = drawn(open, {30, Stage::Sphere, 1}, {LayerId::Labels}, 7);
    const DecisionState& picture = open.session.picture();
    CHECK(list.labels.size() <= picture.candidates.size() + 6);
    std::set<std::string> texts;
    for (const Label& label : list.labels) CHECK(texts.insert(label.text).second);
    CHECK(texts.contains("7"));
    CHECK(texts.contains(std::to_string(picture.pivot)));
}

TEST_CASE("A point of a decision is labeled with its name alone, in a figure that of the paper") {
    for (const char* scene : {"scene:torus", "scene:figure-8"}) {
        CAPTURE(scene);
        OpenSession open(scene);
        const Address at = scene == std::string("scene:torus") ? Address{137, Stage::Sphere, 3}
                                                               : Address{9, Stage::Sphere, 2};
        const DrawList list = drawn(open, at, {LayerId::Labels});
        const DecisionState& picture = open.session.picture();
        REQUIRE(picture.sphere);
        const auto names = open.session.names();
        std::vector<std::string> wanted;
        for (const Index point : {picture.pivot, picture.underTest, picture.sphere->t,
                                  picture.sphere->s, picture.start, picture.end})
            wanted.push_back(nameOf(point, names));
        // Those of the decision come first, in this order.
        std::vector<std::string> labels;
        for (const Label& label : list.labels) labels.push_back(label.text);
        REQUIRE(labels.size() >= wanted.size());
        labels.resize(wanted.size());
        CHECK(labels == wanted);
        // Those of a figure are always shown.
        for (const Label& label : list.labels)
            CHECK(label.given == (!label.text.empty() && std::isdigit(label.text.front()) == 0));
    }
}

TEST_CASE("A point that its stage names has no second label") {
    OpenSession open;
    const Address seed{1, Stage::Seed, 1};
    (void)drawn(open, seed, {});
    const auto* made = open.session.picture().evidence<SeedEvidence>(Stage::Seed);
    REQUIRE(made != nullptr);
    const std::vector<PointName> names{{made->first, "1"}, {made->second, "2"}};
    open.session.giveNames(names);
    const DrawList list = drawn(open, seed, {LayerId::Seed, LayerId::Labels});
    CHECK(list.labels.size() == 3);
    CHECK(says(list, "start point 1"));
    open.session.giveNames({});
}

TEST_CASE("The measures of a sphere are written out where a point has one of their letters") {
    OpenSession open;
    const Address at{30, Stage::Sphere, 1};
    const auto saysCenter = [&] {
        const DrawList list = drawn(open, at, {LayerId::Spheres});
        return std::any_of(list.labels.begin(), list.labels.end(),
                           [](const Label& each) { return each.text == "center"; });
    };
    CHECK_FALSE(saysCenter());
    const std::vector<PointName> names{{7, "r"}};
    open.session.giveNames(names);
    CHECK(saysCenter());
    open.session.giveNames({});
}

TEST_CASE("A marked point whose role is labeled has no second label") {
    OpenSession open;
    (void)drawn(open, {30, Stage::Sphere, 1}, {});
    const Index pivot = open.session.picture().pivot;
    const std::vector<Index> marked{pivot, 7};
    open.session.highlights().mark(marked);
    const DrawList list = drawn(open, {30, Stage::Sphere, 1}, {LayerId::Labels, LayerId::Marked});
    const auto labels = [&](Index point) {
        return std::count_if(list.labels.begin(), list.labels.end(), [&](const Label& each) {
            return each.position == open.session.model().place[point];
        });
    };
    CHECK(labels(pivot) == 1);
    CHECK(labels(7) == 1);
}

TEST_CASE("Links are the neighbor list of the pivot") {
    OpenSession open;
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

TEST_CASE("A pinned layer stays in every stage, until it is unpinned") {
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

TEST_CASE("A layer that is pinned on keeps showing the last test of its stage") {
    OpenSession open;
    CHECK(drawn(open, {30, Stage::Sphere, 1}, {LayerId::Spheres}).spheres.size() == 1);
    CHECK(drawn(open, {30, Stage::Emit, 1}, {LayerId::Spheres}).spheres.size() == 1);
    CHECK_FALSE(drawn(open, {30, Stage::Emit, 1}, {LayerId::SortAngles}).lines.empty());
}

TEST_CASE("Names of the three states of a layer are read back as written") {
    for (const LayerMode mode : {LayerMode::Automatic, LayerMode::PinnedOn, LayerMode::PinnedOff}) {
        CHECK(layerModeFromName(layerModeName(mode)) == mode);
    }
    CHECK(layerModeFromName("maybe") == std::nullopt);
}

TEST_CASE("Styles computed for changed blocks equal those computed for all") {
    test::OpenSession open("scene:torus");
    DrawList kept;
    LayerSwitches on;
    on.set(static_cast<std::size_t>(LayerId::Points));
    for (const std::uint32_t pivot : {10U, 11U, 300U, 12U, 0U}) {
        open.session.moves().goToPivot(pivot);
        open.session.waitUntilDone();
        const LayerInput in{open.session.model(), open.session.picture(), paletteOf(Theme::Dark)};
        DrawList fresh;
        fillDrawList(in, on, kept);
        fillDrawList(in, on, fresh);
        CHECK(kept.cloudStyleOf == fresh.cloudStyleOf);
    }
}
