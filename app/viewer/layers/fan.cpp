/// §6.4: the triangles of the fan, one by one, numbered and with their turn (Fig. 10), or the only
/// one of first and last (Fig. 9).

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "disc.h"
#include "run/selection.h"
#include "scene/screen_rect.h"

namespace se::view {

namespace {

/// An arrow round the middle of a triangle, in the order of its corners.
void addTurn(const LayerInput& in, const Triangle& t, float inner, DrawList& out) {
    const glm::vec3 middle = in.middleOf(t);
    const auto near = [&](Index corner) { return middle + inner * (in.at(corner) - middle); };
    const Color color = in.palette.text;
    out.line(near(t.a), near(t.b), color, 0.1F, Depth::OnTop);
    out.arrow(near(t.b), near(t.c), color, 0.1F, 0.5F);
}

/// The finished triangles that it would cover, outlined as a whole.
void addCovered(const LayerInput& in, const Overlap& overlap, DrawList& out) {
    for (const Triangle& t : overlap.covered)
        out.loop(in.cornersOf(t), in.palette.rejected, 0.09F, Depth::OnTop, 0.25F);
}

/// The comparison with a half turn, as it is shown.
const char* comparedWithHalfTurn(double degrees) {
    return degrees > 180.0   ? " > 180\xC2\xB0"
           : degrees < 180.0 ? " < 180\xC2\xB0"
                             : " = 180\xC2\xB0";
}

/// The effect on the triangle.
std::string twoPointText(const TwoPointEvidence& e) {
    if (e.verdict == Verdict::Discarded) return "overlap: dropped";
    if (e.verdict != Verdict::Hole) return std::string(verdictText(e.verdict));
    return e.degrees > 180.0 ? "made anyway" : "hole: filled";
}

}  // namespace

void addFan(const LayerInput& in, DrawList& out) {
    const std::vector<Triangle>& fresh = in.picture.newTriangles;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        const Triangle& t = fresh[i];
        const glm::vec3 middle = in.middleOf(t);
        const glm::vec3 across = in.acrossOf(t);
        if (!(glm::length(across) > 0.0F)) continue;
        addTurn(in, t, 0.62F, out);
        out.line(middle, middle + 0.45F * in.model.spacing * glm::normalize(across),
                 in.palette.test, 0.12F, Depth::OnTop);
        const bool newest = i + 1 == fresh.size();
        out.label(middle, std::to_string(i + 1), newest ? in.palette.text : in.palette.test, true);
        if (newest) {
            out.label(in.middleOf(t.b, t.c),
                      "least angle " + degreesText(leastDegrees(in.model.points, t)),
                      in.palette.test);
        }
    }
    if (fresh.empty() || in.picture.pivot == kNone) return;
    out.loop(in.cornersOf(fresh.back()), in.palette.test, 0.2F);
}

void addTwoPoint(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<TwoPointEvidence>(Stage::TwoPoint);
    const std::optional<Disc> disc = pivotDisc(in);
    if (e == nullptr || !disc || in.picture.last == kNone) return;
    const bool made = isTaken(e->verdict);
    const Color& color = made ? in.palette.test : in.palette.rejected;
    const glm::vec3 p = in.at(in.picture.pivot);
    const glm::vec3 first = in.at(in.picture.first);
    const glm::vec3 last = in.at(in.picture.last);
    out.sheet(p, first, last, color.withAlpha(0.25F));
    out.hatch(first, last, p, color, 9);
    if (!made) {
        const Overlap overlap =
            overlapOf(in, *disc, {in.picture.pivot, in.picture.first, in.picture.last});
        addOverlap(in, overlap, out);
        addCovered(in, overlap, out);
    }
    out.dashed(first, last, color, 0.2F, made ? 0.0F : 0.35F);
    const Arc arc{0.0, e->degrees, 0.75F * discRadius(in)};
    addArc(*disc, arc, color, 0.22F, out);
    // The half turn that the angle is compared with.
    out.dashed(disc->at(0.0, 1.3F * discRadius(in)), disc->at(180.0, 1.3F * discRadius(in)),
               in.palette.textDim, 0.08F);
    out.label(disc->at(180.0, 1.3F * discRadius(in)), "180\xC2\xB0", in.palette.textDim);
    out.label(disc->at(0.5 * e->degrees, arc.radius),
              degreesText(e->degrees) + comparedWithHalfTurn(e->degrees), color, true);
    out.label(0.5F * (first + last), twoPointText(*e), color, true);
}

// Beyond the paper (docs/robust.md): the objection of a rule to the whole fan.

namespace {

/// An angle at the pivot from a to b, against its limit.
void addWidth(const LayerInput& in, const Disc& disc, const GuardEvidence& e, double limit,
              DrawList& out) {
    const Palette& c = in.palette;
    const double from = degreesOn(disc, in.at(e.a));
    double to = degreesOn(disc, in.at(e.b));
    if (to <= from) to += 360.0;
    const float radius = discRadius(in);
    addArc(disc, {from, to, radius}, c.rejected, 0.26F, out);
    out.line(disc.at(from + limit, 0.85F * radius), disc.at(from + limit, 1.15F * radius), c.text,
             0.12F, Depth::OnTop);
    out.label(
        disc.at(0.5 * (from + to), radius),
        degreesText(to - from) + (to - from > limit ? " > " : ", limit ") + degreesText(limit),
        c.rejected, true);
}

/// The normal of the triangle and those of its corners, from which it deviates too much.
void addTilt(const LayerInput& in, const Triangle& t, double limit, DrawList& out) {
    const Palette& c = in.palette;
    const glm::vec3 across = in.acrossOf(t);
    if (!(glm::length(across) > 0.0F)) return;
    const float length = 1.1F * in.model.spacing;
    const glm::vec3 middle = in.middleOf(t);
    const glm::vec3 tip = middle + length * glm::normalize(across);
    out.arrow(middle, tip, c.rejected, 0.16F);
    for (const Index corner : {t.a, t.b, t.c}) {
        out.arrow(in.at(corner), in.at(corner) + length * in.model.normal[corner], c.unused, 0.1F);
    }
    out.label(
        tip,
        degreesText(tiltDegrees(in.model.points, t)) + " off a normal, limit " + degreesText(limit),
        c.rejected, true);
}

/// Edges of the triangle that a finished one has already, in the same direction.
void addTaken(const LayerInput& in, const Triangle& t, DrawList& out) {
    if (in.meshIndex == nullptr) return;
    const auto passes = [](const Triangle& old, Index from, Index to) {
        return (old.a == from && old.b == to) || (old.b == from && old.c == to) ||
               (old.c == from && old.a == to);
    };
    const std::size_t count = std::min(in.picture.finishedTriangles, in.triangles.size());
    for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
        for (const std::uint32_t number : in.meshIndex->atEdge(in.triangles, from, to)) {
            if (number >= count || !passes(in.triangles[number], from, to)) continue;
            out.line(in.at(from), in.at(to), in.palette.rejected, 0.34F, Depth::OnTop);
            out.label(in.middleOf(from, to), "taken", in.palette.rejected);
        }
    }
}

void addTriangle(const LayerInput& in, const Disc& disc, const GuardEvidence& e, const Color& color,
                 DrawList& out) {
    const Triangle t{in.picture.pivot, e.a, e.b};
    out.sheet(in.at(t.a), in.at(t.b), in.at(t.c), color.withAlpha(0.22F));
    out.hatch(in.at(t.b), in.at(t.c), in.at(t.a), color, 9);
    out.dashed(in.at(t.b), in.at(t.c), color, 0.2F, 0.35F);
    const RobustThresholds& thresholds = in.model.params.thresholds;
    const auto is = [&](Verdict verdict) { return e.verdict == verdict; };
    if (is(Verdict::WideGap)) addWidth(in, disc, e, 180.0, out);
    if (is(Verdict::OverRim)) addWidth(in, disc, e, degreesOf(thresholds.rimAngleCosine), out);
    if (is(Verdict::Steep)) addTilt(in, t, degreesOf(thresholds.steepCosine), out);
    if (is(Verdict::AgainstNormal)) addTilt(in, t, 90.0, out);
    if (is(Verdict::EdgeTaken)) addTaken(in, t, out);
    if (is(Verdict::Crosses) || is(Verdict::Meets) || is(Verdict::FoldsOver))
        addOverlap(in, overlapOf(in, disc, t), out);
}

}  // namespace

void addGuard(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<GuardEvidence>(Stage::Guard);
    const std::optional<Disc> disc = pivotDisc(in);
    if (e == nullptr || !disc) return;
    // A what-if without an objection.
    if (e->a == kNone) return addVerdict(e->verdict, disc->origin, in.palette, out);
    const Color& color = verdictColor(e->verdict, in.palette);
    if (e->b == kNone) {
        out.dashed(disc->origin, in.at(e->a), color, 0.26F, 0.35F);
    } else {
        addTriangle(in, *disc, *e, color, out);
    }
    const glm::vec3 far = e->b == kNone ? in.at(e->a) : in.middleOf(e->a, e->b);
    out.label(far,
              std::string(verdictText(e->verdict)) +
                  (isTaken(e->verdict)   ? ""
                   : e->dropped == kNone ? ": fan refused"
                                         : ": " + std::to_string(e->dropped) + " dropped"),
              color, true);
}

// The possible triangle and the finished triangles around its corners are projected into the plane
// of a disc and intersected there as convex polygons (scene/screen_rect.h). Every piece is lifted
// back onto the possible triangle for drawing.

namespace {

/// Parts smaller than this share of the triangle are caused by the bend of the surface alone.
constexpr float kSliverShare = 0.01F;

using Corners = std::array<glm::vec2, 3>;

/// A triangle in the plane of a disc, counterclockwise.
struct Flat {
    Corners corners{};
    std::array<glm::vec3, 3> places{};
    float area = 0.0F;

    /// The point in the triangle above or below one in the plane.
    glm::vec3 lifted(const glm::vec2& at) const {
        std::array<float, 3> weight{};
        for (std::size_t i = 0; i < 3; ++i) {
            weight[i] = areaOf(Corners{at, corners[(i + 1) % 3], corners[(i + 2) % 3]}) / area;
        }
        return weight[0] * places[0] + weight[1] * places[1] + weight[2] * places[2];
    }
};

Flat flatten(const LayerInput& in, const Disc& disc, const Triangle& t) {
    Flat flat;
    flat.places = in.cornersOf(t);
    const auto fill = [&] {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3 offset = flat.places[i] - disc.origin;
            flat.corners[i] = {glm::dot(offset, disc.zero), glm::dot(offset, disc.quarter)};
        }
        flat.area = areaOf(flat.corners);
    };
    fill();
    if (flat.area < 0.0F) {
        std::swap(flat.places[1], flat.places[2]);
        fill();
    }
    return flat;
}

/// The finished triangles around the corners of a triangle.
std::set<std::uint32_t> finishedAbout(const LayerInput& in, const Triangle& t) {
    std::set<std::uint32_t> found;
    if (in.meshIndex == nullptr || in.picture.repaired) return found;
    const std::size_t count = std::min(in.picture.finishedTriangles, in.triangles.size());
    const auto look = [&](Index point) {
        in.meshIndex->forEachAt(point, [&](std::uint32_t triangle) {
            if (triangle < count) found.insert(triangle);
        });
    };
    for (const Index corner : {t.a, t.b, t.c}) {
        look(corner);
        for (const Index q : in.model.points.neighbors[corner]) look(q);
    }
    return found;
}

/// A triangle on the other side of a thin object is not in the way.
bool facesDisc(const LayerInput& in, const Disc& disc, const Triangle& t) {
    return glm::dot(in.acrossOf(t), disc.normal) > 0.0F;
}

}  // namespace

Overlap overlapOf(const LayerInput& in, const Disc& disc, const Triangle& wouldBe) {
    Overlap overlap;
    const Flat window = flatten(in, disc, wouldBe);
    if (!(window.area > 0.0F)) return overlap;
    for (const std::uint32_t number : finishedAbout(in, wouldBe)) {
        const Triangle& t = in.triangles[number];
        if (!facesDisc(in, disc, t)) continue;
        const std::vector<glm::vec2> part =
            clipConvex(flatten(in, disc, t).corners, window.corners);
        const float share = part.empty() ? 0.0F : areaOf(part) / window.area;
        if (share < kSliverShare) continue;
        overlap.covered.push_back(t);
        overlap.parts.emplace_back();
        glm::vec3 middle(0.0F);
        for (const glm::vec2& at : part) {
            overlap.parts.back().push_back(window.lifted(at));
            middle += overlap.parts.back().back() / static_cast<float>(part.size());
        }
        overlap.share += share;
        overlap.middle += share / overlap.share * (middle - overlap.middle);
    }
    return overlap;
}

void addOverlap(const LayerInput& in, const Overlap& overlap, DrawList& out) {
    if (overlap.parts.empty()) return;
    const Color& color = in.palette.rejected;
    for (const std::vector<glm::vec3>& part : overlap.parts) {
        for (std::size_t i = 1; i + 1 < part.size(); ++i) {
            out.sheets.push_back({{part[0], part[i], part[i + 1]}, color.withAlpha(0.8F), true});
        }
        out.loop(part, color, 0.1F);
    }
}

}  // namespace se::view
