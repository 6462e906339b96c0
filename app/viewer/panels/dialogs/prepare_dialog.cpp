// The dialog that reads the input again with other options of the preparation.
#include "panel_state/ui_requests.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

void drawButtons(const PanelContext& context, PrepareForm& form, bool entered) {
    if (textButton(context, "Prepare again", "prepare ok",
                   "Read the input again with these options, and go to the start") ||
        entered) {
        Result<InputSpec> spec = form.spec(context.session().input().spec());
        form.complaint = spec ? std::string{} : spec.error().message;
        if (spec) {
            context.requests().openSpec = std::move(spec.value());
            form.open = false;
        }
    }
    ImGui::SameLine();
    if (textButton(context, "Cancel (Esc)", "prepare cancel")) form.open = false;
    if (!form.complaint.empty()) wrappedText("! " + form.complaint, context.palette.rejected);
}

}  // namespace

void drawPrepareDialog(const PanelContext& context) {
    PrepareForm& form = context.state<PrepareForm>();
    if (!form.open || !context.session().ready()) return;
    placeDialog(context, {30.0F, 39.3F}, {2.0F, 1.0F});
    if (beginDialog("Prepare", &form.open, ImGuiWindowFlags_NoScrollbar)) {
        const float buttons =
            (form.complaint.empty() ? 1.0F : 2.6F) * ImGui::GetFrameHeightWithSpacing() +
            0.4F * context.em;
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
