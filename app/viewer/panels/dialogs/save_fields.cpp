#include "save_fields.h"

#include <utility>

#include "document/mesh_saving.h"
#include "document/ui_state.h"
#include "lesson/lesson_panel.h"
#include "panel_state/export_form.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

namespace {

/// Position of the fields after their names, in em.
constexpr float kFieldColumn = 4.5F;
constexpr float kAddressEms = 9.0F;
constexpr float kSpeedEms = 3.5F;

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
            ImGui::SetCursorPosX(kFieldColumn * context.em);
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

/// The formats of a table, as "mesh PLY" or "export gif" of `where`.
template <typename Form, typename Formats, typename Label, typename Tip>
void drawFormats(const PanelContext& context, Form& form, const Formats& formats, std::string& name,
                 const std::string& where, Label labelOf, Tip tipOf) {
    form.followName(name);
    drawName(context, "Format");
    for (std::size_t i = 0; i < formats.size(); ++i) {
        const std::string label(labelOf(formats[i]));
        if (drawChoice(context, label, form.format == i, where + label,
                       std::string(tipOf(formats[i])), i == 0))
            form.choose(i, name);
    }
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
    const bool possible = keepsColumns(form.chosen());
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

/// The place of the captions of a format.
std::string captionsTip(const ExportFormat& format) {
    if (format.captioned) return "The sentence of each decision, below the view";
    if (format.content == FrameContent::BothThemes) return "The sentence below each drawing";
    return "The sentences, in a text file beside the pictures";
}

void drawRange(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    drawName(context, "From");
    ImGui::SetNextItemWidth(kAddressEms * context.em);
    textField("##from", "9.sphere.1", form.from);
    nameItem(context, "export from", "First frame: 9, 9.sphere.1 or 50%");
    ImGui::SameLine();
    ImGui::TextDisabled("to");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(kAddressEms * context.em);
    textField("##to", "9.emit.4", form.to);
    nameItem(context, "export to", "Last frame; of a pivot, its last decision");
    drawName(context, "Each");
    const std::vector<std::string> units = frameUnitNames();
    for (std::size_t i = 0; i < units.size(); ++i) {
        const auto unit = static_cast<FrameUnit>(i);
        if (drawChoice(context, units[i], form.unit == unit, "export " + units[i],
                       unit == FrameUnit::Event ? "Seed, split, join or alert" : "", i == 0))
            form.unit = unit;
    }
}

void drawStepNumbers(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    drawName(context, "Steps");
    ImGui::SetNextItemWidth(kAddressEms * context.em);
    textField("##steps", "all", form.steps);
    nameItem(context, "export steps", "Numbers of steps, such as 2,4-6; none: all");
}

void drawFrameOptions(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    const bool lesson = context.state<LessonPanel>().walk.isOpen();
    if (!lesson && form.frames == ExportFrames::Lesson) form.frames = ExportFrames::Picture;
    drawName(context, "Frames");
    const auto offer = [&](ExportFrames frames, const char* label, const char* where) {
        if (drawChoice(context, label, form.frames == frames, where, "",
                       frames == ExportFrames::Picture))
            form.frames = frames;
    };
    offer(ExportFrames::Picture, "This picture", "export picture");
    offer(ExportFrames::Pivot, "This pivot", "export this pivot");
    offer(ExportFrames::Range, "A range", "export range");
    if (lesson) offer(ExportFrames::Lesson, "The lesson", "export lesson");
    if (form.frames == ExportFrames::Range) drawRange(context);
    if (form.frames == ExportFrames::Lesson) drawStepNumbers(context);
}

void drawLookOptions(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    drawName(context, "Size");
    ImGui::SetNextItemWidth(kAddressEms * context.em);
    textField("##size", "1280x800", form.size);
    nameItem(context, "export size", "Width and height in pixels");
    if (form.hasSpeed()) {
        ImGui::SameLine(0.0F, context.em);
        ImGui::SetNextItemWidth(kSpeedEms * context.em);
        textField("##speed", "2", form.perSecond);
        nameItem(context, "export speed", "Frames per second");
        ImGui::SameLine();
        ImGui::TextDisabled("per second");
    }
    if (!form.hasCaptions()) return;
    ImGui::SameLine(0.0F, context.em);
    ImGui::Checkbox("Captions", &form.captions);
    nameItem(context, "export captions", captionsTip(form.chosen()));
}

void drawProgress(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    const std::string text = form.total == 0 ? "opening"
                                             : "frame " + std::to_string(form.made) + " of " +
                                                   std::to_string(form.total);
    const double share =
        form.total == 0 ? 0.0 : static_cast<double>(form.made) / static_cast<double>(form.total);
    if (progressAndStop(context, share, text.c_str(), "export cancel", 5.5F)) form.working = false;
}

}  // namespace

bool saveDialogWaits(const PanelContext& context) {
    const BrowserTask task = context.ui().browser;
    return (task == BrowserTask::SaveMesh && context.state<MeshForm>().waits()) ||
           (task == BrowserTask::Export && context.state<ExportForm>().working);
}

void drawMeshFields(const PanelContext& context, std::string& name, const std::string& path) {
    MeshForm& form = context.state<MeshForm>();
    if (!form.complaint.empty()) wrappedText("! " + form.complaint, context.palette.rejected);
    if (form.saving) return drawWork(context);
    if (!form.question.empty()) return drawReplaceQuestion(context);
    drawFormats(
        context, form, meshFormats(), name, "mesh ",
        [](const MeshFormat& each) { return each.name; }, leftOutText);
    ImGui::SetCursorPosX(kFieldColumn * context.em);
    dimText(leftOutText(form.chosen()));
    drawPoints(context);
    drawFields(context);
    drawSize(context);
    drawCopy(context, path);
    ImGui::Separator();
}

void drawExportFields(const PanelContext& context, std::string& name) {
    ExportForm& form = context.state<ExportForm>();
    if (!form.complaint.empty()) wrappedText("! " + form.complaint, context.palette.rejected);
    if (form.working) return drawProgress(context);
    drawFormats(
        context, form, exportFormats(), name, "export ",
        [](const ExportFormat& each) { return each.extension.substr(1); },
        [](const ExportFormat& each) { return each.title; });
    drawFrameOptions(context);
    drawLookOptions(context);
    ImGui::Separator();
}

}  // namespace se::view
