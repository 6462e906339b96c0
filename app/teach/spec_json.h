/// The options of a session, and the state that a run begins with (--start FILE.json), in JSON: the
/// readers of what optionsJson() and startJson() write (spec_fields.h).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "spiraling_edge/spec/spec_fields.h"

namespace se::teach {

/// Sets what an object has under the keys of the table, and "start"; other keys are passed over.
/// Fails with `"options.radius": expected a number > 0` for the first value that is wrong.
Status readOptions(const nlohmann::json& options, RunSpec& spec);

/// Reads a start. Fails with `name`, the entry that is wrong and what was expected there.
Result<GivenStart> startFromText(std::string_view text, const std::string& name);
/// As startFromText(), of a file.
Result<GivenStart> readStartFile(const std::string& path);

}  // namespace se::teach
