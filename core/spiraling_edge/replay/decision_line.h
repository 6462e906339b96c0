/// Decisions as lines, for the queries about a run (ledger, moments of a failure, query lines).
#pragma once

#include <optional>
#include <string_view>

#include "spiraling_edge/replay/reading.h"

namespace se {

/// Role of a line for the subject.
enum class LineRole : std::uint8_t {
    Fact,     ///< A change of one of its points: ring, pivot, DONE.
    Taken,    ///< A test that it passed.
    Refused,  ///< A test that it failed, or that ended a fan it would have been in.
    Made,     ///< It was added to the mesh.
    Undone,   ///< It was removed from the mesh.
};
/// "fact", "taken", "refused", "made", "undone".
std::string_view roleName(LineRole role);

/// One decision, its place and its reading.
struct LedgerLine {
    Event event;
    Index pivot = kNone;  ///< The point that was the pivot.
    LineRole role = LineRole::Fact;
    std::optional<Reading> reading;
};

/// The line of an event, with the role Taken or Refused by the outcome of its test, else Fact.
LedgerLine lineOf(const Event& event, const ReadingContext& context);

/// True for a point left out of the sort by a fact, not a test: DONE, or first or last itself.
bool wasSettledBefore(const Event& event);

/// True for a step after the last pivot, which changes the mesh without naming the triangles.
bool editsMesh(const Event& event);

}  // namespace se
