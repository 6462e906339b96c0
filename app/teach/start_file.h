/// The state that a run begins with as JSON: --start FILE.json, options.start of a session
/// (docs/file-formats.md).
#pragma once

#include <string>
#include <string_view>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se::teach {

/// Reads a start. Fails with `name`, the entry that is wrong and what was expected there.
Result<GivenStart> startFromText(std::string_view text, const std::string& name);
/// As startFromText(), of a file.
Result<GivenStart> readStartFile(const std::string& path);

}  // namespace se::teach
