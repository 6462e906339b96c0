/// RobustRules::remesh, at each triangle with a fault: those about it are replaced by others
/// between the same points, of which none has a fault, as by a flip of several edges at once.
#include <algorithm>

#include "spiraling_edge/stepper/robust/hole_filling.h"

namespace se {
namespace {

/// Numbers of triangles that are replaced at once, tried in this order.
constexpr std::size_t kPatchSizes[] = {4, 6, 10};

/// Grows a patch to this number of triangles, those nearest to the first before others; false if
/// there are fewer.
bool growTo(const RepairState& m, std::size_t size, HoleRing& patch) {
    for (std::size_t i = 0; i < patch.gone.size(); ++i) {
        for (Index k = 0; k < 3 && patch.gone.size() < size; ++k) {
            const auto side =
                std::find(patch.outer.begin(), patch.outer.end(), m.twin[3 * patch.gone[i] + k]);
            if (side != patch.outer.end())
                widenByTriangle(m, static_cast<std::size_t>(side - patch.outer.begin()), patch);
        }
    }
    return patch.gone.size() == size;
}

bool remeshAround(const PointSet& points, RepairState& m, Index t) {
    const Triangle& mine = m.triangles[t];
    if (m.pinched[mine.a] || m.pinched[mine.b] || m.pinched[mine.c]) return false;
    HoleRing patch{
        {mine.a, mine.b, mine.c}, {m.twin[3 * t], m.twin[3 * t + 1], m.twin[3 * t + 2]}, {t}};
    for (const std::size_t size : kPatchSizes) {
        if (!growTo(m, size, patch)) return false;
        const Filling filling = FillingSearch(points, m, patch).find();
        if (filling.empty()) continue;
        putFilling(m, patch, filling);
        return true;
    }
    return false;
}

}  // namespace

std::optional<RemeshEvidence> remeshNext(const PointSet& points, RepairState& m) {
    for (; m.next < m.triangles.size(); ++m.next) {
        if (!isFaulty(points, m, m.next)) continue;
        const Triangle faulty = m.triangles[m.next];
        if (!remeshAround(points, m, m.next)) continue;
        ++m.remeshed;
        ++m.next;
        return RemeshEvidence{faulty};
    }
    return std::nullopt;
}

}  // namespace se
