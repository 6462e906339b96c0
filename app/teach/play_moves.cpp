#include "play_moves.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "find_named.h"
#include "lesson_setting.h"
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
    bool kept = true;
    bool isLimit = false;  ///< start or end moved to it.
};

/// True for a decision of the reciprocal test, made for each ring entry of its point.
bool isReciprocalTest(const Event& event) { return isA<ReciprocalEvidence>(event); }

void applyDecision(const Event& event, PlayedCandidate& candidate) {
    // Outside of start and end are also the points that they moved to before.
    const auto* limit = as<LimitEvidence>(event);
    candidate.isLimit = candidate.isLimit || (limit != nullptr && limit->moves());
    if (limit != nullptr || candidate.isLimit || !verdictOf(event)) return;
    // Of several entries one that passes is enough.
    const bool passedBefore =
        isReciprocalTest(event) && isReciprocalTest(*candidate.decision) && candidate.kept;
    if (passedBefore) return;
    candidate.kept = !isAgainst(outcomeOf(event));
    candidate.decision = &event;
}

/// The candidates of the angle sort by increasing angle, with the last decision about each.
std::vector<PlayedCandidate> playedCandidates(std::span<const Event> events) {
    std::vector<PlayedCandidate> candidates;
    const auto find = [&](Index point) {
        return std::find_if(candidates.begin(), candidates.end(),
                            [&](const PlayedCandidate& each) { return each.point == point; });
    };
    for (const Event& event : events) {
        if (event.address.stage >= Stage::Emit) break;
        const auto* sort = as<SortEvidence>(event);
        if (sort != nullptr && sort->verdict == Verdict::Kept) {
            const double key = makeAngle(sort->cosine, sort->secondHalf).key;
            candidates.push_back({sort->point, key, &event});
        } else if (const auto found = find(testedPoint(event)); found != candidates.end()) {
            applyDecision(event, *found);
        }
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

/// The last decision about a point; of a limit that moved to it, that move; of the sort if it is no
/// candidate.
const Event* decisionAboutPoint(std::span<const Event> events, Index point) {
    for (const Event& event : events) {
        const auto* limit = as<LimitEvidence>(event);
        if (limit != nullptr && limit->moves() && limit->to == point) return &event;
    }
    for (const PlayedCandidate& each : playedCandidates(events)) {
        if (each.point == point) return each.decision;
    }
    const auto found = std::find_if(events.begin(), events.end(), [&](const Event& event) {
        return isA<SortEvidence>(event) && testedPoint(event) == point;
    });
    return found == events.end() ? nullptr : &*found;
}

}  // namespace

std::span<const MoveRow> moveTable() { return kMoveTable; }

const MoveRow& rowOf(MoveKind kind) { return kMoveTable[static_cast<std::size_t>(kind)]; }

std::string moveText(const PlayMove& move, const std::vector<NamedPoint>& names) {
    std::string text(rowOf(move.kind).name);
    const std::vector<PointName> list = pointNames(names);
    for (const Index point : move.points) text += ' ' + nameOf(point, list);
    return move.points.empty() ? text + ' ' + std::string(kNoPoint) : text;
}

Result<PlayMove> moveFromText(std::string_view text, const std::vector<NamedPoint>& names) {
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
        if (each.isLimit) continue;
        const MoveKind kind = each.kept ? MoveKind::Keep : MoveKind::Remove;
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
            return each.point == given.points.front() && !each.isLimit;
        };
        const std::vector<PlayedCandidate> all = playedCandidates(events);
        // A point that is no candidate; of others, the decision that the run has in this place.
        if (std::none_of(all.begin(), all.end(), isPoint)) {
            if (const Event* found = decisionAboutPoint(events, given.points.front())) return found;
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
