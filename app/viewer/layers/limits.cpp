/// §6.1, Fig. 4: start and end advance along the ring.
#include "corner.h"

namespace se::view {

namespace {

void addMove(const LayerInput& in, const LimitEvidence& e, DrawList& out) {
    const Palette& c = in.palette;
    const bool start = e.side == Side::Start;
    const Color& color = start ? c.first : c.last;
    if (!e.moves()) {
        out.dashed(in.at(e.from), in.at(e.to), c.rejected, 0.12F);
        out.label(in.at(e.to), std::string(verdictText(e.verdict)), c.rejected, true);
        return;
    }
    out.arrow(in.at(e.from), in.at(e.to), color, 0.24F, 0.8F);
    out.label(0.5F * (in.at(e.from) + in.at(e.to)), start ? "S moves here" : "E moves here", color,
              true);
    // The lost part of the range is dotted, outside of the remaining part.
    if (const std::optional<Disc> disc = pivotDisc(in)) {
        addDashedArc(*disc, {e.fromDegrees, e.toDegrees, 1.12F * discRadius(in)}, c.textDim, 0.12F,
                     out);
    }
}

}  // namespace

void addLimits(const LayerInput& in, DrawList& out) {
    if (const auto* drop = in.picture.evidence<DropEvidence>(Stage::Limits)) {
        const bool start = drop->side == Side::Start;
        if (drop->isLimit()) {
            out.label(in.at(drop->point), start ? "now start" : "now end",
                      start ? in.palette.first : in.palette.last, true);
        } else {
            out.label(in.at(drop->point), "outside now", in.palette.rejected, true);
        }
    }
    const auto* e = in.picture.evidence<LimitEvidence>(Stage::Limits);
    if (e == nullptr || e->to == kNone) return;
    const bool start = e->side == Side::Start;
    const Index p = in.picture.pivot;
    // The turn is known if the test went that far.
    const bool looked = e->verdict != Verdict::OtherLimit && e->verdict != Verdict::NotAnEdge;
    if (looked) {
        addCorner(in, {start ? e->to : p, e->from, start ? p : e->to, e->turn > 0.0}, out);
    }
    addMove(in, *e, out);
}

}  // namespace se::view
