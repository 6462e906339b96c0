#include "spiraling_edge/run/watch.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se {
namespace {

template <auto WatchedRun::*number>
double ofRun(const WatchedRun& run, Index) {
    return static_cast<double>(run.*number);
}
template <auto State::*list>
double sizeOf(const WatchedRun& run, Index) {
    return static_cast<double>((run.state.*list).size());
}
template <std::uint32_t Counters::*counter>
double counterOf(const WatchedRun& run, Index) {
    return run.state.counters.*counter;
}

double unusedPoints(const WatchedRun& run, Index) {
    return static_cast<double>(run.state.status.size() - run.state.done.size()) -
           static_cast<double>(run.used);
}
double ringLength(const WatchedRun& run, Index) {
    const EdgeRings& rings = run.state.rings;
    return rings.active() == kNone ? 0.0 : rings.length(rings.active());
}

constexpr WatchTerm kWatchTerms[] = {
    {"ring", "Length of the active ring.", ringLength},
    {"stack", "Rings on the stack.",
     [](const WatchedRun& run, Index) {
         return static_cast<double>(run.state.rings.stack().size());
     }},
    {"status=N", "Status of a point: 0 UNUSED, n > 0 USED with n places on rings, -1 DONE.",
     [](const WatchedRun& run, Index point) {
         return point < run.state.status.size() ? static_cast<double>(run.state.status[point])
                                                : 0.0;
     }},
    {"triangles", "Triangles made.", sizeOf<&State::triangles>},
    {"unused", "Points that are UNUSED.", unusedPoints},
    {"used", "Points that are USED.", ofRun<&WatchedRun::used>},
    {"done", "Points that are DONE.", sizeOf<&State::done>},
    {"tests", "Decisions that took or refused something.", ofRun<&WatchedRun::tests>},
    {"refused", "Those that refused it.", ofRun<&WatchedRun::refused>},
    {"circuit", "Pivots since the last triangle.",
     [](const WatchedRun& run, Index) { return static_cast<double>(run.state.circuit); }},
    {"alerts", "Rings with points in them, or seeds, that were given up.", sizeOf<&State::alerts>},
    {"skipped", "Boundary points passed over.", counterOf<&Counters::skipped>},
    {"seeds", "Rings that were begun.", counterOf<&Counters::seeds>},
    {"inserted", "Third boundary points that led to triangles.", counterOf<&Counters::inserted>},
    {"discarded", "Two-point rings over 180 degrees.", counterOf<&Counters::discarded>},
    {"refused_fans", "Fans that a rule beyond the paper refused.", counterOf<&Counters::refused>},
    {"stranded", "Stranded points.", counterOf<&Counters::stranded>},
    {"splits", "Splits.", counterOf<&Counters::splits>},
    {"joins", "Joins.", counterOf<&Counters::joins>},
    {"closed", "Rings that were closed.", counterOf<&Counters::closedRings>},
    {"freed", "Rings that were freed.", counterOf<&Counters::freedRings>},
    {"failed_seeds", "Seeds without a triangle whose points are UNUSED again.",
     counterOf<&Counters::failedSeeds>},
    {"holes", "Freed rings with interior points.", counterOf<&Counters::holes>},
};

std::string allForms() {
    return joined(kWatchTerms, ", ", [](const WatchTerm& term) { return term.form; });
}

/// Counts the USED points from the points in the events of each pivot.
class UsedCounter {
  public:
    explicit UsedCounter(const State& start) : used_(start.status.size(), false) {
        for (Index p = 0; p < used_.size(); ++p) look(p, start);
    }

    std::size_t count() const { return count_; }
    void add(const SweptPivot& pivot) {
        for (const Event& event : pivot.events) {
            if (const auto* seed = as<SeedEvidence>(event)) {
                look(seed->first, pivot.after);
                look(seed->second, pivot.after);
            } else if (const auto* insert = as<InsertEvidence>(event)) {
                look(insert->third, pivot.after);
            } else if (const auto* ring = as<RingEvidence>(event)) {
                look(ring->point, pivot.after);
            }
        }
    }

  private:
    void look(Index p, const State& state) {
        if (p == kNone || used_[p] == (state.status[p] > 0)) return;
        used_[p] = !used_[p];
        used_[p] ? ++count_ : --count_;
    }

    std::vector<bool> used_;
    std::size_t count_ = 0;
};

}  // namespace

std::span<const WatchTerm> watchTerms() { return kWatchTerms; }

Result<WatchExpression> WatchExpression::parse(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    for (const WatchTerm& term : kWatchTerms) {
        const bool ofPoint = term.form.ends_with("=N");
        if (!ofPoint && text == term.form) return WatchExpression(term, kNone);
        const std::string_view head = term.form.substr(0, term.form.size() - 1);
        if (!ofPoint || !text.starts_with(head)) continue;
        const Index point = numberIn<Index>(text.substr(head.size())).value_or(kNone);
        if (point == kNone)
            return Error{inQuotes(text) + ": expected the number of a point, such as " +
                         std::string(head) + "812."};
        return WatchExpression(term, point);
    }
    return Error{inQuotes(text) + " cannot be watched; there are " + allForms() + "."};
}

PivotVisitor watchVisitor(
    const PointSet& points, const Params& params, std::vector<WatchExpression> expressions,
    std::function<void(std::uint32_t pivot, std::span<const double> values)> visit) {
    struct Watch {
        std::vector<WatchExpression> expressions;
        std::function<void(std::uint32_t, std::span<const double>)> visit;
        UsedCounter used;
        std::uint64_t tests = 0;
        std::uint64_t refused = 0;
        std::vector<double> values{};

        void show(std::uint32_t pivot, const State& state) {
            values.clear();
            for (const WatchExpression& each : expressions)
                values.push_back(each.valueIn({state, tests, refused, used.count()}));
            visit(pivot, values);
        }
    };
    const State start = startState(points, params);
    const auto watch = std::make_shared<Watch>(
        Watch{std::move(expressions), std::move(visit), UsedCounter(start)});
    watch->show(0, start);
    return [watch](const SweptPivot& pivot) {
        for (const Event& event : pivot.events) {
            const Outcome outcome = outcomeOf(event);
            watch->tests += outcome != Outcome::None ? 1 : 0;
            watch->refused += isAgainst(outcome) ? 1 : 0;
        }
        watch->used.add(pivot);
        watch->show(pivot.events.front().address.pivot, pivot.after);
    };
}

}  // namespace se
