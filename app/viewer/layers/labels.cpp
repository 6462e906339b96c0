// Labels of the points that matter at the cursor, one per point.
#include <algorithm>
#include <set>

#include "layer.h"
#include "run/point_label.h"

namespace se::view {

void addLabels(const LayerInput& in, DrawList& out) {
    const DecisionState none;
    const DecisionState& p = in.finished ? none : in.picture;
    const Palette& c = in.palette;
    // One label per point, the more informative one first; strong ones are essential.
    std::set<Index> seen;
    const auto add = [&](Index point, const char* prefix, const Color& color, bool strong) {
        if (point == kNone || !seen.insert(point).second) return;
        const bool essential =
            strong || std::find(in.labeled.begin(), in.labeled.end(), point) != in.labeled.end();
        out.labels.push_back(
            {in.at(point), pointLabel(prefix, point, in.names), color, strong, essential});
    };
    add(p.pivot, "p", c.pivot, true);
    const bool stranded = p.event && p.event->address.stage == Stage::Strand;
    // Seeds and the steps after the last pivot label their points themselves.
    const bool named = p.repaired || (p.event && p.event->address.stage == Stage::Seed);
    if (p.pivot == kNone && !named) add(p.underTest, "", stranded ? c.rejected : c.test, true);
    if (!p.complete && p.pivot != kNone) {
        if (p.sphere) {
            add(p.sphere->q, "q", c.test, true);
            add(p.sphere->s, p.sphere->s == p.end ? "s = E" : "s", c.test, true);
            add(p.sphere->t, p.sphere->t == p.start ? "t = S" : "t", c.test, true);
        }
        add(p.start, p.start == p.end ? "S E" : "S", c.first, true);
        add(p.end, "E", c.last, true);
        if (p.first != p.start) add(p.first, "first", c.first, false);
        if (p.last != p.end) add(p.last, "last", c.last, false);
        add(p.underTest, "?", c.test, true);
        for (const CandidateMark& mark : p.candidates) {
            const bool kept = mark.state == CandidateState::Kept;
            add(mark.point, "", kept ? c.used : c.rejected, false);
        }
    }
    if (p.complete) add(p.nextPivot, "next pivot", c.pivot, true);
    // Of a figure, all points on the rings that it names.
    for (const PointName& each : in.names) {
        const bool onRing = each.point < p.status.size() && p.status[each.point] > 0;
        if (onRing) add(each.point, "", c.used, false);
    }
    for (const Index point : in.labeled) add(point, "", c.text, false);
    if (in.hovered != kNone) {
        out.mark(in.at(in.hovered), Shape::Circle, c.text.withAlpha(0.8F), 1.5F);
        add(in.hovered, "", c.text, true);
    }
    if (in.selected != kNone) {
        out.mark(in.at(in.selected), Shape::Circle, c.text, 1.3F);
        add(in.selected, "", c.text, true);
    }
}

}  // namespace se::view
