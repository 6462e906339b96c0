#include "corner.h"

namespace se::view {

double degreesOn(const Disc& disc, const glm::vec3& place) {
    const glm::vec3 offset = place - disc.origin;
    const double angle =
        glm::degrees(std::atan2(glm::dot(offset, disc.quarter), glm::dot(offset, disc.zero)));
    return angle < 0.0 ? angle + 360.0 : angle;
}

void addCorner(const LayerInput& in, const RingCorner& corner, DrawList& out) {
    const std::optional<Disc> disc = discAt(in, corner.point, corner.before);
    if (!disc || corner.after == kNone) return;
    const Color& color = corner.concave ? in.palette.used : in.palette.rejected;
    const Arc arc{0.0, degreesOn(*disc, in.at(corner.after)), 0.5F * in.model.spacing};
    if (corner.concave) {
        addSectorSheet(*disc, arc, color.withAlpha(0.55F), out);
        addArc(*disc, arc, color, 0.12F, out);
    } else {
        addDashedArc(*disc, arc, color, 0.12F, out);
    }
    for (const double side : {arc.from, arc.to}) {
        out.line(disc->origin, disc->at(side, arc.radius), color, 0.1F, Depth::OnTop);
    }
    out.label(disc->at(0.5 * arc.to, 0.7F * arc.radius),
              (corner.concave ? "concave " : "convex ") + degreesText(arc.to), color, true);
}

}  // namespace se::view
