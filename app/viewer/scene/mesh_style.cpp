#include "mesh_style.h"

#include <algorithm>
#include <array>

namespace se::view {

namespace {

constexpr std::array<MeshStyleRow, 6> kStyles = {{
    {MeshStyle::Faults, "faults", "Faults"},
    {MeshStyle::Flat, "flat", "Flat"},
    {MeshStyle::Shaded, "shaded", "Smooth"},
    {MeshStyle::Wire, "wire", "Edges only"},
    {MeshStyle::CreationOrder, "birth", "By creation order"},
    {MeshStyle::Component, "component", "By component"},
}};

}  // namespace

std::span<const MeshStyleRow> meshStyles() { return kStyles; }

const MeshStyleRow& rowOf(MeshStyle style) { return kStyles[static_cast<std::size_t>(style)]; }

std::optional<MeshStyle> meshStyleFromName(std::string_view name) {
    for (const MeshStyleRow& row : kStyles) {
        if (row.name == name) return row.id;
    }
    return std::nullopt;
}

MeshStyle following(MeshStyle style) {
    return static_cast<MeshStyle>((static_cast<std::size_t>(style) + 1) % kStyles.size());
}

MeshColoring meshColoring(MeshStyle style, const RunOverview& run, std::size_t known) {
    MeshColoring mesh;
    mesh.style = style;
    // A scale that is not used must not mark the picture as changed.
    if (style == MeshStyle::CreationOrder) {
        const std::size_t all = run.triangles.empty() ? 0 : run.triangles.back();
        mesh.creationEnd = std::max({std::size_t{1}, all, known});
    }
    if (style != MeshStyle::Component) return mesh;
    mesh.starts.push_back(0);
    for (const RunMark& mark : run.marks) {
        if (mark.kind != MarkKind::Seed || mark.pivot < 2) continue;
        const std::size_t before = mark.pivot - 2;
        // A seed without a triangle begins nothing.
        if (before < run.triangles.size() && run.triangles[before] > mesh.starts.back()) {
            mesh.starts.push_back(run.triangles[before]);
        }
    }
    return mesh;
}

Color componentColor(std::size_t component) {
    // Bit reversal, so that consecutive numbers are far apart on the scale.
    float share = 0.0F;
    float half = 0.5F;
    for (std::size_t rest = component + 1; rest > 0; rest /= 2, half /= 2.0F) {
        if (rest % 2 == 1) share += half;
    }
    return viridis(0.12F + 0.86F * share);
}

}  // namespace se::view
