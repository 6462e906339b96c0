/// Inputs with the traces of this program, for the test of another implementation: together they
/// show every switch of the paper's rules.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/points/shared_points.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se::teach {

/// An input that shows some rules. A new one is a row in conformance.cpp.
struct ConformanceInput {
    std::string_view name;  ///< Of its files: "figure-8".
    std::string_view shows;
    std::function<PointFile()> build;
    GivenStart (*start)() = nullptr;  ///< Null: nothing is made yet.
};

/// The figures of the paper that have a scene, then inputs for the rules that no figure shows.
const std::vector<ConformanceInput>& conformanceInputs();

/// An input as its run gets it.
struct ConformanceCase {
    /// With the normals, types and neighbor lists of `points`; with its own lists if `opposing`
    /// leaves out some of them.
    PointFile file;
    SharedPoints points;
    GivenStart start;
};
ConformanceCase conformanceCase(const ConformanceInput& input);

/// The trace of a run under the set `paper`, with all stages.
std::string conformanceTrace(const ConformanceCase& input);

}  // namespace se::teach
