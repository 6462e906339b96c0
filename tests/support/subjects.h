/// Whether a mesh has the subject of a query, in the plainest way.
#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "spiraling_edge/why/ledger.h"

namespace se::test {

inline bool hasSubject(const std::vector<Triangle>& mesh, const Subject& subject) {
    return std::any_of(mesh.begin(), mesh.end(), [&](const Triangle& t) {
        const std::set<Index> corners{t.a, t.b, t.c};
        return std::all_of(subject.points().begin(), subject.points().end(),
                           [&](Index p) { return corners.contains(p); });
    });
}

}  // namespace se::test
