// The Paper panel: the paper's pseudo-code with the current line highlighted.
#include "rows/paper_text.h"

#include "document/actions.h"
#include "document/alert_actions.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "rows/evidence_rows.h"
#include "run/model.h"
#include "scene/palette.h"
#include "session/playback.h"
#include "session/session.h"

namespace se::view {

namespace {

/// A line of pseudo-code; the current one highlighted, with its numbers below.
void drawLine(const PanelContext& context, const std::string& line, bool present,
              const std::string& numbers, const Color& color) {
    const std::size_t level = line.find_first_not_of(' ');
    const float indent = 0.5F * context.em * static_cast<float>(level) + 0.6F * context.em;
    const float left = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x - indent;
    const std::vector<std::string> lines = wrapped(line.substr(level), width);
    const float more = 0.5F * context.em;  // Numbers are indented from their line.
    const std::vector<std::string> values =
        numbers.empty() ? std::vector<std::string>{} : wrapped(numbers, width - more);
    const float height = ImGui::GetTextLineHeightWithSpacing();
    if (present) {
        const auto rows = static_cast<float>(lines.size() + values.size());
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImDrawList* list = ImGui::GetWindowDrawList();
        const float right = at.x + ImGui::GetContentRegionAvail().x;
        list->AddRectFilled(at, {right, at.y + rows * height},
                            toU32(context.palette.accent.withAlpha(0.25F)), 0.2F * context.em);
        list->AddRectFilled(at, {at.x + 0.2F * context.em, at.y + rows * height}, toU32(color));
    }
    for (const std::string& part : lines) {
        ImGui::SetCursorPosX(left + indent);
        present ? ImGui::TextUnformatted(part.c_str()) : ImGui::TextDisabled("%s", part.c_str());
    }
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
    for (const std::string& part : values) {
        ImGui::SetCursorPosX(left + indent + more);
        ImGui::TextUnformatted(part.c_str());
    }
    ImGui::PopStyleColor();
}

/// For a scene that fails: class, decision, the paper's sentence, and the remedy.
void drawGallery(const PanelContext& context) {
    const FailureScene* each = galleryScene(context.session().input().spec().source);
    if (each == nullptr) return;
    heading(context, std::string(each->scene.title).c_str(), "scene that fails");
    wrappedText(std::string(each->scene.watch));
    ImGui::Spacing();
    if (beginValues("##gallery", context)) {
        valueRow(context, "failure", titleOf(*findFailureClass(each->failure)),
                 context.palette.rejected);
        valueRow(context, "decision", std::string(each->address));
        valueRow(context, "paper", std::string(each->section) + ": " + std::string(each->sentence));
        valueRow(context, "what helps", std::string(each->helps));
        ImGui::EndTable();
    }
    const auto address = addressFromString(each->address);
    if (smallButton(context, "Go to " + std::string(each->address), "gallery decision") && address)
        jumpingMoves(context.commands).goTo(*address);
    separator();
}

/// Title and caption of a figure of the paper, and what happens without its rule.
void drawFigure(const PanelContext& context) {
    const Figure* figure = figureOfSource(context.session().input().spec().source);
    if (figure == nullptr) return;
    heading(context, std::string(figure->scene.title).c_str());
    wrappedText(std::string(figure->scene.watch));
    if (!figure->absence.empty()) dimText("Without the rule: " + std::string(figure->absence));
    separator();
}

}  // namespace

void drawPaper(const PanelContext& context) {
    const Session& session = context.session();
    drawGallery(context);
    drawFigure(context);
    const Event* event = session.event();
    if (event == nullptr) {
        dimText("Step forward (F11 or \xE2\x86\x92): the active rule is explained here.");
        return;
    }
    const PaperRule& rule = paperRule(event->address.stage);
    const std::string section = sectionOf(*event);
    heading(context, rule.title.c_str(), section.empty() ? "docs/robust.md" : "section " + section);
    wrappedText(rule.words);
    ImGui::Spacing();
    const std::size_t present = presentLine(*event);
    const Color color = outcomeColor(context.palette, *event).value_or(context.palette.accent);
    for (std::size_t i = 0; i < rule.code.size(); ++i) {
        drawLine(context, rule.code[i], i == present, i == present ? liveNumbers(*event) : "",
                 color);
    }
}

}  // namespace se::view
