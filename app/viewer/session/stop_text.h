/// Breakpoints and watches as a session file has them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/replay/breakpoint.h"

namespace se::view {

/// Reads them from the object of a session. What is wrong, if something is. A line that is not
/// understood is kept as it is: the panel says so.
std::optional<std::string> readStops(const nlohmann::json& object,
                                     std::vector<Breakpoint>& breakpoints,
                                     std::vector<std::string>& watches);
void stopsToJson(const std::vector<Breakpoint>& breakpoints,
                 const std::vector<std::string>& watches, nlohmann::json& object);

}  // namespace se::view
