/// RobustRules::remesh and RobustRules::removeFolded, at each triangle with a fault: those about it
/// are replaced by others between the same points, of which none has a fault, as by a flip of
/// several edges at once; or a point near it is taken out and the hole of its triangles filled
/// without a fault. RobustRules::reinsert may put it back where it fits.
#include <algorithm>

#include "spiraling_edge/stepper/robust/hole_filling.h"

namespace se {
namespace {

// ---- remesh -------------------------------------------------------------------------------------

/// Numbers of triangles that are replaced at once, tried in this order.
constexpr std::size_t kPatchSizes[] = {4, 6, 8, 10};

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

// ---- reseat -------------------------------------------------------------------------------------

/// Largest number of triangles about a point that is taken out.
constexpr std::size_t kMaxSides = 14;

/// The ring around the triangles of a point. Empty unless these form one closed fan of 4 to
/// kMaxSides, with no pinched point.
HoleRing ringAround(const RepairState& m, Index x) {
    HoleRing ring;
    HalfEdge h = m.sideOf[x];
    if (h == kNone || m.pinched[x]) return {};
    const HalfEdge begin = h;
    do {
        ring.points.push_back(cornerOf(m, following(h)));
        ring.outer.push_back(m.twin[following(h)]);
        ring.gone.push_back(h / 3);
        h = m.twin[preceding(h)];
    } while (h != kNone && h != begin && ring.size() <= kMaxSides);
    if (h != begin || ring.size() < 4 || ring.size() > kMaxSides) return {};
    // Of a pinched point the other fans are not listed in this phase.
    if (std::any_of(ring.points.begin(), ring.points.end(), [&](Index p) { return m.pinched[p]; }))
        return {};
    return ring;
}

/// Takes a point out and fills the hole that it leaves, if that can be done without a fault.
bool takeOut(const PointSet& points, RepairState& m, Index x) {
    const HoleRing ring = ringAround(m, x);
    if (ring.points.empty()) return false;
    const Filling filling = FillingSearch(points, m, ring).find();
    if (filling.empty()) return false;
    putFilling(m, ring, filling);
    m.sideOf.set(x, kNone);
    return true;
}

/// The corners of a triangle, and of its neighbors the third ones.
std::vector<Index> pointsAbout(const RepairState& m, Index t) {
    std::vector<Index> about{m.triangles[t].a, m.triangles[t].b, m.triangles[t].c};
    for (Index k = 0; k < 3; ++k) {
        const HalfEdge other = m.twin[3 * t + k];
        if (other != kNone) about.push_back(cornerOf(m, preceding(other)));
    }
    return about;
}

}  // namespace

std::optional<Evidence> repairNextFault(const PointSet& points, const RobustRules& rules,
                                        RepairState& m) {
    const bool mayTakeOut = rules.removeFolded && m.round < kSettlingRound;
    m.sound.resize(m.triangles.size(), Triangle{kNone, kNone, kNone});
    for (; m.next < m.triangles.size(); ++m.next) {
        const Index t = m.next;
        if (m.sound[t] == m.triangles[t]) continue;
        if (!isFaulty(points, m, t)) {
            m.sound.set(t, m.triangles[t]);
            continue;
        }
        const Triangle faulty = m.triangles[t];
        if (rules.remesh && remeshAround(points, m, t)) {
            ++m.remeshed;
            ++m.next;
            return RemeshEvidence{faulty};
        }
        if (!mayTakeOut) continue;
        for (const Index x : pointsAbout(m, t)) {
            if (!takeOut(points, m, x)) continue;
            ++m.takenOut;
            return RemoveFoldedEvidence{x, faulty};
        }
    }
    return std::nullopt;
}

}  // namespace se
