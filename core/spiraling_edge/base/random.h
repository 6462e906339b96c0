/// Random numbers that are the same on every machine.
#pragma once

#include <cstdint>

#include "spiraling_edge/base/types.h"

namespace se {

/// SplitMix64 (Vigna 2015); the distributions of the standard library differ between libraries.
class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }
    /// In [0, 1).
    double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
    Vec3 inBox(const Vec3& low, const Vec3& high) {
        return low + (high - low) * Vec3{unit(), unit(), unit()};  // Braces keep the order.
    }

  private:
    std::uint64_t state_;
};

}  // namespace se
