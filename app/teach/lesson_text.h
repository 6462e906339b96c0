/// Text of a step for display: paragraphs, list items, code and images, with their emphasis and
/// links. HTML in a lesson is shown as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace se::teach {

/// Words in one style.
struct TextSpan {
    std::string text;
    bool emphasized = false;
    bool strong = false;
    bool code = false;
    std::string link;  ///< "se:9.sphere.2", or an address of the web; empty: none.
};

enum class TextBlockKind : std::uint8_t { Paragraph, Heading, Item, Code, Quote, Image };

/// One block of text.
struct TextBlock {
    TextBlockKind kind = TextBlockKind::Paragraph;
    std::vector<TextSpan> spans;
    int number = 0;     ///< Of an item of a numbered list, from 1; 0: none.
    std::string image;  ///< Path of an image; the spans are its description.
};

/// The blocks of a Markdown text.
std::vector<TextBlock> textBlocks(std::string_view markdown);

/// The text without marks, one block per line.
std::string plainTextOf(const std::vector<TextBlock>& blocks);

}  // namespace se::teach
