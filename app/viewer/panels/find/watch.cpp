// Numbers of the run over its pivots, each as a plot of the whole run. A column of pixels spans the
// least and the largest value of its pivots, so that no peak is lost; columns are computed again
// only if the run, the known values or the width have changed.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "rows/lane_picture.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/run/decision_query.h"

namespace se::view {

namespace {

constexpr float kPlotHeight = 3.2F;

/// The plots as last painted, by expression.
struct WatchPlots {
    std::map<std::string, PaintedPlot> all;
};

/// 12345.0 as "12 345"; a status in words.
std::string valueText(const std::string& expression, double value) {
    if (expression.starts_with("status=")) {
        if (value < 0.0) return "DONE";
        if (value == 0.0) return "UNUSED";
        return "USED, " + grouped(static_cast<std::size_t>(value)) +
               (value == 1.0 ? " place" : " places");
    }
    if (value < 0.0) return "-" + grouped(static_cast<std::size_t>(-value));
    return grouped(static_cast<std::size_t>(value));
}

std::size_t lastPivot(const Session& session) {
    return std::max<std::size_t>({1, session.overview().lastPivot, session.record().pivot});
}

/// The columns from the bottom of the plot, the largest value at its top.
void drawColumns(const PanelContext& context, const Rect& at, const PaintedPlot& plot,
                 std::size_t columns) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const double low = std::min(0.0, plot.low);
    const double range = std::max(1.0, plot.high - low);
    const float width = at.size.x / static_cast<float>(std::max<std::size_t>(1, columns));
    const auto yOf = [&](double value) {
        return at.max().y - static_cast<float>((value - low) / range) * (at.size.y - 2.0F) - 1.0F;
    };
    const ImU32 fill = toU32(context.palette.used.withAlpha(0.30F));
    const ImU32 line = toU32(context.palette.used);
    const float thick = std::max(1.0F, 0.09F * context.em);
    const float zero = yOf(0.0);
    for (std::size_t i = 0; i < plot.columns.size(); ++i) {
        const float x = at.min.x + static_cast<float>(i) * width;
        const float top = yOf(plot.columns[i].high);
        const float bottom = yOf(plot.columns[i].low);
        list->AddRectFilled({x, std::min(bottom, zero)}, {x + width, std::max(bottom, zero)}, fill);
        // Joined to the previous column, so that steps are visible.
        const float before = i > 0 ? yOf(plot.columns[i - 1].low) : bottom;
        list->AddRectFilled({x, std::min(top, before)},
                            {x + width, std::max({bottom, top + thick, std::min(before, bottom)})},
                            line);
    }
}

/// The plot over the whole run with the cursor in it; a click goes to that pivot.
void drawPlot(const PanelContext& context, const std::string& expression, const WatchSeries& series,
              std::size_t number) {
    Session& session = context.session();
    const Rect at{{ImGui::GetCursorScreenPos().x, ImGui::GetCursorScreenPos().y},
                  {ImGui::GetContentRegionAvail().x, kPlotHeight * context.em}};
    const auto columns = static_cast<std::size_t>(std::max(8.0F, std::round(at.size.x)));
    PaintedPlot& plot = context.state<WatchPlots>().all[expression];
    const std::size_t last = lastPivot(session);
    keepPlot(plot, session.generation(), series.values, last, columns);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(toVec2(at.min), toVec2(at.max()), toU32(context.palette.background),
                        0.2F * context.em);
    list->PushClipRect(toVec2(at.min), toVec2(at.max()), true);
    drawColumns(context, at, plot, columns);
    const float share = static_cast<float>(session.record().pivot) / static_cast<float>(last);
    const float x = std::round(at.min.x + share * (at.size.x - 1.0F));
    list->AddRectFilled({x - 0.06F * context.em, at.min.y},
                        {x + std::max(1.0F, 0.06F * context.em), at.max().y},
                        toU32(context.palette.pivot));
    list->PopClipRect();
    const std::string most = valueText(expression, plot.high);
    const float print = 0.78F * context.em;
    const ImVec2 label(at.min.x + 0.3F * context.em, at.min.y + 0.1F * context.em);
    const ImVec2 size = context.fonts.small->CalcTextSizeA(print, 1e9F, 0.0F, most.c_str());
    // Readable over the plot.
    list->AddRectFilled({label.x - 0.1F * context.em, label.y},
                        {label.x + size.x + 0.1F * context.em, label.y + size.y},
                        toU32(context.palette.background.withAlpha(0.8F)), 0.15F * context.em);
    list->AddText(context.fonts.small, print, label, toU32(context.palette.textDim), most.c_str());
    ImGui::InvisibleButton("##plot", toVec2(at.size));
    context.where()["watch plot " + std::to_string(number)] = at;
    const float place = (ImGui::GetIO().MousePos.x - at.min.x) / std::max(1.0F, at.size.x - 1.0F);
    const auto pivot = static_cast<std::size_t>(
        std::llround(std::clamp(place, 0.0F, 1.0F) * static_cast<float>(last)));
    if (ImGui::IsItemActive() && session.record().pivot != pivot)
        context.pausedMoves().goToPivot(static_cast<std::uint32_t>(pivot));
    if (pivot < series.values.size())
        tooltip("pivot " + grouped(pivot) + ": " + valueText(expression, series.values[pivot]));
}

/// One expression. True if it is to be removed.
bool drawRow(const PanelContext& context, std::string& expression, std::size_t number) {
    const Session& session = context.session();
    const float em = context.em;
    const WatchSeries* series = session.watches().of(expression);
    const std::size_t pivot = session.record().pivot;
    std::string value;
    const bool known = missingPointIn(expression, session.model().points.size()).empty();
    if (known && series != nullptr && pivot < series->values.size())
        value = valueText(expression, series->values[pivot]);
    ImGui::PushFont(context.fonts.mono);
    ImGui::SetNextItemWidth(9.0F * em);
    textField("##expression", "ring", expression);
    ImGui::PopFont();
    nameItem(context, "watch " + std::to_string(number));
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const float button = 1.7F * em;
    const float room = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
    ImGui::PushFont(context.fonts.strong);
    ImGui::TextUnformatted(fittedName(value, room).c_str());
    ImGui::PopFont();
    tooltip("At the end of pivot " + grouped(pivot));
    ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - button);
    const bool gone = ImGui::Button("x", {button, 0.0F});
    tooltip("Remove watch");
    const auto parsed = WatchExpression::parse(expression);
    const std::string complaint =
        parsed ? missingPointIn(expression, session.model().points.size()) : parsed.error().message;
    if (!complaint.empty()) {
        wrappedText(complaint, context.palette.rejected);
    } else if (series != nullptr) {
        drawPlot(context, expression, *series, number);
    }
    ImGui::Spacing();
    return gone;
}

void drawWatchTerms(const PanelContext& context) {
    if (!ImGui::BeginPopup("##terms")) return;
    const Session& session = context.session();
    // For `status=N`: the selected point, otherwise the pivot.
    const Index point = session.selected() != kNone ? session.selected() : session.picture().pivot;
    for (const WatchTerm& term : watchTerms()) {
        std::string expression(term.form);
        const bool ofPoint = expression.ends_with("=N");
        if (ofPoint && point != kNone)
            expression = expression.substr(0, expression.size() - 1) + std::to_string(point);
        const std::string meaning(term.meaning.substr(0, term.meaning.find_first_of(":.")));
        if (ImGui::MenuItem(expression.c_str(), meaning.c_str(), false,
                            !ofPoint || point != kNone)) {
            context.state<WatchPanel>().expressions.push_back(expression);
        }
        nameItem(context, "watch term " + std::string(term.form));
    }
    ImGui::EndPopup();
}

/// Progress of the values, and a button to stop it.
void drawScan(const PanelContext& context) {
    WatchScan& scan = context.session().watches();
    if (scan.busy()) {
        ImGui::SameLine();
        if (progressAndStop(context, scan.share(), "scanning the run", "stop watching"))
            scan.cancel();
    } else if (scan.cancelled()) {
        ImGui::SameLine();
        if (textButton(context, "Resume", "watch on")) scan.resume();
        ImGui::SameLine();
        ImGui::TextDisabled("Stopped.");
        tooltip("Values are known up to the point where the scan stopped.");
    }
}

}  // namespace

void drawWatch(const PanelContext& context) {
    const Session& session = context.session();
    std::vector<std::string>& all = context.state<WatchPanel>().expressions;
    partNote(all.empty() ? "" : "at the end of pivot " + grouped(session.record().pivot));
    if (textButton(context, "Add...", "add watch")) ImGui::OpenPopup("##terms");
    drawWatchTerms(context);
    drawScan(context);
    if (all.empty()) {
        dimText(
            "Numbers of the run over its pivots: the length of the ring, the status of a point, "
            "any counter. Click in a plot to go there.");
    }
    drawRemovable(all, [&](std::string& expression, std::size_t i) {
        return drawRow(context, expression, i + 1);
    });
}

}  // namespace se::view
