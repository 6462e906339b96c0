/// Whether a mesh has the subject of a query, in the plainest way; and the failures of a run.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/ledger.h"

namespace se::test {

inline bool hasSubject(const std::vector<Triangle>& mesh, const Subject& subject) {
    return std::any_of(mesh.begin(), mesh.end(), [&](const Triangle& t) {
        const std::set<Index> corners{t.a, t.b, t.c};
        return std::all_of(subject.points().begin(), subject.points().end(),
                           [&](Index p) { return corners.contains(p); });
    });
}

inline std::vector<RunFailure> failuresOf(const PointSet& points, const Params& params) {
    auto all = failuresOfRun(points, params);
    REQUIRE(all.ok());
    return std::move(all.value());
}

}  // namespace se::test
