#include "mesh_style.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spiraling_edge/base/lists.h"

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
constexpr std::array<PointTintRow, 2> kTints = {{
    {PointTint::Status, "status", "By status"},
    {PointTint::Margin, "margin", "By least margin"},
}};

template <typename Id, std::size_t N>
std::optional<Id> idOf(const std::array<StyleRow<Id>, N>& rows, std::string_view name) {
    const StyleRow<Id>* row = findNamed(rows, name);
    return row != nullptr ? std::optional(row->id) : std::nullopt;
}

}  // namespace

std::span<const MeshStyleRow> meshStyles() { return kStyles; }

const MeshStyleRow& rowOf(MeshStyle style) { return kStyles[static_cast<std::size_t>(style)]; }

std::optional<MeshStyle> meshStyleFromName(std::string_view name) { return idOf(kStyles, name); }

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

std::span<const PointTintRow> pointTints() { return kTints; }

const PointTintRow& rowOf(PointTint tint) { return kTints[static_cast<std::size_t>(tint)]; }

std::optional<PointTint> pointTintFromName(std::string_view name) { return idOf(kTints, name); }

std::optional<std::size_t> marginStep(double margin) {
    if (!std::isfinite(margin)) return std::nullopt;
    std::size_t step = 0;
    double limit = 1e-6;
    while (step + 1 < kMarginSteps && std::abs(margin) >= limit) {
        ++step;
        limit *= 10.0;
    }
    return step;
}

Color marginColor(std::size_t step, Theme theme) {
    const float share = static_cast<float>(step) / static_cast<float>(kMarginSteps - 1);
    // The end that is close to the background color is left out, so that points with large margins
    // stay visible.
    return viridis(theme == Theme::Dark ? 1.0F - 0.68F * share : 0.72F * share);
}

std::string marginStepText(std::size_t step) {
    if (step == 0) return "< 1e-6";
    constexpr int kFirstDecade = -6;  // Of the first step but one.
    const int decade = kFirstDecade + static_cast<int>(step) - 1;
    return decade >= -1 ? "0.1" : "1e" + std::to_string(decade);
}

}  // namespace se::view
