#include "rows/lane_picture.h"

#include <doctest/doctest.h>

#include "open_session.h"

using namespace se;
using namespace se::view;
using test::OpenSession;

namespace {

RingPath ringOf(std::vector<Index> points) {
    RingPath ring;
    ring.open.assign(points.size(), false);
    ring.points = std::move(points);
    return ring;
}

}  // namespace

TEST_CASE("A ring that fits is shown once, with any point in the middle") {
    const RingSlice slice = sliceAbout(5, 4, 0, 9);
    CHECK(slice.whole());
    std::vector<bool> seen(5, false);
    for (std::size_t i = 0; i < slice.count; ++i) seen[slice.at(i)] = true;
    for (const bool one : seen) CHECK(one);
    CHECK(slice.at(2) == 4);
}

TEST_CASE("Of a long ring the points about the middle are shown, across its end") {
    const RingSlice slice = sliceAbout(100, 1, 0, 7);
    CHECK_FALSE(slice.whole());
    CHECK(slice.count == 7);
    CHECK(slice.at(0) == 98);
    CHECK(slice.at(3) == 1);
    CHECK(slice.at(6) == 4);
    CHECK(sliceAbout(100, 1, 10, 7).at(3) == 11);
    CHECK(sliceAbout(100, 1, -302, 7).at(3) == 99);
    CHECK(sliceAbout(0, 0, 0, 7).count == 0);
}

TEST_CASE("A pivot that is on a ring more than once is found between first and last") {
    const RingPath ring = ringOf({7, 1, 2, 7, 3, 4});
    DecisionState picture;
    picture.pivot = 7;
    picture.first = 2;
    picture.last = 3;
    CHECK(workPlace(picture, ring) == 3);
    picture.first = 4;
    picture.last = 1;
    CHECK(workPlace(picture, ring) == 0);
}

TEST_CASE("When the pivot has left the ring, the position is where the ring continues") {
    const RingPath ring = ringOf({1, 2, 3, 4});
    DecisionState picture;
    picture.pivot = 9;
    picture.end = 3;
    CHECK(workPlace(picture, ring) == 2);
    picture.nextPivot = 4;
    CHECK(workPlace(picture, ring) == 3);
    CHECK_FALSE(workPlace(DecisionState{}, ring));
}

TEST_CASE("The strip shows the chosen ring, otherwise the active one") {
    DecisionState picture;
    picture.rings = {ringOf({1, 2, 3}), ringOf({4, 5, 6})};
    picture.rings[0].active = true;
    picture.rings[0].id = 0;
    picture.rings[1].id = 8;
    CHECK(ringToShow(picture, kNone) == &picture.rings[0]);
    CHECK(ringToShow(picture, 8) == &picture.rings[1]);
    CHECK(ringToShow(picture, 77) == &picture.rings[0]);
    CHECK(ringToShow(DecisionState{}, 8) == nullptr);
}

TEST_CASE("A ring is highlighted under the pointer, and stays so when chosen") {
    OpenSession open;
    open.session.moves().goToPivot(30);
    open.session.waitUntilDone();
    Session& session = open.session;
    const std::uint32_t before = session.revision();
    session.highlights().hoverRing(3);
    CHECK(session.highlights().litRing() == 3);
    CHECK(session.revision() > before);
    session.highlights().hoverRing(kNone);
    CHECK(session.highlights().litRing() == kNone);
    session.highlights().chooseRing(5);
    CHECK(session.highlights().litRing() == 5);
    session.highlights().hoverRing(3);
    CHECK(session.highlights().litRing() == 3);
    session.highlights().hoverRing(kNone);
    session.highlights().chooseRing(5);
    CHECK(session.highlights().litRing() == kNone);
}
