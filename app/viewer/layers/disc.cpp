#include "disc.h"

#include <algorithm>

namespace se::view {

namespace {

int partsOf(const Arc& arc) {
    return std::clamp(static_cast<int>(std::abs(arc.to - arc.from) / 6.0), 2, 60);
}

double partOf(const Arc& arc, int i, int parts) {
    return arc.from + (arc.to - arc.from) * i / parts;
}

/// Lines for every `step`-th of equal parts of an arc.
void addParts(const Disc& disc, const Arc& arc, int parts, int step, const Color& color,
              float width, DrawList& out) {
    for (int i = 0; i < parts; i += step) {
        out.line(disc.at(partOf(arc, i, parts), arc.radius),
                 disc.at(partOf(arc, i + 1, parts), arc.radius), color, width, Depth::OnTop);
    }
}

}  // namespace

const Color& verdictColor(Verdict verdict, const Palette& palette) {
    return isTaken(verdict) ? palette.used : palette.rejected;
}

void addVerdict(Verdict verdict, const glm::vec3& at, const Palette& palette, DrawList& out) {
    out.label(at, std::string(verdictText(verdict)), verdictColor(verdict, palette), true);
}

std::optional<Disc> discAt(const LayerInput& in, Index point, Index first) {
    if (point == kNone || first == kNone) return std::nullopt;
    Disc disc;
    disc.origin = in.at(point);
    disc.normal = in.model.normal[point];
    const glm::vec3 toFirst = in.at(first) - disc.origin;
    const glm::vec3 flat = toFirst - disc.normal * glm::dot(toFirst, disc.normal);
    if (glm::length(flat) < 1e-9F) return std::nullopt;
    disc.zero = glm::normalize(flat);
    disc.quarter = glm::cross(disc.normal, disc.zero);
    return disc;
}

std::optional<Disc> pivotDisc(const LayerInput& in) {
    return discAt(in, in.picture.pivot, in.picture.first);
}

void addArc(const Disc& disc, const Arc& arc, const Color& color, float width, DrawList& out) {
    addParts(disc, arc, partsOf(arc), 1, color, width, out);
}

void addDashedArc(const Disc& disc, const Arc& arc, const Color& color, float width,
                  DrawList& out) {
    addParts(disc, arc, 2 * partsOf(arc) + 1, 2, color, width, out);
}

void addSectorSheet(const Disc& disc, const Arc& arc, const Color& color, DrawList& out) {
    const int parts = partsOf(arc);
    for (int i = 0; i < parts; ++i) {
        out.sheet(disc.origin, disc.at(partOf(arc, i, parts), arc.radius),
                  disc.at(partOf(arc, i + 1, parts), arc.radius), color);
    }
}

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
