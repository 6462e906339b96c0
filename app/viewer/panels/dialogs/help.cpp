// The dialogs Guide, the page docs/viewer.md up to its list of keys, and About.
#include <algorithm>
#include <string>
#include <string_view>

#include "document/ui_state.h"
#include "panels/widgets/widgets.h"
#include "run/embedded_files.h"

namespace se::view {

namespace {

/// Plain text of a line of Markdown: links by their words, without marks of emphasis and code.
std::string plainText(std::string_view line) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char sign = line[i];
        if (sign == '*' || sign == '`' || sign == '[') continue;
        if (sign == ']' && i + 1 < line.size() && line[i + 1] == '(') {
            i = std::min(line.find(')', i), line.size());
            continue;
        }
        if (sign != ']') text += sign;
    }
    return text;
}

/// Draws the lines of a page, and joins those of a paragraph.
class PageDrawing {
  public:
    explicit PageDrawing(const PanelContext& context) : context_(context) {}

    void add(std::string_view line) {
        if (line.starts_with("```")) {
            end();
            code_ = !code_;
        } else if (code_) {
            ImGui::PushFont(context_.fonts.mono);
            wrappedText(std::string(line));
            ImGui::PopFont();
        } else if (line.starts_with("#")) {
            end();
            ImGui::Spacing();
            heading(context_, plainText(line.substr(line.find(' ') + 1)).c_str());
        } else if (line.empty() || line.starts_with("<")) {
            end();
        } else {
            if (line.starts_with("- ")) end();
            if (!paragraph_.empty()) paragraph_ += ' ';
            paragraph_ += line.starts_with("- ") ? line : trimmed(line);
        }
    }
    void end() {
        if (paragraph_.empty()) return;
        wrappedText(plainText(paragraph_));
        ImGui::Spacing();
        paragraph_.clear();
    }

  private:
    const PanelContext& context_;
    std::string paragraph_;
    bool code_ = false;
};

void drawGuide(const PanelContext& context) {
    std::string_view page = embeddedFile("viewer.md");
    page = page.substr(0, page.find("## Keys"));
    PageDrawing drawing(context);
    while (!page.empty()) {
        const std::size_t end = std::min(page.find('\n'), page.size());
        drawing.add(page.substr(0, end));
        page.remove_prefix(std::min(end + 1, page.size()));
    }
    drawing.end();
}

void drawAbout(const PanelContext& context) {
    textIn(context.fonts.large, "Spiraling Edge " SE_VERSION);
    ImGui::Spacing();
    wrappedText(
        "Surface reconstruction from points with normals, and every decision on the way, after P. "
        "Crossno and E. Angel, Spiraling Edge: Fast Surface Reconstruction from Partially "
        "Organized Sample Points, IEEE Visualization 1999.");
    ImGui::Spacing();
    dimText("MIT license. Made with Dear ImGui, GLFW, GLM and OpenGL.");
}

}  // namespace

void drawHelp(const PanelContext& context) {
    UiState& ui = context.ui();
    const bool guide = ui.help == HelpPage::Guide;
    if (!guide && ui.help != HelpPage::About) return;
    placeDialog(context, guide ? glm::vec2(48.0F, 46.0F) : glm::vec2(30.0F, 13.0F));
    bool open = true;
    if (beginDialog(guide ? "Guide" : "About", &open)) {
        context.where()[guide ? "help guide" : "help about"] = {
            {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y},
            {ImGui::GetWindowWidth(), ImGui::GetWindowHeight()}};
        guide ? drawGuide(context) : drawAbout(context);
    }
    ImGui::End();
    if (!open) ui.help = HelpPage::None;
}

}  // namespace se::view
