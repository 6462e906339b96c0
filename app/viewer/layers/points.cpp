/// The points of the input, and their normals.
#include <algorithm>
#include <array>

#include "layer.h"
#include "scene/point_tint.h"

namespace se::view {

namespace {

/// Above this number, every point is a plain dot: shapes could not be distinguished anyway.
constexpr std::size_t kShapesUpTo = 100'000;
constexpr std::uint8_t kHiddenStyle = 15;
/// Strength of points beyond the neighborhood.
constexpr float kBeyondAlpha = 0.35F;
constexpr float kBeyondTinted = 0.8F;

/// Number of styles of one tint: status by type. Styles of margin steps follow those by status.
constexpr std::size_t kShapes = 9;
constexpr std::size_t kTinted = 16;
static_assert(kTinted + kMarginSteps * kShapes <= CloudStyles::kCount);

/// Rows: UNUSED, USED, DONE. Columns: interior, boundary, corner.
std::uint8_t styleIndex(PointStatus status, std::uint8_t type) {
    const unsigned row = status == kUnused ? 0U : status > 0 ? 1U : 2U;
    const unsigned column = isCorner(type) ? 2U : isBoundary(type) ? 1U : 0U;
    return static_cast<std::uint8_t>(row * 3U + column);
}

CloudStyles stylesFor(const LayerInput& in) {
    const Palette& c = in.palette;
    CloudStyles s;
    s.styles[0] = {c.unused, 0.46F, Shape::Circle};
    s.styles[1] = {c.unused, 0.46F, Shape::OpenSquare};
    s.styles[2] = {c.unused, 0.54F, Shape::OpenDiamond};
    s.styles[3] = {c.used, 0.52F, Shape::Disc};
    s.styles[4] = {c.used, 0.50F, Shape::Square};
    s.styles[5] = {c.used, 0.60F, Shape::Diamond};
    s.styles[6] = {c.done, 0.26F, Shape::Dot, true};
    s.styles[7] = {c.done, 0.30F, Shape::Square, true};
    s.styles[8] = {c.done, 0.36F, Shape::Diamond, true};
    s.styles[kHiddenStyle].shape = s.styles[CloudStyles::kAside].shape = Shape::Hidden;
    if (in.leastMargin.empty()) return s;
    for (std::size_t step = 0; step < kMarginSteps; ++step) {
        for (std::size_t i = 0; i < kShapes; ++i) {
            PointStyle& style = s.styles[kTinted + step * kShapes + i];
            style = s.styles[i];
            style.color = marginColor(step, in.theme);
            // Color is visible only on points that are large enough.
            style.size = std::max(style.size, 0.4F);
        }
    }
    return s;
}

std::uint8_t styleOf(const LayerInput& in, PointStatus status, std::size_t point) {
    const std::uint8_t plain = styleIndex(status, in.model.points.type[point]);
    const auto step = point < in.leastMargin.size() ? marginStep(in.leastMargin[point])
                                                    : std::optional<std::size_t>{};
    return step ? static_cast<std::uint8_t>(kTinted + *step * kShapes + plain) : plain;
}

bool isAside(const Model& model, std::size_t point) {
    return model.points.isAside(static_cast<Index>(point));
}

/// Computes the styles of the points in blocks that have changed.
void fillStyles(const LayerInput& in, DrawList& out) {
    const BlockList<PointStatus>& status = in.picture.status.blocks();
    if (out.cloudTintMadeOf != in.tint) out.cloudMadeOf = {};
    out.cloudTintMadeOf = in.tint;
    out.cloudStyleOf.resize(status.size());
    std::array<std::uint8_t, BlockList<std::uint8_t>::kBlock> styles{};
    for (std::size_t b = 0; b < status.blockCount(); ++b) {
        if (status.shares(b, out.cloudMadeOf)) continue;
        const auto block = status.block(b);
        for (std::size_t i = 0; i < block.size(); ++i) {
            const std::size_t p = b * BlockList<PointStatus>::kBlock + i;
            styles[i] = !in.model.drawable[p]  ? kHiddenStyle
                        : isAside(in.model, p) ? CloudStyles::kAside
                                               : styleOf(in, block[i], p);
        }
        out.cloudStyleOf.setBlock(b, std::span(styles).first(block.size()));
    }
    out.cloudMadeOf = status;
}

/// Within a pivot its neighborhood is emphasized, and all else dimmed. On top of the cloud and not
/// in its styles, which are computed again only where a status changed.
void addNeighborhood(const LayerInput& in, DrawList& out) {
    for (const Index q : in.model.points.neighbors[in.picture.pivot]) {
        if (!in.model.drawable[q]) continue;
        const std::uint8_t style = styleOf(in, in.picture.status[q], q);
        out.sprites.push_back({in.at(q), out.cloudStyles.styles[style]});
    }
    // Margins are shown everywhere.
    const float beyond = out.marginTint ? kBeyondTinted : kBeyondAlpha;
    for (PointStyle& style : out.cloudStyles.styles) style.color.a *= beyond;
}

/// Number of points up to which all their normals are drawn.
constexpr std::size_t kAllUpTo = 3000;

void addNormal(const LayerInput& in, Index point, DrawList& out) {
    const glm::vec3& from = in.at(point);
    out.line(from, from + in.model.normal[point] * (0.8F * in.model.spacing),
             in.palette.unused.withAlpha(0.8F), 0.05F);
}

}  // namespace

void addPoints(const LayerInput& in, DrawList& out) {
    const std::size_t count = in.model.points.size();
    out.cloudVisible = true;
    out.cloudStyles = stylesFor(in);
    out.marginTint = !in.leastMargin.empty();
    if (count > kShapesUpTo) {
        for (PointStyle& style : out.cloudStyles.styles) {
            if (style.shape != Shape::Hidden)
                style = {style.color, 0.16F, Shape::Dot, style.onMesh};
        }
    }
    fillStyles(in, out);
    if (in.picture.pivot != kNone && !in.picture.complete) addNeighborhood(in, out);
}

void addNormals(const LayerInput& in, DrawList& out) {
    const std::size_t count = in.model.points.size();
    if (count <= kAllUpTo) {
        for (Index p = 0; p < count; ++p) {
            if (in.model.drawable[p]) addNormal(in, p, out);
        }
        return;
    }
    if (in.picture.pivot == kNone) return;
    addNormal(in, in.picture.pivot, out);
    for (const Index q : in.model.points.neighbors[in.picture.pivot]) addNormal(in, q, out);
}

}  // namespace se::view
