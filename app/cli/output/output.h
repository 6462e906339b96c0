/// Destinations of results: a file, or `-` for standard output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "options/spec_options.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::cli {

/// Adds an option that names a file to write, or `-`. An empty name is wrong usage.
CLI::Option* addOutputOption(CLI::App& app, const std::string& names, const std::string& value,
                             std::string& path, const std::string& help);

/// Files of a command; those with an empty path, of options that were not given, are ignored.
using NamedFiles = std::vector<NamedFile>;

/// The option --force.
class ForceOption {
  public:
    /// `also`: what else it permits this verb, the rest of a sentence.
    void addTo(CLI::App& app, const std::string& also = "");
    bool given() const { return given_; }

    /// Fails early, before long work, if an output cannot be written, if two are the same file or
    /// both standard output, or, without the option, if one would replace an input. Throws
    /// Failure(Usage).
    void require(NamedFiles inputs, NamedFiles outputs) const;

  private:
    bool given_ = false;
};

/// Writes all of `bytes` as they are, to a file through a temporary one. Throws Failure(Internal).
void writeOutput(const std::string& path, std::string_view bytes);

/// Throws Failure(Usage) if -o is standard output, and that is a terminal.
void requireNoTerminal(const std::string& output);
/// Writes a mesh, or points alone, by the extension; to standard output as PLY. Throws
/// Failure(Internal).
void writeMeshOutput(const std::string& path, const PointFile& file,
                     std::span<const Triangle> triangles, const WriteOptions& options = {});

/// Prints text on standard output as printableLines(), which leaves JSON of jsonText() as it is.
/// Names in it that may hold newlines need printable(). Throws Failure(Internal).
void printText(std::string_view text);
/// Prints text on standard error as printableLines().
void printNote(std::string_view text);

}  // namespace se::cli
