/// The points of the input, and their normals.

#include <algorithm>
#include <array>
#include <set>

#include "layer.h"
#include "scene/mesh_style.h"

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

/// Within a pivot its neighborhood is emphasized, and all else dimmed. Drawn on top of the cloud,
/// since the styles of the cloud are computed again only where a status changed.
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

// Labels of the points that matter at the cursor, one per point: its name alone. Roles are shown by
// the signs and colors of the points.

namespace {

/// Whether `name` is a word of `text`: "7" of "start point 7".
bool isWordOf(const std::string& name, const std::string& text) {
    const auto ends = [&](std::size_t at) { return text.find_first_of(" ,", at) == at; };
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t after = at + name.size();
        if ((at == 0 || text[at - 1] == ' ') && (after == text.size() || ends(after))) return true;
    }
    return false;
}

/// The color of a point's sign.
const Color& roleColor(const DecisionState& p, const Palette& c, Index point) {
    if (point == p.pivot || point == p.nextPivot) return c.pivot;
    if (point == p.start || point == p.first) return c.first;
    if (point == p.end || point == p.last) return c.last;
    return c.test;
}

/// Points that the decision names besides the pivot, the most important first.
std::vector<Index> namedPoints(const DecisionState& p) {
    std::vector<Index> points{p.underTest};
    if (p.sphere) points.insert(points.end(), {p.sphere->q, p.sphere->t, p.sphere->s});
    if (const auto* e = p.evidence<ReciprocalEvidence>(Stage::Reciprocal))
        points.insert(points.end(), {e->pred, e->succ});
    points.insert(points.end(), {p.start, p.end, p.first, p.last});
    return points;
}

}  // namespace

void addLabels(const LayerInput& in, DrawList& out) {
    const DecisionState none;
    const DecisionState& p = in.finished ? none : in.picture;
    const Palette& c = in.palette;
    std::set<Index> seen;
    // Those of the decision come first: a view has room for a few.
    const auto add = [&](Index point, const Color& color, bool strong) {
        if (point == kNone || !seen.insert(point).second) return;
        const std::string name = nameOf(point, in.names);
        // Another layer may have named it already, with what it is.
        const bool elsewhere =
            std::any_of(out.labels.begin(), out.labels.end(), [&](const Label& each) {
                return each.position == in.at(point) && isWordOf(name, each.text);
            });
        if (elsewhere) return;
        const bool asked =
            point == in.hovered || point == in.selected ||
            std::find(in.labeled.begin(), in.labeled.end(), point) != in.labeled.end();
        const bool given =
            std::any_of(in.names.begin(), in.names.end(),
                        [point](const PointName& each) { return each.point == point; });
        out.labels.push_back({in.at(point), name, color, strong, strong, 0.0F, asked, given});
    };
    add(p.pivot, c.pivot, true);
    const bool stranded = p.event && p.event->address.stage == Stage::Strand;
    // Seeds and the steps after the last pivot label their points themselves.
    const bool named = p.repaired || (p.event && p.event->address.stage == Stage::Seed);
    if (p.pivot == kNone && !named) add(p.underTest, stranded ? c.rejected : c.test, true);
    if (!p.complete && p.pivot != kNone) {
        for (const Index point : namedPoints(p)) add(point, roleColor(p, c, point), true);
        for (const CandidateMark& mark : p.candidates) {
            const bool kept = mark.state == CandidateState::Kept;
            add(mark.point, kept ? c.used : c.rejected, false);
        }
    }
    if (p.complete) add(p.nextPivot, c.pivot, true);
    // Of a figure, all points on the rings that it names.
    for (const PointName& each : in.names) {
        const bool onRing = each.point < p.status.size() && p.status[each.point] > 0;
        if (onRing) add(each.point, c.used, false);
    }
    for (const Index point : in.labeled) add(point, c.text, false);
    for (const auto& [point, size] : {std::pair{in.hovered, 1.5F}, {in.selected, 1.3F}}) {
        if (point == kNone) continue;
        out.mark(in.at(point), Shape::Circle, c.text.withAlpha(point == in.hovered ? 0.8F : 1.0F),
                 size);
        add(point, c.text, true);
    }
}

// The user's selection: an edge or a triangle, and highlighted points.

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
    constexpr float kLineWidth = 0.08F;
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

// Points that take no part in the run: set aside when it was prepared, dropped by a fix, or left
// out by the user.

namespace {

constexpr float kAsideSize = 0.5F;
/// Number of points beyond which the marks are small and faint: they must not cover the run.
constexpr std::size_t kLargeAside = 300;
constexpr float kSmallAside = 0.22F;
constexpr float kFaint = 0.55F;
/// Marks of points that are no points of the run: of more, evenly chosen ones.
constexpr std::size_t kMaxOutside = 20'000;

}  // namespace

void addAside(const LayerInput& in, DrawList& out) {
    const bool many = countOf(in.model.aside) > kLargeAside;
    const PointStyle style{in.palette.unused.withAlpha(many ? kFaint : 1.0F),
                           many ? kSmallAside : kAsideSize, Shape::Plus};
    out.cloudStyles.styles[CloudStyles::kAside] = style;
    std::size_t outside = 0;
    for (const AsidePoints& each : in.model.aside) outside += each.position.size();
    const std::size_t stride = outside / kMaxOutside + 1;
    for (const AsidePoints& each : in.model.aside) {
        for (std::size_t i = 0; i < each.position.size(); i += stride)
            out.sprites.push_back({in.model.toView(each.position[i]), style});
    }
}

}  // namespace se::view
