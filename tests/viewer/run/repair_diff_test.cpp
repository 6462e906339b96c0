#include "run/repair_diff.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;

TEST_CASE("Repair: a flip removes one edge, makes one, and keeps four") {
    const std::vector<Triangle> gone = {{0, 1, 2}, {1, 0, 3}};
    const std::vector<Triangle> made = {{0, 3, 2}, {3, 1, 2}};
    const MeshEdges edges = edgesOf(gone, made);
    CHECK(edges.gone == std::vector<MeshEdge>{{0, 1}});
    CHECK(edges.made == std::vector<MeshEdge>{{2, 3}});
    CHECK(edges.kept.size() == 4);
}

TEST_CASE("Repair: a point in a triangle makes three edges, on an edge four, at a border two") {
    const std::vector<Triangle> one = {{0, 1, 2}};
    const MeshEdges inside =
        edgesOf(one, std::vector<Triangle>{{0, 1, 9}, {1, 2, 9}, {2, 0, 9}}, 9);
    CHECK(inside.made.size() == 3);
    CHECK(inside.gone.empty());
    const std::vector<Triangle> two = {{0, 1, 2}, {1, 0, 3}};
    const MeshEdges across =
        edgesOf(two, std::vector<Triangle>{{1, 2, 9}, {2, 0, 9}, {0, 3, 9}, {3, 1, 9}}, 9);
    CHECK(across.made.size() == 4);
    CHECK(across.gone == std::vector<MeshEdge>{{0, 1}});
    const MeshEdges beside = edgesOf({}, std::vector<Triangle>{{1, 0, 9}}, 9);
    CHECK(beside.made.size() == 2);
    CHECK(beside.kept == std::vector<MeshEdge>{{0, 1}});
}

TEST_CASE(
    "Repair: the change to another mesh has what goes, what comes and what turns, by region") {
    std::vector<Vec3> position(12);
    for (std::size_t p = 0; p < position.size(); ++p) position[p] = {double(p), double(p % 3), 0.0};
    // A flip, a triangle that turns, and one that stays.
    const std::vector<Triangle> before = {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}, {8, 9, 10}};
    const std::vector<Triangle> after = {{0, 3, 2}, {3, 1, 2}, {5, 4, 6}, {10, 8, 9}};
    const MeshChange change = changeOf(position, before, after);
    CHECK(*change.gone == std::vector<Triangle>{{0, 1, 2}, {1, 0, 3}, {4, 5, 6}});
    CHECK(*change.made == std::vector<Triangle>{{0, 3, 2}, {3, 1, 2}, {5, 4, 6}});
    CHECK(change.edges.gone == std::vector<MeshEdge>{{0, 1}});
    CHECK(wordsOf(change) ==
          std::array<std::string, 2>{"2 of 4 triangles go", "2 come, 1 turn, in 2 regions"});
    CHECK(wordsOf(changeOf(position, {}, std::vector<Triangle>{{0, 1, 2}})) ==
          std::array<std::string, 2>{"0 of 0 triangles go", "1 come, in 1 region"});
}

TEST_CASE("Repair: triangles keep their component after flips and points that were put in") {
    // Two components of two triangles each; the second shares point 3 with the first.
    const std::vector<Triangle> emitted = {{0, 1, 2}, {2, 1, 3}, {3, 4, 5}, {5, 4, 6}};
    const std::vector<std::size_t> starts = {0, 2};
    CHECK(componentsOf(emitted, emitted, starts, 8) ==
          std::vector<ComponentStretch>{{0, 0}, {2, 1}});
    // An edge of each flipped; point 7 put into a triangle of the first, at the end of the list.
    const std::vector<Triangle> repaired = {{0, 1, 3}, {0, 3, 2}, {3, 4, 6},
                                            {3, 6, 5}, {0, 1, 7}, {7, 1, 3}};
    CHECK(componentsOf(repaired, emitted, starts, 8) ==
          std::vector<ComponentStretch>{{0, 0}, {2, 1}, {4, 0}});
}
