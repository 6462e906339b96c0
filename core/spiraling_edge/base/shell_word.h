/// Quoting of names for a command line.
#pragma once

#include <string>
#include <string_view>

namespace se {

/// `word` as one word of a POSIX shell, on one line that printable() leaves as it is: in single
/// quotes where a shell would read it differently, by printf where it has signs that cannot be
/// shown. Nothing in it is expanded or run.
std::string shellQuoted(std::string_view word);

/// The path of a file as shellQuoted(), so that no program takes it for an option: -a.ply as
/// ./-a.ply. A lone - stays: standard input or output.
std::string shellPath(std::string_view path);

}  // namespace se
