/// A hash of an input's content, by which a session file recognizes a changed input.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "spiraling_edge/io/read_points.h"

namespace se::view {

/// 64-bit FNV-1a, computed piecewise. It detects changes, not attacks.
class InputHash {
  public:
    void add(std::string_view bytes);
    /// "fnv1a64:" and 16 hexadecimal digits.
    std::string text() const;

  private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// Hash of positions, then normals, as little endian doubles: for inputs without a file.
std::string hashOfPoints(const PointFile& points);

}  // namespace se::view
