/// The triangles near a place, for searches that test many others against them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "spiraling_edge/geometry/edge_planes.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {

/// Triangles of the mesh, numbered from 0, and others that are tested against them. The sides of
/// their corners in the planes of a tested one are found when first needed, and tell most pairs
/// apart.
class NearTriangles {
  public:
    /// Takes the triangles of a list. The points and the mesh must outlive it, without changes.
    NearTriangles(const PointSet& points, RepairState& m, std::span<const Index> list);

    std::size_t size() const { return index_.size(); }
    /// The index of a triangle in the mesh.
    Index index(std::size_t i) const { return index_[i]; }
    /// The triangle and its values, which are computed when first needed.
    const ShapedTriangle& shaped(std::size_t i) {
        if (!shaped_[i]) shaped_[i].emplace(points_, m_.triangles[index_[i]]);
        return *shaped_[i];
    }

    /// Adds a triangle to test; returns its number among those.
    std::size_t addTested(const Triangle& t);
    const ShapedTriangle& tested(std::size_t number) const { return tested_[number].shaped; }
    /// The first triangle, from number `from` on, with which a tested one is not clearly without
    /// conflict; size() if there is none.
    std::size_t nextDoubtful(std::size_t number, std::size_t from) {
        const Tested& mine = tested_[number];
        std::size_t i = from;
        while (i < size() && (!wide_[i].meets(mine.wide) || areApart(number, i))) ++i;
        return i;
    }
    /// True if a tested triangle is in conflict with triangle `i`.
    bool isInConflict(std::size_t number, std::size_t i) {
        return wide_[i].meets(tested_[number].wide) && !areApart(number, i) &&
               conflict(points_, tested_[number].shaped, shaped(i));
    }

  private:
    static constexpr std::uint8_t kUnknown = 0xFF;

    struct Tested {
        ShapedTriangle shaped;
        Box wide;
        EdgePlanes planes;
    };

    /// True if the sides of its corners tell triangle `i` and a tested one apart.
    bool areApart(std::size_t number, std::size_t i) {
        std::uint8_t* const sides = &sides_[number * corner_.size()];
        unsigned common = kUnknown;
        for (const Index place : corners_[i]) {
            if (sides[place] == kUnknown)
                sides[place] = tested_[number].planes.sidesOf(corner_[place]);
            common &= sides[place];
        }
        if ((common & EdgePlanes::kBeyondEdge) != 0) return true;
        return EdgePlanes::tellApart(common, tested_[number].shaped.shape, shaped(i).shape);
    }

    const PointSet& points_;
    const RepairState& m_;
    // Per triangle:
    std::vector<Index> index_;
    std::vector<Box> wide_;                      ///< Its box, grown by at least its reach.
    std::vector<std::array<Index, 3>> corners_;  ///< Positions in `corner_`.
    std::vector<std::optional<ShapedTriangle>> shaped_;

    std::vector<Index> corner_;  ///< The corners of all, each once.
    std::vector<Tested> tested_;
    std::vector<std::uint8_t> sides_;  ///< Per tested triangle and corner, or kUnknown.
};

}  // namespace se
