/// The points of a verb: the options that say which they are and how they are prepared, their
/// reading, and their preparation; and surfaces to sample points on.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>

#include "output/output.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/points/wall_types.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/stepper/params.h"

namespace se::cli {

/// The spec of these values. Throws Failure(Usage) with the first that is not valid.
RunSpec specOf(const SpecChange& given, RunSpec spec = {});

/// Reads a file, `-` or scene:ID. Throws Failure(Input) if it is missing or malformed.
PointFile readInput(const std::string& input, const ByteLimit& limit);

/// Number of points whose types are so: isOnWall, isCorner, ...
std::size_t countOfType(const PointFile& file, bool (*isSo)(std::uint8_t type));

/// The points read from an input, and how many of it the options for a piece kept.
struct InputPiece {
    PointFile file;
    Piece piece;
    std::size_t kept = 0;
    std::size_t inFile = 0;
};
/// Reads the piece. Throws Failure(Input) if the input is missing or malformed, Failure(Usage) if
/// the box holds none of its points.
InputPiece readPiece(const RunSpec& spec);

/// The params of a spec. Throws Failure(Usage).
Params paramsFrom(const RunSpec& spec);
/// Its options of preparing. Throws Failure(Usage) where they do not fit the file.
PrepareOptions prepareOptionsFrom(const RunSpec& spec, const Params& params, const PointFile& file);

/// Throws Failure(Usage) if there is a start, which names points by numbers, for work that changes
/// them: `what` ("--crop") begins the message.
void requireNoStart(const GivenStart& start, const std::string& what);

/// A run that has not started.
struct PreparedInput {
    PointFile file;  ///< As read, repaired by applyFixes(), with the normals and types of `points`.
    PointSet points;
    Params params;
};

/// The options of a verb's input.
class InputArguments {
  public:
    /// IN, and all options of a run.
    void addTo(CLI::App& app);
    /// IN, and the options of these groups.
    void addTo(CLI::App& app, std::initializer_list<SpecGroup> groups);

    const std::string& input() const { return input_; }
    /// All files that are read, for ForceOption::require().
    NamedFiles files() const { return {{"", input_}, {"--start", startFile_}}; }
    ByteLimit limit() const { return ByteLimit{spec().maxBytes}; }
    /// Description of the run, evaluated at the first call. Throws Failure where an option, or the
    /// file of --start, is malformed.
    const RunSpec& spec() const;
    PrepareOptions prepareOptions(const PointFile& file) const {
        return prepareOptionsFrom(spec(), paramsFrom(spec()), file);
    }
    /// Throws Failure(Input) if a run on `points` cannot begin with its start; Failure(Usage) if it
    /// has one although a piece was chosen, whose points have other numbers, or if a what-if has no
    /// effect, or is refused.
    void requirePossible(const PointSet& points, const Params& params) const;

    /// Reads the piece that the options choose; then prints what was kept to stderr, if messages
    /// are wanted. Throws Failure.
    PointFile read(const ProgressLine& line) const;
    /// Reads and prepares, with the line of progress. Throws Failure.
    PreparedInput prepare(ProgressLine& line) const { return prepare(read(line), spec(), line); }
    /// Prepares what read() has returned, also as another run, by another spec. Throws Failure.
    PreparedInput prepare(PointFile file, const RunSpec& spec, ProgressLine& line) const;

  private:
    std::string input_;
    std::string startFile_;
    SpecOptions options_;
    mutable std::optional<RunSpec> spec_;
};

/// Field of a surface, the name of a shape or the file of a volume, at `isovalue` or at its own.
/// Throws Failure without field or isovalue.
Field readSurface(const std::string& input, const std::optional<double>& isovalue,
                  const ByteLimit& limit);

/// Makes `box` the domain. Throws Failure if a volume, whose name begins messages, is smaller.
void cutBy(const WallBox& box, const std::string& input, Field& field);

/// The shape or the volume, in the folder `volumes`, that a figure of the paper's results is of;
/// empty without that folder if it is a volume.
std::string surfaceOf(const Figure& figure, const std::string& volumes);

/// Samples with the progress line. Throws Failure if sampling fails.
PointFile samplePoints(const Field& field, const SamplerOptions& options, const std::string& input,
                       ProgressLine& line);

}  // namespace se::cli
