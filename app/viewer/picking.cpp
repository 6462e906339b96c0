#include "picking.h"

#include <glm/geometric.hpp>
#include <limits>

namespace se::view {

Index pickPoint(const Model& model, const CameraMatrices& camera, glm::vec2 size, glm::vec2 pixel,
                float radius) {
    Index best = kNone;
    float bestDepth = std::numeric_limits<float>::max();
    bool bestFaces = false;
    const glm::vec3 back(glm::vec4(0.0F, 0.0F, 1.0F, 0.0F) * camera.view);
    for (std::size_t p = 0; p < model.place.size(); ++p) {
        if (!model.drawable[p]) continue;
        const glm::vec3 at = project(camera, model.place[p], size);
        if (at.z <= 0.0F || glm::distance(glm::vec2(at), pixel) > radius) continue;
        const glm::vec3 toEye = camera.orthographic ? back : camera.eye - model.place[p];
        const bool faces = glm::dot(toEye, model.normal[p]) >= 0.0F;
        if (bestFaces && !faces) continue;
        if (faces != bestFaces || at.z < bestDepth) {
            best = static_cast<Index>(p);
            bestDepth = at.z;
            bestFaces = faces;
        }
    }
    return best;
}

}  // namespace se::view
