/// The ledger by re-running: one run with a log of one pivot at a time, and only the lines about
/// the subject are kept. O(run), with memory for the answer alone.
#include "spiraling_edge/explain/ledger.h"

#include <algorithm>

#include "spiraling_edge/explain/ledger_builder.h"
#include "spiraling_edge/replay/scan_run.h"

namespace se {

std::size_t Subject::find(Index p) const {
    const auto end = points_.begin() + static_cast<std::ptrdiff_t>(size_);
    return static_cast<std::size_t>(std::find(points_.begin(), end, p) - points_.begin());
}

std::string nameOf(const Subject& subject) {
    const auto name = [&](std::size_t i) { return std::to_string(subject[i]); };
    if (subject.size() == 1) return "point " + name(0);
    if (subject.size() == 2) return "edge " + name(0) + "-" + name(1);
    return "triangle (" + name(0) + ", " + name(1) + ", " + name(2) + ")";
}

namespace {

std::optional<Error> subjectError(const PointSet& points, const Subject& subject) {
    for (std::size_t i = 0; i < subject.size(); ++i) {
        if (subject[i] >= points.size()) {
            return Error{"There is no point " + std::to_string(subject[i]) +
                         ": the points are 0 to " + std::to_string(points.size() - 1) + "."};
        }
        if (subject.find(subject[i]) != i)
            return Error{"The points of the " + nameOf(subject) + " must be different."};
    }
    return {};
}

}  // namespace

Result<Ledger> why(const PointSet& points, const Params& params, const Subject& subject,
                   const Progress& progress) {
    if (points.size() == 0) return Error{"There are no points."};
    if (auto error = subjectError(points, subject)) return *error;
    LedgerBuilder builder(points, params, subject);
    const std::optional<State> end = scanRun(
        points, params, [&](const ScannedPivot& pivot) { builder.add(pivot); }, progress);
    if (!end) return Error{"Cancelled."};
    return builder.finish(*end);
}

}  // namespace se
