// The panel that reads the input again with other options of the preparation.
#include "document/document.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

void drawButtons(const PanelContext& context, PrepareForm& form, bool entered) {
    if (textButton(context, "Prepare again", "prepare ok",
                   "Read the input again with these options, and go to the start") ||
        entered) {
        Result<RunSpec> spec = form.spec(context.session().input().spec());
        form.complaint = spec ? std::string{} : spec.error().message;
        if (spec) {
            context.document().openSpec(std::move(spec.value()));
            form.close();
        }
    }
    ImGui::SameLine();
    if (textButton(context, "Reset", "prepare cancel", "Back to the options of the open input"))
        form.close();
    complain(context, form.complaint);
}

}  // namespace

void drawPrepare(const PanelContext& context) {
    PrepareForm& form = context.state<PrepareForm>();
    const Session& session = context.session();
    // Until it is edited, the form shows the options of the open input.
    if (!form.open && form.shown != session.generation()) {
        form.take(session.input().spec(), session.model());
        form.open = false;
        form.shown = session.generation();
    }
    const float buttons =
        (form.complaint.empty() ? 1.0F : 2.6F) * ImGui::GetFrameHeightWithSpacing() +
        0.4F * context.em;
    bool entered = false;
    // The buttons stay visible below the fields. Keyboard navigation treats both as one.
    if (ImGui::BeginChild("##fields", {0.0F, -buttons}, false, ImGuiWindowFlags_NavFlattened)) {
        const PrepareForm before = form;
        entered = drawPrepareFields(context, form, "prepare ");
        form.open = form.open || form != before;
    }
    ImGui::EndChild();
    drawButtons(context, form, entered);
}

}  // namespace se::view
