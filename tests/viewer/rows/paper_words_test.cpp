#include "rows/paper_text.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace se::view;

TEST_CASE("Each word of the paper has one sentence and a section that exists") {
    const std::set<std::string_view> sections = {"3",   "4",   "5",   "6", "6.1", "6.2",
                                                 "6.3", "6.4", "6.5", "7", "7.1", "7.2"};
    for (const PaperWord& word : paperWords()) {
        CAPTURE(word.words);
        CHECK(sections.contains(word.section));
        REQUIRE(word.sentence.size() > 20);
        CHECK(word.sentence.back() == '.');
        CHECK(word.sentence.find(". ") == std::string_view::npos);
    }
}

TEST_CASE("A word is found by any of its names, and has one definition") {
    std::set<std::string> names;
    for (const PaperWord& row : paperWords()) {
        std::string rest(row.words);
        for (std::size_t bar = 0; bar != std::string::npos;) {
            bar = rest.find('|');
            const std::string name = rest.substr(0, bar);
            CHECK(names.insert(name).second);
            CHECK(definitionOf(name).ends_with(row.sentence));
            if (bar != std::string::npos) rest = rest.substr(bar + 1);
        }
    }
    for (const char* word :
         {"edge ring", "neighbor ring", "reciprocal", "circumsphere", "first", "last", "start",
          "end", "pivot", "ring stack", "manifold", "winding", "used", "DONE", "unused"}) {
        CAPTURE(word);
        CHECK(definitionOf(word).find(" (paper, ") != std::string::npos);
    }
    CHECK(definitionOf("Rings").starts_with("edge ring (paper, 4): "));
    CHECK(definitionOf("Doctor").empty());
}
