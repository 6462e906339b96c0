/// Test for finite positions and normals.
#pragma once

#include <cmath>

#include "spiraling_edge/base/types.h"

namespace se {

inline bool isFinite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace se
