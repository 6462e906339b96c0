/// §6.4, Fig. 9: only first and last are left.
#include "overlap.h"

namespace se::view {

namespace {

/// The finished triangles that it would cover, outlined as a whole.
void addCovered(const LayerInput& in, const Overlap& overlap, DrawList& out) {
    for (const Triangle& t : overlap.covered) {
        for (const auto& [from, to] :
             {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
            out.dashed(in.at(from), in.at(to), in.palette.rejected, 0.09F, 0.25F);
        }
    }
}

}  // namespace

void addTwoPoint(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<TwoPointEvidence>(Stage::TwoPoint);
    const std::optional<Disc> disc = pivotDisc(in);
    if (e == nullptr || !disc || in.picture.last == kNone) return;
    const bool over = e->verdict == Verdict::Discarded;
    const Color& color = over ? in.palette.rejected : in.palette.test;
    const glm::vec3 p = in.at(in.picture.pivot);
    const glm::vec3 first = in.at(in.picture.first);
    const glm::vec3 last = in.at(in.picture.last);
    out.sheet(p, first, last, color.withAlpha(0.25F));
    out.hatch(first, last, p, color, 9);
    if (over) {
        const Triangle wouldBe{in.picture.pivot, in.picture.first, in.picture.last};
        const Overlap overlap = overlapOf(in, *disc, wouldBe);
        addOverlap(in, overlap, out);
        addCovered(in, overlap, out);
    }
    Line closing{first, last, color, 0.2F, over ? 0.35F : 0.0F, 0.0F, Depth::OnTop};
    out.lines.push_back(closing);
    const Arc arc{0.0, e->degrees, 0.75F * discRadius(in)};
    addArc(*disc, arc, color, 0.22F, out);
    // The half turn that the angle is compared with.
    out.dashed(disc->at(0.0, 1.3F * discRadius(in)), disc->at(180.0, 1.3F * discRadius(in)),
               in.palette.textDim, 0.08F);
    out.label(disc->at(180.0, 1.3F * discRadius(in)), "180\xC2\xB0", in.palette.textDim);
    out.label(disc->at(0.5 * e->degrees, arc.radius),
              degreesText(e->degrees) + (over ? " > 180\xC2\xB0" : " < 180\xC2\xB0"), color, true);
    out.label(0.5F * (first + last), over ? "overlap: dropped" : "hole: filled", color, true);
}

}  // namespace se::view
