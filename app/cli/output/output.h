/// What verbs write: answers, as text and as JSON, results, into a file or, for `-`, to standard
/// output, and on a terminal a line of progress. Ctrl+C needs nothing here: it ends the program at
/// once (atomic_file.h).
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exit_code.h"
#include "options/spec_options.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/io/write_mesh.h"
#include "teach/json_text.h"

/// A point or a vector as a list of three numbers.
template <>
struct nlohmann::adl_serializer<se::Vec3> {
    template <typename Json>
    static void to_json(Json& json, const se::Vec3& v) {  // NOLINT(readability-identifier-naming)
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

/// The options --json and --quiet of a verb.
struct AnswerOptions {
    bool json = false;
    bool quiet = false;

    void addAnswerOptions(CLI::App& app, const std::string& jsonHelp,
                          const std::string& quietHelp) {
        app.add_flag("--json", json, jsonHelp);
        app.add_flag("-q,--quiet", quiet, quietHelp);
    }
};

/// Prints one of the forms. Throws Failure(Internal).
void print(const Answer& answer, bool asJson);

/// Name of an input in messages: "standard input" for -.
std::string nameOfInput(const std::string& input);

/// Writes to stderr if that is a terminal, at most ten times a second, and erases the line at the
/// end.
class ProgressLine {
  public:
    /// Never writes anything if not `wanted`.
    explicit ProgressLine(bool wanted);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// False if the user wants no messages.
    bool isWanted() const { return wanted_; }
    /// True if it is time to write again; cheap enough for inner loops.
    bool due();
    /// Writes "what 42 %"; `share` is in [0, 1]. Call when due().
    void write(const std::string& what, double share);
    void clear();

  private:
    bool wanted_;
    bool enabled_;
    bool dirty_ = false;
    std::chrono::steady_clock::time_point last_;
};

/// Runs `work`, which takes a Progress and returns a Result, while the progress line shows `what`
/// and the share done. Throws Failure if it fails; `input` begins the message.
template <typename Work>
auto runWithProgress(const std::string& what, const std::string& input, ProgressLine& line,
                     Work&& work) {
    auto result = work([&](double share) {
        if (line.due()) line.write(what, share);
        return true;
    });
    line.clear();
    return require(std::move(result), ExitCode::Input, nameOfInput(input) + ": ");
}

}  // namespace se::cli
