// The Layers panel: a row per layer, with a pin that holds it on or off.
#include <array>

#include "layers/layer.h"
#include "panel_state/settings.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

/// A pin: upright and filled if the layer is pinned, a ring if the stage decides.
void drawPin(const PanelContext& context, ImVec2 center, LayerMode mode) {
    const float em = context.em;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float width = std::max(1.0F, 0.1F * em);
    if (mode == LayerMode::Automatic) {
        list->AddCircle(center, 0.26F * em, toU32(context.palette.textDim.withAlpha(0.6F)), 0,
                        width);
        return;
    }
    const ImU32 color = toU32(context.palette.accent);
    list->AddCircleFilled({center.x, center.y - 0.16F * em}, 0.28F * em, color);
    list->AddLine({center.x, center.y}, {center.x, center.y + 0.5F * em}, color, width);
}

/// By LayerMode.
constexpr std::array<const char*, 3> kPinTexts = {
    "Automatic: the stage decides.\nClick to pin it as it is now.",
    "Pinned: shown in every stage.\nClick to unpin.",
    "Pinned: hidden in every stage.\nClick to unpin."};
static_assert(static_cast<std::size_t>(LayerMode::PinnedOff) + 1 == kPinTexts.size());

/// The content of the layer is not from the input.
bool isDerived(const Session& session, LayerId layer) {
    if (!session.ready()) return false;
    const PrepareReport& report = session.model().report;
    if (layer == LayerId::Normals) return report.derived.normals || report.derived.orientation;
    if (layer == LayerId::Links) return report.neighborsComputed;
    return layer == LayerId::Walls && report.derived.types;
}

void drawSwitch(const PanelContext& context, const Layer& layer, bool shown) {
    const Session& session = context.session();
    LayerModes& modes = context.settings().layers;
    LayerMode& mode = modeOf(modes, layer.id);
    ImGui::PushID(static_cast<int>(layer.id));
    const float side = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("##pin", {side, side})) {
        mode = mode != LayerMode::Automatic ? LayerMode::Automatic
               : shown                      ? LayerMode::PinnedOn
                                            : LayerMode::PinnedOff;
    }
    tooltip(kPinTexts[static_cast<std::size_t>(mode)]);
    drawPin(context, {corner.x + 0.5F * side, corner.y + 0.5F * side}, mode);
    ImGui::SameLine(0.0F, 0.2F * context.em);
    const bool rests = mode == LayerMode::Automatic && !shown;
    if (rests) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.textDim));
    bool value = shown;
    std::string title(layer.title);
    if (isDerived(session, layer.id)) title += " (derived)";
    if (ImGui::Checkbox(title.c_str(), &value)) toggleLayer(modes, layer.id, session.stage());
    nameItem(context, "layer " + std::string(layer.name));
    if (rests) ImGui::PopStyleColor();
    if (const Command* command = findCommand("layer." + std::string(layer.name))) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - context.em);
        ImGui::TextDisabled("%s", context.key(*command).c_str());
    }
    ImGui::PopID();
}

}  // namespace

void drawLayerSwitches(const PanelContext& context) {
    LayerModes& modes = context.settings().layers;
    const LayerSwitches shown = shownLayers(modes, context.session().stage());
    heading(context, "Layers", "a pin holds a layer");
    for (const Layer& layer : layers()) {
        drawSwitch(context, layer, shown.test(static_cast<std::size_t>(layer.id)));
    }
    ImGui::Spacing();
    ImGui::BeginDisabled(modes == LayerModes{});
    if (ImGui::Button("Unpin all")) modes = {};
    ImGui::EndDisabled();
    ImGui::Checkbox("Legend", &context.settings().legend);
    bool light = context.settings().theme == Theme::Light;
    if (ImGui::Checkbox("Light theme", &light)) context.run("view.theme");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - context.em);
    ImGui::TextDisabled("T");
}

}  // namespace se::view
