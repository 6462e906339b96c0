#include "spiraling_edge/why/other_preparations.h"

#include <algorithm>
#include <utility>

#include "spiraling_edge/mesh/mesh_judge.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se {

std::vector<SpecChange> preparationChanges() {
    std::vector<SpecChange> changes;
    for (const auto& [key, text] :
         std::initializer_list<std::pair<const char*, const char*>>{{"normals", "oriented"},
                                                                    {"normals", "derived"},
                                                                    {"rim", "on"},
                                                                    {"neighbors", "10"},
                                                                    {"neighbors", "16"},
                                                                    {"neighbors", "8"},
                                                                    {"neighbors", "12"},
                                                                    {"neighbors", "20"},
                                                                    {"symmetric", "on"}})
        changes.push_back(specChange({{key, text}}));
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
        if (each.field->key == "rules") with = next;
    }
    return left;
}

std::vector<OtherPreparation> otherPreparations(const PointFile& file, const RunSpec& spec,
                                                const PointSet& run,
                                                const std::vector<Index>& leaveOut) {
    std::vector<OtherPreparation> others;
    for (const SpecChange& each : preparationChanges()) {
        const SpecChange change = withoutPresent(each, spec, file);
        const bool keepsNormals =
            run.judge == nullptr ? textOf(change, "normals").empty() : respects(*run.judge, change);
        if (change.empty() || !keepsNormals) continue;
        const auto points = [&file, &run, leaveOut, with = changed(spec, change)](
                                const Progress& progress) -> std::optional<PointSet> {
            const Result<Params> params = paramsOf(with);
            if (!params) return std::nullopt;
            Result<PrepareOptions> options = prepareOptionsOf(with, params.value(), file);
            if (!options) return std::nullopt;
            options.value().leaveOut = leaveOut;
            Result<Prepared> made = prepare(file, options.value(), progress);
            if (!made || made.value().points.size() != run.size()) return std::nullopt;
            return std::move(made.value().points);
        };
        others.push_back({change.front(), points});
    }
    return others;
}

}  // namespace se
