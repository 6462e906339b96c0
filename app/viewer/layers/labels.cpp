// Labels of the points that matter at the cursor, one per point: its name alone. Roles are shown by
// the signs and colors of the points.
#include <algorithm>
#include <set>

#include "layer.h"

namespace se::view {

namespace {

/// Whether `name` is a word of `text`: "7" of "start point 7".
bool isWordOf(const std::string& name, const std::string& text) {
    const auto ends = [&](std::size_t at) { return text.find_first_of(" ,", at) == at; };
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t after = at + name.size();
        if ((at == 0 || text[at - 1] == ' ') && (after == text.size() || ends(after))) return true;
    }
    return false;
}

/// The color of a point's sign.
const Color& roleColor(const DecisionState& p, const Palette& c, Index point) {
    if (point == p.pivot || point == p.nextPivot) return c.pivot;
    if (point == p.start || point == p.first) return c.first;
    if (point == p.end || point == p.last) return c.last;
    return c.test;
}

/// Points that the decision names besides the pivot, the most important first.
std::vector<Index> namedPoints(const DecisionState& p) {
    std::vector<Index> points{p.underTest};
    if (p.sphere) points.insert(points.end(), {p.sphere->q, p.sphere->t, p.sphere->s});
    if (const auto* e = p.evidence<ReciprocalEvidence>(Stage::Reciprocal))
        points.insert(points.end(), {e->pred, e->succ});
    points.insert(points.end(), {p.start, p.end, p.first, p.last});
    return points;
}

}  // namespace

void addLabels(const LayerInput& in, DrawList& out) {
    const DecisionState none;
    const DecisionState& p = in.finished ? none : in.picture;
    const Palette& c = in.palette;
    std::set<Index> seen;
    // Those of the decision come first: a view has room for a few.
    const auto add = [&](Index point, const Color& color, bool strong) {
        if (point == kNone || !seen.insert(point).second) return;
        const std::string name = nameOf(point, in.names);
        // Another layer may have named it already, with what it is.
        const bool elsewhere =
            std::any_of(out.labels.begin(), out.labels.end(), [&](const Label& each) {
                return each.position == in.at(point) && isWordOf(name, each.text);
            });
        if (elsewhere) return;
        const bool asked =
            point == in.hovered || point == in.selected ||
            std::find(in.labeled.begin(), in.labeled.end(), point) != in.labeled.end();
        out.labels.push_back({in.at(point), name, color, strong, strong, 0.0F, asked});
    };
    add(p.pivot, c.pivot, true);
    const bool stranded = p.event && p.event->address.stage == Stage::Strand;
    // Seeds and the steps after the last pivot label their points themselves.
    const bool named = p.repaired || (p.event && p.event->address.stage == Stage::Seed);
    if (p.pivot == kNone && !named) add(p.underTest, stranded ? c.rejected : c.test, true);
    if (!p.complete && p.pivot != kNone) {
        for (const Index point : namedPoints(p)) add(point, roleColor(p, c, point), true);
        for (const CandidateMark& mark : p.candidates) {
            const bool kept = mark.state == CandidateState::Kept;
            add(mark.point, kept ? c.used : c.rejected, false);
        }
    }
    if (p.complete) add(p.nextPivot, c.pivot, true);
    // Of a figure, all points on the rings that it names.
    for (const PointName& each : in.names) {
        const bool onRing = each.point < p.status.size() && p.status[each.point] > 0;
        if (onRing) add(each.point, c.used, false);
    }
    for (const Index point : in.labeled) add(point, c.text, false);
    for (const auto& [point, size] : {std::pair{in.hovered, 1.5F}, {in.selected, 1.3F}}) {
        if (point == kNone) continue;
        out.mark(in.at(point), Shape::Circle, c.text.withAlpha(point == in.hovered ? 0.8F : 1.0F),
                 size);
        add(point, c.text, true);
    }
}

}  // namespace se::view
