/// Text from outside, made fit to be shown: names of files, properties and keys, texts of lessons
/// and sessions, environment variables. A terminal obeys control characters in it, and marks of
/// the direction of writing make it look like another text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace se {

/// Number of bytes of the UTF-8 character at the start of `text`; 0 if it is none. `text` must not
/// be empty.
std::size_t utf8Length(std::string_view text);

/// `text` on one line that a terminal only shows: newline and tab as "\n" and "\t"; the bytes of
/// other control characters (C0, C1, DEL), of marks of direction (U+202E) and of what is no UTF-8
/// as "\x1b". All else stays, the backslash as well, so that commands can still be copied, and
/// applying it twice changes nothing.
std::string printable(std::string_view text);
/// As printable(), for a text of several lines: newlines stay.
std::string printableLines(std::string_view text);

/// A JSON document in which the characters that printable() replaces, newlines between values
/// apart, are "\u009b": the value of the document stays.
std::string printableJson(std::string_view json);

/// `text` for a message: as printable(), cut after 80 characters.
std::string excerpt(std::string_view text);
/// excerpt() in quotes.
std::string inQuotes(std::string_view field);

}  // namespace se
