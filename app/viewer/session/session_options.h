/// The part of a session file that says how its input is prepared and run.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "run/model.h"

namespace se::view {

/// What is wrong with a part of the file; nothing if all is well.
using Complaint = std::optional<std::string>;

inline Complaint expected(const std::string& field, const std::string& what) {
    return "\"" + field + "\": expected " + what;
}

inline const nlohmann::json* find(const nlohmann::json& object, const char* name) {
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
}

/// Reads "options" of a session file.
Complaint readOptions(const nlohmann::json& object, InputSpec& out);
/// With what was there before and is not known here.
nlohmann::json optionsToJson(const InputSpec& input, nlohmann::json options);

}  // namespace se::view
