#include <algorithm>

#include "dial_drawer.h"
#include "panels/widgets/widgets.h"
#include "scene/draw_list.h"

namespace se::view {

namespace {

/// Distance between the rim and a name, in em, and the size of a name.
constexpr float kNameGap = 0.45F;
constexpr float kNameSize = 0.8F;

std::vector<DialName> namesOf(const PanelContext& context, std::span<const RimText> texts) {
    std::vector<DialName> names;
    for (const RimText& each : texts) {
        names.push_back({each.degrees, rimTextSize(context, each.text)});
    }
    return names;
}

}  // namespace

void fillSector(const DialDisc& disc, double from, double to, float reach, const Color& color) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (double a = from; a < to - 1e-6; a += 180.0) {
        const double b = std::min(a + 180.0, to);
        list->PathLineTo(disc.center);
        list->PathArcTo(disc.center, reach * disc.radius, -static_cast<float>(a) * kDialDegree,
                        -static_cast<float>(b) * kDialDegree, 48);
        list->PathFillConvex(toU32(color));
    }
}

glm::vec2 rimTextSize(const PanelContext& context, const std::string& text) {
    const ImVec2 extent =
        context.fonts.text->CalcTextSizeA(kNameSize * context.em, 1e9F, 0.0F, text.c_str());
    return {extent.x, extent.y};
}

DialDisc discWithTexts(const PanelContext& context, const Rect& room,
                       std::span<const RimText> texts) {
    const DialCircle place =
        fitDial(room, namesOf(context, texts), kNameGap * context.em, 0.35F * context.em);
    return {toVec2(place.center), place.radius};
}

void drawRimTexts(const PanelContext& context, const DialDisc& disc, const Rect& room,
                  std::span<const Rect> taken, std::span<const RimText> texts) {
    const float size = kNameSize * context.em;
    const DialCircle place{{disc.center.x, disc.center.y}, disc.radius};
    const NameRoom around{room, taken, kNameGap * context.em, 1.15F * size};
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (const PlacedName& each : placeNames(place, around, namesOf(context, texts))) {
        const RimText& text = texts[each.name];
        if (each.leader) {
            const ImVec2 rim = disc.at(text.degrees, 1.0F);
            list->AddLine(rim, toVec2(nearestIn(each.rect, {rim.x, rim.y})),
                          toU32(text.color.withAlpha(0.7F)), std::max(1.0F, 0.05F * context.em));
        }
        // A stem may run behind it.
        list->AddRectFilled(toVec2(each.rect.min), toVec2(each.rect.max()),
                            toU32(context.palette.panel.withAlpha(0.8F)), 0.15F * context.em);
        list->AddText(context.fonts.text, size, toVec2(each.rect.min), toU32(text.color),
                      text.text.c_str());
    }
}

void drawReciprocalDial(const PanelContext& context, const DialReciprocal& r, const Rect& room) {
    const Palette& colors = context.palette;
    const float em = context.em;
    const std::string title = "e " + std::to_string(r.e);
    const glm::vec2 extent = rimTextSize(context, title);
    const Rect below{room.min + glm::vec2(0.0F, extent.y), room.size - glm::vec2(0.0F, extent.y)};
    const Color& verdict = r.inside ? colors.used : colors.rejected;
    const std::vector<RimText> texts = {{0.0, "efirst", colors.first},
                                        {r.limitDegrees, "elast", colors.last},
                                        {r.pivotDegrees, "p", verdict}};
    // Room is reserved for a name that moves along the rim.
    const glm::vec2 spare(0.0F, 0.8F * extent.y);
    const DialDisc disc =
        discWithTexts(context, {below.min + spare, below.size - 2.0F * spare}, texts);
    if (disc.radius < 0.7F * em) return;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float stroke = std::max(1.0F, 0.08F * em);
    list->AddCircleFilled(disc.center, disc.radius, toU32(colors.background), 48);
    fillSector(disc, 0.0, r.limitDegrees, 1.0F, colors.test.withAlpha(0.25F));
    list->AddCircle(disc.center, disc.radius, toU32(colors.border), 48, stroke);
    list->AddLine(disc.center, disc.at(0.0, 1.0F), toU32(colors.first), stroke);
    list->AddLine(disc.center, disc.at(r.limitDegrees, 1.0F), toU32(colors.last), stroke);
    const ImVec2 at = disc.at(r.pivotDegrees, 0.9F);
    list->AddLine(disc.center, at, toU32(verdict), 1.5F * stroke);
    drawShape(list, at, 0.6F * em, r.inside ? Shape::Disc : Shape::Cross, toU32(verdict));
    drawShape(list, disc.center, 0.6F * em, Shape::RingedDisc, toU32(colors.test));
    drawRimTexts(context, disc, below, {}, texts);
    list->AddText(context.fonts.text, kNameSize * em,
                  {room.min.x + 0.5F * (room.size.x - extent.x), room.min.y}, toU32(colors.textDim),
                  title.c_str());
}

}  // namespace se::view
