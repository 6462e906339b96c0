#include <set>

#include "layer.h"

namespace se::view {

namespace {

/// Collects one label per point, the more informative one first; strong ones are essential.
class LabelMaker {
  public:
    LabelMaker(const LayerInput& in, DrawList& out) : in_(in), out_(out) {}

    void add(Index point, const std::string& prefix, const Color& color, bool strong) {
        if (point == kNone || !seen_.insert(point).second) return;
        std::string text = prefix.empty() ? "" : prefix + " ";
        out_.labels.push_back({in_.at(point), text + std::to_string(point), color, strong, strong});
    }

  private:
    const LayerInput& in_;
    DrawList& out_;
    std::set<Index> seen_;
};

}  // namespace

void addLabels(const LayerInput& in, DrawList& out) {
    const Picture& p = in.picture;
    const Palette& c = in.palette;
    LabelMaker labels(in, out);
    labels.add(p.pivot, "p", c.pivot, true);
    const bool stranded = p.event && p.event->address.stage == Stage::Strand;
    // Seeds and the steps after the last pivot label their points themselves.
    const bool named = p.repaired || (p.event && p.event->address.stage == Stage::Seed);
    if (p.pivot == kNone && !named) {
        labels.add(p.underTest, "", stranded ? c.rejected : c.test, true);
    }
    if (!p.complete && p.pivot != kNone) {
        if (p.sphere) {
            labels.add(p.sphere->q, "q", c.test, true);
            labels.add(p.sphere->s, p.sphere->s == p.end ? "s = E" : "s", c.test, true);
            labels.add(p.sphere->t, p.sphere->t == p.start ? "t = S" : "t", c.test, true);
        }
        labels.add(p.start, p.start == p.end ? "S E" : "S", c.first, true);
        labels.add(p.end, "E", c.last, true);
        if (p.first != p.start) labels.add(p.first, "first", c.first, false);
        if (p.last != p.end) labels.add(p.last, "last", c.last, false);
        labels.add(p.underTest, "?", c.test, true);
        for (const CandidateMark& mark : p.candidates) {
            const bool kept = mark.state == CandidateState::Kept;
            labels.add(mark.point, "", kept ? c.used : c.rejected, false);
        }
    }
    if (p.complete) labels.add(p.nextPivot, "next pivot", c.pivot, true);
    if (in.hovered != kNone) {
        out.mark(in.at(in.hovered), Shape::Circle, c.text.withAlpha(0.8F), 1.5F);
        labels.add(in.hovered, "", c.text, true);
    }
    if (in.selected != kNone) {
        out.mark(in.at(in.selected), Shape::Circle, c.text, 1.3F);
        labels.add(in.selected, "", c.text, true);
    }
}

}  // namespace se::view
