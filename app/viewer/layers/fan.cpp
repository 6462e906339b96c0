/// §6.4, Fig. 10: the triangles of the fan, one by one, numbered and with their turn.
#include "disc.h"
#include "scene/selection_measures.h"

namespace se::view {

namespace {

/// An arrow round the middle of a triangle, in the order of its corners.
void addTurn(const LayerInput& in, const Triangle& t, float inner, DrawList& out) {
    const glm::vec3 middle = (in.at(t.a) + in.at(t.b) + in.at(t.c)) / 3.0F;
    const auto near = [&](Index corner) { return middle + inner * (in.at(corner) - middle); };
    const Color color = in.palette.text;
    out.line(near(t.a), near(t.b), color, 0.1F, Depth::OnTop);
    out.arrow(near(t.b), near(t.c), color, 0.1F, 0.5F);
}

}  // namespace

void addFan(const LayerInput& in, DrawList& out) {
    const std::vector<Triangle>& fresh = in.picture.newTriangles;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        const Triangle& t = fresh[i];
        const glm::vec3 a = in.at(t.a);
        const glm::vec3 middle = (a + in.at(t.b) + in.at(t.c)) / 3.0F;
        const glm::vec3 across = glm::cross(in.at(t.b) - a, in.at(t.c) - a);
        if (!(glm::length(across) > 0.0F)) continue;
        addTurn(in, t, 0.62F, out);
        out.line(middle, middle + 0.45F * in.model.spacing * glm::normalize(across),
                 in.palette.test, 0.12F, Depth::OnTop);
        const bool newest = i + 1 == fresh.size();
        out.label(middle, std::to_string(i + 1), newest ? in.palette.text : in.palette.test, true);
        if (newest) {
            out.label(0.5F * (in.at(t.b) + in.at(t.c)),
                      "least angle " + degreesText(leastDegrees(in.model.points, t)),
                      in.palette.test);
        }
    }
    if (fresh.empty() || in.picture.pivot == kNone) return;
    const Triangle& t = fresh.back();
    for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
        out.line(in.at(from), in.at(to), in.palette.test, 0.2F, Depth::OnTop);
    }
}

}  // namespace se::view
