/// A short mark of what an input holds, so that a session file can tell whether it is still the
/// same.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "spiraling_edge/io/read_points.h"

namespace se::view {

/// 64-bit FNV-1a, taken piece by piece. Told apart are files that differ, not attackers.
class InputHash {
  public:
    void add(std::string_view bytes);
    /// "fnv1a64:" and 16 hexadecimal digits.
    std::string text() const;

  private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// Of positions, then normals, as little endian doubles: for what has no file.
std::string hashOfPoints(const PointFile& points);

}  // namespace se::view
