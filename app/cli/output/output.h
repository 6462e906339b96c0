/// Where results go: a file or `-`, standard output.
#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>
#include <string_view>

namespace se::cli {

/// An option that names a file to write, or `-`. An empty name is wrong usage.
CLI::Option* addOutputOption(CLI::App& app, const std::string& names, std::string& path,
                             const std::string& help);

/// A file to write and the option that names it.
struct OutputPath {
    std::string_view option;
    const std::string& path;  ///< Empty if the option was not given.
};

/// Fails early, before long work, if one of them cannot be written, or if two are the same file or
/// both standard output. Throws Failure(Usage).
void requireWritable(std::initializer_list<OutputPath> outputs);

/// Fails if one of them is the file `input`, which would be lost. Throws Failure(Usage).
void requireOtherThan(const std::string& input, std::initializer_list<OutputPath> outputs);

/// Writes all of it, to a file by way of a temporary one. Throws Failure(Internal).
void writeOutput(const std::string& path, std::string_view bytes);

}  // namespace se::cli
