/// What the questions about a run ask of its events (ledger, moments of a failure, query lines).
#pragma once

#include <optional>
#include <string_view>

#include "spiraling_edge/replay/reading.h"

namespace se {

/// What a line tells about the subject.
enum class LineRole : std::uint8_t {
    Fact,     ///< What became of one of its points: ring, pivot, DONE.
    Taken,    ///< A test that it passed.
    Refused,  ///< A test that it failed, or that ended a fan it would have been in.
    Made,     ///< It came into the mesh.
    Undone,   ///< It went out of the mesh again.
};
/// "fact", "taken", "refused", "made", "undone".
std::string_view roleName(LineRole role);

/// One decision, where to find it, and what it meant.
struct LedgerLine {
    Event event;
    Index pivot = kNone;  ///< The point that was the pivot.
    LineRole role = LineRole::Fact;
    std::optional<Reading> reading;
};

/// The event as a line, its role by what became of the test.
LedgerLine lineOf(const Event& event, const ReadingContext& context);

/// Left out of the sort as a fact, not by a test: DONE, or first or last itself.
bool wasSettledBefore(const Event& event);

/// A step after the last pivot, which changes the mesh without saying which triangles.
bool mendsMesh(const Event& event);

}  // namespace se
