/// Faults of a mesh, in words and as JSON: the verdict, failures and their places, and the
/// number of each class, where only the first are listed; and one of them, named on the command
/// line: CLASS or CLASS:N.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "output.h"
#include "spiraling_edge/why/failure_moments.h"

namespace se::cli {

/// "     12 folded_edges", "      1 folded_edge": the number of a class in a column.
std::string classText(const FailureClass& kind, const ClassTotal& total);
/// The first `limit` places, one line each; empty if there are none.
std::string placesText(std::span<const FaultPlace> places, std::span<const MeshFailure> failures,
                       std::size_t limit);
/// Adds the number of places as `places_total`, and the first `limit` as `places`: `what`, `at`,
/// `radius` and `faults`, the number of faults there. `rowOf`: of each failure, its position in the
/// list that is printed, if it is in it; those are the `rows` of a place.
void addPlaces(std::span<const FaultPlace> places, std::span<const MeshFailure> failures,
               std::span<const std::optional<std::size_t>> rowOf, std::size_t limit, Json& json);

/// One failure: `class`, `points`, `triangles`, `at`; of a loop also `length` and `area`.
Json failureRow(const MeshFailure& failure);

/// Adds `counts`, the number of each class. If not all failures are listed, also `complete`: false,
/// `listed`, the length of the list by class, and `at_least`, the classes of which there may be
/// more than their count. `classes` are those that `totals` begin with, or all of them.
void addTotals(std::span<const ClassTotal> totals, std::span<const FailureClass> classes,
               Json& json);

/// All numbers of a verdict: whether the mesh is sound, its places by class, points in no triangle
/// by reason, the counts that are compared, and the distances of the points.
Json verdictJson(const MeshVerdict& verdict);

/// A class of failures and a number within it.
struct FailureChoice {
    const FailureClass* kind;
    std::size_t number;  ///< From 1.
};

/// Throws Failure if there is no such class, or N is no number.
FailureChoice failureChoiceFrom(const std::string& text);

/// Throws Failure: the list of the run on `input`, which has these failures in all, lacks it.
[[noreturn]] void noSuchFailure(std::span<const ClassTotal> totals, const FailureChoice& wanted,
                                const std::string& input);

/// The chosen failure of a list, with or without its moments; kindOf(failure) is its class. Throws
/// as noSuchFailure() if it is not there.
template <typename Listed, typename KindOf>
const Listed& pickFailure(const std::vector<Listed>& list, KindOf kindOf,
                          std::span<const ClassTotal> totals, const FailureChoice& wanted,
                          const std::string& input) {
    std::size_t seen = 0;
    for (const Listed& each : list) {
        if (kindOf(each) == wanted.kind && ++seen == wanted.number) return each;
    }
    noSuchFailure(totals, wanted, input);
}

}  // namespace se::cli
