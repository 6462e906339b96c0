/// Short highlights of layers, and their traces in saved pictures.
#include "drawn.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;
using namespace se::view::test;

TEST_CASE("A seed highlights the skipped points, once, permanently in saved pictures") {
    OpenSession open;
    const Model& model = open.session.model();
    const auto nearest = model.points.neighbors[50];
    // As if the run had reached point 50, with two of its neighbors DONE.
    DecisionState picture = open.session.picture();
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
    CHECK(count(at(Moment{}), view::Shape::Dot) == 0);
    CHECK_FALSE(says(at(Moment{}), "passed over"));
    const DrawList lit = at({Moment::Kind::Moving, 0.1, false});
    CHECK(count(lit, view::Shape::Dot) == 30 + 2);
    CHECK(says(lit, "30 DONE, passed over"));
    CHECK(count(at(kPaper), view::Shape::Dot) == 30 + 2);
    CHECK(count(at({Moment::Kind::Moving, 0.7, false}), view::Shape::Dot) == 0);
}

TEST_CASE("The last fan fades as a new one appears") {
    OpenSession open;
    open.session.moves().goTo({30, Stage::Emit, 1});
    open.session.waitUntilDone();
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

TEST_CASE("The old path of the ring fades, and joining points pop up in order") {
    OpenSession open;
    open.session.moves().goTo({30, Stage::Ring, 3});
    open.session.waitUntilDone();
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
        return count(drawnAt(open, moment, addRingChange), view::Shape::RingedDisc);
    };
    const std::size_t all = joined(Moment{});
    CHECK(all >= 1);
    CHECK(joined({Moment::Kind::Moving, 0.0, false}) < all);
    CHECK(joined({Moment::Kind::Moving, 0.49, false}) == all);
    CHECK(joined({Moment::Kind::Moving, 0.0, true}) == all);
}
