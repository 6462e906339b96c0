/// Conditions that must hold between two pivots. The numbers are those of section "Invariants" in
/// docs/architecture.md.
#pragma once

#include <string>
#include <unordered_map>

#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/state.h"

namespace se {

/// Checks the invariants that hold on any input and that a single State can show: 1, 2, 8, 11
/// and 13. Returns a sentence about the first violation; empty if all hold. Call it between pivots.
/// O(points).
std::string checkInvariants(const State& state, const PointSet& points, const Params& params);

/// Follows a run from its beginning and checks every invariant after every pivot, including those
/// that need the previous state. O(points) per pivot: for tests and debugging, not for production.
class InvariantChecker {
  public:
    /// The set of invariants to expect.
    enum class Level : std::uint8_t {
        AnyInput,     ///< 1, 2, 6 to 11, 13.
        Guarded,      ///< Also 3 and 5, which RobustRules::guard guarantees on any input.
        WellSampled,  ///< Also 12: edges and rings fit together as on a manifold.
    };

    InvariantChecker(const PointSet& points, const Params& params, Level level);

    /// Call after every stepPivot(), first of all for a fresh State. Empty if all hold.
    std::string check(const State& state);

  private:
    std::string checkPivot(const State& state) const;
    std::string checkStatusChanges(const State& state) const;
    std::string checkRingCount(const State& state) const;
    std::string checkEdges(const State& state);
    std::string checkSurrounded(const State& state) const;

    const PointSet& points_;
    Params params_;
    Level level_;
    /// Triangles that pass u -> v in this direction, by (u, v).
    std::unordered_map<std::uint64_t, int> directedEdges_;
    std::vector<std::vector<Index>> trianglesOf_;
    State before_;  ///< At the previous check.
};

}  // namespace se
