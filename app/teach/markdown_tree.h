/// The nodes of a CommonMark text, as cmark parses it.
#pragma once

#include <cmark.h>

#include <memory>
#include <string_view>

namespace se::teach {

using MarkdownTree = std::unique_ptr<cmark_node, decltype(&cmark_node_free)>;

inline MarkdownTree markdownTree(std::string_view text) {
    return {cmark_parse_document(text.data(), text.size(), CMARK_OPT_DEFAULT), &cmark_node_free};
}

/// Calls visit(node, event) wherever a node of a tree is entered or left.
template <typename Visit>
void visitNodes(cmark_node* root, Visit&& visit) {
    cmark_iter* iterator = cmark_iter_new(root);
    for (cmark_event_type event = cmark_iter_next(iterator); event != CMARK_EVENT_DONE;
         event = cmark_iter_next(iterator))
        visit(cmark_iter_get_node(iterator), event);
    cmark_iter_free(iterator);
}

/// The text that a node stands for itself; empty if it has none.
inline std::string_view literalOf(cmark_node* node) {
    const char* literal = cmark_node_get_literal(node);
    return literal == nullptr ? std::string_view{} : literal;
}
/// The address of a link or an image; empty for any other node.
inline std::string_view urlOf(cmark_node* node) {
    const char* url = cmark_node_get_url(node);
    return url == nullptr ? std::string_view{} : url;
}

}  // namespace se::teach
