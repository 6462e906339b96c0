/// The part of a session file with the options for preparing and running its input.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "run/model.h"

namespace se::view {

/// Problem of a part of the file; empty if there is none.
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
/// Options as JSON, with the unknown fields of `options` kept.
nlohmann::json optionsToJson(const InputSpec& input, nlohmann::json options);

}  // namespace se::view
