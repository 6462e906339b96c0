/// Search for remedies by trial: a run and an inspection with each single rule of `robust` added,
/// and with the whole sets. A failure counts as prevented only if the list of its class is
/// complete.
#include "spiraling_edge/why/remedy.h"

#include <algorithm>
#include <tuple>

#include "spiraling_edge/why/inspected_run.h"

namespace se {
namespace {

/// A rule or a set to try, with all params as they would be.
struct RuleTrial {
    Remedy remedy;
    Params params;
};

std::vector<RuleTrial> trialsFor(const Params& params) {
    std::vector<RuleTrial> trials;
    for (const RuleSetting* each : rulesToAdd(params)) {
        trials.push_back({{each, {}, false, 0, 0}, params});
        each->turnOn(trials.back().params);
    }
    for (const std::string_view set : {"corrected", "robust"}) {
        RuleTrial trial{{nullptr, set, false, 0, 0}, params};
        trial.params.readings = paramsByName(set)->readings;
        trial.params.robust = paramsByName(set)->robust;
        if (!(trial.params == params)) trials.push_back(trial);
    }
    return trials;
}

/// Failures of all classes; a lower bound where the search ended early.
std::size_t countOf(const InspectedRun& run) {
    std::size_t all = 0;
    for (const ClassTotal& each : run.totals) all += each.total;
    return all;
}

/// True if the classes mean the same failure: points in no triangle near the surface and far from
/// it do, and loops of any width.
bool sameProblem(const FailureClass& a, const FailureClass& b) {
    const auto bothOf = [&](std::string_view one, std::string_view other) {
        return (a.name == one || a.name == other) && (b.name == one || b.name == other);
    };
    return &a == &b || bothOf("lost_points", "isolated_points") || bothOf("holes", "openings");
}

}  // namespace

std::string_view nameOf(const Remedy& remedy) {
    return remedy.rule != nullptr ? remedy.rule->name : remedy.set;
}

std::vector<const RuleSetting*> rulesToAdd(const Params& params) {
    std::vector<const RuleSetting*> rules;
    const Params robust = *paramsByName("robust");
    for (const RuleSetting& each : ruleSwitches()) {
        if (each.isOn(robust) && !each.isOn(params)) rules.push_back(&each);
    }
    return rules;
}

bool isStillThere(const MeshFailure& failure, const std::vector<MeshFailure>& failures) {
    const std::size_t enough = std::min<std::size_t>(2, failure.points.size());
    return std::any_of(failures.begin(), failures.end(), [&](const MeshFailure& each) {
        if (!sameProblem(*each.kind, *failure.kind)) return false;
        const auto shared = std::count_if(each.points.begin(), each.points.end(), [&](Index p) {
            return std::binary_search(failure.points.begin(), failure.points.end(), p);
        });
        return static_cast<std::size_t>(shared) >= enough;
    });
}

Result<Remedies> findRemedies(const PointSet& points, const Params& params,
                              const MeshFailure& failure, const Progress& progress) {
    std::vector<RuleTrial> trials = trialsFor(params);
    const double steps = static_cast<double>(trials.size() + 1);
    double begun = 0.0;
    const auto part = [&](double share) { return !progress || progress((begun + share) / steps); };
    Remedies remedies;
    const auto present = inspectRun(points, params, part);
    if (!present) return Error{"Cancelled."};
    remedies.ofClass = present->totalOf(*failure.kind).total;
    remedies.all = countOf(*present);
    for (RuleTrial& trial : trials) {
        begun += 1.0;
        const auto run = inspectRun(points, trial.params, part);
        if (!run) return Error{"Cancelled."};
        const bool there = isStillThere(failure, run->failures);
        const bool allListed = run->totalOf(*failure.kind).all();
        trial.remedy.prevents = allListed && !there;
        trial.remedy.unknown = !allListed && !there;
        trial.remedy.ofClass = run->totalOf(*failure.kind).total;
        trial.remedy.all = countOf(*run);
        remedies.tried.push_back(trial.remedy);
    }
    std::stable_sort(remedies.tried.begin(), remedies.tried.end(),
                     [](const Remedy& a, const Remedy& b) {
                         // Single rules come before whole sets.
                         const auto rank = [](const Remedy& r) {
                             return std::tuple(!r.prevents, r.rule == nullptr, r.all);
                         };
                         return rank(a) < rank(b);
                     });
    return remedies;
}

}  // namespace se
