// Only what OpenGL 3.3 and OpenGL ES 3.0 share: blits from several samples to one with equal
// rectangles and formats, and no depth that is read while it is attached.
#include "kept_picture.h"

#include <glad/gl.h>

#include <glm/common.hpp>

#include "gl_objects.h"

namespace se::view {

namespace {

/// Samples a pixel of the surfaces. Lines and marks have smooth edges of their own.
constexpr GLint kSamples = 4;
/// Places in frames_, buffers_ and textures_.
enum FrameSlot : std::uint8_t { kSampled, kSurfaces, kShaded, kKept, kPicture };
enum BufferSlot : std::uint8_t { kSampledColor, kSampledDepth, kPictureDepth };
enum TextureSlot : std::uint8_t { kSurfaceColor, kSurfaceDepth, kKeptColor, kPictureColor };

void attach(GLuint frame, GLuint color, GLuint depth) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    if (depth == 0) return;
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
}

void copy(GLuint from, GLuint to, const PixelRect& rect, GLbitfield what) {
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(rect.min.x, rect.min.y, rect.max.x, rect.max.y, rect.min.x, rect.min.y,
                      rect.max.x, rect.max.y, what, GL_NEAREST);
}

}  // namespace

KeptPicture::~KeptPicture() {
    glDeleteFramebuffers(static_cast<GLsizei>(frames_.size()), frames_.data());
    glDeleteRenderbuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
}

bool KeptPicture::resize(glm::ivec2 size, const Color& background) {
    size = glm::max(size, glm::ivec2(1));
    if (size == size_) return false;
    size_ = size;
    GLint bound = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    if (frames_[kSampled] == 0) {
        glGenFramebuffers(static_cast<GLsizei>(frames_.size()), frames_.data());
        glGenRenderbuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        glGenTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    }
    allocateTextures();
    allocateSurfaces();
    for (const unsigned frame : frames_)
        beginNew(frame, {background.r, background.g, background.b, 1.0F});
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
    return true;
}

void KeptPicture::allocateSurfaces() {
    const int samples = samplesOf(kSamples);
    glBindFramebuffer(GL_FRAMEBUFFER, frames_[kSampled]);
    allocateBuffer(buffers_[kSampledColor], samples, GL_RGBA8, size_, GL_COLOR_ATTACHMENT0);
    allocateBuffer(buffers_[kSampledDepth], samples, GL_DEPTH_COMPONENT24, size_,
                   GL_DEPTH_ATTACHMENT);
}

void KeptPicture::allocateTextures() {
    for (std::size_t i = 0; i < textures_.size(); ++i)
        allocateTexture(textures_[i], i == kSurfaceDepth ? GL_DEPTH_COMPONENT24 : GL_RGBA8, size_,
                        GL_NEAREST);
    attach(frames_[kSurfaces], textures_[kSurfaceColor], textures_[kSurfaceDepth]);
    attach(frames_[kShaded], textures_[kKeptColor], 0);
    attach(frames_[kKept], textures_[kKeptColor], textures_[kSurfaceDepth]);
    attach(frames_[kPicture], textures_[kPictureColor], 0);
    allocateBuffer(buffers_[kPictureDepth], 0, GL_DEPTH_COMPONENT24, size_, GL_DEPTH_ATTACHMENT);
}

void KeptPicture::begin() { glGetIntegerv(GL_FRAMEBUFFER_BINDING, &previous_); }

void KeptPicture::beginSurfaces(const PixelRect& rect, const Color& background, Finish finish) {
    const bool smooth = finish == Finish::Full;
    unresolved_ = smooth ? rect : PixelRect{};
    aimAt(frames_[smooth ? kSampled : kSurfaces], size_, rect);
    glClearColor(background.r, background.g, background.b, 1.0F);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void KeptPicture::endSurfaces() {
    if (unresolved_.empty()) return;
    copy(frames_[kSampled], frames_[kSurfaces], unresolved_,
         GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void KeptPicture::beginShading(const PixelRect& rect) { aimAt(frames_[kShaded], size_, rect); }

void KeptPicture::beginPoints(const PixelRect& rect) { aimAt(frames_[kKept], size_, rect); }

void KeptPicture::beginOverlay() {
    copy(frames_[kKept], frames_[kPicture], whole(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, frames_[kPicture]);
    glViewport(0, 0, size_.x, size_.y);
}

void KeptPicture::end() { glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(previous_)); }

}  // namespace se::view
