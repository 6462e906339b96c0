#include "export_fields.h"

#include "document/ui_state.h"
#include "lesson/lesson_panel.h"
#include "panel_state/export_form.h"
#include "panels/widgets/widgets.h"

namespace se::view {

namespace {

/// Position of the fields after their names, in em.
constexpr float kExportColumn = 4.5F;
constexpr float kAddressEms = 9.0F;
constexpr float kSpeedEms = 3.5F;

/// The place of the captions of a format.
std::string captionsTip(const ExportFormat& format) {
    if (format.captioned) return "The sentence of each decision, below the view";
    if (format.content == FrameContent::BothThemes) return "The sentence below each drawing";
    return "The sentences, in a text file beside the pictures";
}

void drawFieldName(const PanelContext& context, const char* name) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(kExportColumn * context.em);
}

/// A choice on the line of the one before. True if it was chosen.
bool drawOption(const PanelContext& context, const std::string& label, bool on,
                const std::string& where, const std::string& tip, bool first) {
    if (!first) ImGui::SameLine(0.0F, context.em);
    const bool chosen = ImGui::RadioButton(label.c_str(), on);
    nameItem(context, where, tip);
    return chosen;
}

void drawFormatOptions(const PanelContext& context, std::string& name) {
    ExportForm& form = context.state<ExportForm>();
    form.followName(name);
    drawFieldName(context, "Format");
    for (std::size_t i = 0; i < exportFormats().size(); ++i) {
        const ExportFormat& format = exportFormats()[i];
        const std::string label(format.extension.substr(1));
        if (drawOption(context, label, form.format == i, "export " + label,
                       std::string(format.title), i == 0))
            form.choose(i, name);
    }
}

void drawRange(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    drawFieldName(context, "From");
    ImGui::SetNextItemWidth(kAddressEms * context.em);
    textField("##from", "9.sphere.1", form.from);
    nameItem(context, "export from", "First frame: 9, 9.sphere.1 or 50%");
    ImGui::SameLine();
    ImGui::TextDisabled("to");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(kAddressEms * context.em);
    textField("##to", "9.emit.4", form.to);
    nameItem(context, "export to", "Last frame; of a pivot, its last decision");
    drawFieldName(context, "Each");
    const std::vector<std::string> units = frameUnitNames();
    for (std::size_t i = 0; i < units.size(); ++i) {
        const auto unit = static_cast<FrameUnit>(i);
        if (drawOption(context, units[i], form.unit == unit, "export " + units[i],
                       unit == FrameUnit::Event ? "Seed, split, join or alert" : "", i == 0))
            form.unit = unit;
    }
}

void drawStepNumbers(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    drawFieldName(context, "Steps");
    ImGui::SetNextItemWidth(kAddressEms * context.em);
    textField("##steps", "all", form.steps);
    nameItem(context, "export steps", "Numbers of steps, such as 2,4-6; none: all");
}

void drawFrameOptions(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    const bool lesson = context.state<LessonPanel>().walk.isOpen();
    if (!lesson && form.frames == ExportFrames::Lesson) form.frames = ExportFrames::Picture;
    drawFieldName(context, "Frames");
    const auto offer = [&](ExportFrames frames, const char* label, const char* where) {
        if (drawOption(context, label, form.frames == frames, where, "",
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
    drawFieldName(context, "Size");
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
    nameItem(context, "export captions", captionsTip(exportFormats()[form.format]));
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

bool exportDialogWaits(const PanelContext& context) {
    return context.ui().browser == BrowserTask::Export && context.state<ExportForm>().working;
}

void drawExportFields(const PanelContext& context, std::string& name) {
    const ExportForm& form = context.state<ExportForm>();
    if (!form.complaint.empty()) wrappedText("! " + form.complaint, context.palette.rejected);
    if (form.working) return drawProgress(context);
    drawFormatOptions(context, name);
    drawFrameOptions(context);
    drawLookOptions(context);
    ImGui::Separator();
}

}  // namespace se::view
