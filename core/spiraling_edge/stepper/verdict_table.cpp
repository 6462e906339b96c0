#include "spiraling_edge/stepper/verdict_table.h"

#include <array>

namespace se {
namespace {

constexpr std::optional<WhatIfKind> kKeep = WhatIfKind::Keep;
constexpr std::optional<WhatIfKind> kDrop = WhatIfKind::Drop;
constexpr std::optional<WhatIfKind> kNoWhatIf = std::nullopt;

// clang-format off
constexpr std::array<VerdictRow, kVerdictCount> kVerdictTable{{
    {Verdict::Kept, "kept", Outcome::Taken, kDrop},
    {Verdict::NotAfterStart, "before start", Outcome::Refused, kNoWhatIf},
    {Verdict::NotBeforeEnd, "beyond last", Outcome::Refused, kNoWhatIf},
    {Verdict::SameAngle, "same angle", Outcome::Refused, kNoWhatIf},
    {Verdict::AlreadyDone, "DONE", Outcome::Unchanged, kNoWhatIf},
    {Verdict::OnRingEnd, "is first or last", Outcome::Unchanged, kNoWhatIf},
    {Verdict::Moved, "moved", Outcome::Taken, kDrop},
    {Verdict::NotListed, "not listed", Outcome::Unchanged, kNoWhatIf},
    {Verdict::NotConcave, "convex", Outcome::Unchanged, kKeep},
    {Verdict::NotAnEdge, "no edge", Outcome::Unchanged, kNoWhatIf},
    {Verdict::Outside, "outside", Outcome::Refused, kNoWhatIf},
    {Verdict::OtherLimit, "other end", Outcome::Unchanged, kNoWhatIf},
    {Verdict::HalfTurn, "across 180", Outcome::Unchanged, kKeep},
    {Verdict::Blocked, "blocked", Outcome::Unchanged, kKeep},
    {Verdict::NowStart, "now start", Outcome::None, kNoWhatIf},
    {Verdict::NowEnd, "now end", Outcome::None, kNoWhatIf},
    {Verdict::BeyondConvex, "after convex end", Outcome::Refused, kKeep},
    {Verdict::BeyondHalfTurn, "after half turn", Outcome::Refused, kKeep},
    {Verdict::BeyondBlocked, "after blocked end", Outcome::Refused, kKeep},
    {Verdict::BeyondOther, "after end", Outcome::Refused, kKeep},
    {Verdict::NotReciprocal, "not reciprocal", Outcome::Refused, kKeep},
    {Verdict::WallComplete, "complete along its walls", Outcome::Refused, kKeep},
    {Verdict::FarSide, "far side", Outcome::Refused, kKeep},
    {Verdict::InsideSphere, "inside sphere", Outcome::Taken, kDrop},
    {Verdict::GapTooWide, "gap too wide", Outcome::Taken, kDrop},
    {Verdict::NoCircle, "no circle", Outcome::Taken, kDrop},
    {Verdict::Removed, "removed", Outcome::Refused, kKeep},
    {Verdict::Discarded, "over 180", Outcome::Refused, kKeep},
    {Verdict::Hole, "under 180", Outcome::Taken, kDrop},
    {Verdict::WideGap, "gap over 180", Outcome::Refused, kKeep},
    {Verdict::EdgeTaken, "edge taken", Outcome::Refused, kKeep},
    {Verdict::EntryMissed, "edge elsewhere on a ring", Outcome::Refused, kKeep},
    {Verdict::Pillow, "pillow", Outcome::Refused, kKeep},
    {Verdict::Crosses, "crosses a ring edge", Outcome::Refused, kKeep},
    {Verdict::AgainstNormal, "against a normal", Outcome::Refused, kKeep},
    {Verdict::FoldsOver, "folds over", Outcome::Refused, kKeep},
    {Verdict::OverRim, "over the rim", Outcome::Refused, kKeep},
    {Verdict::Steep, "steep, waits", Outcome::Refused, kKeep},
    {Verdict::Meets, "meets a triangle", Outcome::Refused, kKeep},
    {Verdict::Covers, "second layer", Outcome::Refused, kKeep},
    {Verdict::Before, "before", Outcome::Taken, kNoWhatIf},
    {Verdict::After, "after", Outcome::Taken, kNoWhatIf},
    {Verdict::OtherSideOpen, "other side open", Outcome::Refused, kNoWhatIf},
    {Verdict::NoThirdPoint, "no third point", Outcome::Refused, kNoWhatIf},
    {Verdict::WhatIfKept, "kept: what if", Outcome::Taken, kNoWhatIf},
    {Verdict::WhatIfDropped, "dropped: what if", Outcome::Refused, kNoWhatIf},
}};
// clang-format on

static_assert(isInOrder(kVerdictTable));

}  // namespace

std::span<const VerdictRow> verdictTable() { return kVerdictTable; }

const VerdictRow& rowOf(Verdict verdict) {
    return kVerdictTable[static_cast<std::size_t>(verdict)];
}

bool isTaken(Verdict verdict) { return rowOf(verdict).outcome == Outcome::Taken; }

std::string_view verdictText(Verdict verdict) { return rowOf(verdict).text; }

}  // namespace se
