#include "step_filter.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>

#include "run/picture.h"
#include "run/strings.h"
#include "spiraling_edge/replay/reading.h"

namespace se::view {

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

}  // namespace

StepFilter::StepFilter(std::string_view text) {
    std::istringstream words{lowerCase(text)};
    for (std::string word; words >> word;) words_.push_back(read(word));
}

StepFilter::Word StepFilter::read(std::string text) {
    Word word;
    word.refused = text == "x" || text == "\xC3\x97";
    Index number = kNone;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc{} && end == text.data() + text.size()) word.number = number;
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
        if (word.refused) return rejects(event);
        if ((found & word.found).any()) return true;
        if (sentence.empty()) sentence = lowerCase(describe(event));
        return word.number != kNone ? hasNumber(sentence, word.text)
                                    : sentence.find(word.text) != std::string::npos;
    });
}

}  // namespace se::view
