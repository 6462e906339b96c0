/// Names as words of a command line.
#pragma once

#include <string>
#include <string_view>

namespace se {

/// As one word of a POSIX shell: between single quotes if a shell would read it otherwise. Nothing
/// in it is expanded or run, line breaks included.
std::string shellQuoted(std::string_view word);

/// On one line, to be shown or to stand in a comment: control characters as "\n" or "\x1b", and the
/// backslash doubled. Other bytes stay as they are.
std::string oneLine(std::string_view text);

}  // namespace se
