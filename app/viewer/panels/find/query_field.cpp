#include "query_field.h"

#include "panels/widgets/text_field.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"
#include "spiraling_edge/replay/decision_query.h"

namespace se::view {

std::string queryComplaint(const PanelContext& context, const std::string& line) {
    const auto mistake = mistakeIn(line);
    if (mistake) return mistake->message;
    return missingPointIn(line, context.session().model().points.size());
}

bool queryField(const PanelContext& context, const char* id, const char* hint, std::string& line) {
    const std::string complaint = queryComplaint(context, line);
    ImGui::PushFont(context.fonts.mono);
    if (!complaint.empty()) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
    const bool changed = textField(id, hint, line);
    if (!complaint.empty()) ImGui::PopStyleColor();
    ImGui::PopFont();
    if (line.size() > 20) tooltip(line.size() > 300 ? line.substr(0, 300) + " ..." : line);
    return changed;
}

void queryHelp(const PanelContext& context) {
    ImGui::TextDisabled("(?)");
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::TextUnformatted("All terms of a line must match:");
    if (ImGui::BeginTable("##terms", 2)) {
        for (const QueryTerm& term : queryTerms()) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::PushFont(context.fonts.mono);
            ImGui::TextUnformatted(term.form.data(), term.form.data() + term.form.size());
            ImGui::PopFont();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(term.meaning.data(), term.meaning.data() + term.meaning.size());
        }
        ImGui::EndTable();
    }
    ImGui::EndTooltip();
}

}  // namespace se::view
