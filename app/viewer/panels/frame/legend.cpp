#include <array>

#include "layout/corner.h"
#include "panels/widgets/widgets.h"
#include "scene/draw_list.h"
#include "screen_projection.h"
#include "view_parts.h"

namespace se::view {

namespace {

struct Entry {
    Shape shape;
    Color Palette::*color;
    const char* text;
};

constexpr std::array kEntries = {
    Entry{Shape::RingedDisc, &Palette::pivot, "pivot p"},
    Entry{Shape::Forward, &Palette::first, "start S"},
    Entry{Shape::Back, &Palette::last, "end E"},
    Entry{Shape::RingedDisc, &Palette::test, "under test, new"},
    Entry{Shape::Disc, &Palette::used, "USED, kept"},
    Entry{Shape::Cross, &Palette::rejected, "rejected"},
    Entry{Shape::Circle, &Palette::unused, "UNUSED"},
    Entry{Shape::Dot, &Palette::done, "DONE"},
};

/// The axes have the fourth corner.
constexpr std::array kLegendCorners = {Corner::TopRight, Corner::TopLeft, Corner::BottomRight};

}  // namespace

std::optional<Rect> drawLegend(const PanelContext& context, std::span<const Rect> taken) {
    const Rect& view = context.rects.view;
    const float em = 0.84F * context.em;
    const float row = 1.32F * em;
    const glm::vec2 size(9.6F * em, row * static_cast<float>(kEntries.size()) + 0.7F * em);
    // Omitted where it would cover too much of the picture; F1 shows it as well.
    if (view.size.y < size.y + 8.0F * em || view.size.x < 3.6F * size.x) return std::nullopt;
    const std::vector<LabelMark> marks = ScreenProjection(context).neighborhood();
    const std::optional<Rect> place =
        freeCorner({view, 0.7F * em, taken, marks}, size, kLegendCorners);
    if (!place) return std::nullopt;
    const glm::vec2 at = place->min;
    context.where()["legend"] = *place;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(toVec2(at), toVec2(at + size),
                        toU32(context.palette.panel.withAlpha(0.94F)), 0.3F * em);
    float y = at.y + 0.35F * em;
    ImGui::PushFont(context.fonts.small);
    for (const Entry& entry : kEntries) {
        const float dot = entry.shape == Shape::Dot ? 0.34F * em : 0.72F * em;
        drawShape(list, {at.x + 0.95F * em, y + 0.5F * row}, dot, entry.shape,
                  toU32(context.palette.*entry.color));
        list->AddText({at.x + 1.9F * em, y + 0.5F * (row - ImGui::GetTextLineHeight())},
                      toU32(context.palette.text), entry.text);
        y += row;
    }
    ImGui::PopFont();
    return place;
}

}  // namespace se::view
