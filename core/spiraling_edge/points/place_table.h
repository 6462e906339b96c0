/// Points by their exact places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/base/float_bits.h"
#include "spiraling_edge/base/types.h"

namespace se {

/// Points at different places: a hash table by open addressing, each slot a point or kNone.
class PlaceTable {
  public:
    /// `points`: the number that is expected; more may follow.
    explicit PlaceTable(std::size_t points = 8) {
        std::size_t slots = 16;
        while (slots < 2 * points) slots *= 2;
        slots_.assign(slots, kNone);
    }

    /// Adds point p, unless another one at the same position was added before. Returns the one in
    /// the table. Requires a finite position, and those of the points before unchanged.
    Index add(std::span<const Vec3> position, Index p) {
        if (2 * count_ > slots_.size()) widen(position);
        Index& slot = slotOf(position, p);
        if (slot == kNone) {
            slot = p;
            ++count_;
        }
        return slot;
    }

  private:
    /// The slot of the point at the place of p, or the free one for it.
    Index& slotOf(std::span<const Vec3> position, Index p) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = hash(position[p]) & mask;
        while (slots_[slot] != kNone && position[slots_[slot]] != position[p])
            slot = (slot + 1) & mask;
        return slots_[slot];
    }
    void widen(std::span<const Vec3> position) {
        std::vector<Index> wider(2 * slots_.size(), kNone);
        slots_.swap(wider);
        for (const Index p : wider) {
            if (p != kNone) slotOf(position, p) = p;
        }
    }
    static std::size_t hash(const Vec3& v) {
        std::uint64_t h = 0;
        for (const double coordinate : {v.x, v.y, v.z}) {
            const auto bits =
                bitsAs<std::uint64_t>(coordinate + 0.0);  // -0 equals 0: hashes like it
            h = (h ^ bits) * 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio: spreads low bits upwards
            h ^= h >> 32U;
        }
        return static_cast<std::size_t>(h);
    }

    std::vector<Index> slots_;
    std::size_t count_ = 0;
};

}  // namespace se
