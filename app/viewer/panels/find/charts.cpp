// The Charts panel: counts at the cursor, and bars that count decisions of the whole run, each a
// link to its query.
#include <algorithm>
#include <string>
#include <variant>

#include "document/ask_actions.h"
#include "jobs/questions.h"
#include "panels/panel.h"
#include "panels/widgets/decision_rows.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

// The counters: size of the run at the cursor, and facts about the input.

namespace {

void count(const PanelContext& context, const char* name, std::size_t value,
           Color Palette::*color = &Palette::text) {
    const Palette& palette = context.palette;
    valueRow(context, name, grouped(value), value == 0 ? palette.textDim : palette.*color);
}

void warn(const PanelContext& context, const char* name, std::size_t value) {
    count(context, name, value, &Palette::rejected);
}

/// Derived values are highlighted among those of the input.
void origin(const PanelContext& context, const char* name, bool derived, const std::string& note) {
    valueRow(context, name, derived ? "derived" + note : "from the input",
             derived ? context.palette.test : context.palette.text);
}

std::string neighborNote(const PanelContext& context) {
    const NeighborOptions& options = context.session().input().spec().neighbors;
    std::string text;
    if (const auto* nearest = std::get_if<KNearest>(&options.reach)) {
        text = ": " + std::to_string(nearest->k) + " nearest";
    } else if (const auto* reach = std::get_if<WithinSpacings>(&options.reach)) {
        text = formatted(": within %.4g spacings", reach->spacings);
    } else {
        text = formatted(": within %.4g", std::get<WithinRadius>(options.reach).radius);
    }
    return text + (options.symmetric ? ", symmetric" : "");
}

std::string normalNote(const DerivedPieces& derived) {
    return derived.normals ? std::string{} : ": " + grouped(derived.turnedNormals) + " flipped";
}

void drawInput(const PanelContext& context) {
    const PrepareReport& report = context.session().model().report;
    ImGui::Spacing();
    heading(context, "Input");
    if (!beginValues("##input", context)) return;
    count(context, "points", context.session().model().points.size());
    const DerivedPieces& derived = report.derived;
    origin(context, "neighbors", report.neighborsComputed, neighborNote(context));
    origin(context, "normals", derived.normals || derived.orientation, normalNote(derived));
    if (derived.types) origin(context, "wall types", derived.types, {});
    if (derived.rim) origin(context, "rims", derived.rim, {});
    if (derived.completedNormals > 0) warn(context, "normals derived", derived.completedNormals);
    if (report.averagedNormals > 0) warn(context, "mean normals", report.averagedNormals);
    for (const AsideWords& each : asideReasons()) {
        const std::size_t aside = report.count(each.reason);
        if (aside > 0) warn(context, std::string(each.name).c_str(), aside);
    }
    if (report.droppedListEntries > 0) count(context, "list cleaned", report.droppedListEntries);
    ImGui::EndTable();
}

void drawCounters(const PanelContext& context) {
    const Session& session = context.session();
    const bool complete = session.picture().complete;
    const RunState& state = complete ? session.record().after : session.record().before;
    const Counters& c = state.counters;
    heading(context, "Run", complete ? "after this pivot" : "before this pivot");
    if (beginValues("##run", context)) {
        count(context, "triangles",
              session.picture().finishedTriangles + session.picture().newTriangles.size());
        count(context, "UNUSED", context.counts.unused);
        count(context, "USED", context.counts.used);
        count(context, "DONE", context.counts.done);
        count(context, "pivots", c.pivots);
        count(context, "passed over", c.skipped);
        count(context, "seeds", c.seeds);
        count(context, "failed seeds", c.failedSeeds);
        count(context, "splits", c.splits);
        count(context, "joins", c.joins);
        count(context, "closed rings", c.closedRings);
        count(context, "freed rings", c.freedRings);
        count(context, "inserted (7)", c.inserted);
        count(context, "discarded", c.discarded);
        count(context, "longest ring", c.maxRingLength);
        count(context, "deepest stack", c.maxStackDepth);
        warn(context, "isolated", c.isolated);
        warn(context, "stranded", c.stranded);
        warn(context, "holes", c.holes);
        warn(context, "lost seeds", c.lostSeeds);
        ImGui::EndTable();
    }
    drawInput(context);
}

/// Label, bar, count; a click queries its decisions. `most`: the count of a bar of full width.
void drawBar(const PanelContext& context, const RunChart& chart, const ChartBar& bar,
             std::uint64_t most) {
    const float em = context.em;
    ImGui::TableNextColumn();
    const bool asked = context.session().questions().line() == bar.query;
    const bool chosen =
        ImGui::Selectable(("##" + bar.query).c_str(), asked, ImGuiSelectableFlags_SpanAllColumns);
    if (ImGui::IsItemVisible())
        nameItem(context, "bar " + std::string(chart.name) + " " + bar.label);
    tooltip(grouped(bar.count) + " " + std::string(chart.unit) + "\n" + bar.query);
    if (chosen) askQuery(context.commands, bar.query);
    ImGui::SameLine(0.0F, 0.0F);
    const bool named = !bar.label.empty() && bar.label[0] > '9';
    named ? ImGui::TextUnformatted(bar.label.c_str())
          : textAtRight(bar.label, context.palette.text);
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    const float share = static_cast<float>(bar.count) / static_cast<float>(most);
    // Any count above zero is visible, however small, and zero is not: a corner that is round has
    // a width.
    const float width = std::max(0.12F * em, share * ImGui::GetContentRegionAvail().x);
    if (bar.count > 0)
        ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 0.18F * height},
                                                  {at.x + width, at.y + 0.86F * height},
                                                  toU32(context.palette.accent), 0.1F * em);
    ImGui::TableNextColumn();
    textAtRight(grouped(bar.count), context.palette.textDim);
}

void drawChart(const PanelContext& context, const RunChart& chart) {
    ImGui::Spacing();
    heading(context, std::string(chart.title).c_str(), std::string(chart.unit));
    if (chart.bars.empty()) return dimText("There are none.");
    // A row is as high as its highlight.
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.3F * context.em, 0.06F * context.em});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.12F * context.em});
    if (!ImGui::BeginTable(chart.name.data(), 3)) return ImGui::PopStyleVar(2);
    float label = 0.0F;
    float count = 0.0F;
    std::uint64_t most = 1;
    for (const ChartBar& bar : chart.bars) {
        label = std::max(label, textWidth(bar.label));
        count = std::max(count, textWidth(grouped(bar.count)));
        most = std::max(most, bar.count);
    }
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthFixed, label);
    ImGui::TableSetupColumn("bar", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("count", ImGuiTableColumnFlags_WidthFixed, count);
    for (const ChartBar& bar : chart.bars) drawBar(context, chart, bar, most);
    ImGui::EndTable();
    ImGui::PopStyleVar(2);
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
