/// Triangles by point: maintained as triangles are made, so that a click needs no pass over all of
/// them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "run/model.h"

namespace se::view {

class MeshIndex {
  public:
    /// Adds the triangles after those that are indexed already.
    void append(const Model& model, std::span<const Triangle> all);
    std::size_t triangleCount() const { return next_.size() / 3; }
    bool empty() const { return next_.empty(); }

    /// Calls a function with the number of each triangle at a point, the latest first.
    template <typename Function>
    void forEachAt(Index point, Function&& function) const {
        if (point >= head_.size()) return;
        for (std::uint32_t corner = head_[point]; corner != kNone; corner = next_[corner]) {
            function(corner / 3);
        }
    }
    /// Distance, in view units, that triangles with `point` as their first corner reach.
    float reach(Index point) const { return reach_[point]; }

    /// The triangles at an edge, the earliest first.
    std::vector<std::uint32_t> atEdge(std::span<const Triangle> all, Index a, Index b) const;
    /// The first triangle with these corners in this orientation.
    std::optional<std::uint32_t> find(std::span<const Triangle> all,
                                      const Triangle& triangle) const;

  private:
    // Corner 3 t + k is corner k of triangle t.
    std::vector<std::uint32_t> head_;  ///< The latest corner of each point.
    std::vector<std::uint32_t> next_;  ///< Per corner: the previous corner of the same point.
    std::vector<float> reach_;
};

}  // namespace se::view
