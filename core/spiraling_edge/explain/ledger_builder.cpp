/// Selects the events about a subject: tests between its points, tests that end a fan it would have
/// been in, and facts about its points. For this it tracks which of its points may still become
/// spokes of the current fan.
#include "spiraling_edge/explain/ledger_builder.h"

#include <algorithm>
#include <functional>

#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/replay/decision_line.h"

namespace se {
namespace {

std::size_t countIn(const Subject& subject, std::initializer_list<Index> points) {
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&](Index p) { return subject.has(p); }));
}

bool holds(const Triangle& t, const Subject& subject) {
    return countIn(subject, {t.a, t.b, t.c}) == subject.size();
}

}  // namespace

bool isInMesh(std::span<const Triangle> mesh, const Subject& subject) {
    return std::any_of(mesh.begin(), mesh.end(),
                       [&](const Triangle& t) { return holds(t, subject); });
}

void LedgerBuilder::add(const ScannedPivot& pivot) {
    alive_.reset();
    reciprocal_ = kNone;
    for (const Event& event : pivot.events) {
        follow(event);
        addEvent(pivot, event);
    }
}

/// Tracks the points of the subject that are still in the neighbor ring of this pivot.
void LedgerBuilder::follow(const Event& event) {
    const Subject& subject = ledger_.subject;
    const auto set = [&](Index p, bool on) {
        if (const std::size_t i = subject.find(p); i < subject.size()) alive_.set(i, on);
    };
    if (const auto* pivot = std::get_if<PivotEvidence>(&event.evidence)) {
        set(pivot->first, true);
        set(pivot->last, true);
        return;
    }
    // Points that limits move past stay spokes, and so do first and last, which are no candidates.
    const auto* sort = std::get_if<SortEvidence>(&event.evidence);
    const bool stays = std::holds_alternative<LimitEvidence>(event.evidence) ||
                       (sort != nullptr && sort->verdict == Verdict::OnRingEnd);
    const Outcome outcome = outcomeOf(event);
    if (stays || outcome == Outcome::None) return;
    // One entry of the point whose test passes is enough (§6.1, Fig. 6).
    const bool otherEntry = event.address.stage == Stage::Reciprocal && isAgainst(outcome) &&
                            reciprocal_ == testedPoint(event);
    if (otherEntry) return;
    if (event.address.stage == Stage::Reciprocal && outcome == Outcome::Taken)
        reciprocal_ = testedPoint(event);
    set(testedPoint(event), outcome == Outcome::Taken);
}

void LedgerBuilder::addEvent(const ScannedPivot& pivot, const Event& event) {
    if (editsMesh(event) && !repairing_) {
        repairing_ = true;
        inMesh_ = isInMesh(pivot.after.triangles, ledger_.subject);
    }
    std::optional<LineRole> role = roleOf(pivot, event);
    if (editsMesh(event)) {
        const bool now = isInMesh(pivot.after.mesh(), ledger_.subject);
        if (now != inMesh_) role = now ? LineRole::Made : LineRole::Undone;
        inMesh_ = now;
    }
    if (!role) return;
    ledger_.lines.push_back(
        {event, pivot.point, *role, readingOf(event, {points_, params_, pivot.point})});
}

bool LedgerBuilder::isFactOf(const Event& event) const {
    const Subject& subject = ledger_.subject;
    return std::visit(
        Overloaded{[&](const SeedEvidence& e) {
                       return countIn(subject, {e.first, e.second}) > 0;
                   },
                   [&](const StrandEvidence& e) { return subject.has(e.point); },
                   [&](const PivotEvidence& e) { return subject.has(e.pivot); },
                   [&](const SkipEvidence& e) { return subject.has(e.pivot); },
                   // The other side of the pivot would stay open (docs/robust.md).
                   [&](const InsertEvidence& e) { return subject.has(e.pivot); },
                   [&](const RingEvidence& e) { return subject.has(e.point); },
                   [&](const SplitEvidence& e) { return subject.has(e.point); },
                   [&](const JoinEvidence& e) { return subject.has(e.point); },
                   [&](const CloseEvidence& e) {
                       return countIn(subject, {e.a, e.b}) > 0;
                   },
                   [&](const FillEvidence& e) { return subject.has(e.pivot); },
                   [&](const ReinsertEvidence& e) { return subject.has(e.point); },
                   [&](const RemoveFoldedEvidence& e) { return subject.has(e.point); },
                   [&](const FlipEvidence& e) {
                       return countIn(subject, {e.u, e.v, e.x, e.y}) > 0;
                   },
                   [&](const EmitEvidence& e) {
                       return countIn(subject, {e.corners.a, e.corners.b, e.corners.c}) >=
                              std::min<std::size_t>(2, subject.size());
                   },
                   [](const auto&) { return false; }},
        event.evidence);
}

/// The role of a test between two points of the subject, or of its one point, or of a test that
/// ends their fan.
std::optional<LineRole> LedgerBuilder::roleOfTest(Index pivot, const Event& event) const {
    const Outcome outcome = outcomeOf(event);
    if (outcome == Outcome::None) return {};
    const Subject& subject = ledger_.subject;
    const LineRole role = outcome == Outcome::Taken ? LineRole::Taken : LineRole::Refused;
    const Index tested = testedPoint(event);
    if (subject.size() == 1) {
        if (tested == subject[0]) return role;
    } else if (subject.has(pivot) && subject.has(tested) && tested != pivot) {
        return role;
    }
    // The fan as a whole, which would have held the subject.
    const bool wholeFan = tested == kNone && rowOf(event.address.stage).tests == StageTests::OfFans;
    if (!wholeFan || !isAgainst(outcome)) return {};
    const std::size_t inFan = alive_.count() + (subject.has(pivot) ? 1U : 0U);
    const bool concerned = subject.size() == 1 ? alive_.any() : subject.has(pivot) && inFan >= 2;
    return concerned ? std::optional(role) : std::nullopt;
}

std::optional<LineRole> LedgerBuilder::roleOf(const ScannedPivot& pivot, const Event& event) const {
    if (const auto* emit = std::get_if<EmitEvidence>(&event.evidence)) {
        if (holds(emit->corners, ledger_.subject)) return LineRole::Made;
    }
    if (const auto role = roleOfTest(pivot.point, event)) return role;
    return isFactOf(event) ? std::optional(LineRole::Fact) : std::nullopt;
}
namespace {

constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);

/// The cause for which a subject is not in the mesh.
struct Cause {
    std::size_t line = kNoLine;
    std::string words;  ///< One sentence, without the address.
};

class CauseFinder {
  public:
    CauseFinder(const PointSet& points, const Ledger& ledger, const State& end)
        : points_(points), ledger_(ledger), end_(end) {}

    Cause find() const {
        const std::size_t undone =
            last([](const LedgerLine& line) { return line.role == LineRole::Undone; });
        if (ledger_.present) return causeAt(firstMade(undone == kNoLine ? 0 : undone + 1));
        if (undone != kNoLine) return causeAt(undone);
        if (ledger_.subject.size() == 3) return ofTriangle();
        return ofPoints(ledger_.subject);
    }

  private:
    using Test = std::function<bool(const LedgerLine&)>;

    std::size_t last(const Test& test) const {
        for (std::size_t i = ledger_.lines.size(); i-- > 0;) {
            if (test(ledger_.lines[i])) return i;
        }
        return kNoLine;
    }
    std::size_t firstMade(std::size_t from) const {
        while (from < ledger_.lines.size() && ledger_.lines[from].role != LineRole::Made) ++from;
        return from;
    }
    Cause causeAt(std::size_t line) const { return {line, describe(ledger_.lines[line].event)}; }

    /// True if another entry of the point passed the reciprocal test: then the refused one is no
    /// cause.
    bool hasOtherEntry(const LedgerLine& refused) const {
        if (refused.event.address.stage != Stage::Reciprocal) return false;
        return std::any_of(ledger_.lines.begin(), ledger_.lines.end(), [&](const LedgerLine& line) {
            return line.role == LineRole::Taken &&
                   line.event.address.pivot == refused.event.address.pivot &&
                   line.event.address.stage == Stage::Reciprocal &&
                   testedPoint(line.event) == testedPoint(refused.event);
        });
    }
    /// True for a limit that does not move, which refuses nothing.
    static bool isLimit(const LedgerLine& line) {
        return std::holds_alternative<LimitEvidence>(line.event.evidence);
    }
    bool concerns(const LedgerLine& line, const Subject& subject) const {
        const Index tested = testedPoint(line.event);
        if (subject.size() == 1) return tested == kNone || subject.has(tested);
        return subject.has(line.pivot) && (tested == kNone || subject.has(tested));
    }

    Cause ofPoints(const Subject& subject) const {
        const auto refused = [&](const LedgerLine& line) {
            return line.role == LineRole::Refused && !isLimit(line) && concerns(line, subject) &&
                   !hasOtherEntry(line);
        };
        const std::size_t test = last(
            [&](const LedgerLine& line) { return refused(line) && !wasSettledBefore(line.event); });
        if (test != kNoLine) return causeAt(test);
        const std::size_t late = last(refused);
        if (late != kNoLine) return causeAt(late);
        return subject.size() == 1 ? untestedPoint(subject[0]) : untestedEdge(subject);
    }

    bool lists(Index a, Index b) const {
        const auto list = points_.neighbors[a];
        return std::find(list.begin(), list.end(), b) != list.end();
    }
    bool wasPivot(Index p) const {
        return last([&](const LedgerLine& line) {
                   const auto* pivot = std::get_if<PivotEvidence>(&line.event.evidence);
                   return pivot != nullptr && pivot->pivot == p;
               }) != kNoLine;
    }
    /// The last line that names one of the points.
    std::size_t lastAbout(const Subject& subject) const {
        const std::size_t about = last([&](const LedgerLine& line) {
            return subject.has(testedPoint(line.event)) || subject.has(line.pivot);
        });
        return about != kNoLine ? about : ledger_.lines.size() - 1;
    }

    Cause untestedPoint(Index p) const {
        std::size_t listing = 0;
        for (std::size_t q = 0; q < points_.size(); ++q) {
            if (lists(static_cast<Index>(q), p)) ++listing;
        }
        const std::string words =
            listing == 0 ? "No point lists " + std::to_string(p) +
                               " among its neighbors, so no pivot ever tested it."
                         : "Point " + std::to_string(p) + " is listed by " +
                               std::to_string(listing) + (listing == 1 ? " point" : " points") +
                               ", but none of them was a pivot that looked at it.";
        return {lastAbout(ledger_.subject), words};
    }

    /// Neither end ever tested the other.
    Cause untestedEdge(const Subject& edge) const {
        const std::size_t line = lastAbout(edge);
        const std::string a = std::to_string(edge[0]);
        const std::string b = std::to_string(edge[1]);
        const bool ab = lists(edge[0], edge[1]);
        const bool ba = lists(edge[1], edge[0]);
        if (!ab && !ba) {
            return {line, "Neither of " + a + " and " + b +
                              " lists the other among its neighbors, so no pivot ever tested them "
                              "together."};
        }
        std::string words;
        const auto add = [&](Index from, const std::string& name, const std::string& other) {
            words += name + " lists " + other + ", but " +
                     (wasPivot(from) ? "looked at no neighbor when it was the pivot"
                                     : "was never a pivot") +
                     ". ";
        };
        if (ab) add(edge[0], a, b);
        if (ba) add(edge[1], b, a);
        words.pop_back();
        return {line, words};
    }

    Cause ofTriangle() const {
        const Subject& s = ledger_.subject;
        Cause latest;
        for (std::size_t i = 0; i < 3; ++i) {
            const Subject edge = Subject::edge(s[i], s[(i + 1) % 3]);
            if (isInMesh(end_.mesh(), edge)) continue;
            const Cause cause = ofPoints(edge);
            if (latest.line != kNoLine && cause.line <= latest.line) continue;
            latest = {cause.line, "Its " + nameOf(edge) + " is not in the mesh: " + cause.words};
        }
        return latest.line != kNoLine ? latest : allEdgesTaken();
    }

    /// All three edges are in the mesh: the other triangles at them came first.
    Cause allEdgesTaken() const {
        const std::size_t emit = last([](const LedgerLine& line) {
            return std::holds_alternative<EmitEvidence>(line.event.evidence);
        });
        if (emit == kNoLine)
            return {lastAbout(ledger_.subject), "Its three edges came into the mesh one by one."};
        return {emit,
                "Its three edges are in the mesh, each in other triangles; the last of them: " +
                    describe(ledger_.lines[emit].event)};
    }

    const PointSet& points_;
    const Ledger& ledger_;
    const State& end_;
};

std::string capitalized(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

}  // namespace

Ledger LedgerBuilder::finish(const State& end) {
    ledger_.present = isInMesh(end.mesh(), ledger_.subject);
    const Cause cause = CauseFinder(points_, ledger_, end).find();
    ledger_.cause = cause.line;
    ledger_.answer = capitalized(nameOf(ledger_.subject)) +
                     (ledger_.present ? " is in the mesh. " : " is not in the mesh. ") +
                     cause.words + " (" + toString(ledger_.lines[cause.line].event.address) + ")";
    return ledger_;
}

}  // namespace se
