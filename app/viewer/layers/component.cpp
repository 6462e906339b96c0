/// §3, §7: a component is complete, or a ring was freed along the rim of the surface.
#include <algorithm>

#include "layer.h"

namespace se::view {

namespace {

/// The freed ring, bold: an open border, or in the color of errors if it should not be open.
void addFreedRing(const LayerInput& in, const ShownFreedRing& ring, bool named, DrawList& out) {
    const std::vector<Index>& points = ring.path.points;
    if (points.empty()) return;
    const Color& color = ring.alert ? in.palette.rejected : in.palette.last;
    // Errors must not be hidden by correct parts.
    const Depth depth = ring.alert ? Depth::OnTop : Depth::XRay;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec3& from = in.at(points[i]);
        const glm::vec3& to = in.at(points[(i + 1) % points.size()]);
        // A step that is no mesh edge bounds nothing.
        ring.path.open[i] ? out.dashed(from, to, color, 0.2F, 0.3F)
                          : out.line(from, to, color, 0.36F, depth);
    }
    if (!named) return;
    std::string text = "ring of " + std::to_string(points.size()) + " freed";
    if (!ring.told) text = "a ring of " + std::to_string(points.size()) + " is freed";
    if (ring.alert == AlertKind::Hole) text += ": a hole stays open";
    if (ring.alert == AlertKind::LostSeed) text += ": its seed got no triangle";
    out.label(in.at(points.front()), text, color, true);
}

}  // namespace

void addComponent(const LayerInput& in, DrawList& out) {
    const auto* e = in.picture.evidence<ComponentEvidence>(Stage::Done);
    if (in.picture.freed) addFreedRing(in, *in.picture.freed, e == nullptr, out);
    if (e == nullptr) return;
    const std::size_t end = e->triangles;
    // Where colors show components, or the creation order, it has its color.
    if (in.mesh.style < MeshStyle::CreationOrder && in.picture.repaired == nullptr) {
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
