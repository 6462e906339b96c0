#include "query_words.h"

namespace se::view {

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
