// Surfaces are drawn and shaded where they changed, and kept; sheets, spheres, lines and marks are
// drawn over a copy. Lines are moved toward the eye, out of the triangles.
#include "renderer.h"

#include <glad/gl.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "gl_dialect.h"

namespace se::view {

// The halo of a line is a wider strip that is drawn into the depth alone: farther lines fail the
// depth test there, and what lies below them stays visible in the gap. Lines are sorted by their
// kind: tested ones, those that shine through, those on top. The first two are tested against the
// mesh; the last only against lines, for which the depth is cleared in between.

namespace {

struct LineInstance {
    glm::vec3 from;
    glm::vec3 to;
    glm::vec4 color;
    glm::vec3 widthDashArrow;
};

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
            instances.push_back({line.from, line.to, colorVector(line.color), measures});
        }
        ends[static_cast<std::size_t>(depth)] = instances.size();
    }
    const auto [tested, through, onTop] = ends;
    shader_.use();
    batch_.upload(0, instances.data(), instances.size() * sizeof(LineInstance));
    shader_.set("uAlpha", kHiddenAlpha);
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

namespace {

struct SpriteVertex {
    glm::vec3 position;
    glm::vec4 color;
    glm::vec2 sizeShape;
};

/// kTowardEye for the halos of lines: less, so that lines that are nearly as near stay whole.
constexpr float kHaloBiasShare = -0.06F;

std::vector<glm::vec3> unitSphere() {
    constexpr int kAround = 48;
    constexpr int kUp = 24;
    const auto at = [](int i, int j) {
        const float lon = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kAround;
        const float lat = std::numbers::pi_v<float> * (static_cast<float>(j) / kUp - 0.5F);
        return glm::vec3(std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon),
                         std::sin(lat));
    };
    std::vector<glm::vec3> vertices;
    for (int j = 0; j < kUp; ++j) {
        for (int i = 0; i < kAround; ++i) {
            vertices.insert(vertices.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j),
                                             at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return vertices;
}

}  // namespace

Renderer::Renderer(std::shared_ptr<Shaders> shaders)
    : shaders_(std::move(shaders)),
      surface_(*shaders_),
      relief_(*shaders_),
      lines_(shaders_->line) {
    sprites_.describe(0, sizeof(SpriteVertex),
                      {{0, 3, offsetof(SpriteVertex, position)},
                       {1, 4, offsetof(SpriteVertex, color)},
                       {2, 2, offsetof(SpriteVertex, sizeShape)}});
    const std::vector<glm::vec3> sphere = unitSphere();
    shell_.describe(0, sizeof(glm::vec3), {{0, 3, 0}});
    shell_.upload(0, sphere.data(), sphere.size() * sizeof(glm::vec3));
    shellVertices_ = sphere.size();
    drawNothing({1, 1}, {});
}

void Renderer::draw(const DrawList& list, SurfaceView view, Finish finish) {
    em_ = view.em;
    size_ = glm::vec2(view.size);
    view.rect = {};
    view.dots = spacingInPixels(view.camera, size_.y, surface_.spacing());
    markZoom_ = markZoom(view.dots, em_);
    picture_.begin();
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    enablePointSize();
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    keep(list, view, finish);

    picture_.beginOverlay();
    glEnable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    surface_.drawGhosts(list, view);
    drawSheets(list, view.camera);
    drawSpheres(list, view.camera);
    drawLines(list, view.camera);
    glDisable(GL_DEPTH_TEST);
    drawSprites(list, view.camera, view.background);

    glDepthMask(GL_TRUE);
    disablePointSize();
    glBindVertexArray(0);
    picture_.end();
}

void Renderer::drawNothing(glm::ivec2 size, const Color& background) {
    picture_.resize(size, background);
    kept_ = {};
}

/// Draws the surfaces again where they differ from what is kept.
void Renderer::keep(const DrawList& list, SurfaceView view, Finish finish) {
    const bool refines = finish == Finish::Full && finish_ == Finish::Quick;
    const bool all = picture_.resize(view.size, view.background) || !(view == kept_) || refines;
    kept_ = view;
    if (all) finish_ = finish;
    const bool full = finish_ == Finish::Full;
    SurfaceChanges changed = surface_.takeChanges(list);
    if (drawnSolid(view.dots)) changed.mesh.add(changed.points);
    // Marks reach beyond their points.
    const auto partOf = [&](const Bounds& bounds) {
        if (all) return picture_.whole();
        return pixelsOf(view.camera, bounds, view.size)
            .grown(static_cast<int>(std::ceil(view.em)), view.size);
    };
    view.rect = partOf(changed.mesh);
    const PixelRect around = view.rect.grown(Relief::reach(view.em), view.size);
    if (!view.rect.empty()) {
        picture_.beginSurfaces(view.rect, view.background, finish);
        surface_.drawSolid(list, view);
        picture_.endSurfaces();
        if (full) relief_.findOcclusion(picture_, around, view.camera, view.em);
    }
    view.rect = around.with(partOf(changed.points));
    if (view.rect.empty()) return;
    relief_.shade(picture_, view.rect, view.camera, view.em, full);
    picture_.beginPoints(view.rect);
    glEnable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    surface_.drawShapes(list, view);
}

void Renderer::drawLines(const DrawList& list, const CameraMatrices& camera) {
    if (list.lines.empty()) return;
    useCamera(lines_.shader(), camera, 0.0F);
    lines_.shader().set("uViewport", size_);
    const float spacing = surface_.spacing();
    lines_.draw(list.lines, {em_, markZoom_, kTowardEye * spacing, kHaloBiasShare * spacing});
}

void Renderer::drawSheets(const DrawList& list, const CameraMatrices& camera) {
    if (list.sheets.empty()) return;
    glDisable(GL_DEPTH_TEST);
    surface_.drawSheets(list.sheets, camera);
    glEnable(GL_DEPTH_TEST);
}

void Renderer::drawSpheres(const DrawList& list, const CameraMatrices& camera) {
    if (list.spheres.empty()) return;
    useCamera(shaders_->shell, camera, 0.0F);
    shell_.bind();
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    // Drawn completely, also where the surface would hide it: it represents a test, not an object.
    glDisable(GL_DEPTH_TEST);
    for (const Sphere& sphere : list.spheres) {
        shaders_->shell.set("uCenter", sphere.center);
        shaders_->shell.set("uRadius", sphere.radius);
        shaders_->shell.set("uColor", colorVector(sphere.color));
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(shellVertices_));
    }
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
}

void Renderer::drawSprites(const DrawList& list, const CameraMatrices& camera,
                           const Color& background) {
    if (list.sprites.empty()) return;
    std::vector<SpriteVertex> vertices;
    for (const Sprite& sprite : list.sprites) {
        const glm::vec2 sizeShape(sprite.style.size * em_ * markZoom_,
                                  static_cast<float>(sprite.style.shape));
        vertices.push_back({sprite.position, colorVector(sprite.style.color), sizeShape});
    }
    useCamera(shaders_->sprite, camera, 0.0F);
    shaders_->sprite.set("uHalo", glm::vec3(background.r, background.g, background.b));
    sprites_.upload(0, vertices.data(), vertices.size() * sizeof(SpriteVertex));
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices.size()));
}

}  // namespace se::view
