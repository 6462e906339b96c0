/// Breakpoints: query lines that a run stops at, in either direction of time. All hits of a line
/// are found by one run from the start, and going forward or back only looks them up: so both
/// directions stop at the same decisions.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/run/decision_query.h"

namespace se {

struct Breakpoint {
    std::string name;         ///< For display; may be empty.
    std::string line;         ///< See decision_query.h.
    std::uint32_t skip = 0;   ///< Number of first hits to pass over.
    std::uint32_t every = 1;  ///< Stops at each N-th of the hits after those; at least 1.
    bool on = true;
    bool logOnly = false;  ///< Never stops; its hits are listed.
    friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

/// True if hit number `hit` stops the run. Hits count from 1, in the order of the run from its
/// start, in both directions of time. A log-only breakpoint picks the hits that it lists in the
/// same way.
bool selectsHit(const Breakpoint& breakpoint, std::uint64_t hit);

/// A decision that a line matches.
struct Hit {
    RunPosition place;
    Address address;
    friend bool operator==(const Hit&, const Hit&) = default;
};

/// Maximum number of hits that are kept of a line.
inline constexpr std::size_t kMaxHits = std::size_t{1} << 22U;

/// The hits of a line known so far.
struct HitList {
    std::vector<Hit> hits;    ///< The first kMaxHits, in the order of the run.
    std::uint64_t total = 0;  ///< Including those that are not kept.

    /// Appends the next hit.
    void add(const Hit& hit) {
        if (++total <= kMaxHits) hits.push_back(hit);
    }
    /// Hits at `here` or before it.
    std::uint64_t upTo(RunPosition here) const;
};

/// Calls `found` with each decision of a run that one of `queries` matches, and the number of the
/// query, in the order of the run; the decision is gone after the call. Borrows the points and
/// params of the run.
PivotVisitor hitVisitor(const PointSet& points, const Params& params,
                        std::vector<DecisionQuery> queries,
                        std::function<void(std::size_t query, const Hit&, const Decision&)> found);

/// A breakpoint and the hits of its line.
struct ArmedBreakpoint {
    const Breakpoint* breakpoint;
    const HitList* hits;
};
/// The hit at which a run stops, and the breakpoint that stops it.
struct Stop {
    Hit hit;
    std::size_t breakpoint = 0;  ///< Position among those given; the first of several.
    std::uint64_t number = 0;    ///< Of the hit, from 1.
};
/// The first stop after `here`; nothing if there is none. Breakpoints that are off or log-only stop
/// nothing. O(log hits).
std::optional<Stop> nextStop(std::span<const ArmedBreakpoint> armed, RunPosition here);
/// The last stop before `here`.
std::optional<Stop> previousStop(std::span<const ArmedBreakpoint> armed, RunPosition here);

}  // namespace se
