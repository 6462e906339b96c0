/// The upload of vertices in pieces: all of a large mesh at once would take its memory twice.
#pragma once

#include <cstddef>
#include <vector>

#include "gl_objects.h"

namespace se::view {

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

}  // namespace se::view
