#include "spec_json.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "teach/json_text.h"

namespace se::teach {
namespace {

using SpecJson = nlohmann::json;

// ---- options ----

std::optional<std::string> numberTextOf(const SpecJson& value) {
    if (!value.is_number()) return std::nullopt;
    if (value.is_number_integer()) return value.dump();
    return plainNumber(value.get<double>());
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
        std::string entry = key;
        if (isObject) entry.append(".").append(name);
        const Status read = readValue(field, entry, each, spec, isObject ? name + "=" : "");
        if (!read) return read;
    }
    return success();
}

// ---- starts ----

/// A list of `count` points.
std::vector<Index> pointsOf(const JsonEntry& entry, std::string_view expected, std::size_t count) {
    std::vector<Index> points = entry.points(expected);
    if (points.size() != count) entry.fail(expected);
    return points;
}

void readTriangles(const JsonEntry& entry, GivenStart& start) {
    for (const JsonEntry& each : entry.items("a list of triangles")) {
        const std::vector<Index> p = pointsOf(each, "a triangle, such as [0, 1, 2]", 3);
        start.triangles.push_back({p[0], p[1], p[2]});
    }
}
void readRings(const JsonEntry& entry, GivenStart& start) {
    for (const JsonEntry& each : entry.items("a list of rings"))
        start.rings.push_back(each.points("a ring, such as [0, 1, 2, 3]"));
}
void readDone(const JsonEntry& entry, GivenStart& start) {
    start.done = entry.points("a list of points");
}
void readOpen(const JsonEntry& entry, GivenStart& start) {
    for (const JsonEntry& each : entry.items("a list of steps")) {
        const std::vector<Index> p = pointsOf(each, "a step of a ring, such as [0, 1]", 2);
        start.open.push_back({p[0], p[1]});
    }
}

/// An entry of the file.
struct StartKey {
    std::string_view name;
    void (*read)(const JsonEntry&, GivenStart&);
};
constexpr std::array kStartKeys{StartKey{"triangles", readTriangles}, StartKey{"rings", readRings},
                                StartKey{"done", readDone}, StartKey{"open", readOpen}};

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

Result<GivenStart> startFromText(std::string_view text, const std::string& name) {
    const Result<SpecJson> read = jsonFromText<SpecJson>(text, name);
    if (!read) return read.error();
    GivenStart start;
    try {
        const JsonEntry root(read.value(), name);
        if (!root.json().is_object()) root.fail("an object with triangles and rings");
        for (const auto& [key, value] : root.json().items()) {
            const StartKey* row = findNamed(kStartKeys, key);
            if (row == nullptr)
                return Error{name + ": " + inQuotes(key) +
                             ": no such entry; expected triangles, rings, done or open"};
            row->read({value, name, key}, start);
        }
    } catch (const Error& fault) {
        return fault;
    }
    if (start.empty())
        return Error{name + ": expected triangles, rings or done points, there are none"};
    return start;
}

Result<GivenStart> readStartFile(const std::string& path) {
    const Result<std::string> bytes = readBytes(path, kTextLimit);
    return bytes ? startFromText(bytes.value(), path) : Result<GivenStart>(bytes.error());
}

}  // namespace se::teach
