#include <algorithm>

#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

std::string ringName(const RingPath& ring) {
    return ring.active ? "active" : "#" + std::to_string(ring.depth + 1);
}

void drawRow(const PanelContext& context, const RingPath& ring) {
    Session& session = context.session();
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(ring.active ? -1 : static_cast<int>(ring.depth));
    const bool lit = ring.id != kNone && session.highlightedRing() == ring.id;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##ring", lit, ImGuiSelectableFlags_SpanAllColumns) && !ring.active) {
        session.highlightRing(ring.id);
    }
    const float y = at.y + 0.5F * ImGui::GetTextLineHeight();
    const ImU32 color = toU32(lit ? context.palette.pivot : context.palette.used);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float em = context.em;
    if (ring.active) {
        list->AddLine({at.x, y}, {at.x + 1.6F * em, y}, color, 0.2F * em);
    } else {
        for (int i = 0; i < 3; ++i) {
            const float x = at.x + static_cast<float>(i) * 0.6F * em;
            list->AddLine({x, y}, {x + 0.4F * em, y}, color, 0.12F * em);
        }
    }
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(ringName(ring).c_str());
    ImGui::TableNextColumn();
    const std::string count = grouped(ring.points.size()) + " points";
    ImGui::TextUnformatted(count.c_str());
    const auto open = std::count(ring.open.begin(), ring.open.end(), true);
    if (open > 0) {
        ImGui::SameLine();
        ImGui::TextDisabled("%ld open", static_cast<long>(open));
    }
    ImGui::PopID();
}

}  // namespace

void drawRings(const PanelContext& context) {
    const Session& session = context.session();
    const std::size_t count = session.ready() ? session.picture().rings.size() : 0;
    heading(context, "Rings", count > 1 ? std::to_string(count - 1) + " stacked" : std::string{});
    if (count == 0) {
        ImGui::TextDisabled("No ring.");
        return;
    }
    if (!ImGui::BeginTable("##rings", 3,
                           ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    ImGui::TableSetupColumn("mark", ImGuiTableColumnFlags_WidthFixed, 2.0F * context.em);
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 3.2F * context.em);
    ImGui::TableSetupColumn("length", ImGuiTableColumnFlags_WidthStretch);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawRow(context, session.picture().rings[static_cast<std::size_t>(i)]);
        }
    }
    ImGui::EndTable();
}

}  // namespace se::view
