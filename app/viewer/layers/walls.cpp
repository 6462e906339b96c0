/// §7, Figs. 13 to 20: the walls that the pivot touches, and the third point that joins the ring.
#include <algorithm>
#include <array>

#include "disc.h"

namespace se::view {

namespace {

constexpr std::array<const char*, 6> kFaceNames = {
    "+x", "+y", "+z", "\xE2\x88\x92x", "\xE2\x88\x92y", "\xE2\x88\x92z"};

/// Outward direction of one of the six faces, in the order of their bits.
glm::vec3 outwardOf(int face) {
    glm::vec3 out(0.0F);
    out[face % 3] = face < 3 ? 1.0F : -1.0F;
    return out;
}

/// A part of a wall around the pivot.
void addWall(const LayerInput& in, const glm::vec3& at, int face, DrawList& out) {
    const float half = 2.6F * in.model.spacing;
    glm::vec3 u(0.0F);
    glm::vec3 v(0.0F);
    u[(face + 1) % 3] = half;
    v[(face + 2) % 3] = half;
    const std::array corners = {at - u - v, at + u - v, at + u + v, at - u + v};
    out.sheet(corners[0], corners[1], corners[2], in.palette.accent.withAlpha(0.16F));
    out.sheet(corners[0], corners[2], corners[3], in.palette.accent.withAlpha(0.16F));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        out.line(corners[i], corners[(i + 1) % 4], in.palette.accent.withAlpha(0.7F), 0.06F,
                 Depth::OnTop);
    }
    out.label(0.55F * corners[2] + 0.45F * at,
              std::string("wall ") + kFaceNames[static_cast<std::size_t>(face)],
              in.palette.textDim);
}

void addWallsOf(const LayerInput& in, Index point, DrawList& out) {
    const std::uint8_t type = in.model.points.type[point];
    for (int face = 0; face < 6; ++face) {
        if ((type >> static_cast<unsigned>(face) & 1U) != 0) addWall(in, in.at(point), face, out);
    }
}

/// §7.1: the normal of p, the vector to the second point, their cross product and the component of
/// it that the wall looks at.
void addVectors(const LayerInput& in, const InsertEvidence& e, DrawList& out) {
    const float length = 1.5F * in.model.spacing;
    const glm::vec3 p = in.at(e.pivot);
    const Palette& c = in.palette;
    const glm::vec3 cross(e.cross);
    const glm::vec3 across = glm::length(cross) > 0.0F ? length * glm::normalize(cross) : cross;
    out.arrow(p, in.at(e.other), c.used, 0.14F);
    out.label(p + 0.6F * (in.at(e.other) - p), "v", c.used);
    out.arrow(p, p + length * in.model.normal[e.pivot], c.unused, 0.12F);
    out.label(p + length * in.model.normal[e.pivot], "N", c.unused);
    out.arrow(p, p + across, c.pivot, 0.14F);
    out.label(p + across, "N \xC3\x97 v", c.pivot, true);
    for (int face = 0; face < 6; ++face) {
        if ((e.faces >> static_cast<unsigned>(face) & 1U) == 0) continue;
        const glm::vec3 axis = outwardOf(face);
        const float component = glm::dot(across, axis);
        const glm::vec3 tip = p + component * axis;
        out.line(p, tip, c.test, 0.22F, Depth::OnTop);
        out.dashed(tip, p + across, c.test, 0.06F);
        out.label(0.5F * (p + tip), component > 0.0F ? "outward" : "inward", c.test);
    }
}

void addCandidatesOnWall(const LayerInput& in, Index pivot, Index chosen, DrawList& out) {
    const PointSet& points = in.model.points;
    for (const Index q : points.neighbors[pivot]) {
        const bool free = in.picture.status[q] == kUnused || q == chosen;
        if (!free || !shareFace(points.type[pivot], points.type[q])) continue;
        out.mark(in.at(q), Shape::Circle, in.palette.test, 1.05F);
    }
}

void addChoice(const LayerInput& in, const InsertEvidence& e, DrawList& out) {
    const Palette& c = in.palette;
    const glm::vec3 p = in.at(e.pivot);
    if (e.third == kNone) {
        out.label(p, std::string(verdictText(e.verdict)), c.rejected, true);
        return;
    }
    const bool before = e.verdict == Verdict::Before;
    const glm::vec3 q = in.at(e.third);
    out.arrow(before ? q : p, before ? p : q, c.test, 0.2F);
    out.mark(0.5F * (p + q), Shape::Disc, c.test, 0.5F);
    out.label(0.5F * (p + q), before ? "+ before p" : "+ after p", c.test, true);
}

}  // namespace

void addWalls(const LayerInput& in, DrawList& out) {
    const Palette& c = in.palette;
    if (const auto* skip = in.picture.evidence<SkipEvidence>(Stage::Skip)) {
        addWallsOf(in, skip->pivot, out);
        out.label(in.at(skip->pivot), "on a wall: passed over", c.pivot, true);
    }
    const auto* e = in.picture.evidence<InsertEvidence>(Stage::Insert);
    if (e == nullptr) return;
    addWallsOf(in, e->pivot, out);
    addCandidatesOnWall(in, e->pivot, e->third, out);
    if (e->corner) {
        addWallsOf(in, e->other, out);
        out.arrow(in.at(e->pivot), in.at(e->other), c.used, 0.16F);
        out.label(0.5F * (in.at(e->pivot) + in.at(e->other)), "across the corner", c.used);
    } else {
        addVectors(in, *e, out);
    }
    addChoice(in, *e, out);
}

}  // namespace se::view
