#include <imgui.h>

#include <algorithm>

#include "break_log.h"
#include "commands/break_commands.h"
#include "panels/panel.h"
#include "panels/widgets/text_field.h"
#include "panels/widgets/widgets.h"
#include "query_field.h"
#include "session/session.h"
#include "spiraling_edge/replay/breakpoint.h"

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
    if (ImGui::Button("...", {kButton * context.em, 0.0F})) ImGui::OpenPopup("##options");
    context.where()[name + " options"] = lastItem();
    tooltip("Name, hit count, log only");
    if (!ImGui::BeginPopup("##options")) return false;
    ImGui::SetNextItemWidth(14.0F * context.em);
    textField("name", "optional name", breakpoint.name);
    numberField(context, "hits to skip first", breakpoint.skip, 0);
    numberField(context, "then stop at every Nth hit", breakpoint.every, 1);
    ImGui::Checkbox("log only: list the hits, do not stop", &breakpoint.logOnly);
    ImGui::TextDisabled("Hits count from the start of the run, in both directions.");
    const bool gone = ImGui::Button("Remove this breakpoint");
    context.where()[name + " away"] = lastItem();
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
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float em = context.em;
    const float button = kButton * em + gap;
    // Constant, so that the row does not move while hits are counted.
    float count = ImGui::CalcTextSize("88 / 88").x;
    for (const Breakpoint& each : context.state<std::vector<Breakpoint>>()) {
        const std::string text = countText(context.session(), each);
        count = std::max(count, ImGui::CalcTextSize(text.c_str()).x);
    }
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
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFrameHeight() +
                         ImGui::GetStyle().ItemSpacing.x);
    ImGui::PushFont(context.fonts.small);
    ImGui::TextDisabled("%s", fitted(text, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopFont();
    tooltip(text);
}

void drawComplaint(const PanelContext& context, const std::string& line) {
    const std::string complaint = queryComplaint(context, line);
    if (complaint.empty()) return;
    wrappedText(complaint, context.palette.rejected);
}

/// One breakpoint. True if it is to be removed.
bool drawRow(const PanelContext& context, Breakpoint& breakpoint, std::size_t number,
             const RowFit& fit) {
    const std::string name = "breakpoint " + std::to_string(number);
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float button = kButton * context.em + gap;
    ImGui::Checkbox("##on", &breakpoint.on);
    context.where()[name + " on"] = lastItem();
    tooltip("On or off");
    ImGui::SameLine();
    const float count = fit.count > 0.0F ? fit.count + gap : 0.0F;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - count - button -
                            (fit.cross ? button : 0.0F));
    queryField(context, "##line", "stage=sphere refused", breakpoint.line);
    context.where()[name] = lastItem();
    ImGui::SameLine();
    const float afterHits = ImGui::GetCursorPosX() + count;
    if (fit.count > 0.0F) {
        const std::string hits = countText(context.session(), breakpoint);
        ImGui::SetCursorPosX(afterHits - gap - ImGui::CalcTextSize(hits.c_str()).x);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(hits.c_str());
        tooltip("Hits up to the cursor, and in all");
        ImGui::SameLine(afterHits);
    }
    bool gone = drawOptions(context, breakpoint, name);
    if (fit.cross) {
        ImGui::SameLine();
        gone = ImGui::Button("x", {kButton * context.em, 0.0F}) || gone;
        tooltip("Remove this breakpoint");
    }
    drawBelow(context, breakpoint, fit);
    drawComplaint(context, breakpoint.line);
    return gone;
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
        context.where()["preset " + title] = lastItem();
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Custom line", "type it")) {
        context.state<std::vector<Breakpoint>>().push_back({});
    }
    ImGui::TextDisabled("Points in the view: Ctrl+left drag around them.");
    ImGui::EndPopup();
}

/// The title with the syntax help of a line, and the number of breakpoints.
void drawTitle(const PanelContext& context) {
    heading(context, "Breakpoints", "");
    ImGui::SameLine();
    queryHelp(context);
    const std::size_t count = context.state<std::vector<Breakpoint>>().size();
    if (count == 0) return;
    const std::string text = std::to_string(count);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextDisabled("%s", text.c_str());
}

/// Whether the buttons fit side by side, all with words.
bool buttonsFit() {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = 3.0F * style.ItemSpacing.x;
    for (const char* each : {"Add...", "Here", "< Back", "Next >"})
        width += ImGui::CalcTextSize(each).x + 2.0F * style.FramePadding.x;
    return width <= ImGui::GetContentRegionAvail().x;
}

void drawButtons(const PanelContext& context) {
    const bool words = buttonsFit();
    if (ImGui::Button("Add...")) ImGui::OpenPopup("##presets");
    context.where()["add breakpoint"] = lastItem();
    drawPresets(context);
    ImGui::SameLine();
    if (ImGui::Button("Here")) context.run("run.break");
    context.where()["breakpoint here"] = lastItem();
    tooltip("Break on the selection, otherwise on this kind of decision (" +
            context.key("run.break") + ")");
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
        const float button = 4.5F * context.em;
        ImGui::ProgressBar(static_cast<float>(hits.share()),
                           {ImGui::GetContentRegionAvail().x - button, 0.0F}, "searching for hits");
        ImGui::SameLine();
        if (ImGui::Button("Stop")) hits.cancel();
        context.where()["stop search"] = lastItem();
    } else if (hits.cancelled()) {
        if (ImGui::Button("Resume")) hits.resume();
        ImGui::SameLine();
        ImGui::TextDisabled("The search was stopped.");
    }
}

}  // namespace

void drawBreakpoints(const PanelContext& context) {
    if (!context.session().ready()) {
        ImGui::TextDisabled("Nothing is open.");
        return;
    }
    std::vector<Breakpoint>& all = context.state<std::vector<Breakpoint>>();
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
    const RowFit fit = rowFit(context);
    std::optional<std::size_t> gone;
    for (std::size_t i = 0; i < all.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (drawRow(context, all[i], i + 1, fit)) gone = i;
        ImGui::PopID();
    }
    if (gone) all.erase(all.begin() + static_cast<std::ptrdiff_t>(*gone));
    drawBreakLog(context);
}

}  // namespace se::view
