/// JSON as text: read within limits from files that anybody may have written, and written so that
/// it can be shown.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/base/types.h"

namespace se::teach {

/// The most levels of lists and objects: deeper values would overflow the stack where they are
/// copied or written.
inline constexpr std::size_t kMaxJsonLevels = 64;

/// The first reason to refuse `text` unparsed, with its place: over kMaxJsonLevels, or a number
/// beyond the largest double. Empty if there is none. `line`: the number of its first line.
std::string jsonLimitFault(std::string_view text, std::size_t line = 1);
/// The place of `byte`, from 1, at which a parser stopped, and what stands there.
std::string jsonSyntaxFault(std::string_view text, std::size_t byte);

/// Parses JSON. Fails with `name`, the line and the column.
template <typename Json>
Result<Json> jsonFromText(std::string_view text, const std::string& name) {
    if (const std::string fault = jsonLimitFault(text); !fault.empty())
        return Error{name + ": " + fault};
    try {
        return Json::parse(text);
    } catch (const typename Json::parse_error& problem) {
        return Error{name + ": " + jsonSyntaxFault(text, problem.byte)};
    }
}

/// A document, indented, with a newline at its end. What is no UTF-8 in its texts becomes U+FFFD.
template <typename Json>
std::string jsonText(const Json& json) {
    return printableJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

/// A value of a JSON file. Its functions throw an Error if it is of another type than theirs; the
/// reader of the whole file catches it.
class JsonEntry {
  public:
    /// `file` begins messages; `path` leads to the value in it: "rings[1][3]".
    JsonEntry(const nlohmann::json& json, std::string file, std::string path = {})
        : json_(json), file_(std::move(file)), path_(std::move(path)) {}

    /// Throws an Error: file, path, what was expected and what is there.
    [[noreturn]] void fail(std::string_view expected) const;
    const nlohmann::json& json() const { return json_; }

    /// True if an object has that key.
    bool has(std::string_view key) const;
    /// The value of an object at a key; null if it is missing.
    JsonEntry at(std::string_view key) const;
    /// The values of a list.
    std::vector<JsonEntry> items(std::string_view expected) const;

    std::string text() const;
    /// A finite number from 0 on.
    double number() const;
    /// A whole number from 0 on.
    std::size_t count() const;
    bool truth() const;
    std::vector<std::string> texts() const;
    /// The number of a point below `count`; of any point if that is kNone.
    Index point(std::size_t count = kNone) const;
    std::vector<Index> points(std::string_view expected, std::size_t count = kNone) const;

  private:
    const nlohmann::json& json_;
    std::string file_;
    std::string path_;
};

}  // namespace se::teach
