#include "spiraling_edge/mesh/edge_table.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "support/oracles.h"

using namespace se;
using namespace se::test;

TEST_CASE("edge table: a triangle has three sides, each in one direction") {
    EdgeTable table(5);
    table.add({1, 4, 2});
    CHECK(table.has(1, 4));
    CHECK(table.has(4, 2));
    CHECK(table.has(2, 1));
    CHECK_FALSE(table.has(4, 1));
    CHECK_FALSE(table.has(0, 1));
    CHECK_FALSE(table.has(1, 3));
}

TEST_CASE("edge table: a side names its triangle and the corner opposite to it") {
    EdgeTable table(6);
    table.add({0, 1, 2});
    table.add({1, 0, 3});
    CHECK(table.find(0, 1) == 0);
    CHECK(table.find(1, 0) == 3);
    CHECK(table.opposite(table.find(0, 1)) == 2);
    CHECK(table.opposite(table.find(1, 2)) == 0);
    CHECK(table.opposite(table.find(2, 0)) == 1);
    CHECK(table.opposite(table.find(1, 0)) == 3);
    CHECK(table.opposite(table.find(0, 3)) == 1);
    CHECK(table.opposite(table.find(3, 1)) == 0);
    CHECK(table.find(2, 3) == kNone);
}

TEST_CASE("edge table: of a side that two triangles have, the newer one is found") {
    EdgeTable table(4);
    table.add({0, 1, 2});
    table.add({0, 1, 3});
    CHECK(table.find(0, 1) / 3 == 1);
    CHECK(table.opposite(table.find(0, 1)) == 3);
}

TEST_CASE("edge table: without points it is empty, with points it is not") {
    CHECK(EdgeTable().empty());
    CHECK_FALSE(EdgeTable(1).empty());
}

TEST_CASE("edge table: finds what a map finds, on random triangles") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        const std::size_t count = 4 + random.below(30);
        EdgeTable table(count);
        std::map<std::pair<Index, Index>, std::set<Index>> expected;  // Side to opposite corners.
        for (int i = 0; i < 60; ++i) {
            const auto any = [&] { return static_cast<Index>(random.below(count)); };
            const Triangle t{any(), any(), any()};
            if (t.a == t.b || t.b == t.c || t.c == t.a) continue;
            table.add(t);
            expected[{t.a, t.b}].insert(t.c);
            expected[{t.b, t.c}].insert(t.a);
            expected[{t.c, t.a}].insert(t.b);
        }
        bool agrees = true;
        for (Index u = 0; u < count; ++u) {
            std::map<std::pair<Index, Index>, std::set<Index>> leaving;
            for (HalfEdge h = table.firstFrom(u); h != kNone; h = table.nextFrom(h)) {
                leaving[{u, table.target(h)}].insert(table.opposite(h));
            }
            for (Index v = 0; v < count; ++v) {
                const auto found = expected.find({u, v});
                agrees = agrees && table.has(u, v) == (found != expected.end());
                if (found == expected.end()) continue;
                agrees = agrees && leaving[{u, v}] == found->second;
                agrees = agrees && found->second.contains(table.opposite(table.find(u, v)));
            }
        }
        CHECK_MESSAGE(agrees, "seed ", seed);
    }
}

TEST_CASE("edge table: gone back and forward, it finds what a table of those triangles finds") {
    Random random(7);
    constexpr std::size_t kPoints = 9;
    const auto any = [&] { return static_cast<Index>(random.below(kPoints)); };
    std::vector<Triangle> triangles;
    EdgeTable table(kPoints);
    for (int i = 0; i < 300; ++i) {
        // To an earlier or later place; then the same triangle again, or another one.
        const std::size_t place = random.below(triangles.size() + 1);
        table.moveTo(place);
        const bool again = place < triangles.size() && random.below(2) == 0;
        const Triangle t = again ? triangles[place] : Triangle{any(), any(), any()};
        table.add(t);
        const bool same = place < triangles.size() && triangles[place] == t;
        if (!same) triangles.resize(place, {});
        if (!same) triangles.push_back(t);
        EdgeTable fresh(kPoints);
        for (std::size_t k = 0; k <= place; ++k) fresh.add(triangles[k]);
        for (Index u = 0; u < kPoints; ++u) {
            CHECK(table.firstFrom(u) == fresh.firstFrom(u));
            for (Index v = 0; v < kPoints; ++v) CHECK(table.find(u, v) == fresh.find(u, v));
        }
    }
}
