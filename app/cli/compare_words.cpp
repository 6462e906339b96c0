#include "compare_words.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace se::cli {
namespace {

/// Pairs of an option in B and an option of A that it replaces, besides itself.
struct Override {
    std::string_view option;
    std::string_view other;
};
constexpr std::array kOverrides{
    Override{"neighbors", "radius"},
    Override{"neighbors", "reach"},
    Override{"radius", "neighbors"},
    Override{"radius", "reach"},
    Override{"reach", "neighbors"},
    Override{"reach", "radius"},
    Override{"rules", "rule"},
    Override{"orient", "derive-normals"},
    Override{"derive-normals", "orient"},
};

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

bool overrides(const GivenOption& mine, const GivenOption& theirs) {
    // --rule of B is added to those of A.
    if (mine.name == theirs.name) return mine.name != "rule";
    return std::any_of(kOverrides.begin(), kOverrides.end(), [&](const Override& row) {
        return row.option == mine.name && row.other == theirs.name;
    });
}

/// Throws Failure if one of the options after --with changes the points.
void requireSamePoints(const InputArguments& change) {
    for (const GivenOption& option : change.given()) {
        if (option.name != "crop" && option.name != "thin") continue;
        throw Failure(ExitCode::Usage,
                      "--" + option.name +
                          ": two runs are compared on the same points; give it before --with");
    }
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

ParsedInput::ParsedInput(const Arguments& words) : app_("", "spiraling-edge compare") {
    input_.addTo(app_);
    app_.set_help_flag();
    (void)parseArguments(app_, words);
}

Arguments optionsOfB(const InputArguments& a, const Arguments& with) {
    Arguments words{a.input()};
    words.insert(words.end(), with.begin(), with.end());
    const ParsedInput change(words);
    requireSamePoints(change.input());
    words = {a.input()};
    for (const GivenOption& theirs : a.given()) {
        const std::vector<GivenOption> mine = change.input().given();
        const bool gone = std::any_of(mine.begin(), mine.end(), [&](const GivenOption& option) {
            return overrides(option, theirs);
        });
        if (!gone) words.insert(words.end(), theirs.words.begin(), theirs.words.end());
    }
    for (const GivenOption& mine : change.input().given())
        words.insert(words.end(), mine.words.begin(), mine.words.end());
    return words;
}

std::string titleOf(const InputArguments& input) {
    std::string title;
    for (const std::string& words : input.options()) title += (title.empty() ? "" : " ") + words;
    return title.empty() ? "the paper's rules" : title;
}

}  // namespace se::cli
