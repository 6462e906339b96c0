/// Text of lessons as HTML, with everything escaped.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "teach/lesson_text.h"

namespace se::view {

/// Where links and images of a text lead.
struct PageLinks {
    std::map<std::string, std::size_t> steps;  ///< Number of the step that shows an address.
    std::filesystem::path folder;              ///< Of the lesson's images.
    /// The link to the program at an address that no step shows; null: there is none.
    std::function<std::string(const std::string& address)> toProgram;
};

/// A link that opens in a window of its own. `text` is HTML.
std::string linkToOutside(const std::string& address, const std::string& text);

/// The blocks as paragraphs, lists, code and images; images are put into the text. Links lead to
/// steps of the page, to the program and to the web, no others.
std::string pageText(const std::vector<teach::TextBlock>& blocks, const PageLinks& links);

}  // namespace se::view
