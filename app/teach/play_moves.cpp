#include "play_moves.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "lesson.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/rules.h"

namespace se::teach {
namespace {

constexpr std::string_view kNoPoint = "none";

constexpr std::array kMoveTable{
    MoveRow{MoveKind::MoveStart, "start", "start advances to this point of the edge ring"},
    MoveRow{MoveKind::MoveEnd, "end", "end advances to this point of the edge ring"},
    MoveRow{MoveKind::Keep, "keep", "this candidate becomes a point of the fan"},
    MoveRow{MoveKind::Remove, "remove", "this candidate is left out"},
    MoveRow{MoveKind::Fan, "fan", "all points of the fan from first to last; none: no triangle"},
    MoveRow{MoveKind::NextPivot, "next",
            "the next pivot: where end stands (last, if it has not moved), on a wall too; none: no "
            "ring is left"},
};
static_assert(isInOrder(kMoveTable));

/// A candidate of the angle sort, and the last decision about it.
struct PlayedCandidate {
    Index point;
    double key;  ///< Of its angle.
    const Event* decision;

    /// True if start or end moved to it.
    bool isLimit() const { return isA<LimitEvidence>(*decision); }
};

/// The events before the first triangle.
std::span<const Event> testsOf(std::span<const Event> events) {
    const auto end = std::find_if(events.begin(), events.end(), [](const Event& event) {
        return event.address.stage >= Stage::Emit;
    });
    return {events.begin(), end};
}

/// The candidates of the angle sort by increasing angle, with the last decision about each.
std::vector<PlayedCandidate> playedCandidates(std::span<const Event> events) {
    std::vector<PlayedCandidate> candidates;
    const std::span<const Event> tests = testsOf(events);
    for (const Event& event : tests) {
        const auto* sort = as<SortEvidence>(event);
        if (sort == nullptr || sort->verdict != Verdict::Kept) continue;
        const double key = makeAngle(sort->cosine, sort->secondHalf).key;
        candidates.push_back({sort->point, key, decisionAbout(tests, sort->point, Stage::Guard)});
    }
    std::stable_sort(
        candidates.begin(), candidates.end(),
        [](const PlayedCandidate& a, const PlayedCandidate& b) { return a.key < b.key; });
    return candidates;
}

template <typename Kind>
const Event* lastEventOf(std::span<const Event> events) {
    const auto found = std::find_if(events.rbegin(), events.rend(), isA<Kind>);
    return found == events.rend() ? nullptr : &*found;
}

/// The fan, and the decision that refused it if it is empty.
RunMove fanOfRun(std::span<const Event> events) {
    RunMove fan{{MoveKind::Fan, {}}, {}};
    for (const Event& event : events) {
        const auto* emit = as<EmitEvidence>(event);
        if (emit == nullptr) continue;
        if (fan.move.points.empty()) fan = {{MoveKind::Fan, {emit->corners.b}}, event};
        fan.move.points.push_back(emit->corners.c);
    }
    if (!fan.move.points.empty()) return fan;
    const Event* refused = lastEventOf<GuardEvidence>(events);
    if (refused == nullptr) refused = lastEventOf<TwoPointEvidence>(events);
    if (refused != nullptr) fan.event = *refused;
    return fan;
}

bool isMoveOf(const Event& event, Side side) {
    const auto* limit = as<LimitEvidence>(event);
    return limit != nullptr && limit->side == side && limit->moves();
}

/// The decision about a move of start or end that the run did not make: that about its point, else
/// the last about that side.
const Event* decisionAboutLimit(std::span<const Event> events, const PlayMove& given) {
    const Side side = given.kind == MoveKind::MoveStart ? Side::Start : Side::End;
    const Event* found = nullptr;
    for (const Event& event : events) {
        const auto* limit = as<LimitEvidence>(event);
        if (limit == nullptr || limit->side != side) continue;
        found = &event;
        if (limit->to == given.points.front()) break;
    }
    return found;
}

/// The first triangle of the run that a fan lacks; null if it has all.
const Event* triangleLackedBy(std::span<const Event> events, const std::vector<Index>& fan) {
    const auto found = std::find_if(events.begin(), events.end(), [&](const Event& event) {
        const auto* emit = as<EmitEvidence>(event);
        const std::array<Index, 2> side =
            emit != nullptr ? std::array{emit->corners.b, emit->corners.c} : std::array<Index, 2>{};
        return emit != nullptr &&
               std::search(fan.begin(), fan.end(), side.begin(), side.end()) == fan.end();
    });
    return found == events.end() ? nullptr : &*found;
}

/// True for the tests that decide about a candidate.
bool decidesCandidate(const Event& event, Index point) {
    if (testedPoint(event) != point) return false;
    if (const auto* e = as<LimitEvidence>(event)) return e->moves();
    if (const auto* e = as<DropEvidence>(event); e && e->isLimit()) return false;
    return verdictOf(event).has_value();
}

}  // namespace

std::span<const MoveRow> moveTable() { return kMoveTable; }

const MoveRow& rowOf(MoveKind kind) { return kMoveTable[static_cast<std::size_t>(kind)]; }

std::string moveText(const PlayMove& move, const std::vector<PointName>& names) {
    std::string text(rowOf(move.kind).name);
    for (const std::string& name : namesOf(move.points, names)) text += ' ' + name;
    return move.points.empty() ? text + ' ' + std::string(kNoPoint) : text;
}

Result<PlayMove> moveFromText(std::string_view text, const std::vector<PointName>& names) {
    io::Fields fields(text, ',');
    const std::string_view name = fields.next();
    const MoveRow* row = findNamed(kMoveTable, name);
    if (row == nullptr) {
        return Error{inQuotes(name) +
                     ": expected start, end, keep, remove, fan or next, "
                     "then points"};
    }
    PlayMove move{row->id, {}};
    bool none = false;
    for (std::string_view word = fields.next(); !word.empty(); word = fields.next()) {
        none = none || word == kNoPoint;
        if (word == kNoPoint) continue;
        move.points.push_back(pointOf(word, names));
        if (move.points.back() == kNone)
            return Error{std::string(name) + ": " + inQuotes(word) +
                         " is no name and no number of a point"};
    }
    const bool mayBeNone = row->id == MoveKind::Fan || row->id == MoveKind::NextPivot;
    const bool isList = row->id == MoveKind::Fan;
    const bool fits = none     ? mayBeNone && move.points.empty()
                      : isList ? move.points.size() >= 2
                               : move.points.size() == 1;
    if (!fits) {
        return Error{std::string(name) + ": expected " +
                     (isList ? "two points or more" : "one point") +
                     (mayBeNone ? ", or none" : "")};
    }
    return move;
}

const Event* decisionAbout(std::span<const Event> events, Index point, Stage last) {
    const Event* found = nullptr;
    for (const Event& event : events) {
        if (event.address.stage > last) continue;
        if (!decidesCandidate(event, point)) continue;
        // A point that start or end has passed is in the fan, although outside of them.
        if (found != nullptr && isA<LimitEvidence>(*found)) continue;
        const bool isOtherEntry = found != nullptr && isA<ReciprocalEvidence>(event) &&
                                  isA<ReciprocalEvidence>(*found) &&
                                  outcomeOf(*found) == Outcome::Taken;
        if (!isOtherEntry) found = &event;
    }
    return found;
}

std::vector<RunMove> movesOfRun(std::span<const Event> events) {
    std::vector<RunMove> moves;
    const Event* advance = lastEventOf<AdvanceEvidence>(events);
    if (advance == nullptr || lastEventOf<SkipEvidence>(events) != nullptr) return moves;
    for (const Side side : {Side::Start, Side::End}) {
        const MoveKind kind = side == Side::Start ? MoveKind::MoveStart : MoveKind::MoveEnd;
        for (const Event& event : events) {
            if (isMoveOf(event, side))
                moves.push_back({{kind, {as<LimitEvidence>(event)->to}}, event});
        }
    }
    for (const PlayedCandidate& each : playedCandidates(events)) {
        if (each.isLimit()) continue;
        const bool removed = isAgainst(outcomeOf(*each.decision));
        const MoveKind kind = removed ? MoveKind::Remove : MoveKind::Keep;
        moves.push_back({{kind, {each.point}}, *each.decision});
    }
    moves.push_back(fanOfRun(events));
    const Index next = as<AdvanceEvidence>(*advance)->to;
    PlayMove move{MoveKind::NextPivot, {}};
    if (next != kNone) move.points.push_back(next);
    moves.push_back({std::move(move), *advance});
    return moves;
}

std::vector<PlayMove> movesOf(const std::vector<RunMove>& moves) {
    std::vector<PlayMove> list;
    list.reserve(moves.size());
    for (const RunMove& each : moves) list.push_back(each.move);
    return list;
}

std::size_t movesAlike(std::span<const PlayMove> given, std::span<const PlayMove> right) {
    const auto [a, b] = std::mismatch(given.begin(), given.end(), right.begin(), right.end());
    return static_cast<std::size_t>(b - right.begin());
}

const Event* decisionAgainst(std::span<const Event> events, const PlayMove& given,
                             const RunMove* expected) {
    assert(given.kind == MoveKind::Fan || given.kind == MoveKind::NextPivot ||
           !given.points.empty());
    const bool movesLimit = given.kind == MoveKind::MoveStart || given.kind == MoveKind::MoveEnd;
    const bool sameKind = expected != nullptr && expected->move.kind == given.kind;
    if (movesLimit && !sameKind) {
        // The run moves this limit no further.
        if (const Event* found = decisionAboutLimit(events, given)) return found;
    }
    const bool namesCandidate = given.kind == MoveKind::Keep || given.kind == MoveKind::Remove;
    if (namesCandidate) {
        const auto isPoint = [&](const PlayedCandidate& each) {
            return each.point == given.points.front() && !each.isLimit();
        };
        const std::vector<PlayedCandidate> all = playedCandidates(events);
        // A point that is no candidate; of others, the decision that the run has in this place.
        if (std::none_of(all.begin(), all.end(), isPoint)) {
            const Event* found = decisionAbout(testsOf(events), given.points.front(), Stage::Guard);
            if (found != nullptr) return found;
        }
    }
    if (given.kind == MoveKind::Fan && sameKind) {
        if (const Event* found = triangleLackedBy(events, given.points)) return found;
    }
    return expected != nullptr ? &expected->event : nullptr;
}

std::string moveReasonText(const Event& event, std::span<const PointName> names) {
    // Its decision would be the answer.
    if (isA<AdvanceEvidence>(event))
        return "The next pivot is the point where end stands: last, unless end has moved.";
    return describe(event, names);
}

}  // namespace se::teach
