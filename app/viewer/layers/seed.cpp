/// §4: a ring of two begins, or a point is stranded.
#include "layer.h"

namespace se::view {

void addSeed(const LayerInput& in, DrawList& out) {
    const Palette& c = in.palette;
    if (const auto* strand = in.picture.evidence<StrandEvidence>(Stage::Strand)) {
        out.mark(in.at(strand->point), Shape::Cross, c.rejected, 1.1F);
        out.label(in.at(strand->point),
                  strand->isolated ? "no neighbors listed" : "no neighbor left", c.rejected, true);
    }
    const auto* e = in.picture.evidence<SeedEvidence>(Stage::Seed);
    if (e == nullptr) return;
    // Nearer neighbors are passed over: they are DONE.
    for (const Index q : in.model.points.neighbors[e->first]) {
        if (q == e->second) break;
        out.mark(in.at(q), Shape::Circle, c.done, 0.9F);
        out.label(in.at(q), "DONE", c.done);
    }
    out.line(in.at(e->first), in.at(e->second), c.used, 0.3F, Depth::OnTop);
    out.mark(in.at(e->second), Shape::RingedDisc, c.used, 1.1F);
    out.mark(in.at(e->first), Shape::RingedDisc, c.pivot, 1.3F);
    out.label(in.at(e->first), "start point", c.pivot, true);
    out.label(in.at(e->second), "nearest not DONE", c.used, true);
    out.label(0.5F * (in.at(e->first) + in.at(e->second)), "ring of two", c.used);
}

}  // namespace se::view
