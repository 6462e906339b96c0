/// One decision as the queries about a run see it: its verdict, the numbers that it compared, and
/// its line in their answers.
#pragma once

#include <optional>
#include <string_view>

#include "spiraling_edge/stepper/params.h"
#include "spiraling_edge/stepper/verdict_table.h"

namespace se {

/// The evidence of an event, if it is of this kind; else null.
template <typename Kind>
const Kind* as(const Event& event) {
    return std::get_if<Kind>(&event.evidence);
}
template <typename Kind>
bool isA(const Event& event) {
    return std::holds_alternative<Kind>(event.evidence);
}

/// The verdict of a test; nothing if the event is no test.
std::optional<Verdict> verdictOf(const Event& event);
/// The outcome of a test; None if the event is no test.
Outcome outcomeOf(const Event& event);
/// The tested point, or the point that an event changed; kNone if it is none or several.
Index testedPoint(const Event& event);
/// The point that an event is about; kNone if there is none. Beside tests, also that of a pivot,
/// of an advance, and of a step after the last pivot.
Index subjectOf(const Event& event);

/// True if the pivot, t and s lie on a circle, so that the sphere of §6.3 exists.
bool hasSphere(const SphereEvidence& evidence);

/// The number that decided. Decisions that compare nothing, such as "is DONE", have none, nor do
/// those of a what-if, or of numbers that a rule leaves out.
struct Reading {
    std::string_view quantity;  ///< "angle", "distance from the center"
    std::string_view unit;      ///< "deg", or empty: scene units.
    double value = 0.0;
    double threshold = 0.0;
    /// Signed, > 0 where the tested point is taken, < 0 where refused; at 0 the decision changes.
    /// An angle in radians, or a length over the tested point's distance from the pivot: about the
    /// move of the tested point that would change it, as a share of that distance. Where two
    /// numbers decide together (§6.3), the margin of the one that would have to change.
    double margin = 0.0;
};

/// The context of an event: its run, and the point that was the pivot.
struct ReadingContext {
    const PointSet& points;
    const Params& params;
    Index pivot;  ///< kNone outside of a pivot.
};

/// The reading of an event; nothing if it compared nothing.
std::optional<Reading> readingOf(const Event& event, const ReadingContext& context);

/// Role of a line for the subject.
enum class LineRole : std::uint8_t {
    Fact,     ///< A change of one of its points: ring, pivot, DONE.
    Taken,    ///< A test that it passed.
    Refused,  ///< A test that it failed, or that ended a fan it would have been in.
    /// A test of other points that decided about it: one that made way for it, or that put
    /// something in its place.
    Indirect,
    Made,    ///< It was added to the mesh.
    Undone,  ///< It was removed from the mesh.
};
/// "fact", "taken", "refused", "indirect", "made", "undone".
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
