/// The user's selection: an edge or a triangle, and highlighted points.
#include <algorithm>

#include "layer.h"

namespace se::view {

namespace {

/// Strength of the tint on a selected triangle.
constexpr float kSelectionTint = 0.42F;
/// Number of highlighted points whose marks are large enough to find each.
constexpr std::size_t kLargeMarks = 500;
/// Number of highlighted points up to which they are named.
constexpr std::size_t kNamedMarks = 24;

}  // namespace

/// The selected edge or triangle: outlined over everything else; dashed if it is not present
/// at the cursor. Points have their circle with the labels.
void addSelection(const LayerInput& in, DrawList& out) {
    const std::span<const Index> corners = in.selection.corners();
    if (corners.size() < 2) return;
    const bool triangle = in.selection.kind == SelectionKind::Triangle;
    const std::size_t sides = triangle ? 3 : 1;
    for (std::size_t i = 0; i < sides; ++i) {
        out.dashed(in.at(corners[i]), in.at(corners[(i + 1) % corners.size()]), in.palette.text,
                   triangle ? 0.2F : 0.3F, in.selectionPresent ? 0.0F : 0.35F);
    }
    for (const Index p : corners) out.mark(in.at(p), Shape::Square, in.palette.text, 0.55F);
    if (!triangle) return;
    const float tint = in.selectionPresent ? kSelectionTint : 0.5F * kSelectionTint;
    out.sheet(in.at(corners[0]), in.at(corners[1]), in.at(corners[2]),
              in.palette.accent.withAlpha(tint));
}

/// Highlighted points, such as those of a finding: a ring around each, over everything else.
void addMarked(const LayerInput& in, DrawList& out) {
    constexpr float kLineWidth = 1.5F;
    for (const EvidenceLine& each : in.markedLines) {
        out.line(in.model.toView(each.from), in.model.toView(each.to),
                 each.asItShouldBe ? in.palette.used : in.palette.rejected, kLineWidth);
    }
    const float size = in.marked.size() > kLargeMarks ? 0.32F : 0.95F;
    for (const Index p : in.marked) {
        if (!in.model.drawable[p]) continue;
        out.mark(in.at(p), Shape::OpenDiamond, in.palette.rejected, size);
        // A point with a label of its role has its name already.
        const bool named =
            std::any_of(out.labels.begin(), out.labels.end(),
                        [&](const Label& each) { return each.position == in.at(p); });
        if (in.marked.size() <= kNamedMarks && !named)
            out.label(in.at(p), nameOf(p, in.names), in.palette.rejected);
    }
}

}  // namespace se::view
