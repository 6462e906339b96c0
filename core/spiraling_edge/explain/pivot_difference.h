/// Two runs at the same pivot, after the same steps: whether it makes the same in both, and if any
/// of its decisions fell differently.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "spiraling_edge/stepper/event.h"

namespace se {

/// Positions in the two lists of events; size() where there is no such event.
struct Mismatch {
    std::size_t a = 0;
    std::size_t b = 0;
    bool aDecides = false;  ///< Else `a` is what happens there instead.
    bool bDecides = false;
    bool listsDiffer = false;  ///< Only one of the runs looks at the point, from its lists.
    /// The first point that only one of the lists has, and that it takes; kNone if there is none.
    Index onlyInA = kNone;
    Index onlyInB = kNone;
};

/// True if seeds, rings, triangles and the way on are the same; tests may have gone otherwise.
bool makesTheSame(std::span<const Event> a, std::span<const Event> b);

/// The first test that fell differently, in the order of the stages; nothing if none did. What only
/// one run looks at, from its lists, does not count.
std::optional<Mismatch> firstOtherTest(std::span<const Event> a, std::span<const Event> b);

/// The same for a pivot that does not make the same: if no test explains it, the point that only
/// one run has in a list, or else the first thing that is done differently.
Mismatch firstDifference(std::span<const Event> a, std::span<const Event> b);

/// One sentence. `pivot` is the pivot's point, kNone outside of one.
std::string wordsFor(const Mismatch& mismatch, std::span<const Event> a, std::span<const Event> b,
                     Index pivot);

}  // namespace se
