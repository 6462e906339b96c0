/// Content of the start page for the built-in scenes: small pictures made of their points.
#pragma once

#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "spiraling_edge/scenes/scenes.h"

namespace se::view {

/// A point of a small picture.
struct ThumbnailDot {
    glm::vec2 at{0.0F};   ///< In the square from -1 to 1, y up.
    float facing = 0.0F;  ///< 1: faces the viewer; 0 or less: its back side is visible.
};

/// A scene as listed on the page.
struct SceneTile {
    std::string_view id;
    std::string_view title;
    std::string_view watch;
    std::vector<ThumbnailDot> dots;  ///< Those at the back first.
    glm::vec2 reach{1.0F};           ///< Half the width and height that they take.
};

/// The picture of some points, of at most `most` of them.
std::vector<ThumbnailDot> thumbnail(const PointFile& points, std::size_t limit);

/// Made on first use.
struct StartPage {
    std::vector<SceneTile> tiles;

    void prepare();
};

}  // namespace se::view
