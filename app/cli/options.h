/// Options that several verbs share, turned into params.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exit_code.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/explain/run_settings.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "verbs.h"

namespace se::cli {

/// Largest K; a larger number is taken for a typing error.
inline constexpr long long kMaxNeighbors = 1'000'000;

/// Parses `arguments` into what `app` binds. Empty if the verb should continue; otherwise the code
/// to exit with, after the help was printed. Throws Failure on wrong usage.
std::optional<ExitCode> parseArguments(CLI::App& app, const Arguments& arguments);

/// Adds --most-bytes, for verbs that read points, volumes or lessons.
void addByteLimit(CLI::App& app, ByteLimit& limit);

/// A box from six numbers separated by commas, X0,Y0,Z0,X1,Y1,Z1. Throws Failure otherwise.
WallBox boxFromText(const std::string& text);

/// Options for missing neighbor lists: --neighbors, --radius, --reach, --symmetric,
/// --keep-opposing, --keep-noise, --keep-strays.
class NeighborArguments {
  public:
    void addTo(CLI::App& app);
    /// Lists in the file are used unless the user asks for others.
    NeighborOptions options() const;
    bool keepOpposing() const { return keepOpposing_; }
    bool keepNoise() const { return keepNoise_; }
    bool keepStrays() const { return keepStrays_; }

  private:
    std::optional<std::size_t> count_;
    std::optional<double> radius_;
    std::optional<double> reach_;
    bool symmetric_ = false;
    bool keepOpposing_ = false;
    bool keepNoise_ = false;
    bool keepStrays_ = false;
};

/// Options for what is derived from the points: --orient, --derive-normals, --scanner,
/// --box, --derive-rim.
class DerivedArguments {
  public:
    void addTo(CLI::App& app);
    /// Combined with `neighbors`. Throws Failure if the box or the scanner is malformed, or if the
    /// file has normals that no option turns toward the scanner.
    PrepareOptions options(const NeighborOptions& neighbors, const PointFile& file) const;

  private:
    Vec3 scanner(const PointFile& file) const;

    bool orient_ = false;
    bool deriveNormals_ = false;
    bool rim_ = false;
    std::string scanner_;
    std::string box_;
};

/// Options for the reading of the paper and for overrides: --rules, --rule NAME=VALUE,
/// --what-if LINE.
class RuleArguments {
  public:
    void addTo(CLI::App& app);
    /// Adds --rules alone: of the rules the set decides whether noise and strays are set aside.
    void addSetTo(CLI::App& app);
    /// Throws Failure if there is no such set or rule.
    Params params() const;
    const std::string& setName() const { return setName_; }
    /// The values of --rule. Throws Failure if there is no such rule.
    std::vector<RuleValue> choices() const;

  private:
    std::string setName_ = "paper";
    std::vector<std::string> switches_;
    std::vector<std::string> whatIfs_;
};

/// Throws Failure with the reason if a what-if of `params` has no effect, or is refused.
void requirePossible(const PointSet& points, const Params& params);

/// All options together, for points of `file`.
RunSettings settingsFrom(const RuleArguments& rules, const NeighborArguments& neighbors,
                         const DerivedArguments& derived, const PointFile& file);
/// Params from all options together.
Params paramsFrom(const RuleArguments& rules, const NeighborArguments& neighbors);
PrepareOptions prepareOptionsFrom(const Params& params, const NeighborArguments& neighbors,
                                  const DerivedArguments& derived, const PointFile& file);

}  // namespace se::cli
