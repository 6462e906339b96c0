/// §6.5: from this pivot to the next.
#include "disc.h"

namespace se::view {

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
