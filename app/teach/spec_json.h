/// The options of a session: the reader of what optionsJson() writes (spec_fields.h).
#pragma once

#include <nlohmann/json.hpp>

#include "spiraling_edge/spec/spec_fields.h"

namespace se::teach {

/// Sets what an object has under the keys of the table, and "start"; other keys are passed over.
/// Fails with `"options.radius": expected a number > 0` for the first value that is wrong.
Status readOptions(const nlohmann::json& options, RunSpec& spec);

}  // namespace se::teach
