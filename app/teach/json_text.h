/// JSON as text: read within limits from files that anybody may have written, and written so that
/// it can be shown.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/result.h"

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

/// A value in a message, cut after 80 characters.
template <typename Json>
std::string jsonExcerpt(const Json& value) {
    return excerpt(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace se::teach
