#include <algorithm>

#include "panel_state/ui_requests.h"
#include "panels/panel.h"
#include "panels/widgets/prepare_fields.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

void drawButtons(const PanelContext& context, PrepareForm& form, bool entered) {
    if (ImGui::Button("Prepare again") || entered) {
        Result<InputSpec> spec = form.spec(context.session().input().spec());
        form.complaint = spec ? std::string{} : spec.error().message;
        if (spec) {
            context.requests().openSpec = std::move(spec.value());
            form.open = false;
        }
    }
    context.where()["prepare ok"] = lastItem();
    tooltip("Read the input again with these options, and go to the start");
    ImGui::SameLine();
    if (ImGui::Button("Cancel (Esc)")) form.open = false;
    context.where()["prepare cancel"] = lastItem();
    if (form.complaint.empty()) return;
    wrappedText("! " + form.complaint, context.palette.rejected);
}

}  // namespace

void drawPrepareDialog(const PanelContext& context) {
    PrepareForm& form = context.state<PrepareForm>();
    if (!form.open || !context.session().ready()) return;
    const float em = context.em;
    const glm::vec2 screen(context.rects.status.size.x, context.rects.status.max().y);
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(
        {std::min(30.0F * em, screen.x - 2.0F * em), std::min(39.3F * em, screen.y - 1.0F * em)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown = ImGui::Begin(
        "Prepare", &form.open,
        ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    if (shown) {
        const float buttons =
            (form.complaint.empty() ? 1.0F : 2.6F) * ImGui::GetFrameHeightWithSpacing() + 0.4F * em;
        bool entered = false;
        // The buttons stay visible in a low window.
        // Keyboard navigation treats them and the fields as one.
        if (ImGui::BeginChild("##fields", {0.0F, -buttons}, false, ImGuiWindowFlags_NavFlattened)) {
            entered = drawPrepareFields(context, form, "prepare ");
        }
        ImGui::EndChild();
        drawButtons(context, form, entered);
    }
    ImGui::End();
}

}  // namespace se::view
