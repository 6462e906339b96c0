/// §6.5, Figs. 11 and 12: a point met again splits its ring, or joins two.
#include <algorithm>

#include "layer.h"

namespace se::view {

namespace {

/// A broad band along a loop, under which everything stays visible.
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

/// The name of a loop, at its step after the next.
void addName(const LayerInput& in, const RingPath& ring, Index point, const std::string& text,
             const Color& color, DrawList& out) {
    const auto found = std::find(ring.points.begin(), ring.points.end(), point);
    const auto at = static_cast<std::size_t>(found - ring.points.begin());
    const std::size_t count = ring.points.size();
    const std::size_t from = (at + (count > 2 ? 1 : 0)) % count;
    const glm::vec3& near = in.at(ring.points[from]);
    out.label(0.5F * (near + in.at(ring.points[(from + 1) % count])), text, color, true);
}

std::string entries(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

void addSplit(const LayerInput& in, Index point, const RingExchange& loops, DrawList& out) {
    const Palette& c = in.palette;
    addBand(in, loops.a, c.used, 0.0F, out);
    addName(in, loops.a, point,
            "a: " + entries(loops.a.points.size()) +
                (loops.a.active ? ", continues" : ", stays #" + std::to_string(loops.a.depth + 1)),
            c.used, out);
    addBand(in, loops.b, c.last, 0.6F, out);
    addName(
        in, loops.b, point,
        "b: " + entries(loops.b.points.size()) + ", waits as #" + std::to_string(loops.b.depth + 1),
        c.last, out);
    out.mark(in.at(point), Shape::OpenDiamond, c.pivot, 1.5F);
    out.label(in.at(point), "a | b: cut here", c.pivot, true);
}

void addJoin(const LayerInput& in, Index point, const RingExchange& loops, DrawList& out) {
    const Palette& c = in.palette;
    addBand(in, loops.a, c.used, 0.0F, out);
    addName(in, loops.a, point, "a", c.used, out);
    addBand(in, loops.b, c.last, 0.0F, out);
    addName(
        in, loops.b, point,
        loops.b.active ? "b was the active ring" : "b was #" + std::to_string(loops.b.depth + 1),
        c.last, out);
    out.mark(in.at(point), Shape::OpenSquare, c.pivot, 1.5F);
    out.label(in.at(point), "a + b: bridge here", c.pivot, true);
}

}  // namespace

/// Loops as they were at that moment: the next split of the same pivot may cut them again.
void addExchange(const LayerInput& in, DrawList& out) {
    if (!in.picture.exchange) return;
    const auto latest =
        std::find_if(in.picture.latest.rbegin(), in.picture.latest.rend(), [](const Event& event) {
            return event.address.stage == Stage::Split || event.address.stage == Stage::Join;
        });
    if (latest == in.picture.latest.rend()) return;
    const Index point = subjectOf(*latest);
    latest->address.stage == Stage::Split ? addSplit(in, point, *in.picture.exchange, out)
                                          : addJoin(in, point, *in.picture.exchange, out);
}

}  // namespace se::view
