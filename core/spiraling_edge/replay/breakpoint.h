/// Breakpoints: query lines that a run stops at, in either direction of time. All hits of a line
/// are found by one run from the start, and going forward or back only looks them up: so both
/// directions stop at the same decisions.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/replay/decision_scan.h"

namespace se {

struct Breakpoint {
    std::string name;         ///< For people; may be empty.
    std::string line;         ///< See decision_query.h.
    std::uint32_t skip = 0;   ///< The first hits that are passed over.
    std::uint32_t every = 1;  ///< Of the hits behind those, only each N-th; at least 1.
    bool on = true;
    bool logOnly = false;  ///< Never stops; its hits are listed.
    friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

/// Is hit number `hit` one to stop at? Hits count from 1, in the order of the run from its start,
/// whichever way one goes: so a count means the same from both sides. Log-only ones pick the hits
/// that they list in the same way.
bool picks(const Breakpoint& breakpoint, std::uint64_t hit);

/// A decision that a line matches.
struct Hit {
    RunPlace place;
    Address address;
    friend bool operator==(const Hit&, const Hit&) = default;
};

/// No more hits of a line are kept.
inline constexpr std::size_t kMostHits = std::size_t{1} << 22U;

/// The hits of a line, as far as they are known.
struct HitList {
    std::vector<Hit> hits;    ///< The first kMostHits, in the order of the run.
    std::uint64_t total = 0;  ///< Also of those that are not kept.

    /// The next one.
    void add(const Hit& hit) {
        if (++total <= kMostHits) hits.push_back(hit);
    }
    /// Hits at `here` or before it.
    std::uint64_t upTo(RunPlace here) const;
};

/// Calls `found` with each decision of a run that one of `queries` matches, and the number of the
/// query, in the order of the run; the decision is gone after the call. Stored is nothing. False if
/// `progress` cancelled. O(run).
bool scanHits(const PointSet& points, const Params& params, std::span<const DecisionQuery> queries,
              const std::function<void(std::size_t query, const Hit&, const Decision&)>& found,
              const Progress& progress = {});

/// A breakpoint and the hits of its line.
struct ArmedBreakpoint {
    const Breakpoint* breakpoint;
    const HitList* hits;
};
/// Where a run stops, and what stops it there.
struct Stop {
    Hit hit;
    std::size_t breakpoint = 0;  ///< Among those given; the first one of several.
    std::uint64_t number = 0;    ///< Of the hit, from 1.
};
/// The first stop behind `here`; nothing if there is none. Breakpoints that are off or log-only
/// stop nothing. O(log hits).
std::optional<Stop> nextStop(std::span<const ArmedBreakpoint> armed, RunPlace here);
/// The last stop before `here`.
std::optional<Stop> previousStop(std::span<const ArmedBreakpoint> armed, RunPlace here);

}  // namespace se
