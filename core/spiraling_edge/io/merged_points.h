/// Points of triangles with corners of their own (STL, GLB): corners at the same place are one
/// point.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/place_table.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/points/usable_points.h"

namespace se::io {

/// Points by their exact places, with the different directions of their normals.
class MergedPoints {
  public:
    /// The point at `place`, a new one unless there is one. Its normal gets one more direction,
    /// unless `normal` has none.
    Index add(const Vec3& place, const Vec3& normal) {
        const auto next = static_cast<Index>(position_.size());
        position_.push_back(place);
        const Index point = isFinite(place) ? table_.add(position_, next) : next;
        if (point != next) position_.pop_back();
        directions_.resize(position_.size());
        addDirection(directions_[point], normal);
        return point;
    }
    /// A new point that no other is merged with.
    Index addSeparate(const Vec3& place, const Vec3& normal) {
        position_.push_back(place);
        addDirection(directions_.emplace_back(), normal);
        return static_cast<Index>(position_.size() - 1);
    }

    std::size_t size() const { return position_.size(); }
    std::vector<Vec3> takePositions() { return std::move(position_); }
    /// Of each point, the unit vectors of its normals that differ; none without a normal.
    std::span<const std::vector<Vec3>> directions() const { return directions_; }

  private:
    std::vector<Vec3> position_;
    std::vector<std::vector<Vec3>> directions_;
    PlaceTable table_;
};

}  // namespace se::io
