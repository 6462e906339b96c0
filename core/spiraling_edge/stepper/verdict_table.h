/// The verdicts of all tests in one table: their words, outcomes and what-ifs. A new verdict is a
/// value of Verdict (event.h) and a row here.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/what_if.h"

namespace se {

/// The effect of a decision on the tested point.
enum class Outcome : std::uint8_t {
    None,       ///< No test: a fact, such as a triangle made.
    Taken,      ///< Kept, moved, filled, inserted.
    Refused,    ///< Left out, removed, discarded.
    Unchanged,  ///< Not taken, and nothing removed: start or end stays, the point is in no test.
};
/// Refused or Unchanged: the decision was against the point.
constexpr bool isAgainst(Outcome outcome) {
    return outcome == Outcome::Refused || outcome == Outcome::Unchanged;
}

/// One verdict.
struct VerdictRow {
    Verdict id;
    std::string_view text;  ///< "inside sphere", as shown to users.
    Outcome outcome;
    std::optional<WhatIfKind>
        inverse;  ///< The what-if with the other outcome; none if there is none.
};

/// All verdicts, in the order of the enum.
std::span<const VerdictRow> verdictTable();
const VerdictRow& rowOf(Verdict verdict);

/// True if a decision took the tested point: kept, moved to, filled, inserted. Code that shows a
/// decision must follow this, not the numbers of its test: a rule or a what-if may override them.
bool isTaken(Verdict verdict);
/// True for the verdict of a what-if, whatever the test would have decided.
constexpr bool isWhatIf(Verdict verdict) {
    return verdict == Verdict::WhatIfKept || verdict == Verdict::WhatIfDropped;
}

}  // namespace se
