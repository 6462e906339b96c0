/// RobustRules::remesh, at each triangle with a fault: those about it are replaced by others
/// between the same points, of which none has a fault, as by a flip of several edges at once. In
/// kSettlingRound those around one of its corners are, too, by others that go around the corner.
#include <algorithm>

#include "spiraling_edge/stepper/robust/hole_filling.h"

namespace se {
namespace {

/// Numbers of triangles that are replaced at once, tried in this order.
constexpr std::size_t kPatchSizes[] = {4, 10};
/// Number of triangles beyond those at a corner that are replaced with them, in a second try.
constexpr std::size_t kBeyondCorner = 6;
/// The search takes O(n^4) for a ring of n points, so that corners of more triangles are left.
constexpr std::size_t kMostAtCorner = 24;

bool remeshAround(const PointSet& points, RepairState& m, Index t) {
    HoleRing patch = patchOf(m, t);
    return !isAnyPinched(m, patch.points) && replacePatch(points, m, patch, kPatchSizes) > 0;
}

/// The triangles at a point, which is inside; none if the surface ends there, and for too few or
/// too many.
HoleRing patchAround(const RepairState& m, Index p) {
    HoleRing patch;
    bool ends = false;
    forEachSideOf(m, p, [&](HalfEdge h) {
        patch.points.push_back(cornerOf(m, following(h)));
        patch.outer.push_back(m.twin[following(h)]);
        patch.gone.push_back(h / 3);
        ends = ends || m.twin[h] == kNone;
    });
    patch.inside = p;
    const bool fits = patch.gone.size() >= 3 && patch.gone.size() <= kMostAtCorner;
    return ends || !fits ? HoleRing{} : patch;
}

bool remeshAroundCorner(const PointSet& points, RepairState& m, Index corner) {
    HoleRing patch = patchAround(m, corner);
    if (patch.gone.empty() || m.pinched[corner] || isAnyPinched(m, patch.points)) return false;
    const std::size_t first = patch.gone.size();
    const std::size_t sizes[] = {first, first + kBeyondCorner};
    return replacePatch(points, m, patch, sizes) > 0;
}

bool remeshAroundCorners(const PointSet& points, RepairState& m, const Triangle& t) {
    FailedCorners& failed = m.failedCorners;
    if (failed.points != &points) failed = {&points, std::vector<std::uint32_t>(points.size())};
    for (const Index corner : {t.a, t.b, t.c}) {
        // Most triangles at a corner have a fault where one has.
        if (failed.at[corner] == m.remeshed + 1) continue;
        if (remeshAroundCorner(points, m, corner)) return true;
        failed.at[corner] = m.remeshed + 1;
    }
    return false;
}

}  // namespace

std::optional<RemeshEvidence> remeshNext(const PointSet& points, RepairState& m) {
    for (; m.next < m.triangles.size(); ++m.next) {
        if (isKnownAsSound(m, m.next) || !isFaulty(points, m, m.next)) continue;
        const Triangle faulty = m.triangles[m.next];
        const bool isSettling = m.round == kSettlingRound;
        if (!remeshAround(points, m, m.next) &&
            !(isSettling && remeshAroundCorners(points, m, faulty)))
            continue;
        ++m.remeshed;
        ++m.next;
        return RemeshEvidence{faulty};
    }
    m.failedCorners = {};
    return std::nullopt;
}

}  // namespace se
