#include "lesson_text.h"

#include "markdown_tree.h"

namespace se::teach {
namespace {

TextBlockKind kindOf(cmark_node* node) {
    cmark_node* parent = cmark_node_parent(node);
    if (cmark_node_get_type(node) == CMARK_NODE_HEADING) return TextBlockKind::Heading;
    if (parent == nullptr) return TextBlockKind::Paragraph;
    if (cmark_node_get_type(parent) == CMARK_NODE_ITEM) return TextBlockKind::Item;
    if (cmark_node_get_type(parent) == CMARK_NODE_BLOCK_QUOTE) return TextBlockKind::Quote;
    return TextBlockKind::Paragraph;
}

/// Position in its numbered list; 0 in a list of bullets.
int numberOf(cmark_node* paragraph) {
    cmark_node* item = cmark_node_parent(paragraph);
    if (item == nullptr || cmark_node_get_type(item) != CMARK_NODE_ITEM) return 0;
    cmark_node* list = cmark_node_parent(item);
    if (cmark_node_get_list_type(list) != CMARK_ORDERED_LIST) return 0;
    int number = cmark_node_get_list_start(list);
    for (cmark_node* each = cmark_node_previous(item); each != nullptr;
         each = cmark_node_previous(each))
        ++number;
    return number;
}

}  // namespace

std::vector<TextBlock> textBlocks(std::string_view markdown) {
    std::vector<TextBlock> blocks;
    TextSpan style;
    const auto add = [&](std::string_view text) {
        if (blocks.empty()) blocks.emplace_back();
        blocks.back().spans.push_back(style);
        blocks.back().spans.back().text = text;
    };
    const MarkdownTree tree = markdownTree(markdown);
    visitNodes(tree.get(), [&](cmark_node* node, cmark_event_type event) {
        const cmark_node_type type = cmark_node_get_type(node);
        const bool enters = event == CMARK_EVENT_ENTER;
        if (type == CMARK_NODE_EMPH) style.emphasized = enters;
        if (type == CMARK_NODE_STRONG) style.strong = enters;
        if (type == CMARK_NODE_LINK) style.link = enters ? urlOf(node) : "";
        if (!enters) return;
        style.code = type == CMARK_NODE_CODE;
        if (type == CMARK_NODE_PARAGRAPH || type == CMARK_NODE_HEADING)
            blocks.push_back({kindOf(node), {}, numberOf(node), {}});
        if (type == CMARK_NODE_IMAGE)
            blocks.push_back({TextBlockKind::Image, {}, 0, std::string(urlOf(node))});
        if (type == CMARK_NODE_CODE_BLOCK || type == CMARK_NODE_HTML_BLOCK)
            blocks.push_back({TextBlockKind::Code, {}, 0, {}});
        if (type == CMARK_NODE_SOFTBREAK) add(" ");
        if (type == CMARK_NODE_LINEBREAK) add("\n");
        // Of texts, code and HTML.
        if (const char* literal = cmark_node_get_literal(node)) add(literal);
    });
    return blocks;
}

std::string plainTextOf(const std::vector<TextBlock>& blocks) {
    std::string text;
    for (const TextBlock& block : blocks) {
        if (block.kind == TextBlockKind::Item)
            text += block.number > 0 ? std::to_string(block.number) + ". " : "- ";
        for (const TextSpan& span : block.spans) text += span.text;
        if (!text.ends_with('\n')) text += '\n';
    }
    return text;
}

}  // namespace se::teach
