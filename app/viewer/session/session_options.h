/// The parts of a session file that are read by themselves: the options for preparing and running
/// its input, and its breakpoints and watches.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "annotations.h"
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

/// Reads a field, text or true and false, if it is present. False: it has another type.
template <typename Value>
bool readField(const nlohmann::json& object, const char* name, Value& out) {
    const nlohmann::json* field = find(object, name);
    if (field == nullptr) return true;
    const bool fits = std::is_same_v<Value, bool> ? field->is_boolean() : field->is_string();
    if (fits) out = field->get<Value>();
    return fits;
}

/// Writes a field; if it is not `given`, an older one is removed.
template <typename Value>
void writeField(nlohmann::json& object, const char* name, bool given, const Value& value) {
    object.erase(name);
    if (given) object[name] = value;
}

/// Reads "options" of a session file.
Complaint readOptions(const nlohmann::json& object, InputSpec& out);
/// Options as JSON, with the unknown fields of `options` kept.
nlohmann::json optionsToJson(const InputSpec& input, nlohmann::json options);

/// Reads breakpoints and watches from the object of a session. A line that is not understood is
/// kept unchanged; the panel reports it.
Complaint readStops(const nlohmann::json& object, Annotations& out);
void stopsToJson(const Annotations& annotations, nlohmann::json& object);

}  // namespace se::view
