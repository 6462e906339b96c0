/// Settings of a run as a user chooses them, and changes of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/stepper/rule_settings.h"

namespace se {

/// Settings of a run.
struct RunSettings {
    std::string rules = "paper";          ///< A name that paramsByName() knows.
    std::vector<RuleValue> choices = {};  ///< Single rules that differ from that set.
    std::vector<WhatIf> whatIf = {};
    bool keepOpposing = false;    ///< Overrides the rules: also neighbors with opposing normals.
    bool keepNoise = false;       ///< Overrides the rules: no point is set aside for noise.
    bool keepStrays = false;      ///< Overrides the rules: no point is set aside as a stray.
    PrepareOptions prepare = {};  ///< For prepareOptionsFor(), which the rules have a part in.
    /// Checks of the doctor whose points are set aside; proposedDrop() finds them.
    std::vector<std::string> drops = {};
    GivenStart start = {};  ///< The state that the run begins with (given_start.h).
};
/// The params of the settings. Fails if there is no such set or rule.
Result<Params> paramsOf(const RunSettings& settings);
/// The options with what the rules decide: whether opposing normals are left out of lists, and
/// noise and strays are set aside.
PrepareOptions prepareOptionsFor(PrepareOptions options, const Params& params);

/// A change of settings. What is empty stays as it is.
struct SettingsChange {
    std::string_view rules = {};    ///< A set of rules.
    std::string_view ruleOff = {};  ///< A rule that is turned off.
    std::size_t nearest = 0;        ///< Lists of this many nearest points.
    std::optional<NormalSource> normals = {};
    bool symmetric = false;      ///< Lists are made symmetric.
    bool rim = false;            ///< Rims are derived.
    std::string_view drop = {};  ///< A check of the doctor whose points are set aside.

    friend bool operator==(const SettingsChange&, const SettingsChange&) = default;
};
/// The settings, and their options for lists alone, after a change.
RunSettings changed(RunSettings settings, const SettingsChange& change);
NeighborOptions changedLists(NeighborOptions lists, const SettingsChange& change);
/// The part of a change that `settings` of a run over `file` do not have already.
SettingsChange withoutPresent(SettingsChange change, const RunSettings& settings,
                              const PointFile& file);
/// Both changes in one; nothing if they set the same thing to two values.
std::optional<SettingsChange> bothOf(const SettingsChange& a, const SettingsChange& b);
/// The change in words: "rules of robust, 10 neighbors"; "no change" for none.
std::string wordsOf(const SettingsChange& change);
/// The options of `run` that make the change: {"--rules robust", "--neighbors 10"}. Points of
/// `drop` are dropped by the doctor before the run.
std::vector<std::string> optionsOf(const SettingsChange& change);

}  // namespace se
