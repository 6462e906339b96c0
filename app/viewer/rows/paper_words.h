/// The words of the paper with a definition each, for tooltips where the window shows them. Plain
/// values, no ImGui.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace se::view {

struct PaperWord {
    std::string_view words;     ///< As the window shows it, with synonyms: "edge ring|rings".
    std::string_view section;   ///< Of the paper.
    std::string_view sentence;  ///< The definition.
};

std::span<const PaperWord> paperWords();

/// The definition of a word with its section: "edge ring (paper, 4): ...". Upper and lower case are
/// the same. Empty for a word that the paper does not have.
std::string definitionOf(std::string_view word);

}  // namespace se::view
