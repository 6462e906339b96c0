#include "draw_pacer.h"

#include <glad/gl.h>

#include <algorithm>
#include <utility>

namespace se::view {

namespace {

/// Items of a piece.
constexpr std::size_t kPiece = std::size_t{1} << 16U;
/// Longest wait for a piece, in nanoseconds: nothing depends on its success.
constexpr GLuint64 kLongestWait = 1'000'000'000;

}  // namespace

DrawPacer::~DrawPacer() { glDeleteSync(static_cast<GLsync>(fence_)); }

void DrawPacer::drawPoints(std::size_t first, std::size_t last) { draw(GL_POINTS, 1, first, last); }

void DrawPacer::drawTriangles(std::size_t first, std::size_t last) {
    draw(GL_TRIANGLES, 3, first, last);
}

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
