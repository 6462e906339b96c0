/// §3, §7: a component is complete, or a ring was freed along the rim of the surface.
#include <algorithm>

#include "layer.h"

namespace se::view {

namespace {

void addFreedRing(const LayerInput& in, const FreeEvidence& e, DrawList& out) {
    if (in.picture.oldRings.empty() || !in.picture.oldRings.front().active) return;
    const std::vector<Index>& points = in.picture.oldRings.front().points;
    if (points.empty()) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.dashed(in.at(points[i]), in.at(points[(i + 1) % points.size()]), in.palette.last, 0.26F,
                   0.6F, Depth::XRay);
    }
    out.label(in.at(points.front()), "ring of " + std::to_string(e.length) + " freed",
              in.palette.last, true);
}

}  // namespace

void addComponent(const LayerInput& in, DrawList& out) {
    if (const auto* freed = in.picture.evidence<FreeEvidence>(Stage::Done)) {
        addFreedRing(in, *freed, out);
    }
    const auto* e = in.picture.evidence<ComponentEvidence>(Stage::Done);
    if (e == nullptr) return;
    const std::size_t end = e->triangles;
    // Where colors tell components, or the order of birth, it has its color.
    if (in.mesh.style < MeshStyle::BirthOrder && in.picture.mended == nullptr) {
        const Color tint = mix(in.palette.mesh, in.palette.used, 0.55F);
        out.meshStretches.push_back({std::min(in.componentBegin, end), tint});
        out.meshStretches.push_back({end, out.meshColor});
    }
    if (in.component == nullptr) return;
    for (const auto& [from, to] : in.component->rim) {
        out.line(in.at(from), in.at(to), in.palette.last, 0.26F, Depth::XRay);
    }
    out.label(in.component->middle,
              "component " + std::to_string(e->component) + ": " +
                  std::to_string(in.component->end - in.component->begin) + " triangles",
              in.palette.text, true);
}

}  // namespace se::view
