#include "mesh_fields.h"

#include <utility>

#include "document/mesh_saving.h"
#include "document/ui_state.h"
#include "panel_state/file_browser_state.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

namespace {

/// Position of the fields after their names, in em.
constexpr float kFieldColumn = 4.5F;

void drawName(const PanelContext& context, const char* name) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(kFieldColumn * context.em);
}

/// A choice, beside the previous one if there is room. True if it was chosen.
bool drawChoice(const PanelContext& context, const std::string& label, bool on,
                const std::string& where, const std::string& tip, bool first) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width =
        ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize(label.c_str()).x;
    if (!first) {
        ImGui::SameLine(0.0F, context.em);
        if (ImGui::GetContentRegionAvail().x < width) {
            ImGui::NewLine();
            ImGui::SameLine(kFieldColumn * context.em);
        }
    }
    const bool chosen = ImGui::RadioButton(label.c_str(), on);
    nameItem(context, where, tip);
    return chosen;
}

std::string leftOutText(const MeshFormat& format) {
    return std::string(format.title) + ". " +
           (format.leavesOut.empty() ? "Keeps everything."
                                     : "Leaves out: " + std::string(format.leavesOut) + ".");
}

void drawFormats(const PanelContext& context, std::string& name) {
    MeshForm& form = context.state<MeshForm>();
    form.followName(name);
    drawName(context, "Format");
    for (std::size_t i = 0; i < meshFormats().size(); ++i) {
        const MeshFormat& format = meshFormats()[i];
        const std::string label(format.name);
        if (drawChoice(context, label, form.format == i, "mesh " + label, leftOutText(format),
                       i == 0))
            form.choose(i, name);
    }
    ImGui::SetCursorPosX(kFieldColumn * context.em);
    dimText(leftOutText(meshFormats()[form.format]));
}

void drawPoints(const PanelContext& context) {
    MeshForm& form = context.state<MeshForm>();
    drawName(context, "Points");
    if (drawChoice(context, "All, in the order of the input", !form.usedOnly, "mesh all points",
                   "Also points in no triangle", true))
        form.usedOnly = false;
    if (drawChoice(context, "Used points only", form.usedOnly, "mesh used points",
                   "Without points in no triangle (--used-points)", false))
        form.usedOnly = true;
}

/// Columns of faults, for formats that hold columns.
void drawFields(const PanelContext& context) {
    MeshForm& form = context.state<MeshForm>();
    const bool possible = keepsColumns(meshFormats()[form.format]);
    drawName(context, "Fields");
    ImGui::BeginDisabled(!possible);
    bool on = form.faultFields && possible;
    if (ImGui::Checkbox("Faults and distances of points", &on)) form.faultFields = on;
    nameItem(context, "mesh fault fields",
             possible
                 ? "Scalar fields se_fault and se_distance, as CloudCompare shows them "
                   "(--fault-fields)"
                 : "Only in " + listText(meshFormats(), &MeshFormat::name, "and", keepsColumns));
    ImGui::EndDisabled();
}

/// Size of the mesh, and the state of the run.
void drawSize(const PanelContext& context) {
    const MeshForm& form = context.state<MeshForm>();
    if (!form.size) {
        ImGui::ProgressBar(static_cast<float>(form.share), {-1.0F, 0.0F}, "running to the end");
        return;
    }
    if (form.size->triangles == 0) {
        return wrappedText("This run makes no triangles: there is no mesh to save.");
    }
    std::string text = sizeText(*form.size, form.usedOnly) + ": the mesh at the end of the run.";
    if (form.size->capped) text += " The run was stopped by the rule cap: the mesh is incomplete.";
    wrappedText(text);
}

void drawCopy(const PanelContext& context, const std::string& path) {
    const MeshForm& form = context.state<MeshForm>();
    if (textButton(context, "Copy command", "mesh copy command",
                   "The command line that writes the same file, for a terminal"))
        context.commands.mesh.copyCommand(path);
    if (form.note.empty()) return;
    ImGui::SameLine();
    dimText(form.note);
}

void drawReplaceQuestion(const PanelContext& context) {
    MeshForm& form = context.state<MeshForm>();
    wrappedText(replaceText(form.question, context.session().input().spec().source));
    const bool replace = textButton(context, "Replace", "mesh replace");
    const bool chosen = ImGui::IsItemFocused();
    ImGui::SameLine();
    const bool keep = textButton(context, "Cancel (Esc)", "mesh keep");
    // The safe answer has the keyboard focus. Space is Dear ImGui's own key for it.
    if (std::exchange(form.justAsked, false)) takeKeyboard();
    const bool enter = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
    if (replace || (enter && chosen)) {
        context.commands.mesh.replace();
    } else if (keep || enter) {
        context.commands.mesh.keep();
    }
}

void drawWork(const PanelContext& context) {
    const MeshForm& form = context.state<MeshForm>();
    const float button = 5.5F * context.em;
    ImGui::ProgressBar(form.writing ? 1.0F : static_cast<float>(form.share),
                       {ImGui::GetContentRegionAvail().x - button, 0.0F},
                       form.writing ? "writing" : "running to the end");
    ImGui::SameLine();
    ImGui::BeginDisabled(form.writing);
    if (textButton(context, "Cancel", "mesh cancel", {}, -1.0F)) context.commands.mesh.cancel();
    ImGui::EndDisabled();
}

}  // namespace

bool meshDialogWaits(const PanelContext& context) {
    return context.ui().browser == BrowserTask::SaveMesh && context.state<MeshForm>().waits();
}

void drawMeshFields(const PanelContext& context, std::string& name, const std::string& path) {
    const MeshForm& form = context.state<MeshForm>();
    if (!form.complaint.empty()) wrappedText("! " + form.complaint, context.palette.rejected);
    if (form.saving) return drawWork(context);
    if (!form.question.empty()) return drawReplaceQuestion(context);
    drawFormats(context, name);
    drawPoints(context);
    drawFields(context);
    drawSize(context);
    drawCopy(context, path);
    ImGui::Separator();
}

}  // namespace se::view
