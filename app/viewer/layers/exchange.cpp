/// §6.5, Figs. 11 and 12: a point met again splits its ring, or joins two.
#include <algorithm>

#include "layer.h"

namespace se::view {

namespace {

bool holds(const RingPath& ring, Index point) {
    return std::find(ring.points.begin(), ring.points.end(), point) != ring.points.end();
}

/// A broad band along a loop: what it is drawn over stays visible.
void addBand(const LayerInput& in, const RingPath& ring, const Color& color, float dash,
             DrawList& out) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        Line line;
        line.from = in.at(ring.points[i]);
        line.to = in.at(ring.points[(i + 1) % ring.points.size()]);
        line.color = color.withAlpha(0.55F);
        line.width = 0.5F;
        line.dash = dash;
        line.depth = Depth::XRay;
        out.lines.push_back(line);
    }
}

/// The name of a loop, half way round from the point.
void addName(const LayerInput& in, const RingPath& ring, Index point, const std::string& text,
             const Color& color, DrawList& out) {
    const auto found = std::find(ring.points.begin(), ring.points.end(), point);
    const auto at = static_cast<std::size_t>(found - ring.points.begin());
    const std::size_t count = ring.points.size();
    const std::size_t far = (at + std::min<std::size_t>(count / 2, 4)) % count;
    out.label(in.at(ring.points[far]), text, color, true);
}

std::string entries(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

void addSplit(const LayerInput& in, const SplitEvidence& e, DrawList& out) {
    const Palette& c = in.palette;
    const std::vector<RingPath>& rings = in.picture.rings;
    if (!rings.empty() && rings.front().active) {
        addBand(in, rings.front(), c.used, 0.0F, out);
        addName(in, rings.front(), e.point,
                "a: " + entries(rings.front().points.size()) + ", goes on", c.used, out);
    }
    const auto stacked = std::find_if(rings.begin(), rings.end(), [&](const RingPath& ring) {
        return !ring.active && holds(ring, e.point);
    });
    if (stacked != rings.end()) {
        addBand(in, *stacked, c.last, 0.6F, out);
        addName(in, *stacked, e.point,
                "b: " + entries(stacked->points.size()) + ", waits as #" +
                    std::to_string(stacked->depth + 1),
                c.last, out);
    }
    out.mark(in.at(e.point), Shape::OpenDiamond, c.pivot, 1.5F);
    out.label(in.at(e.point), "a | b: cut here", c.pivot, true);
}

void addJoin(const LayerInput& in, const JoinEvidence& e, DrawList& out) {
    const Palette& c = in.palette;
    const std::vector<RingPath>& old = in.picture.oldRings;
    const auto other = std::find_if(old.begin(), old.end(), [&](const RingPath& ring) {
        return !ring.active && ring.depth == e.depthFromTop;
    });
    const std::vector<RingPath>& now = in.picture.rings;
    if (!now.empty() && now.front().active) {
        addBand(in, now.front(), c.used, 0.0F, out);
        addName(in, now.front(), e.point, "a", c.used, out);
    }
    if (other != old.end()) {
        addBand(in, *other, c.last, 0.0F, out);
        addName(in, *other, e.point, "b was #" + std::to_string(e.depthFromTop + 1), c.last, out);
    }
    out.mark(in.at(e.point), Shape::OpenSquare, c.pivot, 1.5F);
    out.label(in.at(e.point), "a + b: bridge here", c.pivot, true);
}

}  // namespace

void addExchange(const LayerInput& in, DrawList& out) {
    if (const auto* split = in.picture.evidence<SplitEvidence>(Stage::Split)) {
        addSplit(in, *split, out);
    }
    if (const auto* join = in.picture.evidence<JoinEvidence>(Stage::Join)) {
        addJoin(in, *join, out);
    }
}

}  // namespace se::view
