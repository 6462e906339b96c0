/// The description of a run: which points, prepared how, by which rules. The one that options,
/// sessions, lessons, reports and the viewer share; the table of its fields is in spec_fields.h.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/points/index_ranges.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/prepare/piece.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/rule_settings.h"

namespace se {

/// Sources that are no files: "scene:ID".
inline constexpr std::string_view kScenePrefix = "scene:";
inline bool isScene(std::string_view source) { return source.starts_with(kScenePrefix); }
/// The source name of standard input.
inline constexpr std::string_view kStandardInput = "-";
inline bool isStandardInput(std::string_view source) { return source == kStandardInput; }

/// Source of the walls that boundary points lie on.
struct WallChoice {
    enum class From : std::uint8_t {
        File,    ///< The types that the file has, if any.
        Around,  ///< The box around all points.
        Box,     ///< `box`.
    };
    From from = From::File;
    WallBox box{};
    friend bool operator==(const WallChoice& a, const WallChoice& b) {
        const bool same = a.box.low == b.box.low && a.box.high == b.box.high;
        return a.from == b.from && (a.from != From::Box || same);
    }
};

/// The description of a run. Points are taken in this order: the source, its piece, without those
/// left out, after the doctor's fixes; then they are prepared.
struct RunSpec {
    /// A path, `-`, `scene:ID`, or another name that the program knows.
    std::string source;
    /// Points of `source`, if in memory already: then nothing is read.
    std::shared_ptr<const PointFile> points = nullptr;
    std::uint64_t maxBytes = ByteLimit{}.bytes;  ///< Limit of reading.
    Piece piece = {};                            ///< The part of the source that is taken.
    IndexRanges leftOut = {};  ///< Points of the piece to run without, by their indices.
    /// Checks of the doctor whose fixes are applied, one after the other (doctor.h).
    std::vector<std::string> fixes = {};

    std::string rules = "paper";          ///< A name that paramsByName() knows.
    std::vector<RuleValue> choices = {};  ///< Single rules that differ from that set.
    std::vector<WhatIf> whatIf = {};      ///< Decisions that the user overrides.
    /// Triangles and rings that the run begins with. Empty: those of a scene.
    GivenStart start = {};

    /// Lists; which points oppose is up to the rules.
    NeighborOptions neighbors = {};
    NormalSource normals = NormalSource::AsGiven;
    std::optional<Vec3> scanner = {};  ///< PrepareOptions::scanner.
    WallChoice walls = {};
    bool rim = false;  ///< PrepareOptions::rim.

    friend bool operator==(const RunSpec&, const RunSpec&) = default;
};

/// The rules alone, without what-ifs and start. Those that do not exist are passed over: they were
/// refused where they came in.
Params ruleParams(const RunSpec& spec);
/// The params of a run. Fails if there is no such set or rule.
Result<Params> paramsOf(const RunSpec& spec);

/// The spec of these rules on points in memory.
RunSpec specOf(const Params& params);

/// `spec` with the options that its fixes choose (Fix::Orient, Walls, ...) where it has none of its
/// own, and without fixes: for a file that the fixes which change it were applied to.
RunSpec withFixesAsOptions(RunSpec spec);

/// True if the rule `rim` finds the rims of `file`: on, and the file brings none, or the walls of a
/// box take the place of its types.
bool findsRims(const Params& params, const RunSpec& spec, const PointFile& file);

/// True if prepareOptionsOf() gives the same with both, whatever the file.
bool preparesAlike(const Params& a, const Params& b);

/// The options of prepare() for points of `file`, which has the fixes. Fails if the scanner has no
/// normals to turn.
Result<PrepareOptions> prepareOptionsOf(const RunSpec& spec, const Params& params,
                                        const PointFile& file);

/// `spec` with the rules and what-ifs of another.
RunSpec withRulesOf(RunSpec spec, const RunSpec& rules);
/// `spec` with another set of rules, and no single choices.
RunSpec withSet(RunSpec spec, std::string_view set);
/// `spec` with the value of one rule. Where it is that of the set, no choice is left; an unknown
/// name changes nothing.
RunSpec withRule(RunSpec spec, std::string_view name, double value);
/// The value of a rule: the choice, or the value of its set.
double valueOf(const RunSpec& spec, const RuleSetting& setting);
/// The value of a rule in its set alone.
double usualValueOf(const RunSpec& spec, const RuleSetting& setting);

}  // namespace se
