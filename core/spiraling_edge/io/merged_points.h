/// Points of triangles with corners of their own (STL, GLB): corners at the same place are one
/// point.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "spiraling_edge/base/float_bits.h"
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
        const auto [found, fresh] = numbers_.try_emplace(PlaceKey(place), next);
        if (fresh) addSeparate(place);
        addDirection(directions_[found->second], normal);
        return found->second;
    }
    /// A new point that no other is merged with.
    Index addSeparate(const Vec3& place, const Vec3& normal) {
        addSeparate(place);
        addDirection(directions_.back(), normal);
        return static_cast<Index>(position_.size() - 1);
    }

    std::size_t size() const { return position_.size(); }
    std::vector<Vec3> takePositions() { return std::move(position_); }
    /// Of each point, the unit vectors of its normals that differ; none without a normal.
    std::span<const std::vector<Vec3>> directions() const { return directions_; }

  private:
    /// A place as a key: its bits, the same for both zeros and for all that is not a number.
    struct PlaceKey {
        std::array<std::uint64_t, 3> bits{};

        explicit PlaceKey(const Vec3& x) {
            for (int axis = 0; axis < 3; ++axis) {
                if (!std::isnan(x[axis]))
                    bits[static_cast<std::size_t>(axis)] = bitsAs<std::uint64_t>(x[axis] + 0.0);
                else
                    bits[static_cast<std::size_t>(axis)] = ~std::uint64_t{0};
            }
        }
        friend bool operator==(const PlaceKey&, const PlaceKey&) = default;
    };
    struct PlaceHash {
        std::size_t operator()(const PlaceKey& key) const {
            std::uint64_t hash = 0;
            for (const std::uint64_t each : key.bits) hash = (hash ^ each) * 0x9e3779b97f4a7c15U;
            return static_cast<std::size_t>(hash ^ (hash >> 32U));
        }
    };

    void addSeparate(const Vec3& place) {
        position_.push_back(place);
        directions_.emplace_back();
    }

    std::vector<Vec3> position_;
    std::vector<std::vector<Vec3>> directions_;
    std::unordered_map<PlaceKey, Index, PlaceHash> numbers_;
};

}  // namespace se::io
