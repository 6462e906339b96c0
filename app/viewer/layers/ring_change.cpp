/// §6.5, Fig. 11: the old path of the ring dashed, the new one bold.
#include <algorithm>
#include <set>

#include "layer.h"

namespace se::view {

namespace {

const RingPath* activeOf(const std::vector<RingPath>& rings) {
    return !rings.empty() && rings.front().active ? &rings.front() : nullptr;
}

/// Strength of the old path of the ring.
constexpr float kOldPathRest = 0.5F;

/// Calls `use` with the steps of the ring that have an end among `points`.
template <typename Use>
void forStepsAt(const RingPath& ring, const std::set<Index>& points, Use&& use) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const Index from = ring.points[i];
        const Index to = ring.points[(i + 1) % ring.points.size()];
        if (points.contains(from) || points.contains(to)) use(from, to);
    }
}

/// Leaving points become dots; joining points pop up, one after the other.
void addMarks(const LayerInput& in, DrawList& out) {
    const Palette& c = in.palette;
    const std::vector<RingEvidence>& changes = in.picture.ringChanges;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const RingEvidence& change = changes[i];
        const float size = change.inserted ? popSize(in.moment, i, changes.size()) : 0.6F;
        if (!(size > 0.0F)) continue;
        std::string text = change.inserted ? "+ joins the ring" : "\xE2\x88\x92 leaves: DONE";
        if (!change.inserted && change.status > 0) {
            text = std::to_string(change.status + 1) + "\xE2\x86\x92" +
                   std::to_string(change.status) + " instances";
        } else if (change.inserted && change.status > 1) {
            text = "+ again: " + std::to_string(change.status) + " instances";
        }
        out.mark(in.at(change.point), change.inserted ? Shape::RingedDisc : Shape::Dot,
                 change.inserted ? c.used : c.done, size);
        out.label(in.at(change.point), text, change.inserted ? c.used : c.text, true);
    }
}

}  // namespace

void addRingChange(const LayerInput& in, DrawList& out) {
    const Picture& p = in.picture;
    if (p.ringChanges.empty()) return;
    const Palette& c = in.palette;
    std::set<Index> gone;
    std::set<Index> come;
    for (const RingEvidence& change : p.ringChanges) {
        (change.inserted ? come : gone).insert(change.point);
    }
    if (const RingPath* old = activeOf(p.oldRings)) {
        const Color color = c.text.withAlpha(fadeStrength(in.moment, kOldPathRest));
        forStepsAt(*old, gone, [&](Index from, Index to) {
            out.dashed(in.at(from), in.at(to), color, 0.2F, 0.35F);
        });
    }
    // Where points leave and none come in, the ring closes from start to end.
    if (come.empty() && p.start != kNone) come = {p.start};
    if (const RingPath* now = activeOf(p.rings)) {
        forStepsAt(*now, come, [&](Index from, Index to) {
            out.arrow(in.at(from), in.at(to), c.used, 0.32F, 0.9F);
        });
    }
    addMarks(in, out);
}

}  // namespace se::view
