#include "relief.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>

namespace se::view {

namespace {

/// Radius of the surroundings that occlude a place, in em.
constexpr float kOcclusionEm = 1.6F;
/// Width of outlines, in em; at least one pixel.
constexpr float kOutlineEm = 0.075F;

}  // namespace

Relief::~Relief() { release(); }

void Relief::release() {
    glDeleteFramebuffers(1, &frame_);
    glDeleteTextures(1, &texture_);
    frame_ = texture_ = 0;
}

int Relief::reach(float em) { return static_cast<int>(std::ceil(kOcclusionEm * em)) + 6; }

void Relief::allocate(glm::ivec2 size) {
    if (size == size_) return;
    if (size_.x > 0) release();
    size_ = size;
    glGenTextures(1, &texture_);
    allocateTexture(texture_, GL_R8, size, GL_LINEAR);
    glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    beginNew(frame_, glm::vec4(1.0F));
}

void Relief::useDepth(Shader& shader, const KeptPicture& picture, const CameraMatrices& camera) {
    shader.use();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture.surfaceDepth());
    shader.set("uDepth", 0);
    shader.set("uLens", glm::vec2(camera.projection[2][2], camera.projection[3][2]));
    shader.set("uOrthographic", camera.orthographic);
    const auto height = static_cast<float>(picture.size().y);
    shader.set("uPixel", 2.0F / (camera.projection[1][1] * height));
    nothing_.bind();
}

void Relief::findOcclusion(const KeptPicture& picture, const PixelRect& rect,
                           const CameraMatrices& camera, float em) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    allocate((picture.size() + 1) / 2);
    // The average below reads two pixels around.
    aimAt(frame_, size_, PixelRect{rect.min / 2, (rect.max + 1) / 2}.grown(2, size_));
    useDepth(shaders_.occlusion, picture, camera);
    shaders_.occlusion.set("uReach", kOcclusionEm * em);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Relief::shade(KeptPicture& picture, const PixelRect& rect, const CameraMatrices& camera,
                   float em, bool full) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDepthMask(GL_FALSE);
    picture.beginShading(rect);
    Shader& shader = full ? shaders_.relief : shaders_.outline;
    useDepth(shader, picture, camera);
    shader.set("uStep", static_cast<int>(std::max(1.0F, std::round(kOutlineEm * em))));
    shader.set("uColor", 1);
    shader.set("uOcclusion", 2);
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, picture.surfaceColor());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace se::view
