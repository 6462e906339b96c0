/// §6.5: the old path of the ring dashed and the new one bold (Fig. 11), a point met again that
/// splits its ring or joins two (Figs. 11 and 12), and the way to the next pivot.
#include <algorithm>
#include <set>

#include "disc.h"

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
        std::string text = change.inserted            ? "+ joins the ring"
                           : change.status == kUnused ? "\xE2\x88\x92 leaves: UNUSED"
                                                      : "\xE2\x88\x92 leaves: DONE";
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

/// A broad band along a loop, under which everything stays visible.
void addBand(const LayerInput& in, const RingPath& ring, const Color& color, float dash,
             DrawList& out) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        out.dashed(in.at(ring.points[i]), in.at(ring.points[(i + 1) % ring.points.size()]),
                   color.withAlpha(0.55F), 0.5F, dash, Depth::XRay);
    }
}

/// The name of a loop, at its step after the next.
void addName(const LayerInput& in, const RingPath& ring, Index point, const std::string& text,
             const Color& color, DrawList& out) {
    const auto found = std::find(ring.points.begin(), ring.points.end(), point);
    const auto at = static_cast<std::size_t>(found - ring.points.begin());
    const std::size_t count = ring.points.size();
    const std::size_t from = (at + (count > 2 ? 1 : 0)) % count;
    const glm::vec3& near = in.at(ring.points[from]);
    out.label(0.5F * (near + in.at(ring.points[(from + 1) % count])), text, color, true);
}

/// "ring b: 12 entries".
std::string named(const RingPath& ring) {
    const std::size_t count = ring.points.size();
    return "ring " + ringName(ring.number) + ": " + std::to_string(count) +
           (count == 1 ? " entry" : " entries");
}

void addSplit(const LayerInput& in, Index point, const RingExchange& loops, DrawList& out) {
    const Palette& c = in.palette;
    addBand(in, loops.a, c.used, 0.0F, out);
    addName(in, loops.a, point,
            named(loops.a) + (loops.a.active ? ", continues" : ", stays on the stack"), c.used,
            out);
    addBand(in, loops.b, c.last, 0.6F, out);
    addName(in, loops.b, point, named(loops.b) + ", waits on the stack", c.last, out);
    out.mark(in.at(point), Shape::OpenDiamond, c.pivot, 1.5F);
    out.label(in.at(point),
              ringName(loops.a.number) + " | " + ringName(loops.b.number) + ": cut here", c.pivot,
              true);
}

void addJoin(const LayerInput& in, Index point, const RingExchange& loops, DrawList& out) {
    const Palette& c = in.palette;
    addBand(in, loops.a, c.used, 0.0F, out);
    addName(in, loops.a, point, named(loops.a), c.used, out);
    addBand(in, loops.b, c.last, 0.0F, out);
    addName(in, loops.b, point,
            named(loops.b) + (loops.b.active ? ", was active" : ", was on the stack"), c.last, out);
    out.mark(in.at(point), Shape::OpenSquare, c.pivot, 1.5F);
    out.label(in.at(point),
              ringName(loops.a.number) + " + " + ringName(loops.b.number) + ": bridge here",
              c.pivot, true);
}

}  // namespace

void addRingChange(const LayerInput& in, DrawList& out) {
    const DecisionState& p = in.picture;
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

/// Loops as they were at that moment: the next split of the same pivot may cut them again.
void addExchange(const LayerInput& in, DrawList& out) {
    if (!in.picture.exchange) return;
    const auto latest =
        std::find_if(in.picture.latest.rbegin(), in.picture.latest.rend(), [](const Event& event) {
            return event.address.stage == Stage::Split || event.address.stage == Stage::Join;
        });
    if (latest == in.picture.latest.rend()) return;
    const Index point = subjectOf(*latest);
    latest->address.stage == Stage::Split ? addSplit(in, point, *in.picture.exchange, out)
                                          : addJoin(in, point, *in.picture.exchange, out);
}

void addAdvance(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<AdvanceEvidence>(Stage::Advance);
    const Index pivot = in.picture.pivot;
    if (e == nullptr || pivot == kNone) return;
    const Color& color = in.palette.pivot;
    if (e->to == kNone) {
        out.label(in.at(pivot), "no ring is left", color, true);
        return;
    }
    out.mark(in.at(e->to), Shape::Circle, color, 1.3F);
    if (e->to != pivot) out.arrow(in.at(pivot), in.at(e->to), color, 0.3F, 1.2F);
    if (const std::optional<Disc> disc = discAt(in, e->to, pivot)) {
        addDashedArc(*disc, {0.0, 360.0, discRadius(in)}, color, 0.1F, out);
    }
    if (e->popped) out.label(in.at(e->to), "its ring came off the stack", color);
    if (e->circuit > 0) {
        out.label(in.at(e->to), std::to_string(e->circuit) + " without a triangle", color);
    }
}

}  // namespace se::view
