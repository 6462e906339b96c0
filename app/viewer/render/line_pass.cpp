// The halo of a line is a wider strip that is drawn into the depth alone: farther lines fail the
// depth test there, and what lies below them stays visible in the gap. Lines are sorted by their
// kind: tested ones, those that shine through, those on top. The first two are tested against the
// mesh; the last only against lines, for which the depth is cleared in between.
#include "line_pass.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <vector>

namespace se::view {

namespace {

struct LineInstance {
    glm::vec3 from;
    glm::vec3 to;
    glm::vec4 color;
    glm::vec3 widthDashArrow;
};

/// Strength of hidden lines.
constexpr float kXRayAlpha = 0.34F;
/// Length of the dashes of hidden lines and of their gaps, in em.
constexpr float kHiddenDash = 0.4F;
/// Width of the gap on either side of a line, in em.
constexpr float kHaloEms = 0.16F;

}  // namespace

void LinePass::describeFrom(std::size_t first) {
    const std::size_t at = first * sizeof(LineInstance);
    batch_.describe(0, sizeof(LineInstance),
                    {{0, 3, at + offsetof(LineInstance, from)},
                     {1, 3, at + offsetof(LineInstance, to)},
                     {2, 4, at + offsetof(LineInstance, color)},
                     {3, 3, at + offsetof(LineInstance, widthDashArrow)}},
                    true);
}

void LinePass::drawRange(std::size_t first, std::size_t last, Part part) {
    if (last <= first) return;
    const bool halos = part == Part::Halos;
    shader_.set("uGap", halos ? kHaloEms * sizes_.em : 0.0F);
    shader_.set("uBias", halos ? sizes_.haloBias : sizes_.bias);
    const GLboolean color = halos ? GL_FALSE : GL_TRUE;
    glColorMask(color, color, color, color);
    glDepthMask(halos ? GL_TRUE : GL_FALSE);
    // Without a first instance in this version of OpenGL, the attributes begin there.
    describeFrom(first);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(last - first));
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
}

void LinePass::draw(std::span<const Line> lines, const LineSizes& sizes) {
    sizes_ = sizes;
    std::vector<LineInstance> instances;
    instances.reserve(lines.size());
    std::array<std::size_t, 3> ends{};
    for (const Depth depth : {Depth::Tested, Depth::XRay, Depth::OnTop}) {
        for (const Line& line : lines) {
            if (line.depth != depth) continue;
            const glm::vec3 measures(std::max(1.0F, line.width * sizes.em * sizes.zoom),
                                     line.dash * sizes.em, line.arrow * sizes.em * sizes.zoom);
            const Color& c = line.color;
            instances.push_back({line.from, line.to, {c.r, c.g, c.b, c.a}, measures});
        }
        ends[static_cast<std::size_t>(depth)] = instances.size();
    }
    const auto [tested, through, onTop] = ends;
    shader_.use();
    batch_.upload(0, instances.data(), instances.size() * sizeof(LineInstance));
    shader_.set("uAlpha", kXRayAlpha);
    shader_.set("uHiddenDash", kHiddenDash * sizes.em);
    glDepthFunc(GL_GREATER);
    drawRange(tested, through, Part::Lines);
    glDepthFunc(GL_LEQUAL);
    shader_.set("uAlpha", 1.0F);
    shader_.set("uHiddenDash", 0.0F);
    drawRange(0, onTop, Part::Halos);
    drawRange(0, through, Part::Lines);
    if (onTop == through) return;
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    drawRange(tested, onTop, Part::Halos);
    drawRange(through, onTop, Part::Lines);
}

}  // namespace se::view
