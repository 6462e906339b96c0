// The Charts panel: counts at the cursor, and bars that count decisions of the whole run, each a
// link to its query.
#include <algorithm>

#include "document/ask_actions.h"
#include "jobs/questions.h"
#include "panels/widgets/decision_rows.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

/// Width in em from which the counts are beside the charts, and their share of it.

/// Columns of a chart, in pixels from its left edge.
struct ChartColumns {
    float label = 0.0F;  ///< Width of the labels.
    float count = 0.0F;  ///< Width of the counts.
    std::uint64_t most = 1;
};

ChartColumns columnsOf(const RunChart& chart) {
    ChartColumns columns;
    for (const ChartBar& bar : chart.bars) {
        columns.label = std::max(columns.label, textWidth(bar.label));
        columns.count = std::max(columns.count, textWidth(grouped(bar.count)));
        columns.most = std::max(columns.most, bar.count);
    }
    return columns;
}

/// Label, bar, count; a click queries its decisions.
void drawBar(const PanelContext& context, const RunChart& chart, const ChartBar& bar,
             const ChartColumns& columns) {
    const float em = context.em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetTextLineHeight();
    ImGui::PushID(bar.query.c_str());
    const bool asked = context.session().questions().line() == bar.query;
    const bool chosen = ImGui::Selectable("##bar", asked, 0, {0.0F, height});
    ImGui::PopID();
    if (ImGui::IsItemVisible())
        nameItem(context, "bar " + std::string(chart.name) + " " + bar.label);
    tooltip(grouped(bar.count) + " " + std::string(chart.unit) + "\n" + bar.query);
    if (chosen) askQuery(context.commands, bar.query);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const bool named = !bar.label.empty() && bar.label[0] > '9';
    const float indent = named ? 0.0F : columns.label - textWidth(bar.label);
    list->AddText({at.x + 0.2F * em + indent, at.y}, toU32(context.palette.text),
                  bar.label.c_str());
    const std::string count = grouped(bar.count);
    const float right = at.x + room - 0.2F * em;
    list->AddText({right - textWidth(count), at.y}, toU32(context.palette.textDim), count.c_str());
    const float from = at.x + columns.label + 0.8F * em;
    const float full = std::max(0.0F, right - columns.count - 0.6F * em - from);
    const float share = static_cast<float>(bar.count) / static_cast<float>(columns.most);
    // Any count above zero is visible, however small.
    const float width = bar.count == 0 ? 0.0F : std::max(0.12F * em, share * full);
    list->AddRectFilled({from, at.y + 0.18F * height}, {from + width, at.y + 0.86F * height},
                        toU32(context.palette.accent), 0.1F * em);
}

void drawChart(const PanelContext& context, const RunChart& chart) {
    ImGui::Spacing();
    heading(context, std::string(chart.title).c_str(), std::string(chart.unit));
    if (chart.bars.empty()) return dimText("There are none.");
    const ChartColumns columns = columnsOf(chart);
    ImGui::PushID(chart.name.data());
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.12F * context.em});
    for (const ChartBar& bar : chart.bars) drawBar(context, chart, bar, columns);
    ImGui::PopStyleVar();
    ImGui::PopID();
}

void drawRunCharts(const PanelContext& context) {
    Questions& questions = context.session().questions();
    BackgroundQuery<std::vector<RunChart>>& charts = questions.charts();
    questions.requestCharts();
    if (drawAsking(context, charts)) return;
    const std::vector<RunChart>* answer = charts.answer();
    if (answer == nullptr) {
        dimText(charts.complaint());
        if (ImGui::SmallButton("Retry")) charts.cancel();
        return;
    }
    dimText("Click a bar to list its decisions in the panel Query.");
    for (const RunChart& chart : *answer) drawChart(context, chart);
}

}  // namespace

void drawCharts(const PanelContext& context) {
    drawCounters(context);
    ImGui::Spacing();
    drawRunCharts(context);
}

}  // namespace se::view
