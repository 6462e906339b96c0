/// §6.1, Fig. 5: the next point on the ring beyond a convex start or end.
#include <cstdio>

#include "corner.h"

namespace se::view {

namespace {

/// Height of the point above the plane of the disc: the reason why the angle misleads.
void addStem(const LayerInput& in, const Disc& disc, Index point, DrawList& out) {
    const Color& color = in.palette.rejected;
    const glm::vec3 at = in.at(point);
    const glm::vec3 foot = disc.foot(at);
    out.line(at, foot, color, 0.14F, Depth::OnTop);
    out.mark(foot, Shape::Dot, color, 0.4F);
    out.dashed(disc.origin, foot, color.withAlpha(0.7F), 0.06F, 0.2F);
    const double height = glm::dot(at - disc.origin, disc.normal) / in.model.scale;
    char text[48];
    std::snprintf(text, sizeof text, "height %+.3g", height);
    out.label(0.5F * (at + foot), text, color);
}

}  // namespace

void addConvexity(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<DropEvidence>(Stage::Convex);
    const std::optional<Disc> disc = pivotDisc(in);
    if (e == nullptr || !disc) return;
    const bool start = e->side == Side::Start;
    const Index p = in.picture.pivot;
    const Index limit = start ? in.picture.start : in.picture.end;
    addCorner(in, {start ? e->point : p, limit, start ? p : e->point, false}, out);
    addStem(in, *disc, e->point, out);
    // The path along the ring, against the straight spoke.
    out.dashed(in.at(p), in.at(limit), in.palette.used, 0.22F, 0.16F);
    out.dashed(in.at(limit), in.at(e->point), in.palette.used, 0.22F, 0.16F);
    out.label(0.5F * (in.at(limit) + in.at(e->point)), "along the ring", in.palette.used, true);
    out.label(0.5F * (in.at(p) + in.at(e->point)), "straight: removed", in.palette.rejected, true);
}

}  // namespace se::view
