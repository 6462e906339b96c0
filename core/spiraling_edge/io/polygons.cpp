/// Ears by exact signs in the projection along the greatest component of the polygon's normal
/// (Newell). As many triangles as the fan has take its places.
#include "spiraling_edge/io/polygons.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "spiraling_edge/geometry/exact_predicates.h"

namespace se::io {
namespace {

constexpr std::size_t kMaxCorners = 1000;

/// A polygon of which ears are cut off.
class EarCut {
  public:
    EarCut(std::span<const Vec3> position, std::span<const Triangle> fan) : position_(position) {
        left_ = {fan.front().a, fan.front().b};
        for (const Triangle& t : fan) left_.push_back(t.c);
        // Relative to a corner: far from the origin little would be left.
        const Vec3 origin = position[left_[0]];
        for (const Triangle& t : fan)
            normal_ += glm::cross(position[t.b] - origin, position[t.c] - origin);
        const Vec3 size = glm::abs(normal_);
        if (size.y > size.x) dropped_ = Axis::Y;
        if (size.z > std::max(size.x, size.y)) dropped_ = Axis::Z;
        const auto axis = static_cast<Vec3::length_type>(dropped_);
        turn_ = normal_[axis] < 0.0 ? -1 : 1;
    }

    /// True if the triangle faces as the polygon does.
    bool faces(const Triangle& t) const {
        const Vec3& a = position_[t.a];
        return glm::dot(glm::cross(position_[t.b] - a, position_[t.c] - a), normal_) > 0.0;
    }

    /// The ears, in order around the polygon; fewer if it crosses itself.
    std::vector<Triangle> cut() {
        std::vector<Triangle> ears;
        std::size_t i = 0;
        for (std::size_t failed = 0; left_.size() > 2 && failed < left_.size();) {
            i %= left_.size();
            const Triangle ear{left_[(i + left_.size() - 1) % left_.size()], left_[i],
                               left_[(i + 1) % left_.size()]};
            if (!isEar(ear)) {
                ++failed;
                ++i;
                continue;
            }
            ears.push_back(ear);
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
            failed = 0;
        }
        return ears;
    }

  private:
    int turnOf(Index a, Index b, Index c) const {
        return turn_ * orient2d(position_[a], position_[b], position_[c], dropped_);
    }
    /// Corners at the place of one of the ear's, as where a slit joins a hole, are not within.
    bool isEar(const Triangle& ear) const {
        if (turnOf(ear.a, ear.b, ear.c) <= 0) return false;
        const auto isAt = [&](Index x) {
            const Vec3& at = position_[x];
            return at == position_[ear.a] || at == position_[ear.b] || at == position_[ear.c];
        };
        return std::none_of(left_.begin(), left_.end(), [&](Index x) {
            return !isAt(x) && turnOf(ear.a, ear.b, x) >= 0 && turnOf(ear.b, ear.c, x) >= 0 &&
                   turnOf(ear.c, ear.a, x) >= 0;
        });
    }

    std::span<const Vec3> position_;
    std::vector<Index> left_;
    Vec3 normal_{0.0};
    Axis dropped_ = Axis::X;
    int turn_ = 1;
};

}  // namespace

void Polygons::append(std::span<const Index> corners, std::vector<Triangle>& faces) {
    if (corners.size() > 3) fans_.push_back({faces.size(), corners.size() - 2});
    for (std::size_t i = 2; i < corners.size(); ++i)
        faces.push_back({corners[0], corners[i - 1], corners[i]});
}

void Polygons::cutConcave(std::span<const Vec3> position, std::vector<Triangle>& faces) const {
    for (const Fan& fan : fans_) {
        const std::span<Triangle> triangles = std::span(faces).subspan(fan.first, fan.triangles);
        EarCut polygon(position, triangles);
        const bool isRight = std::all_of(triangles.begin(), triangles.end(),
                                         [&](const Triangle& t) { return polygon.faces(t); });
        if (isRight || fan.triangles + 2 > kMaxCorners) continue;
        const std::vector<Triangle> ears = polygon.cut();
        if (ears.size() == triangles.size()) std::copy(ears.begin(), ears.end(), triangles.begin());
    }
}

}  // namespace se::io
