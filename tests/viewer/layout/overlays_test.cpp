#include "layout/overlays.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>
#include <set>

using namespace se::view;

namespace {

constexpr float kEm = 16.0F;
constexpr Rect kView{{100.0F, 50.0F}, {640.0F, 400.0F}};

bool holds(const Rect& outer, const Rect& inner) {
    return inner.min.x >= outer.min.x && inner.min.y >= outer.min.y &&
           inner.max().x <= outer.max().x && inner.max().y <= outer.max().y;
}

/// Many labels in a small area: `count` of each rank, around the middle of the view.
std::vector<LabelRequest> crowd(unsigned seed, int count) {
    std::mt19937 random(seed);
    const auto share = [&] { return static_cast<float>(random() % 1000) / 1000.0F; };
    std::vector<LabelRequest> labels;
    for (const LabelRank rank : {LabelRank::Minor, LabelRank::Strong, LabelRank::Essential}) {
        for (int i = 0; i < count; ++i) {
            const glm::vec2 off((share() - 0.5F) * 260.0F, (share() - 0.5F) * 160.0F);
            labels.push_back(
                {kView.min + 0.5F * kView.size + off, {30.0F + 90.0F * share(), 20.0F}, rank});
        }
    }
    return labels;
}

std::vector<LabelMark> marksOf(const std::vector<LabelRequest>& labels) {
    std::vector<LabelMark> marks;
    for (const LabelRequest& label : labels) {
        if (label.rank == LabelRank::Essential) marks.push_back({label.at, 0.6F * kEm});
    }
    return marks;
}

bool contains(const std::vector<PlacedLabel>& placed, std::size_t label) {
    return std::any_of(placed.begin(), placed.end(),
                       [&](const PlacedLabel& each) { return each.index == label; });
}

}  // namespace

TEST_CASE("Labels cover neither each other nor marks nor used areas, in any number") {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        const std::vector<LabelRequest> labels = crowd(seed, 12);
        const std::vector<LabelMark> marks = marksOf(labels);
        const std::vector<Rect> taken = {{{560.0F, 60.0F}, {170.0F, 180.0F}}};
        LabelRoom room{kView, taken, marks, nullptr, kView.min + 0.5F * kView.size, kEm};
        const std::vector<PlacedLabel> placed = placeLabels(room, labels);
        CHECK_FALSE(placed.empty());
        std::set<std::size_t> seen;
        for (const PlacedLabel& a : placed) {
            CHECK(seen.insert(a.index).second);
            CHECK(holds(kView, a.plate));
            CHECK(a.plate.size == labels[a.index].plate);
            CHECK_FALSE(overlap(a.plate, taken[0]));
            for (const LabelMark& mark : marks) CHECK_FALSE(overlap(a.plate, mark));
            for (const PlacedLabel& b : placed) CHECK((&a == &b || !overlap(a.plate, b.plate)));
        }
    }
}

TEST_CASE("A view has seven labels, the essential ones first, and those that are asked for") {
    std::vector<LabelRequest> labels = crowd(3, 12);
    LabelRoom room{kView, {}, {}, nullptr, kView.min + 0.5F * kView.size, kEm};
    const auto count = [&](LabelRank rank) {
        const std::vector<PlacedLabel> placed = placeLabels(room, labels);
        return std::count_if(placed.begin(), placed.end(), [&](const PlacedLabel& each) {
            return labels[each.index].rank == rank;
        });
    };
    CHECK(placeLabels(room, labels).size() == kMaxLabels);
    CHECK(count(LabelRank::Essential) == kMaxLabels);
    labels.push_back({kView.min + glm::vec2(60.0F, 60.0F), {30.0F, 20.0F}, LabelRank::Asked});
    CHECK(placeLabels(room, labels).size() == kMaxLabels + 1);
    CHECK(count(LabelRank::Asked) == 1);
}

TEST_CASE("Names that are given are beside the number of the others, in any number") {
    std::vector<LabelRequest> labels = crowd(3, 12);
    for (int i = 0; i < 8; ++i)
        labels.push_back({kView.min + glm::vec2(40.0F + 70.0F * static_cast<float>(i), 60.0F),
                          {20.0F, 20.0F},
                          LabelRank::Given});
    const LabelRoom room{kView, {}, {}, nullptr, kView.min + 0.5F * kView.size, kEm};
    const std::vector<PlacedLabel> placed = placeLabels(room, labels);
    REQUIRE(placed.size() == kMaxLabels + 8);
    // Right after those of the decision.
    for (std::size_t i = 0; i < placed.size(); ++i)
        CHECK(labels[placed[i].index].rank ==
              (i < kMaxLabels ? LabelRank::Essential : LabelRank::Given));
}

TEST_CASE("Minor labels are left out first, essential ones last") {
    int dropped[3] = {0, 0, 0};
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const std::vector<LabelRequest> labels = crowd(seed, 5);
        const std::vector<LabelMark> marks = marksOf(labels);
        const LabelRoom room{kView, {}, marks, nullptr, kView.min + 0.5F * kView.size, kEm};
        const std::vector<PlacedLabel> placed = placeLabels(room, labels);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (!contains(placed, i)) ++dropped[static_cast<std::size_t>(labels[i].rank)];
        }
    }
    CHECK(dropped[0] == 0);
    CHECK(dropped[1] < dropped[2]);
    CHECK(dropped[2] > 0);
}

TEST_CASE("Where there is room for one label only, it is the essential one") {
    // A view that one plate nearly fills: the order of the list does not matter.
    const Rect small{{0.0F, 0.0F}, {120.0F, 60.0F}};
    const std::vector<LabelRequest> labels = {
        {{30.0F, 30.0F}, {80.0F, 40.0F}, LabelRank::Minor},
        {{30.0F, 30.0F}, {80.0F, 40.0F}, LabelRank::Strong},
        {{30.0F, 30.0F}, {80.0F, 40.0F}, LabelRank::Essential}};
    const std::vector<PlacedLabel> placed = placeLabels({small, {}, {}, nullptr, {}, kEm}, labels);
    REQUIRE(placed.size() == 1);
    CHECK(placed[0].index == 2);
}

TEST_CASE("A label is close to its point and away from the pivot, otherwise a line leads to it") {
    const glm::vec2 pivot(400.0F, 250.0F);
    const std::vector<LabelMark> marks = {{pivot, 10.0F}};
    const LabelRoom room{kView, {}, marks, nullptr, pivot, kEm};
    for (const glm::vec2 off :
         {glm::vec2(60, 40), glm::vec2(-60, 40), glm::vec2(60, -40), glm::vec2(-60, -40)}) {
        const std::vector<LabelRequest> one = {{pivot + off, {60.0F, 20.0F}, LabelRank::Minor}};
        const std::vector<PlacedLabel> placed = placeLabels(room, one);
        REQUIRE(placed.size() == 1);
        CHECK_FALSE(placed[0].leader);
        CHECK(glm::distance(nearestIn(placed[0].plate, one[0].at), one[0].at) < kEm);
        const glm::vec2 middle = placed[0].plate.min + 0.5F * placed[0].plate.size;
        CHECK(glm::dot(middle - one[0].at, off) > 0.0F);
    }
    // All around is used: far off, with a line.
    const std::vector<Rect> taken = {{pivot - glm::vec2(80.0F, 60.0F), {160.0F, 120.0F}}};
    const std::vector<LabelRequest> one = {{pivot, {60.0F, 20.0F}, LabelRank::Essential}};
    const std::vector<PlacedLabel> placed =
        placeLabels({kView, taken, marks, nullptr, pivot, kEm}, one);
    REQUIRE(placed.size() == 1);
    CHECK(placed[0].leader);
}

TEST_CASE("A label whose point is not visible is not shown") {
    const std::vector<LabelRequest> one = {{{90.0F, 60.0F}, {60.0F, 20.0F}, LabelRank::Essential}};
    CHECK(placeLabels({kView, {}, {}, nullptr, {}, kEm}, one).empty());
}

TEST_CASE("Of two positions a label takes the one that covers less of the picture") {
    const glm::vec2 at(400.0F, 250.0F);
    OccupancyGrid occupancy(kView, 0.5F * kEm);
    // Spokes to the right above, where a label usually goes.
    for (int i = 0; i < 12; ++i) {
        occupancy.addLine(at, at + glm::vec2(90.0F, -8.0F * static_cast<float>(i)), 1.0F);
    }
    occupancy.finish();
    const std::vector<LabelRequest> one = {{at, {60.0F, 20.0F}, LabelRank::Strong}};
    const std::vector<PlacedLabel> without = placeLabels({kView, {}, {}, nullptr, at, kEm}, one);
    const std::vector<PlacedLabel> with = placeLabels({kView, {}, {}, &occupancy, at, kEm}, one);
    REQUIRE(without.size() == 1);
    REQUIRE(with.size() == 1);
    CHECK(occupancy.under(without[0].plate) > 0.0F);
    CHECK(occupancy.under(with[0].plate) < occupancy.under(without[0].plate));
}

TEST_CASE("Clutter is the length of lines and the area of faces, in cells") {
    const Rect area{{10.0F, 20.0F}, {100.0F, 100.0F}};
    OccupancyGrid occupancy(area, 10.0F);
    occupancy.addLine({10.0F, 25.0F}, {60.0F, 25.0F}, 2.0F);
    occupancy.addSpot({95.0F, 105.0F}, 1.0F, 3.0F);
    // Parts outside do not count.
    occupancy.addLine({-500.0F, -10.0F}, {500.0F, -10.0F}, 1.0F);
    occupancy.addSpot({300.0F, 300.0F}, 5.0F, 1.0F);
    occupancy.finish();
    CHECK(occupancy.under(area) == doctest::Approx(13.0));
    CHECK(occupancy.under({{10.0F, 20.0F}, {50.0F, 10.0F}}) == doctest::Approx(10.0));
    CHECK(occupancy.under({{10.0F, 30.0F}, {50.0F, 10.0F}}) == doctest::Approx(0.0));
    CHECK(occupancy.under({{90.0F, 100.0F}, {10.0F, 10.0F}}) == doctest::Approx(3.0));
    CHECK(occupancy.under({{500.0F, 500.0F}, {10.0F, 10.0F}}) == doctest::Approx(0.0));

    OccupancyGrid face(area, 2.0F);
    face.addTriangle({10.0F, 20.0F}, {110.0F, 20.0F}, {10.0F, 120.0F}, 1.0F);
    face.finish();
    CHECK(face.under(area) == doctest::Approx(1250.0).epsilon(0.05));
}

TEST_CASE("A line that crosses the area counts only within it") {
    OccupancyGrid occupancy({{0.0F, 0.0F}, {100.0F, 100.0F}}, 10.0F);
    occupancy.addLine({-100.0F, 55.0F}, {300.0F, 55.0F}, 1.0F);
    occupancy.finish();
    CHECK(occupancy.under({{0.0F, 0.0F}, {100.0F, 100.0F}}) == doctest::Approx(10.0));
}
