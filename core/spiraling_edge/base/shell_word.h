/// Quoting of names for a command line.
#pragma once

#include <string>
#include <string_view>

namespace se {

/// `word` as one word of a POSIX shell, in single quotes where a shell would read it differently.
/// Nothing in it is expanded or run, line breaks included.
std::string shellQuoted(std::string_view word);

/// `text` on one line, for display or a comment: control characters as "\n" or "\x1b", and the
/// backslash doubled. Other bytes stay as they are.
std::string oneLine(std::string_view text);

}  // namespace se
