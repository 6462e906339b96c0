// The Breakpoints panel: breakpoints, watches, and the line that adds one.
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "document/actions.h"
#include "document/ask_actions.h"
#include "jobs/kept_pass.h"
#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/run/breakpoint.h"

namespace se::view {

namespace {

/// In em: a small button, and the minimum width of a line beside the rest of its row.
constexpr float kButton = 1.7F;
constexpr float kLeastLine = 9.5F;

/// "3 / 17": hits up to the cursor, and in all.
std::string countText(const Session& session, const Breakpoint& breakpoint) {
    const LineHits* known = session.hits().of(breakpoint.line);
    if (!breakpoint.on) return "off";
    if (known == nullptr) return "";
    return grouped(known->list.upTo(session.place())) + " / " +
           (known->complete ? "" : "\xE2\x89\xA5") + grouped(known->list.total);
}

/// Non-default options: name, condition, log only.
std::string summaryOf(const Breakpoint& breakpoint) {
    std::string text = breakpoint.name;
    const auto add = [&](const std::string& more) { text += (text.empty() ? "" : ", ") + more; };
    if (breakpoint.every > 1) add("1 hit in " + std::to_string(breakpoint.every));
    if (breakpoint.skip > 0) add("after " + std::to_string(breakpoint.skip));
    if (breakpoint.logOnly) add("log only");
    return text;
}

void numberField(const PanelContext& context, const char* label, std::uint32_t& number,
                 std::uint32_t least) {
    ImGui::SetNextItemWidth(6.0F * context.em);
    const std::uint32_t one = 1;
    ImGui::InputScalar(label, ImGuiDataType_U32, &number, &one);
    number = std::max(number, least);
}

/// Name, hit count and log-only, in a popup. True if the breakpoint is to be removed.
bool drawOptions(const PanelContext& context, Breakpoint& breakpoint, const std::string& name) {
    if (textButton(context, "...", name + " options", "Name, hit count, log only",
                   kButton * context.em))
        ImGui::OpenPopup("##options");
    if (!ImGui::BeginPopup("##options")) return false;
    ImGui::SetNextItemWidth(14.0F * context.em);
    textField("name", "optional name", breakpoint.name);
    numberField(context, "hits to skip first", breakpoint.skip, 0);
    numberField(context, "then stop at every Nth hit", breakpoint.every, 1);
    ImGui::Checkbox("log only: list the hits, do not stop", &breakpoint.logOnly);
    ImGui::TextDisabled("Hits count from the start of the run, in both directions.");
    const bool gone = textButton(context, "Remove this breakpoint", name + " away");
    if (gone) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return gone;
}

/// Parts that fit into the row of a breakpoint, the same for all.
struct RowFit {
    float count = 0.0F;  ///< Width of the hits; 0: they are below.
    bool cross = false;  ///< A button of its own removes one; otherwise the menu "..." does.
};

RowFit rowFit(const PanelContext& context) {
    const float gap = 2.0F * ImGui::GetStyle().CellPadding.x;
    const float em = context.em;
    const float button = kButton * em + gap;
    // Constant, so that the row does not move while hits are counted.
    float count = textWidth("88 / 88");
    for (const Breakpoint& each : context.state<BreakpointsPanel>().all)
        count = std::max(count, textWidth(countText(context.session(), each)));
    const float room =
        ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - gap - button - kLeastLine * em;
    if (room >= count + gap + button) return {count, true};
    if (room >= count + gap) return {count, false};
    return {0.0F, room >= button};
}

/// Hits, name, condition, log only: non-default options, and parts that do not fit above.
void drawBelow(const PanelContext& context, const Breakpoint& breakpoint, const RowFit& fit) {
    std::string text = fit.count > 0.0F ? "" : countText(context.session(), breakpoint);
    const std::string summary = summaryOf(breakpoint);
    if (!summary.empty()) text += (text.empty() ? "" : "   ") + summary;
    if (text.empty()) return;
    // Closer to its own line than to the next one.
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - 0.6F * ImGui::GetStyle().ItemSpacing.y);
    ImGui::PushFont(context.fonts.small);
    ImGui::TextDisabled("%s", fittedName(text, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopFont();
    tooltip(text);
}

/// One breakpoint. True if it is to be removed.
bool drawRow(const PanelContext& context, Breakpoint& breakpoint, std::size_t number,
             const RowFit& fit) {
    const std::string name = "breakpoint " + std::to_string(number);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::Checkbox("##on", &breakpoint.on);
    nameItem(context, name + " on", "On or off");
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0F);
    queryField(context, "##line", "stage=sphere refused", breakpoint.line);
    nameItem(context, name);
    drawBelow(context, breakpoint, fit);
    if (const std::string complaint = queryComplaint(context, breakpoint.line); !complaint.empty())
        wrappedText(complaint, context.palette.rejected);
    if (fit.count > 0.0F) {
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        textAtRight(countText(context.session(), breakpoint), context.palette.text);
        tooltip("Hits up to the cursor, and in all");
    }
    ImGui::TableNextColumn();
    bool gone = drawOptions(context, breakpoint, name);
    if (fit.cross) {
        ImGui::TableNextColumn();
        gone = ImGui::Button("x", {kButton * context.em, 0.0F}) || gone;
        tooltip("Remove this breakpoint");
    }
    return gone;
}

void drawRows(const PanelContext& context, std::vector<Breakpoint>& all) {
    const RowFit fit = rowFit(context);
    const int columns = 3 + (fit.count > 0.0F ? 1 : 0) + (fit.cross ? 1 : 0);
    if (all.empty() || !ImGui::BeginTable("##breakpoints", columns)) return;
    ImGui::TableSetupColumn("on", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFrameHeight());
    ImGui::TableSetupColumn("line", ImGuiTableColumnFlags_WidthStretch);
    if (fit.count > 0.0F)
        ImGui::TableSetupColumn("hits", ImGuiTableColumnFlags_WidthFixed, fit.count);
    ImGui::TableSetupColumn("options", ImGuiTableColumnFlags_WidthFixed, kButton * context.em);
    if (fit.cross)
        ImGui::TableSetupColumn("away", ImGuiTableColumnFlags_WidthFixed, kButton * context.em);
    drawRemovable(all, [&](Breakpoint& breakpoint, std::size_t i) {
        return drawRow(context, breakpoint, i + 1, fit);
    });
    ImGui::EndTable();
}

void drawPresets(const PanelContext& context) {
    if (!ImGui::BeginPopup("##presets")) return;
    const BreakSubject subject = breakSubject(context.commands);
    for (const BreakPreset& preset : breakPresets()) {
        const auto line = preset.line(subject);
        const std::string title(preset.title);
        const std::string right =
            line ? fitted(*line, 16.0F * context.em) : "needs " + std::string(preset.needs);
        if (ImGui::MenuItem(title.c_str(), right.c_str(), false, line.has_value()))
            addBreakpoint(context.commands, {title, *line});
        nameItem(context, "preset " + title);
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Custom line", "type it")) {
        context.state<BreakpointsPanel>().all.push_back({});
    }
    ImGui::TextDisabled("Points in the view: Ctrl+left drag around them.");
    ImGui::EndPopup();
}

/// The title with the syntax help of a line, and the number of breakpoints.
void drawTitle(const PanelContext& context) {
    ImGui::SameLine();
    queryHelp(context);
    const std::size_t count = context.state<BreakpointsPanel>().all.size();
    if (count > 0) dimAtRight(std::to_string(count));
}

void drawButtons(const PanelContext& context) {
    const bool words =
        buttonsWidth({"Add...", "Here", "< Back", "Next >"}) <= ImGui::GetContentRegionAvail().x;
    if (textButton(context, "Add...", "add breakpoint")) ImGui::OpenPopup("##presets");
    drawPresets(context);
    ImGui::SameLine();
    if (textButton(context, "Here", "breakpoint here",
                   "Break on the selection, otherwise on this kind of decision (" +
                       context.key("run.break") + ")"))
        context.run("run.break");
    ImGui::SameLine();
    if (ImGui::Button(words ? "< Back" : "<")) context.run("run.continue.back");
    tooltip("Previous breakpoint (" + context.key("run.continue.back") + ")");
    ImGui::SameLine();
    if (ImGui::Button(words ? "Next >" : ">")) context.run("run.continue");
    tooltip("Next breakpoint (" + context.key("run.continue") + ")");
}

void drawHitSearch(const PanelContext& context) {
    HitSearch& hits = context.session().hits();
    if (hits.busy()) {
        if (progressAndStop(context, hits.share(), "searching for hits", "stop search", 4.5F))
            hits.cancel();
    } else if (hits.cancelled()) {
        if (ImGui::Button("Resume")) hits.resume();
        ImGui::SameLine();
        ImGui::TextDisabled("The search was stopped.");
    }
}

// ---- the log --------------------------------------------------------------------------------

/// Width in em below which the sentence is placed under its address.
constexpr float kWide = 26.0F;
constexpr float kAddress = 10.0F;
constexpr std::size_t kLongestText = 200;

/// A hit of a log-only breakpoint.
struct LogRow {
    Hit hit;
    const Breakpoint* breakpoint;
    const std::string* sentence;  ///< Null beyond the first kMaxLogged.
};

std::vector<LogRow> logRows(const PanelContext& context) {
    std::vector<LogRow> rows;
    for (const Breakpoint& each : context.state<BreakpointsPanel>().all) {
        const LineHits* known = context.session().hits().of(each.line);
        if (!each.on || !each.logOnly || known == nullptr) continue;
        for (std::size_t i = 0; i < known->list.hits.size() && rows.size() < kMaxLogged; ++i) {
            if (!selectsHit(each, i + 1)) continue;
            const bool hasSentence = i < known->sentences.size();
            rows.push_back(
                {known->list.hits[i], &each, hasSentence ? &known->sentences[i] : nullptr});
        }
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [](const LogRow& a, const LogRow& b) { return a.hit.place < b.hit.place; });
    return rows;
}

bool isWide(const PanelContext& context) {
    return ImGui::GetContentRegionAvail().x >= kWide * context.em;
}

float rowHeight(const PanelContext& context) {
    const float line = ImGui::GetTextLineHeight();
    return isWide(context) ? line : line + context.fonts.small->FontSize;
}

/// Address and sentence, beside or below each other; hits after the cursor are dim.
void drawLogRow(const PanelContext& context, const LogRow& row) {
    const RunPosition here = context.session().place();
    const Palette& palette = context.palette;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const bool wide = isWide(context);
    if (ImGui::Selectable("##hit", here == row.hit.place, 0, {0.0F, rowHeight(context)}))
        jumpingMoves(context.commands).goTo(row.hit.address);
    const std::string& what = row.sentence != nullptr ? *row.sentence : row.breakpoint->line;
    tooltip(what);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const std::string address = toString(row.hit.address);
    list->AddText(context.fonts.mono, context.fonts.mono->FontSize, at,
                  toU32(here < row.hit.place ? palette.textDim : palette.text), address.c_str());
    const float left = (wide ? kAddress : 1.0F) * context.em;
    ImFont* font = wide ? context.fonts.text : context.fonts.small;
    ImGui::PushFont(font);
    const std::string sentence = fitted(what.substr(0, kLongestText), room - left);
    ImGui::PopFont();
    const float y = wide ? at.y : at.y + ImGui::GetTextLineHeight();
    list->AddText(font, font->FontSize, {at.x + left, y}, toU32(palette.textDim), sentence.c_str());
}

/// The hits of log-only breakpoints, as a list of links; nothing if no breakpoint is log-only.
void drawBreakLog(const PanelContext& context) {
    const auto& all = context.state<BreakpointsPanel>().all;
    if (std::none_of(all.begin(), all.end(),
                     [](const Breakpoint& each) { return each.on && each.logOnly; }))
        return;
    const std::vector<LogRow> rows = logRows(context);
    ImGui::Spacing();
    heading(context, "Log", grouped(rows.size()));
    if (ImGui::BeginChild("##log", {0.0F, 12.0F * context.em})) {
        bool first = true;
        drawSeen(rows.size(), rowHeight(context) + ImGui::GetStyle().ItemSpacing.y,
                 [&](std::size_t i) {
                     ImGui::PushID(static_cast<int>(i));
                     drawLogRow(context, rows[i]);
                     if (std::exchange(first, false)) nameItem(context, "log row");
                     ImGui::PopID();
                 });
    }
    ImGui::EndChild();
}

}  // namespace

void drawBreakpoints(const PanelContext& context) {
    std::vector<Breakpoint>& all = context.state<BreakpointsPanel>().all;
    drawTitle(context);
    drawButtons(context);
    drawHitSearch(context);
    if (all.empty()) {
        dimText("The run stops where a breakpoint matches: " + context.key("run.continue") +
                " continues, " + context.key("run.continue.back") + " goes back. " +
                context.key("run.break") +
                " sets or removes one on the selection, otherwise on this kind of "
                "decision. Add... lists all kinds.");
    }
    drawRows(context, all);
    drawBreakLog(context);
}

}  // namespace se::view
