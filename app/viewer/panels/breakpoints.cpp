#include <imgui.h>

#include <algorithm>

#include "interface/break_commands.h"
#include "panel.h"
#include "query_field.h"
#include "text_field.h"
#include "widgets.h"

namespace se::view {

namespace {

constexpr std::size_t kLongestText = 120;

void dimText(const std::string& text) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::PopTextWrapPos();
}

/// "3 / 17": hits up to the cursor, and in all.
std::string countText(const Session& session, const Breakpoint& breakpoint) {
    const LineHits* known = session.hits().of(breakpoint.line);
    if (!breakpoint.on) return "off";
    if (known == nullptr) return "";
    return grouped(known->list.upTo(session.place())) + " / " +
           (known->complete ? "" : "\xE2\x89\xA5") + grouped(known->list.total);
}

/// What is not as usual about it: name, condition, log only.
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

/// Name, hit count and log-only, in a popup.
void drawOptions(const PanelContext& context, Breakpoint& breakpoint, float width) {
    if (ImGui::Button("...", {width, 0.0F})) ImGui::OpenPopup("##options");
    tooltip("Name, hit count, log only");
    if (!ImGui::BeginPopup("##options")) return;
    ImGui::SetNextItemWidth(14.0F * context.em);
    textField("name", "a name of your own", breakpoint.name);
    numberField(context, "hits passed over first", breakpoint.skip, 0);
    numberField(context, "then one hit in so many", breakpoint.every, 1);
    ImGui::Checkbox("log only: list the hits, do not stop", &breakpoint.logOnly);
    ImGui::TextDisabled("Hits count from the start of the run, in both directions.");
    ImGui::EndPopup();
}

/// Below the line: hits, what is not as usual, and the buttons. True if it is to go.
bool drawFooter(const PanelContext& context, Breakpoint& breakpoint, const std::string& name) {
    const float em = context.em;
    const float button = 1.7F * em;
    const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    const float buttons = end - 2.0F * button - ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFrameHeight() +
                         ImGui::GetStyle().ItemSpacing.x);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(countText(context.session(), breakpoint).c_str());
    tooltip("Hits up to the cursor, and in all");
    ImGui::SameLine();
    const std::string summary = summaryOf(breakpoint);
    ImGui::TextDisabled("%s", fitted(summary, buttons - ImGui::GetCursorPosX()).c_str());
    tooltip(summary);
    ImGui::SameLine(buttons);
    drawOptions(context, breakpoint, button);
    context.ui().where[name + " options"] = lastItem();
    ImGui::SameLine(end - button);
    const bool gone = ImGui::Button("x", {button, 0.0F});
    tooltip("Take this breakpoint away");
    return gone;
}

/// One breakpoint. True if it is to go.
bool drawRow(const PanelContext& context, Breakpoint& breakpoint, std::size_t number) {
    const std::string name = "breakpoint " + std::to_string(number);
    ImGui::Checkbox("##on", &breakpoint.on);
    context.ui().where[name + " on"] = lastItem();
    tooltip("On or off");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    queryField(context, "##line", "stage=sphere refused", breakpoint.line);
    context.ui().where[name] = lastItem();
    const std::string complaint = queryComplaint(breakpoint.line);
    if (!complaint.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(complaint.c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopStyleColor();
    }
    return drawFooter(context, breakpoint, name);
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
        context.ui().where["preset " + title] = lastItem();
    }
    ImGui::Separator();
    if (ImGui::MenuItem("A line of your own", "type it")) {
        context.ui().breakpoints.push_back({});
    }
    ImGui::TextDisabled("Points in the view: Ctrl and a left drag around them.");
    ImGui::EndPopup();
}

void drawButtons(const PanelContext& context) {
    if (ImGui::Button("Add...")) ImGui::OpenPopup("##presets");
    context.ui().where["add breakpoint"] = lastItem();
    drawPresets(context);
    ImGui::SameLine();
    if (ImGui::Button("Here")) context.run("run.break");
    context.ui().where["breakpoint here"] = lastItem();
    tooltip("What is selected, else this kind of decision (" + context.key("run.break") + ")");
    ImGui::SameLine();
    if (ImGui::Button("< Back")) context.run("run.continue.back");
    tooltip("The breakpoint before (" + context.key("run.continue.back") + ")");
    ImGui::SameLine();
    if (ImGui::Button("Go on >")) context.run("run.continue");
    tooltip("The next breakpoint (" + context.key("run.continue") + ")");
    ImGui::SameLine();
    queryHelp(context);
}

void drawSearch(const PanelContext& context) {
    HitSearch& hits = context.session().hits();
    if (hits.busy()) {
        const float button = 4.5F * context.em;
        ImGui::ProgressBar(static_cast<float>(hits.share()),
                           {ImGui::GetContentRegionAvail().x - button, 0.0F}, "looking for hits");
        ImGui::SameLine();
        if (ImGui::Button("Stop")) hits.cancel();
        context.ui().where["stop search"] = lastItem();
    } else if (hits.cancelled()) {
        if (ImGui::Button("Look on")) hits.resume();
        ImGui::SameLine();
        ImGui::TextDisabled("The search was stopped.");
    }
}

/// A hit of a log-only breakpoint.
struct LogRow {
    Hit hit;
    const Breakpoint* breakpoint;
    const std::string* sentence;  ///< Null beyond the first kMostLogged.
};

std::vector<LogRow> logRows(const PanelContext& context) {
    std::vector<LogRow> rows;
    for (const Breakpoint& each : context.ui().breakpoints) {
        const LineHits* known = context.session().hits().of(each.line);
        if (!each.on || !each.logOnly || known == nullptr) continue;
        for (std::size_t i = 0; i < known->list.hits.size() && rows.size() < kMostLogged; ++i) {
            if (!picks(each, i + 1)) continue;
            const bool told = i < known->sentences.size();
            rows.push_back({known->list.hits[i], &each, told ? &known->sentences[i] : nullptr});
        }
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [](const LogRow& a, const LogRow& b) { return a.hit.place < b.hit.place; });
    return rows;
}

void drawLogRow(const PanelContext& context, const LogRow& row) {
    Session& session = context.session();
    const RunPlace here = session.place();
    const bool ahead = here < row.hit.place;
    const std::string address = toString(row.hit.address);
    ImGui::PushFont(context.fonts.mono);
    if (ahead) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.textDim));
    if (ImGui::Selectable(address.c_str(), here == row.hit.place)) {
        context.playback().pause();
        session.goTo(row.hit.address);
    }
    ImGui::PopFont();
    const std::string& what = row.sentence != nullptr ? *row.sentence : row.breakpoint->line;
    tooltip(what);
    ImGui::SameLine(10.0F * context.em);
    ImGui::TextUnformatted(
        fitted(what.substr(0, kLongestText), ImGui::GetContentRegionAvail().x).c_str());
    if (ahead) ImGui::PopStyleColor();
}

void drawLog(const PanelContext& context) {
    const auto& all = context.ui().breakpoints;
    if (std::none_of(all.begin(), all.end(),
                     [](const Breakpoint& each) { return each.on && each.logOnly; }))
        return;
    const std::vector<LogRow> rows = logRows(context);
    ImGui::Spacing();
    heading(context, "Log", grouped(rows.size()));
    if (ImGui::BeginChild("##log",
                          {0.0F, std::max(8.0F * context.em, ImGui::GetContentRegionAvail().y)})) {
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()));
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                ImGui::PushID(i);
                drawLogRow(context, rows[static_cast<std::size_t>(i)]);
                if (i == clipper.DisplayStart) context.ui().where["log row"] = lastItem();
                ImGui::PopID();
            }
        }
    }
    ImGui::EndChild();
}

}  // namespace

void drawBreakpoints(const PanelContext& context) {
    if (!context.session().ready()) {
        ImGui::TextDisabled("Nothing is open.");
        return;
    }
    std::vector<Breakpoint>& all = context.ui().breakpoints;
    heading(context, "Breakpoints", all.empty() ? "" : std::to_string(all.size()));
    drawButtons(context);
    drawSearch(context);
    if (all.empty()) {
        dimText(context.key("run.break") +
                " sets one on what is selected, or on this kind of "
                "decision, and takes it away again.");
    }
    std::optional<std::size_t> gone;
    for (std::size_t i = 0; i < all.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (drawRow(context, all[i], i + 1)) gone = i;
        ImGui::PopID();
    }
    if (gone) all.erase(all.begin() + static_cast<std::ptrdiff_t>(*gone));
    drawLog(context);
}

}  // namespace se::view
