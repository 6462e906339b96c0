#include "options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "output/output.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/explain/what_if_check.h"
#include "spiraling_edge/prepare/facing.h"

namespace se::cli {
namespace {

/// One rule from NAME=VALUE.
RuleValue ruleFrom(const std::string& text) {
    if (findRuleSetting(text.substr(0, text.find('='))) == nullptr) {
        std::vector<std::string_view> names;
        for (const RuleSetting& each : ruleSettings()) names.push_back(each.name);
        throw Failure(ExitCode::Usage, fmt::format("--rule {}: no such rule; the rules are {}",
                                                   text, fmt::join(names, ", ")));
    }
    const Result<RuleValue> value = ruleValueFromText(text);
    if (!value) {
        throw Failure(ExitCode::Usage, fmt::format("--rule {}: {}", text, value.error().message));
    }
    return value.value();
}

}  // namespace

std::optional<ExitCode> parseArguments(CLI::App& app, const Arguments& arguments) {
    Arguments reversed(arguments.rbegin(), arguments.rend());  // in the order that CLI11 expects
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        printText(app.help());
        return ExitCode::Good;
    } catch (const CLI::ParseError& problem) {
        throw Failure(ExitCode::Usage,
                      fmt::format("{}; see {} --help", problem.what(), app.get_name()));
    }
    return std::nullopt;
}

void NeighborArguments::addTo(CLI::App& app) {
    auto* count = app.add_option("-k,--neighbors", count_,
                                 "Neighbors of a point: the K nearest (default: the lists in the "
                                 "file, or 12)");
    count->type_name("K")->check(CLI::Range(1LL, kMaxNeighbors));
    auto* radius =
        app.add_option("-r,--radius", radius_, "Neighbors of a point: all within R, in scene units")
            ->type_name("R")
            ->excludes(count);
    app.add_option("--reach", reach_,
                   "Neighbors of a point: all within X times the mean distance to the nearest")
        ->type_name("X")
        ->excludes(count)
        ->excludes(radius);
    app.add_flag("--symmetric", symmetric_, "Make neighbor lists symmetric");
    app.add_flag("--keep-opposing", keepOpposing_,
                 "Keep neighbors whose normal opposes that of the point");
    app.add_flag("--keep-noise", keepNoise_,
                 "Keep all points where noise is as wide as the spacing (--rules robust sets "
                 "aside those above or below others)");
    app.add_flag("--keep-strays", keepStrays_,
                 "Keep points far from all others (--rules corrected and robust set them aside)");
}

NeighborOptions NeighborArguments::options() const {
    NeighborOptions options;
    if (count_) options.reach = KNearest{*count_};
    if (radius_) {
        if (!(*radius_ > 0.0) || !std::isfinite(*radius_))
            throw Failure(ExitCode::Usage, "--radius: must be greater than 0");
        options.reach = WithinRadius{*radius_};
    }
    if (reach_) {
        if (!(*reach_ > 0.0) || !std::isfinite(*reach_))
            throw Failure(ExitCode::Usage, "--reach: must be greater than 0");
        options.reach = WithinSpacings{*reach_};
    }
    options.dropOpposingNormals = !keepOpposing_;
    options.symmetric = symmetric_;
    options.recompute = count_.has_value() || radius_.has_value() || reach_.has_value();
    return options;
}

void DerivedArguments::addTo(CLI::App& app) {
    auto* orient = app.add_flag("--orient", orient_,
                                "Flip normals of the file so that they agree with each other");
    app.add_flag("--derive-normals", deriveNormals_,
                 "Derive normals from the positions even if the file has some")
        ->excludes(orient);
    app.add_option(
           "--scanner", scanner_,
           "Derived or flipped normals face this position, X,Y,Z, part by part (default: they "
           "face outward)")
        ->type_name("POINT");
    app.add_option("--box", box_,
                   "Points on the walls of this box are boundary points: auto (around all "
                   "points), or X0,Y0,Z0,X1,Y1,Z1")
        ->type_name("BOX");
    app.add_flag("--derive-rim", rim_,
                 "Find where the surface ends without a wall, and treat the points there as "
                 "boundary points");
}

Vec3 DerivedArguments::scanner(const PointFile& file) const {
    const Result<Vec3> position = scannerFromText(scanner_);
    if (!position) {
        throw Failure(ExitCode::Usage,
                      fmt::format("--scanner {}: {}", scanner_, position.error().message));
    }
    if (file.hasNormals() && !orient_ && !deriveNormals_) {
        throw Failure(ExitCode::Usage,
                      "--scanner: the file has normals; add --orient to turn them, or "
                      "--derive-normals");
    }
    return position.value();
}

void addByteLimit(CLI::App& app, ByteLimit& limit) {
    app.add_option("--most-bytes", limit.bytes,
                   "Read and unpack at most N bytes of an input (default 2147483648, 2 GiB)")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
}

WallBox boxFromText(const std::string& text) {
    const auto n = numbersIn(text, 6);
    if (!n) {
        throw Failure(ExitCode::Usage,
                      fmt::format("--box {}: expected auto, or six numbers separated by commas: "
                                  "X0,Y0,Z0,X1,Y1,Z1",
                                  text));
    }
    WallBox box;
    box.low = {(*n)[0], (*n)[1], (*n)[2]};
    box.high = {(*n)[3], (*n)[4], (*n)[5]};
    if (!(box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z)) {
        throw Failure(ExitCode::Usage,
                      fmt::format("--box {}: expected six numbers, the lower corner first", text));
    }
    return box;
}

PrepareOptions DerivedArguments::options(const NeighborOptions& neighbors,
                                         const PointFile& file) const {
    PrepareOptions options;
    options.neighbors = neighbors;
    if (orient_) options.normals = NormalSource::Oriented;
    if (deriveNormals_) options.normals = NormalSource::Derived;
    if (!scanner_.empty()) options.scanner = scanner(file);
    if (box_ == "auto") {
        options.walls = boxAround(file.position);
    } else if (!box_.empty()) {
        options.walls = boxFromText(box_);
    }
    options.rim = rim_;
    return options;
}

void RuleArguments::addSetTo(CLI::App& app) {
    app.add_option("--rules", setName_,
                   fmt::format("Reading of the paper: {}", fmt::join(paramSetNames(), ", ")))
        ->type_name("SET")
        ->capture_default_str();
}

void RuleArguments::addTo(CLI::App& app) {
    addSetTo(app);
    app.add_option("--rule", switches_, "Set one rule, after --rules; may be repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    app.add_option(
           "--what-if", whatIfs_,
           "Override one decision: \"137.sphere keep 812\", \"137.sphere "
           "drop 812\", \"137.advance pivot 640\", \"137 move 812 X Y Z\", \"137 list 812 5 "
           "7\"; may be repeated (docs/choices.md)")
        ->type_name("LINE")
        ->allow_extra_args(false);
    std::string footer = "\nRules (docs/choices.md):\n";
    for (const RuleSetting& rule : ruleSettings()) {
        footer += fmt::format("  {:<12} {:<4} {}: {}\n", rule.name, rule.section, rule.summary,
                              valuesText(rule));
    }
    footer.pop_back();
    app.footer(footer);
}

Params RuleArguments::params() const {
    std::optional<Params> params = paramsByName(setName_);
    if (!params) {
        throw Failure(ExitCode::Usage, fmt::format("--rules {}: no such set; the sets are {}",
                                                   setName_, fmt::join(paramSetNames(), ", ")));
    }
    for (const RuleValue& each : choices()) applyRuleValues({&each, 1}, *params);
    for (const std::string& text : whatIfs_) {
        const Result<WhatIf> what = whatIfFromText(text);
        if (!what) throw Failure(ExitCode::Usage, "--what-if: " + what.error().message);
        params->whatIf.push_back(what.value());
    }
    return *params;
}

std::vector<RuleValue> RuleArguments::choices() const {
    std::vector<RuleValue> values;
    values.reserve(switches_.size());
    for (const std::string& text : switches_) values.push_back(ruleFrom(text));
    return values;
}

void requirePossible(const PointSet& points, const Params& params) {
    const Status possible = requireWhatIfs(points, params);
    if (!possible) throw Failure(ExitCode::Usage, "--what-if " + possible.error().message);
}

RunSettings settingsFrom(const RuleArguments& rules, const NeighborArguments& neighbors,
                         const DerivedArguments& derived, const PointFile& file) {
    RunSettings settings;
    settings.rules = rules.setName();
    settings.choices = rules.choices();
    settings.whatIf = rules.params().whatIf;
    settings.keepOpposing = neighbors.keepOpposing();
    settings.keepNoise = neighbors.keepNoise();
    settings.keepStrays = neighbors.keepStrays();
    settings.prepare = derived.options(neighbors.options(), file);
    return settings;
}

Params paramsFrom(const RuleArguments& rules, const NeighborArguments& neighbors) {
    Params params = rules.params();
    if (neighbors.keepOpposing()) params.dropOpposingNormals = false;
    if (neighbors.keepNoise()) params.setNoiseAside = false;
    if (neighbors.keepStrays()) params.setStraysAside = false;
    return params;
}

PrepareOptions prepareOptionsFrom(const Params& params, const NeighborArguments& neighbors,
                                  const DerivedArguments& derived, const PointFile& file) {
    return prepareOptionsFor(derived.options(neighbors.options(), file), params);
}

}  // namespace se::cli
