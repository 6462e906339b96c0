#include "spiraling_edge/why/other_preparations.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "spiraling_edge/mesh/mesh_judge.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se {

namespace {

/// Keys and texts.
constexpr std::pair<std::string_view, std::string_view> kPreparations[] = {
    {"normals", "oriented"}, {"normals", "derived"}, {"rim", "on"},
    {"neighbors", "10"},     {"neighbors", "16"},    {"neighbors", "8"},
    {"neighbors", "12"},     {"neighbors", "20"},    {"symmetric", "on"}};
static_assert(std::size(kPreparations) == kPreparationChanges);

}  // namespace

std::vector<SpecChange> preparationChanges() {
    std::vector<SpecChange> changes;
    for (const auto& each : kPreparations) changes.push_back(specChange({each}));
    return changes;
}

bool respects(const MeshJudge& judge, const SpecChange& change) {
    const std::string_view normals = textOf(change, "normals");
    if (normals.empty()) return true;
    const bool fit = judge.facts.normalsFit;
    return normals == "oriented" ? fit && !judge.areRight() : !fit;
}

SpecChange withoutPresent(const SpecChange& change, const RunSpec& spec, const PointFile& file) {
    SpecChange left;
    RunSpec with = spec;
    // What is derived or searched anyway.
    if (!file.hasNormals()) with.normals = NormalSource::Derived;
    if (!file.hasNeighbors()) with.neighbors.recompute = true;
    const auto findRims = [&] { with.rim = with.rim || findsRims(ruleParams(with), with, file); };
    findRims();
    for (const FieldValue& each : change) {
        const RunSpec next = changed(with, {each});
        const bool present =
            each.field->type == SpecType::Rule ? differenceOf(with, next).empty() : next == with;
        // Derived normals are oriented.
        const bool derived = each.field->key == "normals" && with.normals == NormalSource::Derived;
        const bool fixed =
            each.field->key == "doctor" &&
            std::find(spec.fixes.begin(), spec.fixes.end(), each.text) != spec.fixes.end();
        if (!present && !derived && !fixed) left.push_back(each);
        if (each.field->key != "rules") continue;
        with = next;
        findRims();
    }
    return left;
}

std::vector<OtherPreparation> otherPreparations(const PointFile& file, const RunSpec& spec,
                                                const MeshJudge& judge,
                                                const std::vector<Index>& leaveOut) {
    std::vector<OtherPreparation> others;
    if (!spec.whatIf.empty() || !spec.start.empty()) return others;
    for (const SpecChange& each : preparationChanges()) {
        const SpecChange change = withoutPresent(each, spec, file);
        if (change.empty() || !respects(judge, change)) continue;
        const auto points = [&file, leaveOut, with = changed(spec, change)](
                                const Progress& progress) -> std::optional<PointSet> {
            const Result<Params> params = paramsOf(with);
            if (!params) return std::nullopt;
            Result<PrepareOptions> options = prepareOptionsOf(with, params.value(), file);
            if (!options) return std::nullopt;
            options.value().leaveOut = leaveOut;
            Result<Prepared> made = prepare(file, options.value(), progress);
            if (!made) return std::nullopt;
            return std::move(made.value().points);
        };
        others.push_back({change.front(), points});
    }
    return others;
}

Alternatives alternativesOf(const PointFile& file, const RunSpec& spec,
                            std::shared_ptr<const MeshJudge> judge,
                            const std::vector<Index>& leaveOut) {
    std::vector<OtherPreparation> others = otherPreparations(file, spec, *judge, leaveOut);
    return {std::move(judge), std::move(others)};
}

}  // namespace se
