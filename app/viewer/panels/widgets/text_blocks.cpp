// Dear ImGui has one style per line of text: here each word is drawn by itself, at a position of
// our own, so that styles change within a line.
#include <cmath>
#include <utility>

#include "widgets.h"

namespace se::view {

namespace {

using teach::TextBlock;
using teach::TextBlockKind;
using teach::TextSpan;

/// A word in one style. Words without a blank before them belong to the word before.
struct Word {
    std::string text;
    const TextSpan* style = nullptr;
    bool blankBefore = false;
};

std::vector<Word> wordsOfSpans(const std::vector<TextSpan>& spans) {
    std::vector<Word> words;
    bool blank = false;
    for (const TextSpan& span : spans) {
        bool inWord = false;
        for (const char sign : span.text) {
            if (sign == ' ' || sign == '\n') {
                blank = true;
                inWord = false;
                continue;
            }
            if (!std::exchange(inWord, true))
                words.push_back({{}, &span, std::exchange(blank, false)});
            words.back().text += sign;
        }
    }
    return words;
}

class BlockDrawing {
  public:
    explicit BlockDrawing(const PanelContext& context)
        : context_(context), line_(ImGui::GetTextLineHeightWithSpacing()) {}

    void draw(const TextBlock& block) {
        const float indent = block.kind == TextBlockKind::Item    ? 1.2F * context_.em
                             : block.kind == TextBlockKind::Quote ? 0.8F * context_.em
                                                                  : 0.0F;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        left_ = at.x + indent;
        right_ = at.x + ImGui::GetContentRegionAvail().x;
        x_ = left_;
        y_ = at.y;
        if (block.kind == TextBlockKind::Item) drawBullet(block.number, at);
        heading_ = block.kind == TextBlockKind::Heading;
        if (block.kind == TextBlockKind::Code) {
            drawCode(block);
        } else {
            drawWords(block);
        }
        ImGui::SetCursorScreenPos({at.x, y_ + line_ + 0.35F * context_.em});
        ImGui::Dummy({0.0F, 0.0F});
    }
    const std::string& clicked() const { return clicked_; }

  private:
    ImFont* fontOf(const TextSpan& style) const {
        const Fonts& fonts = context_.fonts;
        if (style.code) return fonts.mono;
        return style.strong || style.emphasized || heading_ ? fonts.strong : fonts.text;
    }
    ImVec2 extentOf(const Word& word) const {
        ImFont* font = fontOf(*word.style);
        return font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, word.text.c_str());
    }

    void drawBullet(int number, ImVec2 at) const {
        const std::string sign = number > 0 ? std::to_string(number) + "." : "\xE2\x80\xA2";
        ImGui::GetWindowDrawList()->AddText(at, toU32(context_.palette.textDim), sign.c_str());
    }

    void drawCode(const TextBlock& block) {
        for (const TextSpan& span : block.spans) wrappedIn(context_.fonts.mono, span.text);
        y_ = ImGui::GetCursorScreenPos().y - line_;
    }

    /// Words that belong together, such as one and the full stop after it, share a line.
    void drawWords(const TextBlock& block) {
        const std::vector<Word> words = wordsOfSpans(block.spans);
        const float blank = ImGui::CalcTextSize(" ").x;
        for (std::size_t i = 0; i < words.size();) {
            std::size_t end = i + 1;
            float width = extentOf(words[i]).x;
            for (; end < words.size() && !words[end].blankBefore; ++end)
                width += extentOf(words[end]).x;
            const bool first = x_ == left_;
            if (!first && x_ + blank + width > right_) {
                x_ = left_;
                y_ += line_;
            } else if (!first && words[i].blankBefore) {
                drawGap(words, i, blank);
                x_ += blank;
            }
            for (; i < end; ++i) drawWord(words[i]);
        }
    }

    /// The line below a link goes on between its words.
    void drawGap(const std::vector<Word>& words, std::size_t i, float width) const {
        const TextSpan* style = words[i].style;
        if (i > 0 && words[i - 1].style == style && !style->link.empty()) underline(x_, width);
    }

    void underline(float x, float width) const {
        const float y = std::round(y_ + ImGui::GetFontSize() + 0.05F * context_.em);
        ImGui::GetWindowDrawList()->AddLine({x, y}, {x + width, y},
                                            toU32(context_.palette.accent.withAlpha(0.7F)));
    }

    void drawWord(const Word& word) {
        const ImVec2 extent = extentOf(word);
        ImFont* font = fontOf(*word.style);
        const bool link = !word.style->link.empty();
        if (link) {
            ImGui::SetCursorScreenPos({x_, y_});
            ImGui::PushID(id_++);
            if (ImGui::InvisibleButton("##link", {extent.x, ImGui::GetFontSize()}))
                clicked_ = word.style->link;
            nameItem(context_, "link " + word.style->link, word.style->link);
            ImGui::PopID();
            underline(x_, extent.x);
        }
        const Color& color = link ? context_.palette.accent : context_.palette.text;
        ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {x_, y_}, toU32(color),
                                            word.text.c_str());
        x_ += extent.x;
    }

    const PanelContext& context_;
    float line_;
    float left_ = 0.0F;
    float right_ = 0.0F;
    float x_ = 0.0F;
    float y_ = 0.0F;
    bool heading_ = false;
    int id_ = 0;
    std::string clicked_;
};

}  // namespace

std::string drawTextBlocks(const PanelContext& context, const std::vector<TextBlock>& blocks) {
    BlockDrawing drawing(context);
    for (const TextBlock& block : blocks) drawing.draw(block);
    return drawing.clicked();
}

}  // namespace se::view
