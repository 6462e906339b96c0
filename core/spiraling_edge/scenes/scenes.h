/// Built-in inputs, shared by the viewer, the command line and the tests. One table, filled
/// explicitly: a new scene is one function and one row.
#pragma once

#include <span>
#include <string_view>

#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se {

/// A named input that needs no file.
struct Scene {
    std::string_view id;     ///< As on the command line: `scene:torus`.
    std::string_view title;  ///< For display.
    std::string_view watch;  ///< One sentence about the points of interest.
    PointFile (*build)();    ///< Makes the points; equal on every machine.
    /// Address of the decision that it shows, with the set `paper`; empty: the start of the run.
    std::string_view address = {};
    /// The state that its run begins with (Params::start); null: nothing is made yet.
    GivenStart (*start)() = nullptr;
};

/// A scene that fails, and why.
struct FailureScene {
    Scene scene;
    std::string_view failure;  ///< Class of the failure, as in inspection.h, under the set `paper`.
    std::string_view address;  ///< Address of the decision that causes it.
    std::string_view section;  ///< Section of the paper that predicts it.
    std::string_view sentence;  ///< The paper's sentence there.
    std::string_view helps;     ///< Advice for the user.
};

/// The failure gallery.
std::span<const FailureScene> failureScenes();

/// All scenes that work, the default first; those of the figures of the paper (figures.h) last.
std::span<const Scene> scenes();
/// The scene of that id in either table; null if there is none.
const Scene* findScene(std::string_view id);
/// The address of the decision that a scene of either table shows; empty if it shows the whole run,
/// or if there is no scene of that id.
std::string_view addressOfScene(std::string_view id);
/// The state that the run of a scene begins with, for Params::start; empty if it begins as usual,
/// or if there is no scene of that id. Every program that opens a scene has to set it.
GivenStart startOfScene(std::string_view id);

}  // namespace se
