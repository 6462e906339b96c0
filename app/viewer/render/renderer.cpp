// Data is uploaded once: positions per input, triangles as they are made, a style byte per point
// where it changed. Points and lines are moved toward the eye, out of the triangles.
#include "renderer.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_access.hpp>
#include <numbers>

namespace se::view {

namespace {

struct CloudVertex {
    glm::vec3 position;
    glm::vec3 normal;
};
struct MeshVertex {
    glm::vec3 position;
    std::array<std::int8_t, 4> normal;
};
struct SpriteVertex {
    glm::vec3 position;
    glm::vec4 color;
    glm::vec2 sizeShape;
};
struct FaceVertex {
    glm::vec3 position;
    glm::vec4 color;
    float hatched;
};

/// Share of the point spacing by which points and lines are moved toward the eye.
constexpr float kBiasShare = 0.12F;
/// Number of points above which all are dots, with a minimum size.
constexpr std::size_t kPlainDotsFrom = 100'000;
/// Colors of a scale, as in shaders/mesh.vert.
constexpr std::size_t kScaleSteps = 9;
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

std::array<std::int8_t, 4> packed(const glm::vec3& normal) {
    const auto byte = [](float x) {
        return static_cast<std::int8_t>(std::lround(127.0F * std::clamp(x, -1.0F, 1.0F)));
    };
    return {byte(normal.x), byte(normal.y), byte(normal.z), 0};
}

/// Writes the corners of the triangles from `first` up to `last` to their positions in `batch`.
void uploadCorners(Batch& batch, const Model& model, std::span<const Triangle> triangles,
                   std::size_t first, std::size_t last) {
    std::vector<MeshVertex> corners;
    corners.reserve(3 * (last - first));
    for (const Triangle& t : triangles.subspan(first, last - first)) {
        for (const Index p : {t.a, t.b, t.c}) {
            corners.push_back({model.place[p], packed(model.normal[p])});
        }
    }
    batch.append(0, 3 * first * sizeof(MeshVertex), corners.data(),
                 corners.size() * sizeof(MeshVertex));
    // The buffer may have been replaced.
    batch.describe(0, sizeof(MeshVertex),
                   {{0, 3, offsetof(MeshVertex, position)},
                    {3, 4, offsetof(MeshVertex, normal), false, true}});
}

/// Draws the triangles from `first` up to `last` of the bound batch in one color.
void drawTriangles(std::size_t first, std::size_t last, const Color& c) {
    if (last <= first) return;
    glVertexAttrib4f(1, c.r, c.g, c.b, c.a);
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * first),
                 static_cast<GLsizei>(3 * (last - first)));
}

Status loadInto(Shader& shader, const char* vertex, const char* fragment,
                const std::filesystem::path& folder, const char* defines = "") {
    Result<Shader> loaded = Shader::load(vertex, fragment, folder, defines);
    if (!loaded) return loaded.error();
    shader = std::move(loaded.value());
    return success();
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create(const std::filesystem::path& shaderFolder) {
    std::unique_ptr<Renderer> renderer(new Renderer);
    if (const Status status = renderer->loadShaders(shaderFolder); !status) return status.error();
    renderer->describeBatches();
    return renderer;
}

Status Renderer::loadShaders(const std::filesystem::path& folder) {
    for (const Status& status :
         {loadInto(cloudShader_, "cloud.vert", "point.frag", folder),
          loadInto(spriteShader_, "sprite.vert", "point.frag", folder, "#define HALO\n"),
          lines_.load(folder), loadInto(meshShader_, "mesh.vert", "mesh.frag", folder),
          loadInto(shellShader_, "shell.vert", "shell.frag", folder)}) {
        if (!status) return status;
    }
    return success();
}

void Renderer::describeBatches() {
    cloud_.describe(
        0, sizeof(CloudVertex),
        {{0, 3, offsetof(CloudVertex, position)}, {1, 3, offsetof(CloudVertex, normal)}});
    cloud_.describe(1, 1, {{2, 1, 0, true}});
    sprites_.describe(0, sizeof(SpriteVertex),
                      {{0, 3, offsetof(SpriteVertex, position)},
                       {1, 4, offsetof(SpriteVertex, color)},
                       {2, 2, offsetof(SpriteVertex, sizeShape)}});
    lines_.describe();
    faces_.describe(0, sizeof(FaceVertex),
                    {{0, 3, offsetof(FaceVertex, position)},
                     {1, 4, offsetof(FaceVertex, color)},
                     {2, 1, offsetof(FaceVertex, hatched)}});
    const std::vector<glm::vec3> sphere = unitSphere();
    shell_.describe(0, sizeof(glm::vec3), {{0, 3, 0}});
    shell_.upload(0, sphere.data(), sphere.size() * sizeof(glm::vec3));
    shellVertices_ = sphere.size();
}

void Renderer::setModel(const Model& model) {
    std::vector<CloudVertex> vertices;
    vertices.reserve(model.place.size());
    for (std::size_t p = 0; p < model.place.size(); ++p) {
        vertices.push_back({model.place[p], model.normal[p]});
    }
    cloud_.upload(0, vertices.data(), vertices.size() * sizeof(CloudVertex));
    cloudCount_ = vertices.size();
    meshTriangles_ = 0;
    uploadedStyles_ = {};
    uploadedRepaired_ = nullptr;
    uploadedTinted_ = {};
    spacing_ = model.spacing;
}

void Renderer::setTriangles(const Model& model, std::span<const Triangle> triangles) {
    if (triangles.size() <= meshTriangles_) return;
    uploadCorners(mesh_, model, triangles, meshTriangles_, triangles.size());
    meshTriangles_ = triangles.size();
}

void Renderer::setRepaired(const Model& model,
                           std::shared_ptr<const std::vector<Triangle>> triangles) {
    if (!triangles || triangles == uploadedRepaired_) return;
    static const std::vector<Triangle> kNothing;
    const std::vector<Triangle>& before = uploadedRepaired_ ? *uploadedRepaired_ : kNothing;
    const std::size_t common = std::min(before.size(), triangles->size());
    for (std::size_t i = 0; i < common; ++i) {
        const std::size_t first = i;
        while (i < common && !((*triangles)[i] == before[i])) ++i;
        if (i > first) uploadCorners(repaired_, model, *triangles, first, i);
    }
    if (common < triangles->size()) {
        uploadCorners(repaired_, model, *triangles, common, triangles->size());
    }
    uploadedRepaired_ = std::move(triangles);
}

void Renderer::setTinted(const Model& model, const DrawList& list) {
    for (std::size_t i = 0; i < tinted_.size(); ++i) {
        const auto& triangles = list.tinted[i].triangles;
        if (!triangles || triangles == uploadedTinted_[i]) continue;
        uploadCorners(tinted_[i], model, *triangles, 0, triangles->size());
        uploadedTinted_[i] = triangles;
    }
}

void Renderer::draw(const DrawList& list, const CameraMatrices& camera, glm::ivec2 size, float em,
                    const Color& background) {
    em_ = em;
    size_ = glm::vec2(size);
    setZoom(camera);
    target_.begin(size);
    glClearColor(background.r, background.g, background.b, 1.0F);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glDisable(GL_BLEND);
    drawMesh(list, camera);

    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    drawSheets(list, camera);
    drawCloud(list, camera);
    drawSpheres(list, camera);
    drawLines(list, camera);
    glDisable(GL_DEPTH_TEST);
    drawSprites(list, camera, background);

    glDepthMask(GL_TRUE);
    glDisable(GL_PROGRAM_POINT_SIZE);
    glBindVertexArray(0);
    target_.end();
}

void Renderer::setZoom(const CameraMatrices& camera) {
    // Pixels of the median spacing at the middle of the scene.
    const float depth =
        camera.orthographic ? 1.0F : std::max(0.01F, glm::length(camera.eye) - 0.7F);
    const float pixels = 0.5F * size_.y * camera.projection[1][1] * spacing_ / depth;
    dotAlpha_ = std::clamp((pixels - 2.0F) / 6.0F, 0.0F, 1.0F);
    const float ems = pixels / em_;
    cloudZoom_ = std::clamp(ems / 1.5F, 0.45F, 1.35F);
    markZoom_ = std::clamp(ems / 1.5F, 0.72F, 1.15F);
}

void Renderer::useCamera(Shader& shader, const CameraMatrices& camera, float bias) {
    shader.use();
    shader.set("uView", camera.view);
    shader.set("uProjection", camera.projection);
    shader.set("uEye", camera.eye);
    shader.set("uBackward", glm::vec3(glm::row(camera.view, 2)));
    shader.set("uOrthographic", camera.orthographic);
    shader.set("uBias", bias);
}

void Renderer::drawMesh(const DrawList& list, const CameraMatrices& camera) {
    useCamera(meshShader_, camera, 0.0F);
    meshShader_.set("uRight", glm::vec3(glm::row(camera.view, 0)));
    meshShader_.set("uUp", glm::vec3(glm::row(camera.view, 1)));
    meshShader_.set("uLit", true);
    meshShader_.set("uHatch", 0.55F * em_);
    meshShader_.set("uEdgeWidth", std::max(1.0F, 0.07F * em_));
    meshShader_.set("uEdgeColor", vec(list.meshEdgeColor.withAlpha(list.meshEdges ? 0.85F : 0.0F)));
    const bool repaired = list.repaired != nullptr && list.repaired == uploadedRepaired_;
    const std::size_t count =
        repaired ? list.repaired->size() : std::min(list.finishedTriangles, meshTriangles_);
    if (list.meshVisible && count > 0) {
        repaired ? repaired_.bind() : mesh_.bind();
        beginGhosts(list);
        drawStretches(list, count);
        drawTinted(list);
        endGhosts();
    }
    meshShader_.set("uSmooth", false);
    meshShader_.set("uWire", false);
    meshShader_.set("uByBirth", false);
    meshShader_.set("uSoft", 0.0F);
    drawFaces(list.faces);
}

/// What hides the decision is drawn into some of the samples of each pixel only, which needs
/// neither an order of the triangles nor a second pass.
void Renderer::beginGhosts(const DrawList& list) {
    if (!list.ghosts || !list.decision) return;
    meshShader_.set("uGhost", glm::vec4(list.decision->center, list.decision->radius));
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
}

void Renderer::endGhosts() {
    meshShader_.set("uGhost", glm::vec4(0.0F));
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// Draws the finished triangles, each stretch in its color.
void Renderer::drawStretches(const DrawList& list, std::size_t count) {
    const bool data = list.meshStyle >= MeshStyle::CreationOrder;
    meshShader_.set("uSmooth", list.meshStyle == MeshStyle::Shaded);
    meshShader_.set("uWire", list.meshStyle == MeshStyle::Wire);
    meshShader_.set("uByBirth", list.meshStyle == MeshStyle::CreationOrder);
    meshShader_.set("uBirthEnd", static_cast<float>(list.creationEnd));
    // Colors that are data must stay distinguishable in the shade.
    meshShader_.set("uSoft", data ? 0.6F : 0.0F);
    if (list.meshStyle == MeshStyle::Wire) meshShader_.set("uEdgeColor", vec(list.meshEdgeColor));
    if (list.meshStyle == MeshStyle::CreationOrder) {
        std::array<glm::vec4, kScaleSteps> scale{};
        for (std::size_t i = 0; i < kScaleSteps; ++i) {
            scale[i] = vec(viridis(static_cast<float>(i) / static_cast<float>(kScaleSteps - 1)));
        }
        meshShader_.set("uScale", std::span<const glm::vec4>(scale));
    }
    glVertexAttrib1f(2, 0.0F);
    const auto& stretches = list.meshStretches;
    drawTriangles(0, stretches.empty() ? count : std::min(count, stretches.front().first),
                  list.meshColor);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const std::size_t end = i + 1 < stretches.size() ? stretches[i + 1].first : count;
        drawTriangles(stretches[i].first, std::min(count, end), stretches[i].color);
    }
}

/// Drawn over the finished triangles, at exactly the same depth.
void Renderer::drawTinted(const DrawList& list) {
    meshShader_.set("uByBirth", false);
    for (std::size_t i = 0; i < tinted_.size(); ++i) {
        const TintedTriangles& tinted = list.tinted[i];
        if (tinted.count == 0 || tinted.triangles != uploadedTinted_[i]) continue;
        tinted_[i].bind();
        glVertexAttrib1f(2, 0.0F);
        drawTriangles(0, tinted.count, tinted.color);
    }
}

void Renderer::drawFaces(std::span<const Face> faces) {
    if (faces.empty()) return;
    std::vector<FaceVertex> vertices;
    for (const Face& face : faces) {
        for (const glm::vec3& corner : face.corners) {
            vertices.push_back({corner, vec(face.color), face.hatched ? 1.0F : 0.0F});
        }
    }
    faces_.upload(0, vertices.data(), vertices.size() * sizeof(FaceVertex));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

void Renderer::uploadStyles(const BlockList<std::uint8_t>& styles) {
    constexpr std::size_t kBlock = BlockList<std::uint8_t>::kBlock;
    std::vector<std::uint8_t> bytes;
    for (std::size_t b = 0; b < styles.blockCount(); ++b) {
        // Adjacent blocks are uploaded together.
        const std::size_t first = b;
        for (; b < styles.blockCount() && !styles.shares(b, uploadedStyles_); ++b) {
            const auto block = styles.block(b);
            bytes.insert(bytes.end(), block.begin(), block.end());
        }
        if (b > first) cloud_.append(1, first * kBlock, bytes.data(), bytes.size());
        bytes.clear();
    }
    // The buffer may have been replaced.
    if (uploadedStyles_.empty()) cloud_.describe(1, 1, {{2, 1, 0, true}});
    uploadedStyles_ = styles;
}

void Renderer::drawCloud(const DrawList& list, const CameraMatrices& camera) {
    if (!list.cloudVisible || cloudCount_ == 0 || list.cloudStyleOf.size() != cloudCount_) return;
    std::array<glm::vec4, CloudStyles::kCount> colors{};
    std::array<glm::vec2, CloudStyles::kCount> sizes{};
    for (std::size_t i = 0; i < CloudStyles::kCount; ++i) {
        const PointStyle& style = list.cloudStyles.styles[i];
        colors[i] = vec(style.color);
        if (style.shape == Shape::Dot && cloudCount_ <= kPlainDotsFrom) colors[i].a *= dotAlpha_;
        sizes[i] = {std::max(1.5F, style.size * em_ * cloudZoom_), static_cast<float>(style.shape)};
    }
    useCamera(cloudShader_, camera, kBiasShare * spacing_);
    cloudShader_.set("uStyleColor", std::span<const glm::vec4>(colors));
    cloudShader_.set("uStyleSizeShape", std::span<const glm::vec2>(sizes));
    uploadStyles(list.cloudStyleOf);
    cloud_.bind();
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(cloudCount_));
}

void Renderer::drawLines(const DrawList& list, const CameraMatrices& camera) {
    if (list.lines.empty()) return;
    useCamera(lines_.shader(), camera, 0.0F);
    lines_.shader().set("uViewport", size_);
    lines_.draw(list.lines, {em_, markZoom_, kBiasShare * spacing_, kHaloBiasShare * spacing_});
}

void Renderer::drawSheets(const DrawList& list, const CameraMatrices& camera) {
    if (list.sheets.empty()) return;
    useCamera(meshShader_, camera, 0.0F);
    meshShader_.set("uLit", false);
    meshShader_.set("uEdgeColor", glm::vec4(0.0F));
    glDisable(GL_DEPTH_TEST);
    drawFaces(list.sheets);
    glEnable(GL_DEPTH_TEST);
}

void Renderer::drawSpheres(const DrawList& list, const CameraMatrices& camera) {
    if (list.spheres.empty()) return;
    useCamera(shellShader_, camera, 0.0F);
    shell_.bind();
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    // Drawn completely, also where the surface would hide it: it represents a test, not an object.
    glDisable(GL_DEPTH_TEST);
    for (const Sphere& sphere : list.spheres) {
        shellShader_.set("uCenter", sphere.center);
        shellShader_.set("uRadius", sphere.radius);
        shellShader_.set("uColor", vec(sphere.color));
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
    useCamera(spriteShader_, camera, 0.0F);
    spriteShader_.set("uHalo", glm::vec3(background.r, background.g, background.b));
    sprites_.upload(0, vertices.data(), vertices.size() * sizeof(SpriteVertex));
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices.size()));
}

}  // namespace se::view
