/// Draws millions of items in pieces, of which at most two wait to be drawn.
#pragma once

#include <cstddef>

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
    void drawPoints(std::size_t first, std::size_t last);
    /// Draws the triangles `first` up to but not including `last`, of three vertices each.
    void drawTriangles(std::size_t first, std::size_t last);

  private:
    void draw(unsigned mode, std::size_t vertices, std::size_t first, std::size_t last);
    void endPiece();

    std::size_t full_ = 0;   ///< Items of the present piece.
    void* fence_ = nullptr;  ///< GLsync at the end of the piece before; null: none.
};

}  // namespace se::view
