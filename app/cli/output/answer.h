/// Answers of verbs, as text and as JSON.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "output.h"
#include "teach/json_text.h"

/// A point or a vector as a list of three numbers.
template <>
struct nlohmann::adl_serializer<se::Vec3> {
    template <typename Json>
    static void to_json(Json& json, const se::Vec3& v) {
        json = {v.x, v.y, v.z};
    }
};

namespace se::cli {

using Json = nlohmann::ordered_json;

/// Both forms of an answer, filled side by side: each fact is looked up and listed once.
struct Answer {
    std::string text = {};
    Json json = {};

    /// Adds "  label      sentence" to the text, unless the sentence is empty.
    void line(std::string_view label, const std::string& sentence) {
        if (!sentence.empty()) text += fmt::format("  {:<10} {}\n", label, sentence);
    }
};

/// A value in JSON; null for an empty text or list.
template <typename Value>
Json orNull(const Value& value) {
    return value.empty() ? Json() : Json(value);
}

/// Prints one of the forms. Throws Failure(Internal).
inline void print(const Answer& answer, bool asJson) {
    printText(asJson ? teach::jsonText(answer.json) : answer.text);
}

}  // namespace se::cli
