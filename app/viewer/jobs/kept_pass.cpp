#include "kept_pass.h"

#include <cmath>
#include <limits>

#include "spiraling_edge/run/event_text.h"

namespace se::view {

// A run is searched for all wanted lines at once, because making the run costs far more than
// testing its events against another line. When a new line is wanted, the search is restarted for
// the missing lines only; lines that are known completely are kept until another run is open.

namespace {

/// An empty line, which would match everywhere.
bool isSought(const Breakpoint& breakpoint) {
    return breakpoint.on && breakpoint.line.find_first_not_of(" \t") != std::string::npos;
}

}  // namespace

std::vector<std::uint32_t> stopPivots(const Breakpoint& breakpoint, const HitList& list,
                                      std::pair<double, double> window, std::size_t columns) {
    std::vector<std::uint32_t> pivots;
    Breakpoint every = breakpoint;
    every.logOnly = false;
    every.on = true;
    const ArmedBreakpoint armed{&every, &list};
    const double width = (window.second - window.first) / static_cast<double>(columns);
    // The last position before the window.
    double at = std::max(0.0, std::ceil(window.first) - 1.0);
    constexpr std::uint32_t kEndOfPivot = std::numeric_limits<std::uint32_t>::max();
    while (pivots.size() <= columns) {
        const auto next = nextStop({&armed, 1}, {static_cast<std::uint32_t>(at), kEndOfPivot});
        if (!next || next->hit.place.pivot > window.second) break;
        pivots.push_back(next->hit.place.pivot);
        at = std::max<double>(pivots.back(), std::floor(pivots.back() + width));
    }
    return pivots;
}

void HitSearch::dropPart() {
    for (const Line& line : sought_) known_.erase(line.text);
}

std::vector<HitSearch::Line> HitSearch::missing() const {
    std::vector<Line> lines;
    for (const Breakpoint& each : wanted_) {
        const LineHits* known = of(each.line);
        const bool listed = known != nullptr && !known->sentences.empty();
        const bool enough = known != nullptr && known->complete &&
                            (!each.logOnly || listed || known->list.total == 0);
        const auto same = std::find_if(lines.begin(), lines.end(),
                                       [&](const Line& line) { return line.text == each.line; });
        if (!isSought(each) || enough) continue;
        if (same != lines.end()) {
            same->listed = same->listed || each.logOnly;
            continue;
        }
        auto query = DecisionQuery::parse(each.line);
        if (query) lines.push_back({each.line, std::move(query.value()), each.logOnly});
    }
    return lines;
}

/// Searches all lines that are wanted and not known, in one run, unless that is in progress.
void HitSearch::startNext() {
    std::vector<Line> lines = missing();
    const auto among = [](const std::vector<Line>& all, const Line& line) {
        return std::any_of(all.begin(), all.end(), [&](const Line& each) {
            return each.text == line.text && each.listed == line.listed;
        });
    };
    if (busy() && std::all_of(lines.begin(), lines.end(),
                              [&](const Line& line) { return among(sought_, line); }))
        return;
    job_.cancel();
    if (lines.empty()) return;
    for (const Line& line : lines) known_[line.text] = {};
    sought_ = lines;
    job_.startPass(model_, [lines = std::move(lines)](const Model& model, auto& results) {
        return visitorFor(model, lines, results);
    });
}

/// The visitor of a search for lines.
PivotVisitor HitSearch::visitorFor(const Model& model, const std::vector<Line>& lines,
                                   BackgroundJob<FoundHit>::Results& results) {
    std::vector<DecisionQuery> queries;
    queries.reserve(lines.size());
    for (const Line& line : lines) queries.push_back(line.query);
    const auto found = [&results, lines, logged = std::vector<std::size_t>(lines.size(), 0)](
                           std::size_t line, const se::Hit& hit, const Decision& decision) mutable {
        const bool logs = lines[line].listed && logged[line] < kMaxLogged;
        if (logs) ++logged[line];
        results.add({line, hit, logs ? describe(decision.event) : std::string()});
    };
    return hitVisitor(model.points, model.params, std::move(queries), found);
}

bool HitSearch::add(std::vector<FoundHit>& found, bool complete) {
    for (FoundHit& each : found) {
        LineHits& line = known_[sought_[each.line].text];
        line.list.add(each.hit);
        if (!each.sentence.empty()) line.sentences.push_back(std::move(each.sentence));
    }
    if (found.empty() && !complete) return false;
    // The run has reached the last pivot found, and may not have finished it.
    const std::uint32_t knownTo =
        complete ? std::numeric_limits<std::uint32_t>::max() : found.back().hit.place.pivot - 1;
    for (const Line& line : sought_) {
        known_[line.text].knownTo = knownTo;
        known_[line.text].complete = complete;
    }
    return true;
}

HitSearch::Answer HitSearch::stop(RunPosition here, int direction) const {
    static const HitList kNothing;
    std::vector<ArmedBreakpoint> armed;
    std::uint32_t knownTo = std::numeric_limits<std::uint32_t>::max();
    for (const Breakpoint& each : wanted_) {
        const LineHits* known = of(each.line);
        armed.push_back({&each, known != nullptr ? &known->list : &kNothing});
        if (each.logOnly || !isSought(each)) continue;
        if (known != nullptr) knownTo = std::min(knownTo, known->knownTo);
        if (known == nullptr && DecisionQuery::parse(each.line)) knownTo = 0;
    }
    Answer answer;
    answer.stop = direction > 0 ? nextStop(armed, here) : previousStop(armed, here);
    const std::uint32_t needed = direction < 0 ? here.pivot
                                 : answer.stop ? answer.stop->hit.place.pivot
                                               : std::numeric_limits<std::uint32_t>::max();
    if (knownTo >= needed) return answer;
    return {givenUp_ ? Known::GivenUp : Known::NotYet, std::nullopt};
}

void WatchScan::startNext() {
    if (busy()) return;
    std::vector<WatchExpression> expressions;
    sought_.clear();
    for (const std::string& each : wanted_) {
        const auto expression = WatchExpression::parse(each);
        const bool twice = std::find(sought_.begin(), sought_.end(), each) != sought_.end();
        if (!expression || twice || known_[each].complete) continue;
        known_[each] = {};
        sought_.push_back(each);
        expressions.push_back(expression.value());
    }
    if (sought_.empty()) return;
    job_.startPass(model_, [expressions](const Model& model, auto& results) {
        const auto add = [&results](std::uint32_t pivot, std::span<const double> values) {
            results.add({pivot, {values.begin(), values.end()}});
        };
        return watchVisitor(model.points, model.params, expressions, add);
    });
}

bool WatchScan::add(std::vector<WatchValues>& found, bool complete) {
    for (std::size_t i = 0; i < sought_.size(); ++i) {
        WatchSeries& series = known_[sought_[i]];
        for (const WatchValues& each : found) {
            series.values.resize(each.pivot + std::size_t{1}, each.values[i]);
            series.values.back() = each.values[i];
        }
        series.complete = complete;
    }
    return !found.empty();
}

}  // namespace se::view
