/// A vertex array with its buffers.
#pragma once

#include <cstddef>
#include <vector>

namespace se::view {

/// One vertex attribute of a batch.
struct VertexAttribute {
    unsigned location = 0;
    int components = 3;
    std::size_t offset = 0;
    bool bytes = false;  ///< Unsigned bytes read as integers; otherwise floats.
    bool signs = false;  ///< Signed bytes read as numbers from -1 to 1.
};

/// A vertex array with up to two buffers: one that seldom changes, one that often does.
class Batch {
  public:
    Batch() = default;
    ~Batch();
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    /// Describes the vertices of buffer `buffer` (0 or 1). With `perInstance`, one per instance.
    void describe(int buffer, std::size_t stride, const std::vector<VertexAttribute>& attributes,
                  bool perInstance = false);
    /// Replaces the contents of a buffer.
    void upload(int buffer, const void* data, std::size_t bytes);
    /// Replaces the bytes from `offset` on; grows the buffer, keeping what is before.
    void append(int buffer, std::size_t offset, const void* data, std::size_t bytes);
    void bind();

  private:
    void create();

    unsigned array_ = 0;
    unsigned buffers_[2] = {0, 0};
    std::size_t capacity_[2] = {0, 0};
};

}  // namespace se::view
