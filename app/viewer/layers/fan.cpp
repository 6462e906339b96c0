/// §6.4: the triangles of the fan, one by one, numbered and with their turn (Fig. 10), or the only
/// one of first and last (Fig. 9).
#include "disc.h"
#include "scene/selection_measures.h"

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
    for (const Triangle& t : overlap.covered) {
        for (const auto& [from, to] :
             {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
            out.dashed(in.at(from), in.at(to), in.palette.rejected, 0.09F, 0.25F);
        }
    }
}

/// Against the half turn, as it is shown.
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

}  // namespace se::view
