/// Built-in inputs, shared by the viewer, the command line and the tests. One table, filled
/// explicitly: a new scene is one function and one row.
#pragma once

#include <span>
#include <string_view>

#include "spiraling_edge/io.h"

namespace se {

/// A named input that needs no file.
struct Scene {
    std::string_view id;     ///< As on the command line: `scene:torus`.
    std::string_view title;  ///< For people.
    std::string_view watch;  ///< One sentence: what to look at.
    PointFile (*build)();    ///< Makes the points; equal on every machine.
};

/// All scenes, the default first.
std::span<const Scene> scenes();
/// Null if there is none of that id.
const Scene* findScene(std::string_view id);

}  // namespace se
