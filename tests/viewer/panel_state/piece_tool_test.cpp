#include "panel_state/view_tools.h"

#include <doctest/doctest.h>

using namespace se::view;

TEST_CASE("A dragged box has four corners, one without an area encloses nothing") {
    EnclosingLine tool;
    tool.begin({10, 20}, PieceShape::Box);
    tool.moveTo({50, 30}, 4.0F);
    tool.moveTo({40, 80}, 4.0F);
    CHECK(tool.path.size() == 2);
    CHECK(tool.finish() == std::vector<glm::vec2>{{10, 20}, {40, 20}, {40, 80}, {10, 80}});
    CHECK_FALSE(tool.drawing);
    CHECK(tool.path.empty());
    tool.begin({10, 20}, PieceShape::Box);
    CHECK(tool.finish().empty());
}

TEST_CASE("A lasso has corners at least a step apart, and needs three") {
    EnclosingLine tool;
    tool.begin({0, 0}, PieceShape::Lasso);
    tool.moveTo({1, 0}, 4.0F);
    CHECK(tool.finish().empty());
    tool.begin({0, 0}, PieceShape::Lasso);
    tool.moveTo({10, 0}, 4.0F);
    tool.moveTo({10, 2}, 4.0F);
    tool.moveTo({10, 9}, 4.0F);
    CHECK(tool.finish() == std::vector<glm::vec2>{{0, 0}, {10, 0}, {10, 9}});
}
