/// Content of the start page for the built-in scenes: small pictures of their meshes, half grown,
/// or finished with the failure that they show.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/background_job.h"
#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::view {

/// A point of a small picture.
struct ThumbnailDot {
    glm::vec2 at{0.0F};   ///< In the square from -1 to 1, y up.
    float facing = 0.0F;  ///< 1: faces the viewer; 0 or less: its back side is visible.
};

/// A triangle of a small picture.
struct ThumbnailFace {
    std::array<glm::vec2, 3> at{};  ///< As ThumbnailDot::at.
    float facing = 0.0F;            ///< As ThumbnailDot::facing.
    bool failure = false;           ///< Part of the failure that the scene shows.
};

/// An edge or, with both ends equal, a point of the failure that a scene shows.
struct ThumbnailMark {
    glm::vec2 from{0.0F};
    glm::vec2 to{0.0F};
};

/// A lesson or a scene as listed on the page.
struct SceneTile {
    std::string_view id;  ///< Of a scene; of a lesson and of sampled points their source.
    std::string_view title;
    std::string_view watch;
    double minutes = 0.0;                ///< Length of a lesson; 0: of a scene.
    const Figure* figure = nullptr;      ///< Null if the tile shows none.
    std::vector<ThumbnailDot> dots{};    ///< Those at the back first.
    std::vector<ThumbnailFace> faces{};  ///< Those at the back first.
    std::vector<ThumbnailMark> marks{};
    glm::vec2 reach{1.0F};  ///< Half the width and height that they take.
};

/// The picture of some points, of at most `limit` of them, seen from `direction`.
std::vector<ThumbnailDot> thumbnail(const PointFile& points, std::size_t limit,
                                    const Vec3& direction);

/// Source of a tile: "scene:figure-8", "lesson:tour", "sample:hydrogen,n=1516".
std::string sourceOf(const SceneTile& tile);

/// Made on first use: lessons, figures of the paper, other scenes that work, and those that fail.
struct StartPage {
    std::vector<SceneTile> tiles;
    /// Pictures of sampled figures, which take a while.
    BackgroundJob<SceneTile> sampling;

    void prepare();
    /// Takes the pictures that have been made.
    void poll();
};

}  // namespace se::view
