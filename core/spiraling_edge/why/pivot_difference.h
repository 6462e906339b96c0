/// Comparison of two runs at the same pivot, after the same steps: whether its results are equal,
/// and which of its decisions differ.
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
    bool aDecides = false;  ///< False: `a` is the event there instead.
    bool bDecides = false;
    /// Only one of the runs tests the point, since only its list holds it.
    bool listsDiffer = false;
    /// The first point that only one of the lists has, and that it takes; kNone if there is none.
    Index onlyInA = kNone;
    Index onlyInB = kNone;
};

/// True if seeds, rings, triangles and the next pivot are the same; tests may differ.
bool sameResult(std::span<const Event> a, std::span<const Event> b);

/// The first test with different outcomes, in the order of the stages; nothing if there is none.
/// Points in the list of only one run do not count.
std::optional<Mismatch> firstOtherTest(std::span<const Event> a, std::span<const Event> b);

/// The first difference of a pivot whose results differ: a test, or if none differs, the point that
/// only one run has in a list, or else the first different event.
Mismatch firstDifference(std::span<const Event> a, std::span<const Event> b);

/// One sentence about the mismatch. `pivot` is the pivot's point, kNone outside a pivot.
std::string wordsFor(const Mismatch& mismatch, std::span<const Event> a, std::span<const Event> b,
                     Index pivot);

}  // namespace se
