// Data is uploaded once: positions per input, triangles as they are made, a style byte per point
// where it changed. Points are moved toward the eye, out of the triangles.
#include "surface.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_access.hpp>
#include <utility>

#include "scene/camera.h"

namespace se::view {

/// Draws parts of bound batches. OpenGL in software keeps every item until it is drawn, 300 bytes
/// per point; it is ahead by two pieces at most here. Nothing is waited for in draws of one piece.
class DrawPacer {
  public:
    DrawPacer() = default;
    ~DrawPacer();
    DrawPacer(const DrawPacer&) = delete;
    DrawPacer& operator=(const DrawPacer&) = delete;

    /// Draws the points `first` up to but not including `last`.
    void drawPoints(std::size_t first, std::size_t last) { draw(GL_POINTS, 1, first, last); }
    /// Draws the triangles `first` up to but not including `last`, of three vertices each.
    void drawTriangles(std::size_t first, std::size_t last) { draw(GL_TRIANGLES, 3, first, last); }

  private:
    void draw(unsigned mode, std::size_t vertices, std::size_t first, std::size_t last);
    void endPiece();

    std::size_t full_ = 0;   ///< Items of the present piece.
    void* fence_ = nullptr;  ///< GLsync at the end of the piece before; null: none.
};

namespace {

// All of a large mesh at once would take its memory twice.

/// Writes vertices one after the other to buffer 0 of a batch, which must outlive this object.
template <typename Vertex>
class VertexUpload {
  public:
    /// Room for the vertices `from` up to but not including `to`, which follow.
    VertexUpload(Batch& batch, std::size_t from, std::size_t to) : batch_(batch), next_(from) {
        batch_.reserve(0, to * sizeof(Vertex));
    }
    ~VertexUpload() { flush(); }
    VertexUpload(const VertexUpload&) = delete;
    VertexUpload& operator=(const VertexUpload&) = delete;

    void add(const Vertex& vertex) {
        vertices_.push_back(vertex);
        if (vertices_.size() == kPiece) flush();
    }

  private:
    static constexpr std::size_t kPiece = std::size_t{1} << 16U;

    void flush() {
        if (vertices_.empty()) return;
        batch_.append(0, next_ * sizeof(Vertex), vertices_.data(),
                      vertices_.size() * sizeof(Vertex));
        next_ += vertices_.size();
        vertices_.clear();
    }

    Batch& batch_;
    std::size_t next_;  ///< Number of the first vertex of `vertices_`.
    std::vector<Vertex> vertices_;
};

struct CloudVertex {
    glm::vec3 position;
    glm::vec3 normal;
};
struct MeshVertex {
    glm::vec3 position;
    std::array<std::int8_t, 4> normal;
};
struct FaceVertex {
    glm::vec3 position;
    glm::vec4 color;
    float hatched;
};

/// Colors of a scale, as in shaders/mesh.vert.
constexpr std::size_t kScaleSteps = 9;

std::array<std::int8_t, 4> packed(const glm::vec3& normal) {
    const auto byte = [](float x) {
        return static_cast<std::int8_t>(std::lround(127.0F * std::clamp(x, -1.0F, 1.0F)));
    };
    return {byte(normal.x), byte(normal.y), byte(normal.z), 0};
}

/// Writes the corners of the triangles of the range to their positions in `batch`. Returns their
/// bounds, and adds them to those of the blocks.
Bounds uploadCorners(Batch& batch, BlockBounds* blocks, const Model& model,
                     std::span<const Triangle> triangles, BlockBounds::Range range) {
    Bounds all;
    const auto upload = [&](std::size_t triangle, VertexUpload<MeshVertex>& corners) {
        const Triangle& t = triangles[triangle];
        for (const Index p : {t.a, t.b, t.c}) {
            corners.add({model.place[p], packed(model.normal[p])});
            all.add(model.place[p]);
            if (blocks != nullptr) blocks->add(triangle, model.place[p]);
        }
    };
    {
        VertexUpload<MeshVertex> corners(batch, 3 * range.first, 3 * range.second);
        for (std::size_t i = range.first; i < range.second; ++i) upload(i, corners);
    }
    // The buffer may have been replaced.
    batch.describe(0, sizeof(MeshVertex),
                   {{0, 3, offsetof(MeshVertex, position)},
                    {3, 4, offsetof(MeshVertex, normal), false, true}});
    return all;
}

/// Draws the triangles of the range of the bound batch in one color.
void drawTriangles(DrawPacer& pacer, BlockBounds::Range range, const Color& c) {
    if (range.second <= range.first) return;
    glVertexAttrib4f(1, c.r, c.g, c.b, c.a);
    pacer.drawTriangles(range.first, range.second);
}

/// Draws a range of the finished triangles, each stretch in its color.
void drawInColors(DrawPacer& pacer, const DrawList& list, BlockBounds::Range range) {
    const auto& stretches = list.meshStretches;
    const std::size_t plain = stretches.empty() ? range.second : stretches.front().first;
    drawTriangles(pacer, {range.first, std::min(range.second, plain)}, list.meshColor);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const std::size_t end = i + 1 < stretches.size() ? stretches[i + 1].first : range.second;
        drawTriangles(pacer,
                      {std::max(range.first, stretches[i].first), std::min(range.second, end)},
                      stretches[i].color);
    }
}

/// Bounds of any scene.
Bounds everything() {
    Bounds all;
    all.add(glm::vec3(-1e3F));
    all.add(glm::vec3(1e3F));
    return all;
}

/// Around the part of the picture that a sphere covers.
Bounds boundsOf(const glm::vec4& sphere) {
    Bounds all;
    if (sphere.w <= 0.0F) return all;
    all.add(glm::vec3(sphere) - 1.2F * sphere.w);
    all.add(glm::vec3(sphere) + 1.2F * sphere.w);
    return all;
}

Bounds boundsOf(const std::vector<Face>& faces) {
    Bounds all;
    for (const Face& face : faces) {
        for (const glm::vec3& corner : face.corners) all.add(corner);
    }
    return all;
}

/// Items of a piece.
constexpr std::size_t kPiece = std::size_t{1} << 16U;
/// Longest wait for a piece, in nanoseconds: nothing depends on its success.
constexpr GLuint64 kLongestWait = 1'000'000'000;

}  // namespace

void useCamera(Shader& shader, const CameraMatrices& camera, float bias) {
    shader.use();
    shader.set("uView", camera.view);
    shader.set("uProjection", camera.projection);
    shader.set("uEye", camera.eye);
    shader.set("uBackward", glm::vec3(glm::row(camera.view, 2)));
    shader.set("uOrthographic", camera.orthographic);
    shader.set("uBias", bias);
}

Surface::Surface(Shaders& shaders) : shaders_(shaders) {
    cloud_.describe(
        0, sizeof(CloudVertex),
        {{0, 3, offsetof(CloudVertex, position)}, {1, 3, offsetof(CloudVertex, normal)}});
    cloud_.describe(1, 1, {{2, 1, 0, true}});
    faces_.describe(0, sizeof(FaceVertex),
                    {{0, 3, offsetof(FaceVertex, position)},
                     {1, 4, offsetof(FaceVertex, color)},
                     {2, 1, offsetof(FaceVertex, hatched)}});
}

void Surface::setModel(const Model& model) {
    const std::size_t count = model.place.size();
    cloud_.upload(0, nullptr, count * sizeof(CloudVertex));
    cloudBounds_.clear();
    {
        VertexUpload<CloudVertex> vertices(cloud_, 0, count);
        for (std::size_t p = 0; p < count; ++p) {
            vertices.add({model.place[p], model.normal[p]});
            cloudBounds_.add(p, model.place[p]);
        }
    }
    places_ = model.place;
    meshTriangles_ = 0;
    meshBounds_.clear();
    repairedBounds_.clear();
    uploadedStyles_ = {};
    uploadedRepaired_ = nullptr;
    uploadedTinted_ = {};
    spacing_ = model.spacing;
    changed_ = {everything(), everything()};
}

void Surface::movePoint(const Model& model, Index point, std::span<const Triangle> triangles) {
    const auto note = [this](const glm::vec3& place) {
        changed_.mesh.add(place);
        changed_.points.add(place);
    };
    note(places_[point]);
    places_[point] = model.place[point];
    note(places_[point]);
    const CloudVertex vertex{model.place[point], model.normal[point]};
    cloud_.append(0, point * sizeof(CloudVertex), &vertex, sizeof(CloudVertex));
    cloudBounds_.add(point, model.place[point]);
    for (std::size_t i = 0; i < meshTriangles_; ++i) {
        const Triangle& t = triangles[i];
        if (t.a != point && t.b != point && t.c != point) continue;
        changed_.mesh.add(uploadCorners(mesh_, &meshBounds_, model, triangles, {i, i + 1}));
    }
}

void Surface::setTriangles(const Model& model, std::span<const Triangle> triangles) {
    if (triangles.size() <= meshTriangles_) return;
    uploadCorners(mesh_, &meshBounds_, model, triangles, {meshTriangles_, triangles.size()});
    meshTriangles_ = triangles.size();
}

void Surface::setRepaired(const Model& model,
                          std::shared_ptr<const std::vector<Triangle>> triangles) {
    if (!triangles || triangles == uploadedRepaired_) return;
    static const std::vector<Triangle> kNothing;
    const std::vector<Triangle>& before = uploadedRepaired_ ? *uploadedRepaired_ : kNothing;
    const std::size_t common = std::min(before.size(), triangles->size());
    const auto note = [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            for (const glm::vec3& corner : model.cornersOf(before[i])) changed_.mesh.add(corner);
        }
    };
    const auto upload = [&](std::size_t first, std::size_t last) {
        if (first == last) return;
        // Old and new triangles: the bounds of the blocks still have the old ones.
        changed_.mesh.add(
            uploadCorners(repaired_, &repairedBounds_, model, *triangles, {first, last}));
        note(first, std::min(last, before.size()));
    };
    for (std::size_t i = 0; i < common; ++i) {
        const std::size_t first = i;
        while (i < common && !((*triangles)[i] == before[i])) ++i;
        upload(first, i);
    }
    upload(common, triangles->size());
    note(common, before.size());
    uploadedRepaired_ = std::move(triangles);
}

void Surface::setTinted(const Model& model, const DrawList& list) {
    for (std::size_t i = 0; i < tinted_.size(); ++i) {
        const auto& triangles = list.tinted[i].triangles;
        if (!triangles || triangles == uploadedTinted_[i]) continue;
        uploadCorners(tinted_[i], nullptr, model, *triangles, {0, triangles->size()});
        uploadedTinted_[i] = triangles;
    }
}

std::size_t Surface::meshCount(const DrawList& list) const {
    const bool repaired = list.repaired != nullptr && list.repaired == uploadedRepaired_;
    return repaired ? list.repaired->size() : std::min(list.finishedTriangles, meshTriangles_);
}

SurfaceChanges Surface::takeChanges(const DrawList& list) {
    SurfaceChanges changed = std::exchange(changed_, {});
    const MeshLooks& looks = list;
    const bool repaired = list.repaired != nullptr;
    if (std::exchange(repairedShown_, repaired) != repaired || looks != looks_)
        changed.mesh = everything();
    looks_ = looks;
    const std::size_t before = std::exchange(drawnTriangles_, meshCount(list));
    if (!repaired) changed.mesh.add(meshBounds_.of(std::minmax(before, drawnTriangles_)));
    if (list.faces != drawnFaces_) {
        changed.mesh.add(boundsOf(drawnFaces_));
        changed.mesh.add(boundsOf(list.faces));
        drawnFaces_ = list.faces;
    }
    const glm::vec4 ghost = list.ghosts && list.decision
                                ? glm::vec4(list.decision->center, list.decision->radius)
                                : glm::vec4(0.0F);
    if (ghost != ghost_) {
        changed.mesh.add(boundsOf(ghost_));
        changed.mesh.add(boundsOf(ghost));
        ghost_ = ghost;
    }
    const bool shown = list.cloudVisible && list.cloudStyleOf.size() == places_.size();
    if (std::exchange(pointsShown_, shown) != shown || pointLooks_ != list.cloudStyles.styles)
        changed.points = everything();
    pointLooks_ = list.cloudStyles.styles;
    if (shown) changed.points.add(uploadStyles(list.cloudStyleOf));
    return changed;
}

void Surface::drawSolid(const DrawList& list, const SurfaceView& view) {
    glDisable(GL_BLEND);
    useMesh(list, view);
    shaders_.mesh.set("uGhost", ghost_);
    shaders_.mesh.set("uGhostsOnly", false);
    drawFinished(list, view);
    shaders_.mesh.set("uGhost", glm::vec4(0.0F));
    shaders_.mesh.set("uSmooth", 0.0F);
    shaders_.mesh.set("uWire", false);
    shaders_.mesh.set("uByCreation", false);
    // New triangles and faults are data: their color stays on the back too.
    shaders_.mesh.set("uSoft", 0.35F);
    drawFaces(list.faces);
    if (!drawnSolid(view.dots)) return;
    // Shares of samples make the dots smooth; the picture itself stays opaque.
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    drawPoints(shaders_.dot, list, view);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

void Surface::drawFinished(const DrawList& list, const SurfaceView& view) {
    if (!list.meshVisible || meshCount(list) == 0) return;
    drawStretches(list, view);
    drawTinted(list);
}

void Surface::drawGhosts(const DrawList& list, SurfaceView view) {
    if (ghost_.w <= 0.0F) return;
    view.rect = pixelsOf(view.camera, boundsOf(ghost_), view.size);
    useMesh(list, view);
    shaders_.mesh.set("uGhost", ghost_);
    shaders_.mesh.set("uGhostsOnly", true);
    drawFinished(list, view);
    shaders_.mesh.set("uGhost", glm::vec4(0.0F));
}

void Surface::drawShapes(const DrawList& list, const SurfaceView& view) {
    if (!drawnSolid(view.dots)) drawPoints(shaders_.shape, list, view);
}

void Surface::drawSheets(const std::vector<Sheet>& sheets, const CameraMatrices& camera) {
    useCamera(shaders_.mesh, camera, 0.0F);
    shaders_.mesh.set("uLit", false);
    shaders_.mesh.set("uEdgeColor", glm::vec4(0.0F));
    drawFaces(sheets);
}

void Surface::useMesh(const DrawList& list, const SurfaceView& view) {
    useCamera(shaders_.mesh, view.camera, 0.0F);
    shaders_.mesh.set("uRight", glm::vec3(glm::row(view.camera.view, 0)));
    shaders_.mesh.set("uUp", glm::vec3(glm::row(view.camera.view, 1)));
    shaders_.mesh.set("uLit", true);
    shaders_.mesh.set("uHatch", 0.55F * view.em);
    shaders_.mesh.set("uCorner", glm::vec2(view.corner));
    shaders_.mesh.set("uEdgeWidth", std::max(1.0F, 0.07F * view.em));
    shaders_.mesh.set("uSpacing", spacing_);
    shaders_.mesh.set("uPixel",
                      2.0F / (view.camera.projection[1][1] * static_cast<float>(view.size.y)));
    const Color edge = list.meshEdgeColor.withAlpha(list.meshEdges ? 0.85F : 0.0F);
    shaders_.mesh.set("uEdgeColor", colorVector(edge));
}

/// Draws the finished triangles that can be seen in the part, each stretch in its color.
void Surface::drawStretches(const DrawList& list, const SurfaceView& view) {
    const bool data = list.meshStyle >= MeshStyle::CreationOrder;
    shaders_.mesh.set("uSmooth", list.meshStyle == MeshStyle::Shaded ? 1.0F : 0.0F);
    shaders_.mesh.set("uWire", list.meshStyle == MeshStyle::Wire);
    shaders_.mesh.set("uByCreation", list.meshStyle == MeshStyle::CreationOrder);
    shaders_.mesh.set("uCreationEnd", static_cast<float>(list.creationEnd));
    // Colors that are data must stay distinguishable in the shade.
    shaders_.mesh.set("uSoft", data ? 0.6F : 0.0F);
    if (list.meshStyle == MeshStyle::Wire)
        shaders_.mesh.set("uEdgeColor", colorVector(list.meshEdgeColor));
    if (list.meshStyle == MeshStyle::CreationOrder) {
        std::array<glm::vec4, kScaleSteps> scale{};
        for (std::size_t i = 0; i < kScaleSteps; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(kScaleSteps - 1);
            scale[i] = colorVector(viridis(share));
        }
        shaders_.mesh.set("uScale", std::span<const glm::vec4>(scale));
    }
    const bool repaired = list.repaired != nullptr && list.repaired == uploadedRepaired_;
    repaired ? repaired_.bind() : mesh_.bind();
    glVertexAttrib1f(2, 0.0F);
    const BlockBounds& blocks = repaired ? repairedBounds_ : meshBounds_;
    DrawPacer pacer;
    for (const auto& range : blocks.within(view.camera, view.size, view.rect, meshCount(list)))
        drawInColors(pacer, list, range);
}

/// Drawn over the finished triangles, at exactly the same depth.
void Surface::drawTinted(const DrawList& list) {
    shaders_.mesh.set("uByCreation", false);
    DrawPacer pacer;
    for (std::size_t i = 0; i < tinted_.size(); ++i) {
        const TintedTriangles& tinted = list.tinted[i];
        if (tinted.count == 0 || tinted.triangles != uploadedTinted_[i]) continue;
        tinted_[i].bind();
        glVertexAttrib1f(2, 0.0F);
        drawTriangles(pacer, {0, tinted.count}, tinted.color);
    }
}

void Surface::drawFaces(const std::vector<Face>& faces) {
    if (faces.empty()) return;
    std::vector<FaceVertex> vertices;
    vertices.reserve(3 * faces.size());
    for (const Face& face : faces) {
        for (const glm::vec3& corner : face.corners) {
            vertices.push_back({corner, colorVector(face.color), face.hatched ? 1.0F : 0.0F});
        }
    }
    faces_.upload(0, vertices.data(), vertices.size() * sizeof(FaceVertex));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

/// Bounds of the points whose style changed.
Bounds Surface::uploadStyles(const BlockList<std::uint8_t>& styles) {
    constexpr std::size_t kBlock = BlockList<std::uint8_t>::kBlock;
    Bounds changed;
    const bool fresh = uploadedStyles_.size() != styles.size();
    std::vector<std::uint8_t> bytes;
    for (std::size_t b = 0; b < styles.blockCount(); ++b) {
        // Adjacent blocks are uploaded together.
        const std::size_t first = b;
        for (; b < styles.blockCount() && !styles.shares(b, uploadedStyles_); ++b) {
            const auto block = styles.block(b);
            bytes.insert(bytes.end(), block.begin(), block.end());
            for (std::size_t i = 0; i < block.size(); ++i) {
                if (fresh || block[i] != uploadedStyles_.block(b)[i])
                    changed.add(places_[b * kBlock + i]);
            }
        }
        if (b > first) cloud_.append(1, first * kBlock, bytes.data(), bytes.size());
        bytes.clear();
    }
    // The buffer may have been replaced.
    if (uploadedStyles_.empty()) cloud_.describe(1, 1, {{2, 1, 0, true}});
    uploadedStyles_ = styles;
    return changed;
}

void Surface::drawPoints(Shader& shader, const DrawList& list, const SurfaceView& view) {
    if (!list.cloudVisible || places_.empty() || list.cloudStyleOf.size() != places_.size()) return;
    const float marks = list.meshVisible ? markStrength(view.dots) : 1.0F;
    const float zoom = std::clamp(view.dots / view.em / 1.5F, 0.45F, 1.35F);
    std::array<glm::vec4, CloudStyles::kCount> colors{};
    std::array<glm::vec2, CloudStyles::kCount> sizes{};
    for (std::size_t i = 0; i < CloudStyles::kCount; ++i) {
        const PointStyle& style = list.cloudStyles.styles[i];
        colors[i] = colorVector(style.color);
        if (style.onMesh) colors[i].a *= marks;
        const Shape shape = colors[i].a < kFaintest ? Shape::Hidden : style.shape;
        // Solid dots nearly touch each other, as a surface.
        const float size = drawnSolid(view.dots) ? std::max(2.0F, kSolidShare * view.dots)
                                                 : std::max(1.5F, style.size * view.em * zoom);
        sizes[i] = {size, static_cast<float>(shape)};
    }
    useCamera(shader, view.camera, kTowardEye * spacing_);
    shader.set("uStyleColor", std::span<const glm::vec4>(colors));
    shader.set("uStyleSizeShape", std::span<const glm::vec2>(sizes));
    shader.set("uBackground", glm::vec3(view.background.r, view.background.g, view.background.b));
    cloud_.bind();
    DrawPacer pacer;
    for (const auto& [first, last] :
         cloudBounds_.within(view.camera, view.size, view.rect, places_.size()))
        pacer.drawPoints(first, last);
}

DrawPacer::~DrawPacer() { glDeleteSync(static_cast<GLsync>(fence_)); }

void DrawPacer::draw(unsigned mode, std::size_t vertices, std::size_t first, std::size_t last) {
    while (first < last) {
        if (full_ == kPiece) endPiece();
        const std::size_t count = std::min(last - first, kPiece - full_);
        glDrawArrays(mode, static_cast<GLint>(vertices * first),
                     static_cast<GLsizei>(vertices * count));
        first += count;
        full_ += count;
    }
}

/// Waits until the piece before this one is drawn.
void DrawPacer::endPiece() {
    full_ = 0;
    const auto before =
        static_cast<GLsync>(std::exchange(fence_, glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)));
    if (before == nullptr) return;
    glClientWaitSync(before, GL_SYNC_FLUSH_COMMANDS_BIT, kLongestWait);
    glDeleteSync(before);
}

}  // namespace se::view
