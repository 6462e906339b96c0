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

/// Collects blocks while the nodes of a tree are entered and left.
class BlockCollector {
  public:
    void visit(cmark_node* node, cmark_event_type event) {
        const cmark_node_type type = cmark_node_get_type(node);
        const bool enters = event == CMARK_EVENT_ENTER;
        if (type == CMARK_NODE_EMPH) style_.emphasized = enters;
        if (type == CMARK_NODE_STRONG) style_.strong = enters;
        if (type == CMARK_NODE_LINK) style_.link = enters ? urlOf(node) : "";
        if (!enters) return;
        if (type == CMARK_NODE_PARAGRAPH || type == CMARK_NODE_HEADING) {
            blocks_.push_back({kindOf(node), {}, numberOf(node), {}});
        } else if (type == CMARK_NODE_IMAGE) {
            blocks_.push_back({TextBlockKind::Image, {}, 0, std::string(urlOf(node))});
        } else if (type == CMARK_NODE_CODE_BLOCK || type == CMARK_NODE_HTML_BLOCK) {
            blocks_.push_back({TextBlockKind::Code, {}, 0, {}});
            add(literalOf(node));
        } else {
            addInline(node, type);
        }
    }
    std::vector<TextBlock> take() { return std::move(blocks_); }

  private:
    void addInline(cmark_node* node, cmark_node_type type) {
        if (type == CMARK_NODE_SOFTBREAK) add(" ");
        if (type == CMARK_NODE_LINEBREAK) add("\n");
        if (type == CMARK_NODE_TEXT || type == CMARK_NODE_HTML_INLINE) add(literalOf(node));
        if (type != CMARK_NODE_CODE) return;
        style_.code = true;
        add(literalOf(node));
        style_.code = false;
    }
    void add(std::string_view text) {
        if (blocks_.empty()) blocks_.emplace_back();
        TextSpan span = style_;
        span.text = text;
        blocks_.back().spans.push_back(std::move(span));
    }

    TextSpan style_;
    std::vector<TextBlock> blocks_;
};

}  // namespace

std::vector<TextBlock> textBlocks(std::string_view markdown) {
    const MarkdownTree tree = markdownTree(markdown);
    BlockCollector collector;
    visitNodes(tree.get(),
               [&](cmark_node* node, cmark_event_type event) { collector.visit(node, event); });
    return collector.take();
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
