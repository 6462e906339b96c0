// The deciding line of a ledger, and the answer in words.
#include <algorithm>
#include <functional>

#include "spiraling_edge/explain/ledger_builder.h"
#include "spiraling_edge/replay/decision_line.h"

namespace se {
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
        if (ledger_.present) return told(firstMade(undone == kNoLine ? 0 : undone + 1));
        if (undone != kNoLine) return told(undone);
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
    Cause told(std::size_t line) const { return {line, describe(ledger_.lines[line].event)}; }

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
        if (test != kNoLine) return told(test);
        const std::size_t late = last(refused);
        if (late != kNoLine) return told(late);
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

Ledger LedgerBook::close(const State& end) {
    ledger_.present = isInMesh(end.mesh(), ledger_.subject);
    const Cause cause = CauseFinder(points_, ledger_, end).find();
    ledger_.cause = cause.line;
    ledger_.answer = capitalized(nameOf(ledger_.subject)) +
                     (ledger_.present ? " is in the mesh. " : " is not in the mesh. ") +
                     cause.words + " (" + toString(ledger_.lines[cause.line].event.address) + ")";
    return ledger_;
}

}  // namespace se
