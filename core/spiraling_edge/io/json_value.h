/// JSON in files of points (GLB): a tree of values that know their place, for errors.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"

namespace se::io {

/// A value of a JSON text.
struct JsonValue {
    enum class Kind : std::uint8_t { Missing, Null, Boolean, Number, Text, List, Object };

    Kind kind = Kind::Missing;
    std::size_t at = 0;              ///< Its first byte in the file.
    double number = 0.0;             ///< 1 for true.
    std::string text;                ///< Characters beyond ASCII by \u are "?".
    std::vector<std::string> names;  ///< Of the members of an object.
    std::vector<JsonValue> items;    ///< Members of an object, or values of a list.

    bool isThere() const { return kind != Kind::Missing; }
    bool isList() const { return kind == Kind::List; }
    /// The first member of that name; one that is missing for any other name or kind.
    const JsonValue& member(std::string_view name) const;
    /// The value at a place of a list; one that is missing beyond its end.
    const JsonValue& item(std::size_t i) const;
};

/// Parses a whole JSON text that begins at the byte `begin` of the file `name`: at most 64 levels
/// of lists and objects, 2,000,000 values, and no number beyond the largest double. Errors name the
/// byte.
Result<JsonValue> parseJson(std::string_view text, const std::string& name, std::size_t begin);

}  // namespace se::io
