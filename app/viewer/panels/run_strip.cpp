#include <algorithm>
#include <cmath>

#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

/// Where the bars of a strip are: right of its name.
Rect barsOf(const PanelContext& context, const Rect& area) {
    const float left = 4.4F * context.em;
    const float right = 0.9F * context.em;
    return {{area.min.x + left, area.min.y},
            {std::max(1.0F, area.size.x - left - right), area.size.y}};
}

/// Highest ring over each pixel column, as a filled curve.
void drawRingLengths(const PanelContext& context, const Rect& bars, std::uint32_t last) {
    const RunOverview& run = context.session().overview();
    if (run.longestRing == 0 || last == 0) return;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const auto columns = static_cast<std::size_t>(bars.size.x);
    const std::size_t count = run.ringLength.size();
    const ImU32 ring = toU32(context.palette.used.withAlpha(0.55F));
    const ImU32 stack = toU32(context.palette.text.withAlpha(0.85F));
    for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t from = c * last / columns;
        const std::size_t to = std::max(from + 1, (c + 1) * last / columns);
        std::uint32_t longest = 0;
        std::uint32_t deepest = 0;
        for (std::size_t i = from; i < std::min(to, count); ++i) {
            longest = std::max(longest, run.ringLength[i]);
            deepest = std::max(deepest, run.stackDepth[i]);
        }
        const float x = bars.min.x + static_cast<float>(c);
        const float share = static_cast<float>(longest) / static_cast<float>(run.longestRing);
        list->AddRectFilled({x, bars.max().y - share * bars.size.y}, {x + 1.0F, bars.max().y},
                            ring);
        if (deepest == 0) continue;
        const float depth = static_cast<float>(deepest) / static_cast<float>(run.deepestStack);
        const float y = bars.max().y - depth * 0.45F * bars.size.y;
        list->AddRectFilled({x, y - 1.0F}, {x + 1.0F, y + 1.0F}, stack);
    }
}

void drawMarks(const PanelContext& context, const Rect& bars, std::uint32_t last) {
    const RunOverview& run = context.session().overview();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float em = context.em;
    float seedX = -1.0F;
    for (const RunMark& mark : run.marks) {
        const float x =
            bars.min.x + bars.size.x * static_cast<float>(mark.pivot) / static_cast<float>(last);
        if (mark.kind == MarkKind::Seed && x > seedX + 0.3F * em) {
            seedX = x;
            list->AddRectFilled({x, bars.min.y}, {x + 1.0F, bars.max().y},
                                toU32(context.palette.textDim.withAlpha(0.6F)));
        } else if (mark.kind == MarkKind::Alert) {
            list->AddTriangleFilled({x - 0.3F * em, bars.min.y}, {x + 0.3F * em, bars.min.y},
                                    {x, bars.min.y + 0.5F * em}, toU32(context.palette.rejected));
        }
    }
}

void drawPlayhead(const PanelContext& context, const Rect& bars, std::uint32_t last) {
    const Session& session = context.session();
    const float share =
        static_cast<float>(session.record().pivot) / static_cast<float>(std::max(1U, last));
    const float x = std::round(bars.min.x + bars.size.x * std::min(1.0F, share));
    const float em = context.em;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 color = toU32(context.palette.pivot);
    list->AddRectFilled({x - 0.06F * em, bars.min.y}, {x + 0.06F * em + 1.0F, bars.max().y}, color);
    list->AddTriangleFilled({x - 0.35F * em, bars.min.y - 0.25F * em},
                            {x + 0.35F * em, bars.min.y - 0.25F * em}, {x, bars.min.y + 0.3F * em},
                            color);
}

void handleDrag(const PanelContext& context, const Rect& bars, std::uint32_t last) {
    ImGui::SetCursorScreenPos(toVec2(bars.min));
    ImGui::InvisibleButton("##run", toVec2(bars.size));
    const float share = std::clamp((ImGui::GetMousePos().x - bars.min.x) / bars.size.x, 0.0F, 1.0F);
    const auto pivot = static_cast<std::uint32_t>(std::lround(share * static_cast<float>(last)));
    Session& session = context.session();
    if (ImGui::IsItemActive() && session.record().pivot != pivot &&
        (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0.0F)) {
        context.playback().pause();
        session.goToPivot(pivot);
    }
    if (!ImGui::IsItemHovered()) return;
    const RunOverview& run = session.overview();
    std::string text = "pivot " + grouped(pivot);
    if (pivot > 0 && pivot <= run.ringLength.size()) {
        text += "\nring " + grouped(run.ringLength[pivot - 1]) + ", stacked " +
                grouped(run.stackDepth[pivot - 1]) + "\ntriangles " +
                grouped(run.triangles[pivot - 1]);
    }
    tooltip(text);
}

}  // namespace

void drawRunStrip(const PanelContext& context, const Rect& area) {
    const Session& session = context.session();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const Rect bars = barsOf(context, area);
    const float line = ImGui::GetTextLineHeight();
    ImGui::PushFont(context.fonts.strong);
    list->AddText({area.min.x + 0.7F * context.em, bars.min.y}, toU32(context.palette.textDim),
                  "RUN");
    ImGui::PopFont();
    list->AddRectFilled(toVec2(bars.min), toVec2(bars.max()), toU32(context.palette.background),
                        0.2F * context.em);
    if (!session.ready()) return;
    const std::uint32_t last = std::max({1U, session.overview().lastPivot, session.record().pivot});
    drawRingLengths(context, bars, last);
    drawMarks(context, bars, last);
    drawPlayhead(context, bars, last);
    handleDrag(context, bars, last);
    const std::string total = (session.overview().complete ? "" : "\xE2\x89\xA5") + grouped(last);
    if (area.size.y > 2.0F * line) {
        list->AddText({area.min.x + 0.7F * context.em, bars.max().y - line},
                      toU32(context.palette.textDim), total.c_str());
    }
}

void drawDrawer(const PanelContext& context) {
    if (beginRegion("##drawer", context.layout.drawer)) {
        const Rect& whole = context.layout.drawer;
        const float em = context.em;
        const float height = context.layout.stageStrip ? 2.9F * em : whole.size.y - 1.3F * em;
        drawRunStrip(context, {{whole.min.x, whole.min.y + 0.65F * em}, {whole.size.x, height}});
        if (context.layout.stageStrip) {
            const float top = whole.min.y + height + 1.1F * em;
            drawStageStrip(context,
                           {{whole.min.x, top}, {whole.size.x, whole.max().y - top - 0.5F * em}});
        }
    }
    ImGui::End();
}

}  // namespace se::view
