#include "spiraling_edge/points/wall_types.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

namespace se {
namespace {

/// The faces that `x` lies on.
std::uint8_t facesAt(const Vec3& x, const WallBox& box, double reach) {
    if (!isFinite(x)) return kInterior;
    unsigned faces = kInterior;
    for (const auto& [bit, axis, sign] : kWallFaces) {
        const double low = box.low[axis] - reach;
        const double high = box.high[axis] + reach;
        if (x[axis] < low || x[axis] > high) return kInterior;
        const bool isLong = box.high[axis] - box.low[axis] > 2.0 * reach;
        const bool isOn =
            sign > 0.0 ? x[axis] >= box.high[axis] - reach : x[axis] <= box.low[axis] + reach;
        if (isLong && isOn) faces |= bit;
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
        for (std::size_t i = 0; i < kWallFaces.size(); ++i) {
            if ((type[p] & kWallFaces[i].bit) != 0) ++count[i];
        }
    }
    unsigned walls = 0;
    constexpr std::size_t kLeast = 3;
    for (std::size_t i = 0; i < kWallFaces.size(); ++i) {
        if (count[i] >= kLeast) walls |= kWallFaces[i].bit;
    }
    for (std::uint8_t& t : type) t = withCornerBit(static_cast<std::uint8_t>(t & walls));
    return type;
}

}  // namespace se
