#include <doctest/doctest.h>

#include <limits>

#include "spiraling_edge/points/point_set.h"

using namespace se;

namespace {

/// Four points on a square, each with the two beside it in its list.
PointSet makeSquare() {
    PointSet points;
    points.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    points.normal.assign(4, Vec3(0, 0, 1));
    points.type.assign(4, kInterior);
    for (Index p = 0; p < 4; ++p) {
        const Index list[] = {(p + 1) % 4, (p + 3) % 4};
        points.neighbors.append(list);
    }
    return points;
}

std::string flawOf(const PointSet& points) {
    const Status status = validate(points);
    return status.ok() ? "none" : status.error().message;
}

}  // namespace

TEST_CASE("validate: good points pass, and so does the empty set") {
    CHECK(validate(makeSquare()).ok());
    CHECK(validate(PointSet{}).ok());
}

TEST_CASE("validate: arrays of different length are refused") {
    for (int i = 0; i < 4; ++i) {
        PointSet points = makeSquare();
        if (i == 0) points.normal.pop_back();
        if (i == 1) points.type.pop_back();
        if (i == 2) points.neighbors.append({});
        if (i == 3) points.neighbors.offset.clear();
        CHECK(flawOf(points).find("there are 4 positions, but") == 0);
    }
}

TEST_CASE("validate: offsets must divide the entries") {
    PointSet points = makeSquare();
    points.neighbors.ids.pop_back();
    CHECK(flawOf(points).find("offsets") != std::string::npos);
    points = makeSquare();
    points.neighbors.offset[1] = 5;
    CHECK(flawOf(points).find("offsets") != std::string::npos);
    points = makeSquare();
    points.neighbors.offset[0] = 1;
    CHECK(flawOf(points).find("offsets") != std::string::npos);
}

TEST_CASE("validate: lists name existing other points, each once") {
    PointSet points = makeSquare();
    points.neighbors.ids[3] = 4;
    CHECK(flawOf(points) == "the list of point 1 names point 4, which does not exist");
    points.neighbors.ids[3] = kNone;
    CHECK(flawOf(points) == "the list of point 1 names point 4294967295, which does not exist");
    points.neighbors.ids[3] = 1;
    CHECK(flawOf(points) == "the list of point 1 names the point itself");
    points.neighbors.ids[3] = 2;
    CHECK(flawOf(points) == "the list of point 1 names point 2 twice");
}

TEST_CASE("validate: an order names every point once") {
    PointSet points = makeSquare();
    points.order = {2, 0, 1, 3};
    CHECK(validate(points).ok());
    for (const std::vector<Index>& wrong :
         {std::vector<Index>{0, 1, 2}, {0, 1, 2, 2}, {0, 1, 2, 4}, {0, 1, 2, 3, 0}}) {
        points.order = wrong;
        CHECK_FALSE(validate(points).ok());
    }
}

TEST_CASE("validate: points in lists need a finite position and a unit normal") {
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {inf, -inf, nan}) {
        PointSet points = makeSquare();
        points.position[2].y = bad;
        CHECK(flawOf(points) == "point 2 is in a neighbor list, but its position is not finite");
    }
    for (const double bad : {inf, nan, 0.0, -0.9, 1.0 + 2e-6}) {
        PointSet points = makeSquare();
        points.normal[3].z = bad;
        CHECK(flawOf(points) ==
              "point 3 is in a neighbor list, but its normal is not of unit length");
    }
    PointSet points = makeSquare();
    points.normal[3].z = 1.0 + 5e-7;
    CHECK(validate(points).ok());
}

TEST_CASE("validate: a point outside all lists may hold anything") {
    PointSet points = makeSquare();
    points.position.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    points.normal.emplace_back(0, 0, 0);
    points.type.push_back(kInterior);
    points.neighbors.append({});
    CHECK(validate(points).ok());
    points.neighbors.ids[0] = 4;
    CHECK(flawOf(points) == "point 4 is in a neighbor list, but its position is not finite");
}

TEST_CASE("Type bits: corners have two faces, and the corner bit follows from them") {
    CHECK_FALSE(isBoundary(kCorner));
    CHECK(isBoundary(kNegativeZ));
    CHECK_FALSE(isCorner(kPositiveX));
    CHECK(isCorner(kPositiveX | kNegativeY));
    CHECK(shareFace(kPositiveX | kPositiveY, kPositiveY));
    CHECK_FALSE(shareFace(kPositiveX | kCorner, kNegativeX | kCorner));
    CHECK(withCornerBit(kPositiveX | kPositiveY) == (kPositiveX | kPositiveY | kCorner));
    CHECK(withCornerBit(kPositiveX | kCorner | 128) == kPositiveX);
    CHECK(withCornerBit(kCorner) == kInterior);
}

TEST_CASE("validate: the gap of a rim point has two other points as ends") {
    PointSet points = makeSquare();
    points.rim.assign(4, RimGap{});
    points.rim[1] = {0, 2};
    CHECK(validate(points).ok());
    for (const RimGap& wrong : {RimGap{1, 2}, RimGap{0, 1}, RimGap{0, 4}, RimGap{4, 0}}) {
        points.rim[1] = wrong;
        CHECK(flawOf(points) == "the gap of point 1 has an end that is no other point");
    }
    points.rim.resize(3);
    CHECK_FALSE(validate(points).ok());
}

TEST_CASE("validate: marks of points are for all of them, or for none") {
    PointSet points = makeSquare();
    points.aside.assign(4, Aside::No);
    CHECK(validate(points).ok());
    points.aside.pop_back();
    CHECK(flawOf(points) == "there are 4 positions, but 3 marks of points set aside");
}
