/// Destinations of results: a file, or `-` for standard output.
#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>
#include <string_view>

namespace se::cli {

/// Adds an option that names a file to write, or `-`. An empty name is wrong usage.
CLI::Option* addOutputOption(CLI::App& app, const std::string& names, std::string& path,
                             const std::string& help);

/// A file to write and the option that named it.
struct OutputPath {
    std::string_view option;
    const std::string& path;  ///< Empty if the option was not given.
};

/// Fails early, before long work, if one of them cannot be written, or if two are the same file or
/// both standard output. Throws Failure(Usage).
void requireWritable(std::initializer_list<OutputPath> outputs);

/// Fails if one of the files is `input`, which would be overwritten. Throws Failure(Usage).
void requireOtherThan(const std::string& input, std::initializer_list<OutputPath> outputs);

/// Writes all of `bytes` as they are, to a file through a temporary one. Throws Failure(Internal).
void writeOutput(const std::string& path, std::string_view bytes);

/// Prints text on standard output as printableLines(), which leaves JSON of jsonText() as it is.
/// Names in it that may hold newlines need printable(). Throws Failure(Internal).
void printText(std::string_view text);
/// Prints text on standard error as printableLines().
void printNote(std::string_view text);

}  // namespace se::cli
