/// §6.5: the old path of the ring dashed and the new one bold (Fig. 11), a point met again that
/// splits its ring or joins two (Figs. 11 and 12), and the way to the next pivot.

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "disc.h"
#include "layer.h"
#include "run/model.h"
#include "scene/picking.h"

namespace se::view {

// The pivot with its candidates and its sector, and the listed neighbors of a point.

namespace {

void addSpoke(const LayerInput& in, const CandidateMark& mark, DrawList& out) {
    const bool rejected = mark.state == CandidateState::Rejected;
    const bool tested = mark.point == in.picture.underTest;
    const Color color = rejected ? in.palette.rejected.withAlpha(0.75F)
                        : tested ? in.palette.test
                                 : in.palette.used;
    out.dashed(in.at(in.picture.pivot), in.at(mark.point), color,
               tested     ? 0.16F
               : rejected ? 0.06F
                          : 0.09F,
               rejected ? 0.3F : 0.0F);
}

void addMark(const LayerInput& in, Index point, Shape shape, const Color& color, float size,
             DrawList& out) {
    if (point != kNone) out.mark(in.at(point), shape, color, size);
}

void addCandidates(const LayerInput& in, DrawList& out) {
    for (const CandidateMark& mark : in.picture.candidates) {
        addSpoke(in, mark, out);
        const bool rejected = mark.state == CandidateState::Rejected;
        addMark(in, mark.point, rejected ? Shape::Cross : Shape::Disc,
                rejected ? in.palette.rejected : in.palette.used, rejected ? 0.72F : 0.62F, out);
    }
}

void addEnds(const LayerInput& in, DrawList& out) {
    const DecisionState& p = in.picture;
    const auto spoke = [&](Index point, const Color& color, float width) {
        if (point != kNone) out.line(in.at(p.pivot), in.at(point), color, width, Depth::OnTop);
    };
    spoke(p.first, in.palette.first, 0.12F);
    if (p.last != p.first) spoke(p.last, in.palette.last, 0.12F);
    if (p.start != p.first) spoke(p.start, in.palette.first, 0.12F);
    if (p.end != p.last) spoke(p.end, in.palette.last, 0.12F);
    if (p.start != p.first) addMark(in, p.first, Shape::Forward, in.palette.first, 0.7F, out);
    if (p.end != p.last) addMark(in, p.last, Shape::Back, in.palette.last, 0.7F, out);
    addMark(in, p.end, Shape::Back, in.palette.last, 1.0F, out);
    addMark(in, p.start, Shape::Forward, in.palette.first, 1.0F, out);
}

void addList(const LayerInput& in, Index point, const Color& color, DrawList& out) {
    if (point == kNone) return;
    for (const Index q : in.model.points.neighbors[point]) {
        out.dashed(in.at(point), in.at(q), color, 0.06F, 0.2F);
    }
}

}  // namespace

void addSector(const LayerInput& in, DrawList& out) {
    const std::optional<Disc> disc = pivotDisc(in);
    if (!disc) return;
    const float radius = discRadius(in);
    const Color& color = in.palette.pivot;
    const double from = in.picture.startDegrees;
    const Arc arc{from, std::max(in.picture.endDegrees, from), radius};
    addSectorSheet(*disc, arc, color.withAlpha(0.16F), out);
    addArc(*disc, {0.0, 360.0, radius}, color.withAlpha(0.25F), 0.05F, out);
    addArc(*disc, arc, color.withAlpha(0.8F), 0.08F, out);
    out.line(disc->origin, disc->origin + disc->normal * in.model.spacing, color.withAlpha(0.8F),
             0.08F, Depth::XRay);
}

void addNeighborRing(const LayerInput& in, DrawList& out) {
    const DecisionState& p = in.picture;
    // Seeds, stranded points and the steps after the last pivot have layers of their own.
    if (p.pivot == kNone) return;
    out.decision = decisionPlace(in.model, p.pivot, neighborhoodOf(p));
    // Once the pivot is complete only the result of its tests is shown.
    if (!p.complete) addCandidates(in, out);
    if (!p.complete) addEnds(in, out);
    if (!p.complete && p.underTest != p.pivot) {
        addMark(in, p.underTest, Shape::RingedDisc, in.palette.test, 1.0F, out);
    }
    for (const CandidateMark& mark : p.candidates) {
        const bool rejected = mark.state == CandidateState::Rejected;
        if (p.complete || mark.point != p.underTest || !rejected) continue;
        addMark(in, mark.point, Shape::Cross, in.palette.rejected, 1.0F, out);
    }
    addMark(in, p.pivot, Shape::RingedDisc, in.palette.pivot, 1.15F, out);
}

void addLinks(const LayerInput& in, DrawList& out) {
    addList(in, in.picture.pivot, in.palette.unused, out);
    if (in.selected != in.picture.pivot) addList(in, in.selected, in.palette.accent, out);
}

// The edge rings: the active one with arrow heads, those on the stack dashed, with their letters.

namespace {

/// Steps shorter than this share of the median spacing get no arrow head of their own.
constexpr float kArrowShare = 0.5F;
/// Rings deeper on the stack are named only when chosen.
constexpr Index kNamesUpTo = 6;

void addRing(const LayerInput& in, const RingPath& ring, const Line& like, DrawList& out) {
    const std::size_t count = ring.points.size();
    // Long rings: an arrow head on every step would be clutter.
    const std::size_t arrowEvery = count > 240 ? 6 : count > 80 ? 3 : 1;
    for (std::size_t i = 0; i < count; ++i) {
        Line line = like;
        line.from = in.at(ring.points[i]);
        line.to = in.at(ring.points[(i + 1) % count]);
        const float length = glm::distance(line.from, line.to);
        if (i % arrowEvery != 0 || length < kArrowShare * in.model.spacing) line.arrow = 0.0F;
        if (ring.open[i]) {
            // No edge of the mesh: thin and dotted.
            line.width *= 0.6F;
            line.dash = 0.22F;
        }
        out.lines.push_back(line);
    }
}

/// The letter of a ring is at its first point.
void addName(const LayerInput& in, const RingPath& ring, DrawList& out) {
    if (ring.points.empty()) return;
    out.label(in.at(ring.points.front()), "ring " + ringName(ring.number), in.palette.used);
}

}  // namespace

void addEdgeRing(const LayerInput& in, DrawList& out) {
    for (const RingPath& ring : in.picture.rings) {
        if (!ring.active) continue;
        const bool lit = ring.id != kNone && ring.id == in.highlightedRing;
        const Color& color = lit ? in.palette.pivot : in.palette.used;
        addRing(in, ring, {{}, {}, color, lit ? 0.26F : 0.2F, 0.0F, 0.55F, Depth::XRay}, out);
    }
}

void addStackedRings(const LayerInput& in, DrawList& out) {
    for (const RingPath& ring : in.picture.rings) {
        if (ring.active) continue;
        const bool lit = ring.id != kNone && ring.id == in.highlightedRing;
        const Color& color = lit ? in.palette.pivot : in.palette.used;
        const float width = std::max(0.07F, 0.14F - 0.02F * static_cast<float>(ring.depth));
        addRing(in, ring, {{}, {}, color, width, 0.4F, 0.0F, Depth::XRay}, out);
        if (lit || ring.depth < kNamesUpTo) addName(in, ring, out);
    }
}

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
