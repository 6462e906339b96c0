#include "layout/overlays.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "spiraling_edge/base/random.h"

using namespace se;
using namespace se::view;

namespace {

constexpr float kPinEm = 16.0F;
const Rect kArea{{100.0F, 50.0F}, {800.0F, 500.0F}};

std::vector<PinPlace> scattered(std::size_t count) {
    SplitMix random(5);
    std::vector<PinPlace> places;
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<float>(random.unit());
        const auto y = static_cast<float>(random.unit());
        places.push_back({kArea.min + glm::vec2(x, y) * kArea.size, 2.0F});
    }
    return places;
}

bool same(const Pin& a, const Pin& b) {
    return a.place == b.place && a.count == b.count && a.tip == b.tip && a.strength == b.strength;
}

}  // namespace

TEST_CASE("Pins: places near the most severe one share its pin, and are counted") {
    const std::vector<PinPlace> places{
        {{500, 300}, 1}, {{700, 300}, 1}, {{520, 300}, 1}, {{500, 270}, 1}, {{705, 305}, 1}};
    const std::vector<Pin> pins = pinsOf(places, kArea, kPinEm);
    REQUIRE(pins.size() == 2);
    CHECK(pins[0].place == 0);
    CHECK(pins[0].count == 3);
    CHECK(pins[0].tip == glm::vec2(500, 300));
    CHECK(pins[1].place == 1);
    CHECK(pins[1].count == 2);
}

TEST_CASE("Pins: a place that is seen at its size has none, and one nearly seen fades") {
    const auto strength = [](float radius) {
        const std::vector<Pin> pins =
            pinsOf(std::vector<PinPlace>{{{500, 300}, radius * kPinEm}}, kArea, kPinEm);
        return pins.empty() ? 0.0F : pins[0].strength;
    };
    CHECK(strength(0.1F) == 1.0F);
    CHECK(strength(0.7F) > 0.1F);
    CHECK(strength(0.7F) < 0.9F);
    CHECK(strength(kSeenFrom) == 0.0F);
    CHECK(strength(5.0F) == 0.0F);
}

TEST_CASE("Pins: only places in the view have one, and each of them is counted once") {
    std::vector<PinPlace> places = scattered(3000);
    for (const glm::vec2 outside : {glm::vec2(99, 300), glm::vec2(500, 551), glm::vec2(-1, -1)})
        places.push_back({outside, 1.0F});
    std::size_t counted = 0;
    for (const Pin& pin : pinsOf(places, kArea, kPinEm)) counted += pin.count;
    CHECK(counted == 3000);
}

TEST_CASE("Pins: equal places give equal pins, whose heads do not overlap") {
    const std::vector<PinPlace> places = scattered(3000);
    const std::vector<Pin> pins = pinsOf(places, kArea, kPinEm);
    const std::vector<Pin> again = pinsOf(places, kArea, kPinEm);
    REQUIRE(pins.size() > 20);
    CHECK(std::equal(pins.begin(), pins.end(), again.begin(), again.end(), same));
    // Away from the edges, where heads may move.
    const Rect inner{kArea.min + 5.0F * kPinEm, kArea.size - 10.0F * kPinEm};
    for (std::size_t i = 0; i < pins.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (!inner.contains(pins[i].tip) || !inner.contains(pins[k].tip)) continue;
            CHECK(glm::distance(pins[i].tip, pins[k].tip) > 2.0F * kPinEm);
            CHECK_FALSE(overlap(headOf(pins[i], 1.5F * kPinEm, kArea, kPinEm),
                                headOf(pins[k], 1.5F * kPinEm, kArea, kPinEm)));
        }
    }
}

TEST_CASE("Pins: the head is within the view and never covers what its tip marks") {
    for (const PinPlace& place : scattered(500)) {
        for (const float text : {0.0F, 8.0F, 40.0F}) {
            const Pin pin{0, 1, place.at, 1.0F};
            const Rect head = headOf(pin, text, kArea, kPinEm);
            CHECK(within(head, kArea));
            CHECK(glm::distance(nearestIn(head, pin.tip), pin.tip) > kSeenFrom * kPinEm);
        }
    }
}
