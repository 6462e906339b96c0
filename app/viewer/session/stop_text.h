/// Breakpoints and watches in a session file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/replay/breakpoint.h"

namespace se::view {

/// Reads them from the object of a session. Returns the problem, if any. A line that is not
/// understood is kept unchanged; the panel reports it.
std::optional<std::string> readStops(const nlohmann::json& object,
                                     std::vector<Breakpoint>& breakpoints,
                                     std::vector<std::string>& watches);
void stopsToJson(const std::vector<Breakpoint>& breakpoints,
                 const std::vector<std::string>& watches, nlohmann::json& object);

}  // namespace se::view
