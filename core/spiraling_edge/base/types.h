/// The basic types of the library.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace se {

using Vec3 = glm::dvec3;

inline bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Index of a point, a ring entry or a ring. 32 bits: at most 4,294,967,294 of each.
using Index = std::uint32_t;
/// "No such thing", for any Index.
inline constexpr Index kNone = 0xffffffffU;

/// Three point indices, counterclockwise seen from the tip of the normals (§6.4, Fig. 10).
struct Triangle {
    Index a = kNone;
    Index b = kNone;
    Index c = kNone;
    friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// True if all corners are below `points`. O(t) for t triangles.
inline bool cornersBelow(std::span<const Triangle> triangles, std::size_t points) {
    return std::all_of(triangles.begin(), triangles.end(), [points](const Triangle& t) {
        return t.a < points && t.b < points && t.c < points;
    });
}

}  // namespace se
