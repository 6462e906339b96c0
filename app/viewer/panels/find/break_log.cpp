#include "break_log.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "jobs/hit_search.h"
#include "panels/widgets/widgets.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/replay/breakpoint.h"

namespace se::view {

namespace {

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
    for (const Breakpoint& each : context.state<std::vector<Breakpoint>>()) {
        const LineHits* known = context.session().hits().of(each.line);
        if (!each.on || !each.logOnly || known == nullptr) continue;
        for (std::size_t i = 0; i < known->list.hits.size() && rows.size() < kMaxLogged; ++i) {
            if (!selectsHit(each, i + 1)) continue;
            const bool told = i < known->sentences.size();
            rows.push_back({known->list.hits[i], &each, told ? &known->sentences[i] : nullptr});
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
    Session& session = context.session();
    const RunPosition here = session.place();
    const Palette& palette = context.palette;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const bool wide = isWide(context);
    if (ImGui::Selectable("##hit", here == row.hit.place, 0, {0.0F, rowHeight(context)})) {
        context.playback().pause();
        session.moves().goTo(row.hit.address);
    }
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

}  // namespace

void drawBreakLog(const PanelContext& context) {
    const auto& all = context.state<std::vector<Breakpoint>>();
    if (std::none_of(all.begin(), all.end(),
                     [](const Breakpoint& each) { return each.on && each.logOnly; }))
        return;
    const std::vector<LogRow> rows = logRows(context);
    ImGui::Spacing();
    heading(context, "Log", grouped(rows.size()));
    if (ImGui::BeginChild("##log",
                          {0.0F, std::max(8.0F * context.em, ImGui::GetContentRegionAvail().y)})) {
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()),
                      rowHeight(context) + ImGui::GetStyle().ItemSpacing.y);
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                ImGui::PushID(i);
                drawLogRow(context, rows[static_cast<std::size_t>(i)]);
                if (i == clipper.DisplayStart) context.where()["log row"] = lastItem();
                ImGui::PopID();
            }
        }
    }
    ImGui::EndChild();
}

}  // namespace se::view
