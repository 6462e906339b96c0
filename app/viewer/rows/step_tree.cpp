// The rows are never listed. A component has as many rows as pivots when open, and only the pivot
// at the cursor has rows below it; so the row number of anything follows from a short list of the
// open components with their first rows (open_), by binary search. The filter keeps a list of
// matching pivots, which grows with the overview.
#include "step_tree.h"

#include <cassert>
#include <cctype>
#include <sstream>

#include "run/strings.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

// ---- the filter -----------------------------------------------------------------------------

namespace {

/// All possible meanings of a word.
Findings findingsOf(std::string_view word) {
    Findings found;
    for (const StageRow& row : stageTable()) {
        if (row.name.starts_with(word)) found |= findingOf(row.id);
    }
    for (const VerdictRow& row : verdictTable()) {
        if (lowerCase(row.text).find(word) != std::string::npos) found |= findingOf(row.id);
    }
    return found;
}

/// Whether `number` is in the text, and not as a part of a longer one.
bool hasNumber(std::string_view text, std::string_view number) {
    const auto digit = [&](std::size_t i) {
        return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    };
    for (std::size_t at = text.find(number); at != std::string_view::npos;
         at = text.find(number, at + 1)) {
        if ((at == 0 || !digit(at - 1)) && !digit(at + number.size())) return true;
    }
    return false;
}

std::vector<StageRun> stageRuns(const std::vector<Event>& events) {
    std::vector<StageRun> runs;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Stage stage = events[i].address.stage;
        if (runs.empty() || runs.back().stage != stage) runs.push_back({stage, i, i, 0, 0});
        StageRun& run = runs.back();
        run.end = i + 1;
        if (verdictOf(events[i])) ++run.tests;
        if (outcomeOf(events[i]) == Outcome::Refused) ++run.refused;
    }
    return runs;
}

}  // namespace

StepFilter::StepFilter(std::string_view text) {
    std::istringstream words{lowerCase(text)};
    for (std::string word; words >> word;) words_.push_back(read(word));
}

StepFilter::Word StepFilter::read(std::string text) {
    Word word;
    word.refused = text == "x" || text == "\xC3\x97";
    word.number = numberIn<Index>(text).value_or(kNone);
    if (!word.refused && word.number == kNone) word.found = findingsOf(text);
    word.text = std::move(text);
    return word;
}

bool StepFilter::matches(std::uint32_t pivot, const PivotSummary& summary) const {
    return std::all_of(words_.begin(), words_.end(), [&](const Word& word) {
        if (word.refused) return summary.refused > 0;
        if (word.number != kNone) return word.number == summary.point || word.number == pivot;
        return (summary.found & word.found).any();
    });
}

bool StepFilter::matches(const Event& event) const {
    Findings found = findingOf(event.address.stage);
    if (const auto verdict = verdictOf(event)) found |= findingOf(*verdict);
    std::string sentence;
    return std::all_of(words_.begin(), words_.end(), [&](const Word& word) {
        if (word.refused) return outcomeOf(event) == Outcome::Refused;
        if ((found & word.found).any()) return true;
        if (sentence.empty()) sentence = lowerCase(describe(event));
        return word.number != kNone ? hasNumber(sentence, word.text)
                                    : sentence.find(word.text) != std::string::npos;
    });
}

// ---- the tree -------------------------------------------------------------------------------

void StepTree::update(const RunOverview& run, std::uint32_t generation, const PivotRecord& record,
                      std::size_t cursor) {
    const bool another = generation != generation_ || run_ == nullptr;
    if (another) {
        opened_.clear();
        componentFolded_ = pivotFolded_ = stageFolded_ = false;
        matches_.clear();
        matchedPivots_ = 0;
    }
    const bool longer = another || run.pivots.size() != pivotCount_;
    const bool moved = another || record_ != &record || recordPivot_ != record.pivot;
    run_ = &run;
    record_ = &record;
    generation_ = generation;
    recordPivot_ = record.pivot;
    pivotCount_ = run.pivots.size();
    if (!longer && !moved && cursor == cursor_) return;
    cursor_ = cursor;
    const std::size_t component = componentOf(recordPivot_);
    if (component != cursorComponent_) componentFolded_ = false;
    cursorComponent_ = component;
    if (moved) runs_ = stageRuns(record.events);
    const auto at = std::find_if(runs_.begin(), runs_.end(),
                                 [&](const StageRun& r) { return r.contains(cursor); });
    const auto place = static_cast<std::size_t>(at - runs_.begin());
    if (moved || place != cursorRun_) stageFolded_ = false;
    cursorRun_ = place;
    matchPivots();
    if (moved) matchEvents();
    layOut();
}

void StepTree::setFilter(const std::string& text) {
    if (text == filterText_) return;
    filterText_ = text;
    filter_ = StepFilter(text);
    matches_.clear();
    matchedPivots_ = 0;
    matchPivots();
    matchEvents();
}

void StepTree::matchPivots() {
    if (run_ == nullptr || filter_.empty()) return;
    for (; matchedPivots_ < run_->pivots.size(); ++matchedPivots_) {
        const auto pivot = static_cast<std::uint32_t>(matchedPivots_ + 1);
        if (filter_.matches(pivot, run_->pivots[matchedPivots_])) matches_.push_back(pivot);
    }
}

void StepTree::matchEvents() {
    eventMatches_.clear();
    if (record_ == nullptr || filter_.empty()) return;
    for (std::size_t i = 0; i < record_->events.size(); ++i) {
        if (filter_.matches(record_->events[i])) eventMatches_.push_back(i);
    }
}

void StepTree::layOut() {
    runRow_.clear();
    std::size_t row = 0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        runRow_.push_back(row);
        row += 1 + (stageOpen(i) ? runs_[i].size() : 0);
    }
    runRow_.push_back(row);
    open_.clear();
    if (run_ == nullptr) return;
    std::set<std::size_t> open = opened_;
    if (!componentFolded_) open.insert(cursorComponent_);
    std::size_t below = 0;
    for (const std::size_t component : open) {
        if (component >= run_->components.size()) break;
        std::size_t rows = pivotsOf(component);
        if (component == cursorComponent_ && cursorPivotListed()) rows += rowsOfPivot();
        open_.push_back({component, component + below, rows});
        below += rows;
    }
}

bool StepTree::stageOpen(std::size_t run) const {
    if (runs_[run].size() < 2) return false;
    const bool byHand = openedStages_.test(static_cast<std::size_t>(runs_[run].stage));
    return byHand || (run == cursorRun_ && !stageFolded_);
}

bool StepTree::componentOpen(std::size_t component) const {
    return std::any_of(open_.begin(), open_.end(),
                       [&](const OpenComponent& open) { return open.component == component; });
}

bool StepTree::cursorPivotListed() const { return recordPivot_ > 0 && recordPivot_ <= pivotCount_; }

std::size_t StepTree::rowsOfPivot() const { return pivotFolded_ ? 0 : runRow_.back(); }

std::uint32_t StepTree::pivotsOf(std::size_t component) const {
    const auto& all = run_->components;
    const auto end = component + 1 < all.size() ? all[component + 1].firstPivot
                                                : static_cast<std::uint32_t>(pivotCount_ + 1);
    return end - all[component].firstPivot;
}

std::size_t StepTree::componentOf(std::uint32_t pivot) const {
    const auto& all = run_->components;
    const auto after = std::upper_bound(
        all.begin(), all.end(), pivot,
        [](std::uint32_t p, const ComponentSummary& c) { return p < c.firstPivot; });
    return after == all.begin() ? 0 : static_cast<std::size_t>(after - all.begin()) - 1;
}

// ---- rows -----------------------------------------------------------------------------------

std::size_t StepTree::rowCount() const {
    if (run_ == nullptr) return 0;
    if (filtered()) {
        const bool listed = std::binary_search(matches_.begin(), matches_.end(), recordPivot_);
        const bool shown = listed || !eventMatches_.empty();
        return matches_.size() + (shown && !listed ? 1 : 0) +
               (shown && !pivotFolded_ ? eventMatches_.size() : 0);
    }
    std::size_t rows = run_->components.size();
    for (const OpenComponent& open : open_) rows += open.rows;
    return rows;
}

StepRow StepTree::row(std::size_t row) const {
    assert(row < rowCount());
    if (filtered()) return filteredRow(row);
    const auto after =
        std::upper_bound(open_.begin(), open_.end(), row,
                         [](std::size_t r, const OpenComponent& open) { return r < open.row; });
    if (after == open_.begin()) return {StepRowKind::Component, row, 0, 0, 0};
    const OpenComponent& open = *std::prev(after);
    if (row == open.row) return {StepRowKind::Component, open.component, 0, 0, 0};
    if (row <= open.row + open.rows) return rowOfPivot(open.component, row - open.row - 1);
    return {StepRowKind::Component, open.component + row - open.row - open.rows, 0, 0, 0};
}

StepRow StepTree::rowOfPivot(std::size_t component, std::size_t place) const {
    const std::uint32_t first = run_->components[component].firstPivot;
    const bool here = component == cursorComponent_ && cursorPivotListed();
    const std::size_t at = here ? recordPivot_ - first : pivotCount_;
    const std::size_t inside = here ? rowsOfPivot() : 0;
    if (place > at && place <= at + inside) return rowInPivot(place - at - 1);
    const std::size_t pivot = first + place - (place > at ? inside : 0);
    return {StepRowKind::Pivot, component, static_cast<std::uint32_t>(pivot), 0, 0};
}

StepRow StepTree::rowInPivot(std::size_t place) const {
    const auto after = std::upper_bound(runRow_.begin(), runRow_.end(), place);
    const auto run = static_cast<std::size_t>(after - runRow_.begin()) - 1;
    const std::size_t inside = place - runRow_[run];
    const StepRowKind kind = inside == 0 ? StepRowKind::Stage : StepRowKind::Test;
    const std::size_t event = runs_[run].begin + (inside == 0 ? 0 : inside - 1);
    return {kind, cursorComponent_, recordPivot_, run, event};
}

std::size_t StepTree::placeInPivot() const {
    if (cursorRun_ >= runs_.size()) return 0;
    const std::size_t inside = stageOpen(cursorRun_) ? 1 + cursor_ - runs_[cursorRun_].begin : 0;
    return runRow_[cursorRun_] + inside;
}

std::optional<std::size_t> StepTree::rowOfCursor() const {
    if (run_ == nullptr || !cursorPivotListed()) return std::nullopt;
    if (filtered()) return filteredCursor();
    const auto open = std::find_if(open_.begin(), open_.end(), [&](const OpenComponent& o) {
        return o.component == cursorComponent_;
    });
    if (open == open_.end()) {
        std::size_t row = cursorComponent_;
        for (const OpenComponent& o : open_) row += o.component < cursorComponent_ ? o.rows : 0;
        return row;
    }
    const std::size_t pivot =
        open->row + 1 + recordPivot_ - run_->components[cursorComponent_].firstPivot;
    if (pivotFolded_ || runs_.empty()) return pivot;
    return pivot + 1 + placeInPivot();
}

// ---- filtered -------------------------------------------------------------------------------

StepRow StepTree::filteredRow(std::size_t row) const {
    const auto at = std::lower_bound(matches_.begin(), matches_.end(), recordPivot_);
    const auto before = static_cast<std::size_t>(at - matches_.begin());
    const bool listed = at != matches_.end() && *at == recordPivot_;
    const bool shown = listed || !eventMatches_.empty();
    const auto pivotRow = [&](std::uint32_t pivot) {
        return StepRow{StepRowKind::Pivot, componentOf(pivot), pivot, 0, 0};
    };
    if (row < before || !shown) return pivotRow(matches_[row]);
    if (row == before) return pivotRow(recordPivot_);
    const std::size_t inside = pivotFolded_ ? 0 : eventMatches_.size();
    if (row - before <= inside) {
        const std::size_t event = eventMatches_[row - before - 1];
        const auto run = std::find_if(runs_.begin(), runs_.end(),
                                      [&](const StageRun& r) { return r.contains(event); });
        return {StepRowKind::Test, cursorComponent_, recordPivot_,
                static_cast<std::size_t>(run - runs_.begin()), event};
    }
    return pivotRow(matches_[row - inside - (listed ? 0 : 1)]);
}

std::optional<std::size_t> StepTree::filteredCursor() const {
    const auto at = std::lower_bound(matches_.begin(), matches_.end(), recordPivot_);
    const bool listed = at != matches_.end() && *at == recordPivot_;
    if (!listed && eventMatches_.empty()) return std::nullopt;
    const auto before = static_cast<std::size_t>(at - matches_.begin());
    if (pivotFolded_ || eventMatches_.empty()) return before;
    const auto event = std::upper_bound(eventMatches_.begin(), eventMatches_.end(), cursor_);
    return before + static_cast<std::size_t>(event - eventMatches_.begin());
}

// ---- opening --------------------------------------------------------------------------------

bool StepTree::canOpen(const StepRow& row) const {
    if (row.kind == StepRowKind::Stage) return runs_[row.run].size() > 1;
    return row.kind != StepRowKind::Test;
}

bool StepTree::isOpen(const StepRow& row) const {
    if (row.kind == StepRowKind::Component) return componentOpen(row.component);
    if (row.kind == StepRowKind::Pivot) return row.pivot == recordPivot_ && !pivotFolded_;
    return row.kind == StepRowKind::Stage && stageOpen(row.run);
}

void StepTree::toggle(const StepRow& row) {
    const bool open = isOpen(row);
    if (row.kind == StepRowKind::Component) {
        if (row.component == cursorComponent_) componentFolded_ = open;
        open ? void(opened_.erase(row.component)) : void(opened_.insert(row.component));
    } else if (row.kind == StepRowKind::Pivot) {
        if (row.pivot == recordPivot_) pivotFolded_ = open;
    } else if (row.kind == StepRowKind::Stage) {
        openedStages_.set(static_cast<std::size_t>(runs_[row.run].stage), !open);
        if (row.run == cursorRun_) stageFolded_ = open;
    }
    layOut();
}

}  // namespace se::view
