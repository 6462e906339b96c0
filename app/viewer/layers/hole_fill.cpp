/// Beyond the paper (RobustRules::fill): a hole is closed by ears, the largest least angle first.
#include <algorithm>

#include "layer.h"
#include "run/number_format.h"

namespace se::view {

namespace {

/// The rim of the hole, bold.
void addHole(const LayerInput& in, const FillEvidence& e, DrawList& out) {
    const std::vector<RingPath>& rings = in.picture.rings;
    if (rings.empty() || !rings.front().active || rings.front().points.empty()) return;
    const std::vector<Index>& points = rings.front().points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.line(in.at(points[i]), in.at(points[(i + 1) % points.size()]), in.palette.last, 0.28F,
                 Depth::XRay);
    }
    // Away from the ear, which has labels of its own.
    const auto ear = std::find(points.begin(), points.end(), e.pivot) - points.begin();
    const std::size_t away = (static_cast<std::size_t>(ear) + points.size() / 2) % points.size();
    out.label(in.at(points[away]), "hole of " + std::to_string(e.ringLength), in.palette.last,
              true);
}

}  // namespace

void addHoleFill(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<FillEvidence>(Stage::Fill);
    if (e == nullptr || e->first == kNone || e->last == kNone) return;
    const Palette& c = in.palette;
    const glm::vec3& p = in.at(e->pivot);
    const glm::vec3& first = in.at(e->first);
    const glm::vec3& last = in.at(e->last);
    addHole(in, *e, out);
    out.sheet(p, first, last, c.test.withAlpha(0.25F));
    out.hatch(first, last, p, c.test, 9);
    out.line(first, last, c.test, 0.26F, Depth::OnTop);
    out.label(
        0.5F * (first + last),
        (e->forced ? "no ear without a fault: " : "best ear: ") + degreesText(e->leastDegrees),
        e->forced ? c.rejected : c.test, true);
}

}  // namespace se::view
