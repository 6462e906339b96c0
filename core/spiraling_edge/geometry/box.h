/// Axis-aligned boxes, and the grid cells they touch, to skip exact tests of shapes that are apart.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// An axis-aligned box, bounds included.
struct Box {
    Vec3 low, high;

    explicit Box(const Vec3& p) : low(p), high(p) {}
    friend bool operator==(const Box&, const Box&) = default;
    /// Grows the box so that it holds `p`.
    void add(const Vec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    /// The box that reaches farther by `width` on every side.
    Box grown(double width) const { return grown(Vec3(width)); }
    /// The box that reaches farther by `width` on both sides of each axis.
    Box grown(const Vec3& width) const {
        Box box = *this;
        box.low -= width;
        box.high += width;
        return box;
    }
    bool meets(const Box& o) const {
        return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y &&
               low.z <= o.high.z && o.low.z <= high.z;
    }
    /// grown(width).meets(o)
    bool meets(const Box& o, double width) const {
        return low.x - width <= o.high.x && o.low.x <= high.x + width &&
               low.y - width <= o.high.y && o.low.y <= high.y + width &&
               low.z - width <= o.high.z && o.low.z <= high.z + width;
    }
};

inline Box boxOf(const PointSet& points, const Triangle& t) {
    Box box(points.position[t.a]);
    box.add(points.position[t.b]);
    box.add(points.position[t.c]);
    return box;
}

/// Grid cells that boxes touch: two boxes that meet have a cell in common.
class BoxCells {
  public:
    /// Maximum number of cells of a box; larger boxes are kept apart.
    static constexpr std::uint64_t kManyCells = 512;

    /// A block is a cube of 2 to this power cells a side.
    static constexpr unsigned kBlockBits = 4;

    /// `low` is the lower corner of the grid: boxes that reach below it are in its first cells.
    /// `cell` is the width of a cell, above 0.
    BoxCells(Vec3 low, double cell) : low_(low), perCell_(1.0 / cell) {}

    /// Calls `visit` with the number of each cell. False, without a call, if they are too many.
    template <typename Visit>
    bool forEachCell(const Vec3& low, const Vec3& high, Visit&& visit) const {
        const CellPosition from = positionOf(low);
        const CellPosition to = positionOf(high);
        if (areTooMany(from, to)) return false;
        visitRange(from, to, visit);
        return true;
    }
    /// As forEachCell(), with the number of each block of cells.
    template <typename Visit>
    bool forEachBlock(const Vec3& low, const Vec3& high, Visit&& visit) const {
        CellPosition from = positionOf(low);
        CellPosition to = positionOf(high);
        if (areTooMany(from, to)) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            from[i] >>= kBlockBits;
            to[i] >>= kBlockBits;
        }
        visitRange(from, to, visit);
        return true;
    }
    /// The block that a cell is in.
    static std::uint64_t blockOf(std::uint64_t cell) {
        constexpr std::uint64_t kPlace = (1U << (21U - kBlockBits)) - 1;
        return (cell >> kBlockBits) & ((kPlace << 42U) | (kPlace << 21U) | kPlace);
    }

    /// The one cell, of all that both boxes touch, in which the pair is tested.
    std::uint64_t cellOfPair(const Vec3& lowA, const Vec3& lowB) const {
        const CellPosition c = positionOf(glm::max(lowA, lowB));
        return numberOf(c[0], c[1], c[2]);
    }

  private:
    using CellPosition = std::array<std::uint64_t, 3>;  ///< Along each axis.

    static std::uint64_t numberOf(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
        return (x << 42U) | (y << 21U) | z;
    }
    static bool areTooMany(const CellPosition& from, const CellPosition& to) {
        std::uint64_t count = 1;
        for (std::size_t i = 0; i < 3; ++i)
            count *= std::min<std::uint64_t>(to[i] - from[i] + 1, 1U << 20U);
        return count > kManyCells;
    }
    template <typename Visit>
    static void visitRange(const CellPosition& from, const CellPosition& to, Visit& visit) {
        for (std::uint64_t x = from[0]; x <= to[0]; ++x) {
            for (std::uint64_t y = from[1]; y <= to[1]; ++y) {
                for (std::uint64_t z = from[2]; z <= to[2]; ++z) visit(numberOf(x, y, z));
            }
        }
    }

    CellPosition positionOf(const Vec3& p) const {
        constexpr double kMax = (1U << 21U) - 1;
        CellPosition cell{};
        for (int i = 0; i < 3; ++i) {
            const double x = (p[i] - low_[i]) * perCell_;
            cell[static_cast<std::size_t>(i)] =
                static_cast<std::uint64_t>(std::min(std::max(x, 0.0), kMax));
        }
        return cell;
    }

    Vec3 low_;
    double perCell_;
};

}  // namespace se
