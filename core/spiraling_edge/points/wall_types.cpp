#include "spiraling_edge/points/wall_types.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

namespace se {
namespace {

constexpr std::array<std::uint8_t, 3> kHighFaces{kPositiveX, kPositiveY, kPositiveZ};
constexpr std::array<std::uint8_t, 3> kLowFaces{kNegativeX, kNegativeY, kNegativeZ};
constexpr std::array<std::uint8_t, 6> kFaces{kPositiveX, kPositiveY, kPositiveZ,
                                             kNegativeX, kNegativeY, kNegativeZ};

/// The faces that `x` lies on.
std::uint8_t facesAt(const Vec3& x, const WallBox& box, double reach) {
    if (!isFinite(x)) return kInterior;
    unsigned faces = kInterior;
    for (int axis = 0; axis < 3; ++axis) {
        if (x[axis] < box.low[axis] - reach || x[axis] > box.high[axis] + reach) return kInterior;
        if (!(box.high[axis] - box.low[axis] > 2.0 * reach)) continue;
        const auto i = static_cast<std::size_t>(axis);
        if (x[axis] <= box.low[axis] + reach) faces |= kLowFaces[i];
        if (x[axis] >= box.high[axis] - reach) faces |= kHighFaces[i];
    }
    return static_cast<std::uint8_t>(faces);
}

}  // namespace

WallBox boxAround(std::span<const Vec3> position) {
    WallBox box;
    bool any = false;
    for (const Vec3& x : position) {
        if (!isFinite(x)) continue;
        box.low = any ? glm::min(box.low, x) : x;
        box.high = any ? glm::max(box.high, x) : x;
        any = true;
    }
    return box;
}

std::vector<std::uint8_t> wallTypes(std::span<const Vec3> position, const WallBox& box) {
    const Vec3 sides = box.high - box.low;
    const double reach = box.tolerance * std::max({sides.x, sides.y, sides.z});
    std::vector<std::uint8_t> type(position.size());
    std::array<std::size_t, 6> count{};
    for (std::size_t p = 0; p < position.size(); ++p) {
        type[p] = facesAt(position[p], box, reach);
        for (std::size_t i = 0; i < kFaces.size(); ++i) {
            if ((type[p] & kFaces[i]) != 0) ++count[i];
        }
    }
    unsigned walls = 0;
    constexpr std::size_t kLeast = 3;
    for (std::size_t i = 0; i < kFaces.size(); ++i) {
        if (count[i] >= kLeast) walls |= kFaces[i];
    }
    for (std::uint8_t& t : type) t = withCornerBit(static_cast<std::uint8_t>(t & walls));
    return type;
}

}  // namespace se
