// One row of names. They are never cut: in little room they are set smaller and closer, and if that
// does not suffice, a button at the end lists the rest.

#include <algorithm>
#include <string>
#include <vector>

#include "input/tab_order.h"
#include "widgets.h"

namespace se::view {

namespace {

constexpr const char* kMorePopup = "##moreTabs";
/// Margin beside a name in em, wide and close, and distance between tabs.
constexpr float kPadWide = 0.5F;
constexpr float kPadClose = 0.24F;
constexpr float kTabGap = 0.12F;

/// Font and margins of a row.
struct RowStyle {
    ImFont* font;
    float pad;
};

float widthOf(const RowStyle& style, const std::string& title) {
    return style.font->CalcTextSizeA(style.font->FontSize, 1e9F, 0.0F, title.c_str()).x +
           2.0F * style.pad;
}

std::string moreText(std::size_t count) { return std::to_string(count) + " more..."; }

/// Width of the first `count` names and the open one, with the button for the others.
float widthOf(const PanelContext& context, const RowStyle& style, const TabRow& row,
              std::size_t count) {
    float width = 0.0F;
    std::size_t more = 0;
    for (std::size_t i = 0; i < row.names.size(); ++i) {
        const bool shown = i < count || row.names[i].open;
        if (shown) width += widthOf(style, row.names[i].title) + kTabGap * context.em;
        more += shown ? 0 : 1;
    }
    return width + (more > 0 ? widthOf(style, moreText(more)) : -kTabGap * context.em);
}

/// The first style in which all names fit, otherwise the last.
RowStyle styleFor(const PanelContext& context, const TabRow& row, float room) {
    const RowStyle all[] = {{context.fonts.text, kPadWide * context.em},
                            {context.fonts.text, kPadClose * context.em},
                            {context.fonts.small, kPadClose * context.em}};
    const auto fits = [&](const RowStyle& style) {
        return widthOf(context, style, row, row.names.size()) <= room;
    };
    const auto found = std::find_if(std::begin(all), std::end(all), fits);
    return found == std::end(all) ? all[2] : *found;
}

/// A name; true if it was clicked. `lit`: the name of the open tab.
bool drawName(const PanelContext& context, const RowStyle& style, const std::string& title,
              bool lit) {
    const Palette& palette = context.palette;
    ImGui::PushStyleColor(ImGuiCol_Button,
                          toVec4(lit ? palette.panelRaised : palette.panel.withAlpha(0.0F)));
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(lit ? palette.text : palette.textDim));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0F, 0.0F});
    const bool clicked = ImGui::Button(title.c_str(), {widthOf(style, title), 1.5F * context.em});
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    return clicked;
}

/// The names that do not fit, in a list.
std::optional<std::size_t> drawMore(const PanelContext& context, const RowStyle& style,
                                    const TabRow& row, std::size_t count) {
    std::vector<std::size_t> more;
    more.reserve(row.names.size());
    for (std::size_t i = count; i < row.names.size(); ++i) {
        if (!row.names[i].open) more.push_back(i);
    }
    if (more.empty()) return std::nullopt;
    std::optional<std::size_t> chosen;
    ImGui::SameLine();
    if (drawName(context, style, moreText(more.size()), false)) ImGui::OpenPopup(kMorePopup);
    nameItem(context, "more tabs", "Panels that do not fit here");
    ImGui::PushFont(context.fonts.text);
    if (ImGui::BeginPopup(kMorePopup)) {
        for (const std::size_t i : more) {
            if (ImGui::MenuItem(row.names[i].title)) chosen = i;
            nameItem(context, std::string("more ") + row.names[i].title);
        }
        ImGui::EndPopup();
    }
    ImGui::PopFont();
    return chosen;
}

}  // namespace

std::optional<std::size_t> drawTabRow(const PanelContext& context, const TabRow& row) {
    const float room = ImGui::GetContentRegionAvail().x;
    const float forNames = room - row.reserved;
    const RowStyle style = styleFor(context, row, forNames);
    std::size_t count = row.names.size();
    while (count > 0 && widthOf(context, style, row, count) > forNames) --count;
    std::optional<std::size_t> chosen;
    ImGui::PushFont(style.font);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kTabGap * context.em, 0.0F});
    bool first = true;
    for (std::size_t i = 0; i < row.names.size(); ++i) {
        const TabName& name = row.names[i];
        if (i >= count && !name.open) continue;
        if (!std::exchange(first, false)) ImGui::SameLine();
        if (drawName(context, style, name.title, name.open)) chosen = i;
        const Rect place = lastItem();
        context.where()[std::string(name.kind) + " " + name.title] = place;
        if (!name.open) continue;
        ImGui::GetWindowDrawList()->AddRectFilled({place.min.x, place.max().y - 0.12F * context.em},
                                                  toVec2(place.max()),
                                                  toU32(context.palette.accent));
        if (row.stop && context.state<KeyWalk>().offer(*row.stop)) takeKeyboard();
    }
    if (const auto listed = drawMore(context, style, row, count)) chosen = listed;
    ImGui::PopStyleVar();
    ImGui::PopFont();
    const ImVec2 end = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({end.x, end.y}, {end.x + room, end.y},
                                        toU32(context.palette.border));
    ImGui::Dummy({0.0F, 0.1F * context.em});
    return chosen;
}

}  // namespace se::view
