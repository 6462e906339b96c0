#include "picking.h"

#include <glm/geometric.hpp>
#include <limits>

namespace se::view {

namespace {

/// Looks at one point after the other and keeps the best.
class Picker {
  public:
    Picker(const Model& model, const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
           float radius)
        : model_(model),
          camera_(camera),
          size_(size),
          pixel_(pixel),
          radius_(radius),
          back_(glm::vec4(0.0F, 0.0F, 1.0F, 0.0F) * camera.view) {}

    void look(Index p) {
        if (!model_.drawable[p]) return;
        const glm::vec3 at = project(camera_, model_.place[p], size_);
        if (at.z <= 0.0F || glm::distance(glm::vec2(at), pixel_) > radius_) return;
        const glm::vec3 toEye = camera_.orthographic ? back_ : camera_.eye - model_.place[p];
        const bool faces = glm::dot(toEye, model_.normal[p]) >= 0.0F;
        if (bestFaces_ && !faces) return;
        if (faces == bestFaces_ && at.z >= bestDepth_) return;
        best_ = p;
        bestDepth_ = at.z;
        bestFaces_ = faces;
    }
    Index best() const { return best_; }

  private:
    const Model& model_;
    const CameraMatrices& camera_;
    glm::vec2 size_;
    glm::vec2 pixel_;
    float radius_;
    glm::vec3 back_;
    Index best_ = kNone;
    float bestDepth_ = std::numeric_limits<float>::max();
    bool bestFaces_ = false;
};

}  // namespace

Index pickPoint(const Model& model, const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                float radius) {
    Picker picker(model, camera, size, pixel, radius);
    for (std::size_t p = 0; p < model.place.size(); ++p) picker.look(static_cast<Index>(p));
    return picker.best();
}

Index pickAmong(const Model& model, std::span<const Index> points, const CameraMatrices& camera,
                glm::vec2 size, glm::vec2 pixel, float radius) {
    Picker picker(model, camera, size, pixel, radius);
    for (const Index p : points) picker.look(p);
    return picker.best();
}

}  // namespace se::view
