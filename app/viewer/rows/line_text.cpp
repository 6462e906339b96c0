#include "line_text.h"

#include "run/number_format.h"
#include "run/strings.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

namespace {

std::string valueText(const Reading& reading, double value) {
    return reading.unit.empty() ? numberText(value) : degreesText(value);
}

}  // namespace

std::string marginText(double margin) { return margin == 0.0 ? "0" : formatted("%+.2g", margin); }

std::string comparisonText(const Reading& reading, bool named) {
    return (named ? std::string(reading.quantity) + " " : std::string{}) +
           valueText(reading, reading.value) + " against " + valueText(reading, reading.threshold);
}

std::string readingText(const Reading& reading) {
    return comparisonText(reading, true) + ", margin " + marginText(reading.margin);
}

std::string lineText(const LedgerLine& line) {
    const std::string_view section = stageSection(line.event.address.stage);
    std::string text = toString(line.event.address) + "  " + std::string(roleName(line.role)) +
                       (line.pivot == kNone ? "" : "  pivot " + std::to_string(line.pivot)) +
                       (section.empty() ? "" : "  " + std::string(section)) + "  " +
                       describe(line.event);
    if (line.reading) text += "\n    " + readingText(*line.reading);
    return text;
}

std::string ledgerText(const std::string& answer, std::span<const LedgerLine> lines,
                       std::size_t cause) {
    std::string text = answer + "\n\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += (i == cause ? "> " : "  ") + lineText(lines[i]) + "\n";
    return text;
}

namespace {

std::string_view lastWord(std::string_view line) {
    const std::size_t blank = line.find_last_of(" \t");
    return blank == std::string_view::npos ? line : line.substr(blank + 1);
}

/// The literal part of a form: "stage=" of "stage=NAME", all of "kept".
std::string_view fixedPart(const QueryTerm& term) {
    const std::size_t sign = term.form.find_first_of("=<");
    return sign == std::string_view::npos ? term.form : term.form.substr(0, sign + 1);
}

/// True if one is a prefix of the other: "mar" and "margin<", "margin<1e" and "margin<".
bool agree(std::string_view word, std::string_view fixed) {
    return word.starts_with(fixed) || fixed.starts_with(word);
}

}  // namespace

std::vector<const QueryTerm*> termsFor(std::string_view line) {
    const std::string_view word = lastWord(line);
    std::vector<const QueryTerm*> all;
    std::vector<const QueryTerm*> fitting;
    for (const QueryTerm& term : queryTerms()) {
        all.push_back(&term);
        if (!word.empty() && agree(word, fixedPart(term))) fitting.push_back(&term);
    }
    return fitting.empty() ? all : fitting;
}

std::string completed(std::string_view line, const QueryTerm& term) {
    const std::string_view word = lastWord(line);
    const std::string_view fixed = fixedPart(term);
    std::string text(line.substr(0, line.size() - word.size()));
    // A complete word stays; the new one is added after it.
    if (!word.empty() && !agree(word, fixed)) text += std::string(word) + " ";
    const bool whole = fixed.size() == term.form.size();
    return text + std::string(fixed) + (whole ? " " : "");
}

}  // namespace se::view
