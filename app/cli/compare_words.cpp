#include "compare_words.h"

#include <algorithm>
#include <sstream>

namespace se::cli {
namespace {

/// Number of words from `i` on that belong to neither run, wherever they occur.
std::size_t wordsForBothRuns(const Arguments& words, std::size_t i) {
    const std::string& word = words[i];
    if (word == "--json" || word == "-q" || word == "--quiet" || word.starts_with("--most="))
        return 1;
    return word == "--most" ? std::min<std::size_t>(2, words.size() - i) : 0;
}

Arguments splitAtBlanks(const std::string& text) {
    Arguments words;
    std::istringstream parts(text);
    for (std::string part; parts >> part;) words.push_back(part);
    return words;
}

}  // namespace

ComparedWords splitAtWith(const Arguments& words) {
    ComparedWords split;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--with") {
            split.hasWith = true;
            continue;
        }
        std::size_t count = split.hasWith ? wordsForBothRuns(words, i) : 1;
        for (; count > 1; --count) split.a.push_back(words[i++]);
        if (count == 1) {
            split.a.push_back(words[i]);
            continue;
        }
        split.with.push_back(words[i]);
    }
    // A word among others is one value, spaces included, such as the value of --what-if.
    if (split.with.size() == 1) split.with = splitAtBlanks(split.with.front());
    return split;
}

RunSpec specOfB(const RunSpec& a, const Arguments& with) {
    const Result<SpecChange> change = changeFromWords(with);
    if (!change) throw Failure(ExitCode::Usage, "--with " + change.error().message);
    for (const char* key : {"crop", "thin"}) {
        if (textOf(change.value(), key).empty()) continue;
        throw Failure(ExitCode::Usage,
                      std::string("--") + key +
                          ": two runs are compared on the same points; give it before --with");
    }
    return otherRun(a, change.value());
}

std::string titleOf(const RunSpec& spec) {
    const std::string title = optionsText(
        spec, {SpecGroup::Reading, SpecGroup::Rules, SpecGroup::Lists, SpecGroup::Derived});
    return title.empty() ? "the paper's rules" : title.substr(1);
}

}  // namespace se::cli
