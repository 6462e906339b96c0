#include "spec_json.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "spiraling_edge/base/number_text.h"
#include "start_file.h"

namespace se::teach {
namespace {

using SpecJson = nlohmann::json;

std::optional<std::string> numberTextOf(const SpecJson& value) {
    if (!value.is_number()) return std::nullopt;
    if (value.is_number_integer()) return value.dump();
    std::string text;
    appendPlainNumber(text, value.get<double>());
    return text;
}

/// A value as the text of an option; nothing if it has another type than the field.
std::optional<std::string> textOf(SpecType type, const SpecJson& value) {
    const bool isNumbers = type == SpecType::Numbers;
    if (value.is_string() && (isNumbers || type == SpecType::Word || type == SpecType::Rule))
        return value.get<std::string>();
    if (value.is_boolean() && (type == SpecType::Switch || type == SpecType::Rule))
        return value.get<bool>() ? "on" : "off";
    if (isNumbers && value.is_array()) {
        std::string list;
        for (const SpecJson& each : value) {
            const auto number = numberTextOf(each);
            if (!number) return std::nullopt;
            list += (list.empty() ? "" : ",") + *number;
        }
        return list;
    }
    const bool isNumber =
        type == SpecType::Whole || type == SpecType::Number || type == SpecType::Rule;
    return isNumber ? numberTextOf(value) : std::nullopt;
}

Error faultOf(const std::string& key, const std::string& message) {
    return Error{"\"options." + key + "\": " + message};
}

Status readValue(const SpecField& field, const std::string& key, const SpecJson& value,
                 RunSpec& spec, const std::string& prefix = {}) {
    const auto text = textOf(field.type, value);
    if (!text) return faultOf(key, "expected " + std::string(field.expected));
    const Status set = setField(field, spec, prefix + *text);
    return set ? success() : Status(faultOf(key, set.error().message));
}

Status readField(const SpecField& field, const SpecJson& value, RunSpec& spec) {
    const std::string key(field.key);
    if (!field.repeats) return readValue(field, key, value, spec);
    const bool isObject = field.type == SpecType::Rule;
    if (isObject ? !value.is_object() : !value.is_array())
        return faultOf(key, "expected " + std::string(field.expected));
    for (const auto& [name, each] : value.items()) {
        const Status read = isObject ? readValue(field, key + "." + name, each, spec, name + "=")
                                     : readValue(field, key, each, spec);
        if (!read) return read;
    }
    return success();
}

}  // namespace

Status readOptions(const SpecJson& options, RunSpec& spec) {
    for (const SpecField& field : specFields()) {
        const auto found = options.find(std::string(field.key));
        // Of fields with several options the first stands for the key.
        if (found == options.end() || findSpecField(field.key) != &field) continue;
        if (const Status read = readField(field, *found, spec); !read) return read;
    }
    const auto start = options.find("start");
    if (start == options.end()) return success();
    Result<GivenStart> read = startFromText(start->dump(), "\"options.start\"");
    if (!read) return read.error();
    spec.start = std::move(read.value());
    return success();
}

}  // namespace se::teach
