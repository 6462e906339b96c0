/// The paper's rules in this program's words and as pseudo-code, stage by stage, for the panel that
/// highlights the current line. Plain values, no ImGui.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/stepper/event.h"

namespace se::view {

struct PaperRule {
    std::string stages;  ///< Names, with spaces between them.
    std::string title;
    std::string words;
    std::vector<std::string> code;  ///< Lines, two spaces per level.
};

/// The rule of a stage. Stages that belong together share one.
const PaperRule& paperRule(Stage stage);

/// The line of the rule's code for the event, counted from 0.
std::size_t presentLine(const Event& event);

/// The numbers compared in that line; empty if there are none.
std::string liveNumbers(const Event& event);

// The words of the paper with a definition each, for tooltips where the window shows them. Plain
// values, no ImGui.

struct PaperWord {
    std::string words;     ///< As the window shows it, with synonyms: "edge ring|rings".
    std::string section;   ///< Of the paper.
    std::string sentence;  ///< The definition.
};

std::span<const PaperWord> paperWords();

/// The definition of a word with its section: "edge ring (paper, 4): ...". Upper and lower case are
/// the same. Empty for a word that the paper does not have.
std::string definitionOf(std::string_view word);

}  // namespace se::view
