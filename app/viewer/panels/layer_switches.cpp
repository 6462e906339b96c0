#include "panel.h"
#include "widgets.h"

namespace se::view {

void drawLayerSwitches(const PanelContext& context) {
    LayerSwitches& on = context.ui().settings.layers;
    heading(context, "Layers");
    for (const Layer& layer : layers()) {
        const auto bit = static_cast<std::size_t>(layer.id);
        bool value = on.test(bit);
        if (ImGui::Checkbox(std::string(layer.title).c_str(), &value)) on.set(bit, value);
        const Command* command = findCommand("layer." + std::string(layer.name));
        if (command == nullptr) continue;
        const std::string key = firstKey(*command);
        ImGui::SameLine(ImGui::GetContentRegionMax().x - context.em);
        ImGui::TextDisabled("%s", key.c_str());
    }
    ImGui::Spacing();
    ImGui::Checkbox("Legend", &context.ui().settings.legend);
    bool light = context.ui().settings.theme == Theme::Light;
    if (ImGui::Checkbox("Light theme", &light)) context.run("view.theme");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - context.em);
    ImGui::TextDisabled("T");
}

}  // namespace se::view
