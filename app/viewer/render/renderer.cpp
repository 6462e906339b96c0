// Surfaces are drawn and shaded where they changed, and kept; sheets, spheres, lines and marks are
// drawn over a copy. Lines are moved toward the eye, out of the triangles.
#include "renderer.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "gl_dialect.h"
#include "scene/detail.h"

namespace se::view {

namespace {

struct SpriteVertex {
    glm::vec3 position;
    glm::vec4 color;
    glm::vec2 sizeShape;
};

/// Share of the point spacing by which lines are moved toward the eye.
constexpr float kBiasShare = 0.12F;
/// That of the halos of lines: less, so that lines that are nearly as near stay whole.
constexpr float kHaloBiasShare = -0.06F;

glm::vec4 vec(const Color& c) { return {c.r, c.g, c.b, c.a}; }

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
    markZoom_ = std::clamp(view.dots / em_ / 1.5F, 0.72F, 1.15F);
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
    lines_.draw(list.lines, {em_, markZoom_, kBiasShare * spacing, kHaloBiasShare * spacing});
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
        shaders_->shell.set("uColor", vec(sphere.color));
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
        vertices.push_back({sprite.position, vec(sprite.style.color), sizeShape});
    }
    useCamera(shaders_->sprite, camera, 0.0F);
    shaders_->sprite.set("uHalo", glm::vec3(background.r, background.g, background.b));
    sprites_.upload(0, vertices.data(), vertices.size() * sizeof(SpriteVertex));
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices.size()));
}

}  // namespace se::view
