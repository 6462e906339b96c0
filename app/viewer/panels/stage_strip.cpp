#include <algorithm>
#include <cmath>

#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

/// A run of events of the same stage.
struct StageRun {
    Stage stage;
    std::size_t begin;
    std::size_t end;
};

std::vector<StageRun> stageRuns(const std::vector<Event>& events) {
    std::vector<StageRun> runs;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Stage stage = events[i].address.stage;
        if (runs.empty() || runs.back().stage != stage) runs.push_back({stage, i, i});
        runs.back().end = i + 1;
    }
    return runs;
}

/// Every cell is as wide as any other, but a stage is at least as wide as half its name.
std::vector<float> widthsOf(const std::vector<StageRun>& runs, float total, float gap) {
    std::vector<float> widths;
    float sum = 0.0F;
    for (const StageRun& run : runs) {
        const float name = ImGui::CalcTextSize(std::string(stageName(run.stage)).c_str()).x + gap;
        const float cells = static_cast<float>(run.end - run.begin) * 1.35F * ImGui::GetFontSize();
        widths.push_back(std::max(name, cells));
        sum += widths.back();
    }
    const float room = total - gap * static_cast<float>(runs.size());
    const float factor = std::min(1.0F, room / sum);
    for (float& width : widths) width *= factor;
    return widths;
}

void drawCell(const PanelContext& context, const Rect& cell, std::size_t index) {
    Session& session = context.session();
    const Event& event = session.record().events[index];
    ImDrawList* list = ImGui::GetWindowDrawList();
    const bool here = index == session.cursor();
    const bool later = index > session.cursor();
    Color color = verdictColor(context, event);
    if (!verdictOf(event)) color = context.palette.textDim;
    if (event.address.stage == Stage::Emit) color = context.palette.test;
    const float inset = cell.size.x > 4.0F ? 1.0F : 0.0F;
    const ImVec2 low(cell.min.x + inset, cell.min.y);
    const ImVec2 high(cell.max().x - inset, cell.max().y);
    list->AddRectFilled(low, high, toU32(color.withAlpha(later ? 0.30F : 0.85F)),
                        0.15F * context.em);
    if (rejects(event) && cell.size.x > 0.7F * context.em) {
        // Rejected is also a shape.
        const ImVec2 center(0.5F * (low.x + high.x), 0.5F * (low.y + high.y));
        drawShape(list, center, 0.5F * context.em, Shape::Cross,
                  toU32(context.palette.background.withAlpha(later ? 0.6F : 1.0F)));
    }
    if (here) {
        const float stroke = std::max(1.5F, 0.14F * context.em);
        list->AddRect({low.x - 1.0F, low.y - 2.0F}, {high.x + 1.0F, high.y + 2.0F},
                      toU32(context.palette.pivot), 0.2F * context.em, 0, stroke);
    }
    ImGui::SetCursorScreenPos(toVec2(cell.min));
    ImGui::PushID(static_cast<int>(index));
    if (ImGui::InvisibleButton("##cell", {std::max(1.0F, cell.size.x), cell.size.y})) {
        context.playback().pause();
        session.goToEvent(index);
    }
    tooltip(toString(event.address) + "\n" + describe(event));
    ImGui::PopID();
}

}  // namespace

void drawStageStrip(const PanelContext& context, const Rect& area) {
    const Session& session = context.session();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float em = context.em;
    const float line = ImGui::GetTextLineHeight();
    ImGui::PushFont(context.fonts.strong);
    list->AddText({area.min.x + 0.7F * em, area.min.y + line + 0.15F * em},
                  toU32(context.palette.textDim), "PIVOT");
    ImGui::PopFont();
    if (!session.ready() || session.record().events.empty()) return;
    const std::vector<StageRun> runs = stageRuns(session.record().events);
    const float gap = 0.45F * em;
    const float left = area.min.x + 4.4F * em;
    const std::vector<float> widths = widthsOf(runs, area.max().x - 0.9F * em - left, gap);
    float x = left;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const StageRun& run = runs[i];
        const std::string name(stageName(run.stage));
        const bool here = session.cursor() >= run.begin && session.cursor() < run.end;
        list->AddText({x, area.min.y}, toU32(here ? context.palette.text : context.palette.textDim),
                      fitted(name, widths[i] + 0.4F * gap).c_str());
        const float cell = widths[i] / static_cast<float>(run.end - run.begin);
        for (std::size_t e = run.begin; e < run.end; ++e) {
            const float from = x + cell * static_cast<float>(e - run.begin);
            drawCell(context, {{from, area.min.y + line + 0.2F * em}, {cell, 0.95F * em}}, e);
        }
        x += widths[i] + gap;
    }
}

}  // namespace se::view
