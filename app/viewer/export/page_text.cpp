#include "page_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "paint/svg_text.h"
#include "run/base64.h"
#include "spiraling_edge/base/files.h"

namespace se::view {

namespace {

using teach::TextBlock;
using teach::TextBlockKind;
using teach::TextSpan;

constexpr std::string_view kStepLink = "se:";

struct ImageKind {
    std::string_view extension;
    std::string_view type;
};
constexpr std::array kImageKinds{
    ImageKind{".png", "image/png"},     ImageKind{".jpg", "image/jpeg"},
    ImageKind{".jpeg", "image/jpeg"},   ImageKind{".gif", "image/gif"},
    ImageKind{".svg", "image/svg+xml"},
};

std::string linked(const TextSpan& span, const std::string& text, const PageLinks& links) {
    if (span.link.starts_with(kStepLink)) {
        const std::string address = span.link.substr(kStepLink.size());
        const auto step = links.steps.find(address);
        if (step != links.steps.end())
            return fmt::format("<a href=\"#{}\">{}</a>", step->second, text);
        if (links.toProgram) return linkToOutside(links.toProgram(address), text);
        return fmt::format("<span title=\"{}\">{}</span>", escapedXml(address), text);
    }
    if (!span.link.starts_with("https://") && !span.link.starts_with("http://")) return text;
    return linkToOutside(span.link, text);
}

std::string spansText(const TextBlock& block, const PageLinks& links) {
    std::string all;
    for (const TextSpan& span : block.spans) {
        std::string text = escapedXml(span.text);
        const auto wrap = [&](std::string_view tag) {
            text = fmt::format("<{0}>{1}</{0}>", tag, text);
        };
        if (span.code && block.kind != TextBlockKind::Code) wrap("code");
        if (span.strong) wrap("strong");
        if (span.emphasized) wrap("em");
        all += span.link.empty() ? text : linked(span, text, links);
    }
    return all;
}

std::string plainSpans(const TextBlock& block) {
    std::string text;
    for (const TextSpan& span : block.spans) text += span.text;
    return escapedXml(text);
}

/// An image of the lesson's folder; its description if it cannot be read.
std::string imageText(const TextBlock& block, const PageLinks& links) {
    const std::filesystem::path path = links.folder / block.image;
    const std::string extension = lowerExtension(path);
    const auto kind = std::find_if(kImageKinds.begin(), kImageKinds.end(),
                                   [&](const auto& each) { return each.extension == extension; });
    const Result<std::string> bytes = readBytes(path);
    if (kind == kImageKinds.end() || !bytes) return "<p>" + plainSpans(block) + "</p>";
    return fmt::format("<img alt=\"{}\" src=\"data:{};base64,{}\">", plainSpans(block), kind->type,
                       base64Of(bytes.value()));
}

std::string_view tagOf(TextBlockKind kind) {
    switch (kind) {
        case TextBlockKind::Heading:
            return "h3";
        case TextBlockKind::Code:
            return "pre";
        case TextBlockKind::Quote:
            return "blockquote";
        case TextBlockKind::Item:
            return "li";
        case TextBlockKind::Paragraph:
        case TextBlockKind::Image:
            return "p";
    }
    return "p";
}

}  // namespace

std::string linkToOutside(const std::string& address, const std::string& text) {
    return fmt::format("<a href=\"{}\" rel=\"noopener noreferrer\" target=\"_blank\">{}</a>",
                       escapedXml(address), text);
}

std::string pageText(const std::vector<TextBlock>& blocks, const PageLinks& links) {
    std::string text;
    std::string_view list;  // The tag of the open list.
    for (const TextBlock& block : blocks) {
        const bool item = block.kind == TextBlockKind::Item;
        const std::string_view wanted = !item ? "" : block.number > 0 ? "ol" : "ul";
        if (wanted != list) {
            if (!list.empty()) text += fmt::format("</{}>", list);
            if (!wanted.empty()) text += fmt::format("<{}>", wanted);
            list = wanted;
        }
        if (block.kind == TextBlockKind::Image) {
            text += imageText(block, links);
            continue;
        }
        text += fmt::format("<{0}>{1}</{0}>\n", tagOf(block.kind), spansText(block, links));
    }
    if (!list.empty()) text += fmt::format("</{}>", list);
    return text;
}

}  // namespace se::view
