// The possible triangle and the finished triangles around its corners are projected into the plane
// of a disc and intersected there as convex polygons (scene/clip.h). Every piece is lifted back
// onto the possible triangle for drawing.
#include "disc.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "scene/clip.h"

namespace se::view {

namespace {

/// Parts smaller than this share of the triangle are caused by the bend of the surface alone.
constexpr float kSliverShare = 0.01F;

using Corners = std::array<glm::vec2, 3>;

/// A triangle in the plane of a disc, counterclockwise.
struct Flat {
    Corners corners{};
    std::array<glm::vec3, 3> places{};
    float area = 0.0F;

    /// The point in the triangle above or below one in the plane.
    glm::vec3 lifted(const glm::vec2& at) const {
        std::array<float, 3> weight{};
        for (std::size_t i = 0; i < 3; ++i) {
            weight[i] = areaOf(Corners{at, corners[(i + 1) % 3], corners[(i + 2) % 3]}) / area;
        }
        return weight[0] * places[0] + weight[1] * places[1] + weight[2] * places[2];
    }
};

Flat flatten(const LayerInput& in, const Disc& disc, const Triangle& t) {
    Flat flat;
    flat.places = in.cornersOf(t);
    const auto fill = [&] {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3 offset = flat.places[i] - disc.origin;
            flat.corners[i] = {glm::dot(offset, disc.zero), glm::dot(offset, disc.quarter)};
        }
        flat.area = areaOf(flat.corners);
    };
    fill();
    if (flat.area < 0.0F) {
        std::swap(flat.places[1], flat.places[2]);
        fill();
    }
    return flat;
}

/// The finished triangles around the corners of a triangle.
std::set<std::uint32_t> finishedAbout(const LayerInput& in, const Triangle& t) {
    std::set<std::uint32_t> found;
    if (in.meshIndex == nullptr || in.picture.repaired) return found;
    const std::size_t count = std::min(in.picture.finishedTriangles, in.triangles.size());
    const auto look = [&](Index point) {
        in.meshIndex->forEachAt(point, [&](std::uint32_t triangle) {
            if (triangle < count) found.insert(triangle);
        });
    };
    for (const Index corner : {t.a, t.b, t.c}) {
        look(corner);
        for (const Index q : in.model.points.neighbors[corner]) look(q);
    }
    return found;
}

/// A triangle on the other side of a thin object is not in the way.
bool facesDisc(const LayerInput& in, const Disc& disc, const Triangle& t) {
    return glm::dot(in.acrossOf(t), disc.normal) > 0.0F;
}

}  // namespace

Overlap overlapOf(const LayerInput& in, const Disc& disc, const Triangle& wouldBe) {
    Overlap overlap;
    const Flat window = flatten(in, disc, wouldBe);
    if (!(window.area > 0.0F)) return overlap;
    for (const std::uint32_t number : finishedAbout(in, wouldBe)) {
        const Triangle& t = in.triangles[number];
        if (!facesDisc(in, disc, t)) continue;
        const std::vector<glm::vec2> part =
            clipConvex(flatten(in, disc, t).corners, window.corners);
        const float share = part.empty() ? 0.0F : areaOf(part) / window.area;
        if (share < kSliverShare) continue;
        overlap.covered.push_back(t);
        overlap.parts.emplace_back();
        glm::vec3 middle(0.0F);
        for (const glm::vec2& at : part) {
            overlap.parts.back().push_back(window.lifted(at));
            middle += overlap.parts.back().back() / static_cast<float>(part.size());
        }
        overlap.share += share;
        overlap.middle += share / overlap.share * (middle - overlap.middle);
    }
    return overlap;
}

void addOverlap(const LayerInput& in, const Overlap& overlap, DrawList& out) {
    if (overlap.parts.empty()) return;
    const Color& color = in.palette.rejected;
    for (const std::vector<glm::vec3>& part : overlap.parts) {
        for (std::size_t i = 1; i + 1 < part.size(); ++i) {
            out.sheets.push_back({{part[0], part[i], part[i + 1]}, color.withAlpha(0.8F), true});
        }
        out.loop(part, color, 0.1F);
    }
}

}  // namespace se::view
