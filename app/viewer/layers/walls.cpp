/// §7, Figs. 13 to 20: the walls that the pivot touches, and the third point that joins the ring.
#include <algorithm>
#include <array>
#include <bit>

#include "disc.h"
#include "spiraling_edge/geometry/triangle_shape.h"

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

/// Squares along the longer side of a wall.
constexpr float kGridSquares = 8.0F;

/// One face of the box of the points: the middle, and half its sides.
struct Wall {
    glm::vec3 middle{0.0F};
    std::array<glm::vec3, 2> half{};

    glm::vec3 at(float u, float v) const { return middle + u * half[0] + v * half[1]; }
};

/// The face that goes through `at`; points that lie in a plane have no box, so it gets some height.
Wall wallAt(const LayerInput& in, const glm::vec3& at, int face) {
    Wall wall{in.model.middle, {}};
    wall.middle[face % 3] = at[face % 3];
    for (std::size_t side = 0; side < 2; ++side) {
        const int axis = (face + 1 + static_cast<int>(side)) % 3;
        wall.half[side][axis] = std::max(in.model.boxHalf[axis], 2.0F * in.model.spacing);
    }
    return wall;
}

void addGrid(const Wall& wall, const Color& color, DrawList& out) {
    const float longest = std::max(glm::length(wall.half[0]), glm::length(wall.half[1]));
    for (std::size_t side = 0; side < 2; ++side) {
        const float share = glm::length(wall.half[side]) / longest;
        const auto squares = static_cast<int>(std::max(1.0F, std::round(kGridSquares * share)));
        for (int i = 1; i < squares; ++i) {
            const float t = 2.0F * static_cast<float>(i) / static_cast<float>(squares) - 1.0F;
            side == 0 ? out.line(wall.at(t, -1.0F), wall.at(t, 1.0F), color, 0.05F)
                      : out.line(wall.at(-1.0F, t), wall.at(1.0F, t), color, 0.05F);
        }
    }
}

/// A point on the edge of the wall that is closest to `at`, a little toward the middle; if that
/// is far away, on the way there.
glm::vec3 labelPosition(const LayerInput& in, const Wall& wall, const glm::vec3& at) {
    const float step = 2.2F * in.model.spacing;
    std::array<float, 2> place{};
    std::array<float, 2> length{};
    for (std::size_t side = 0; side < 2; ++side) {
        length[side] = glm::length(wall.half[side]);
        place[side] = glm::dot(at - wall.middle, wall.half[side]) / length[side];
    }
    // An edge that the point is on may belong to another wall as well.
    const auto toEdge = [&](std::size_t side, float sign) {
        const float way = length[side] - sign * place[side];
        return way > 1.5F * in.model.spacing ? way : 1e6F;
    };
    std::size_t across = 0;
    float sign = -1.0F;
    for (const auto& [side, direction] :
         {std::pair<std::size_t, float>{0, 1.0F}, {1, -1.0F}, {1, 1.0F}}) {
        if (toEdge(side, direction) < 0.99F * toEdge(across, sign)) {
            across = side;
            sign = direction;
        }
    }
    const std::size_t along = 1 - across;
    place[across] += sign * std::min(toEdge(across, sign), 5.0F * in.model.spacing);
    const float inward = place[along] > 0.0F ? -1.0F : 1.0F;
    place[along] += inward * std::min(step, std::abs(place[along]) + 0.5F * length[along]);
    return wall.at(place[0] / length[0], place[1] / length[1]);
}

/// The wall through `at` as a whole, for identification; its name is near p.
void addWall(const LayerInput& in, const glm::vec3& at, int face, DrawList& out) {
    const Wall wall = wallAt(in, at, face);
    const Color& color = in.palette.accent;
    const std::array corners = {wall.at(-1, -1), wall.at(1, -1), wall.at(1, 1), wall.at(-1, 1)};
    out.sheet(corners, color.withAlpha(0.14F));
    addGrid(wall, color.withAlpha(0.35F), out);
    out.loop(corners, color.withAlpha(0.8F), 0.08F, Depth::XRay);
    out.label(labelPosition(in, wall, in.at(in.picture.pivot)),
              std::string("wall ") + kFaceNames[static_cast<std::size_t>(face)], color, true);
}

/// The walls that a point touches, but for those of `drawn`.
void addWallsOf(const LayerInput& in, Index point, std::uint8_t drawn, DrawList& out) {
    const unsigned faces = in.model.points.type[point] & ~unsigned{drawn};
    for (int face = 0; face < 6; ++face) {
        if ((faces >> static_cast<unsigned>(face) & 1U) != 0) addWall(in, in.at(point), face, out);
    }
}

/// §7.1: the normal of p, the vector to the second point, their cross product and its
/// component toward the wall.
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

/// §7.1, Fig. 14: the triangle with which the unmodified neighbor ring would end, between the two
/// points beside p on the wall.
void addIncorrect(const LayerInput& in, const InsertEvidence& e, DrawList& out) {
    if (e.third == kNone) return;
    const Color& color = in.palette.rejected;
    const bool flat = isDegenerate(in.model.points, {e.pivot, e.third, e.other});
    out.hatch(in.at(e.pivot), in.at(e.third), in.at(e.other), color.withAlpha(0.8F));
    out.line(in.at(e.third), in.at(e.other), color, 0.5F, Depth::OnTop);
    const auto face = static_cast<int>(std::countr_zero(unsigned{e.faces}));
    out.label(
        in.at(e.pivot) + 0.6F * in.model.spacing * outwardOf(face),
        flat ? "unmodified ring: a triangle without area" : "unmodified ring: a triangle outside",
        color, true);
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
    out.label(0.5F * (p + q), before ? "+ before the pivot" : "+ after the pivot", c.test, true);
}

}  // namespace

void addWalls(const LayerInput& in, DrawList& out) {
    const Palette& c = in.palette;
    if (const auto* skip = in.picture.evidence<SkipEvidence>(Stage::Skip)) {
        // Refused third points are drawn below.
        if (in.picture.evidence<InsertEvidence>(Stage::Insert) == nullptr) {
            addWallsOf(in, skip->pivot, 0, out);
        }
        out.label(in.at(skip->pivot),
                  isRimPoint(skip->type) ? "on a rim: passed over" : "on a wall: passed over",
                  c.pivot, true);
    }
    const auto* e = in.picture.evidence<InsertEvidence>(Stage::Insert);
    if (e == nullptr) return;
    if (isRimPoint(e->faces)) {
        addChoice(in, *e, out);
        return;
    }
    addWallsOf(in, e->pivot, 0, out);
    addCandidatesOnWall(in, e->pivot, e->third, out);
    if (e->corner) {
        addWallsOf(in, e->other, in.model.points.type[e->pivot], out);
        out.arrow(in.at(e->pivot), in.at(e->other), c.used, 0.16F);
        out.label(in.middleOf(e->pivot, e->other), "across the corner", c.used);
    } else {
        addVectors(in, *e, out);
        addIncorrect(in, *e, out);
    }
    addChoice(in, *e, out);
}

}  // namespace se::view
