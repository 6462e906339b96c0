// The Doctor panel: findings about the input, each with its points and its fixes.
#include <imgui.h>

#include <filesystem>
#include <span>

#include "document/document.h"
#include "document/piece_actions.h"
#include "jobs/doctor_job.h"
#include "paint/shapes.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/screen_painter.h"
#include "run/packed_file.h"
#include "run/strings.h"
#include "scene/framing.h"
#include "session/session.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/base/word_list.h"

namespace se::view {

namespace {

// Points that take no part in the run, by reason: to show them, and to bring them back.

void drawAsideGroup(const PanelContext& context, const AsidePoints& group) {
    const std::string name = nameOf(group);
    ImGui::PushID(name.c_str());
    const float em = context.em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ScreenPainter painter(context);
    drawShape(painter, {at.x + 0.5F * em, at.y + 0.5F * ImGui::GetTextLineHeight()}, 0.7F * em,
              Shape::Plus, painter.ink(&Palette::unused));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.2F * em);
    wrappedText(withS(group.count, "point") + " " + reasonText(group) + ".");
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.2F * em);
    if (smallButton(context, "Show", "show " + name, "Frame these points in the view"))
        showAside(context.commands, group);
    const std::string_view back = returnText(group);
    if (!back.empty()) {
        ImGui::SameLine();
        if (smallButton(context, "Bring back", "return " + name, std::string(back)))
            bringBack(context.commands, group);
    }
    ImGui::PopID();
}

void drawAside(const PanelContext& context) {
    const std::vector<AsidePoints>& groups = context.session().model().aside;
    if (groups.empty()) return;
    textIn(context.fonts.strong, "Not in the run");
    for (const AsidePoints& group : groups) drawAsideGroup(context, group);
    ImGui::Spacing();
    ImGui::Separator();
}

// The findings.

Color severityColor(const PanelContext& context, Severity severity) {
    if (severity == Severity::Error) return context.palette.rejected;
    return severity == Severity::Warning ? context.palette.test : context.palette.textDim;
}

/// Highlights the points of a finding and frames them; a second click clears the highlight.
void show(const PanelContext& context, const Finding& finding, bool shown) {
    Session& session = context.session();
    if (shown) return session.highlights().mark({});
    std::vector<Index> points = pointsToMark(session.model(), finding);
    if (points.empty()) {
        session.highlights().mark({}, finding.lines);
        if (!finding.lines.empty()) return;
        return session.messages().say(finding.points.empty()
                                          ? "This is about the file as a whole."
                                          : "These points have no finite position.");
    }
    frameFault(session.model(), points, context.ui().viewPart(), context.camera());
    session.highlights().mark(std::move(points), finding.lines);
}

/// Number of highlighted points, if not all are.
std::string markedText(const Session& session, const Finding& finding) {
    const std::size_t marked = session.highlights().marked().size();
    if (marked == finding.points.size()) return {};
    return "Marked: " + grouped(marked) + " of " + grouped(finding.points.size()) + " points.";
}

/// File name for sampled points, which are saved first; none for those of an intermediate step.
std::string commandForMade(const std::string& source, const Finding& finding) {
    const Result<SampleSpec> spec = sampleFromSource(source);
    const std::string making = spec ? sampleCommand(spec.value()) : std::string{};
    if (making.empty()) return {};
    const std::string stem = sampleStem(spec.value(), spec.value().count);
    return making + " && " +
           remedyFor(finding, shellPath(stem + ".ply"), shellPath(stem + "-fixed.ply"));
}

/// The command of a fix, ready to be pasted, with absolute paths for any folder.
std::string commandFor(const PanelContext& context, const Finding& finding) {
    namespace fs = std::filesystem;
    const std::string& source = context.session().input().spec().source;
    // One option has one value.
    if (finding.scale && context.session().input().spec().piece.isScaled()) return {};
    // A command would examine all points of the file.
    if (!context.session().input().spec().leftOut.empty()) return {};
    if (isScene(source) || isStandardInput(source)) return remedyFor(finding, shellPath(source));
    if (isSample(source)) return commandForMade(source, finding);
    // There is no file.
    if (isPacked(source)) return {};
    const std::string output = fs::path(source).stem().string() + "-fixed.ply";
    return remedyFor(finding,
                     shellPath(wholePath(source)) +
                         optionsText(context.session().input().spec(), {SpecGroup::Reading}),
                     shellPath(output));
}

/// Requests to open the input again, with these fixes besides those it has.
void follow(const PanelContext& context, const std::vector<std::string>& more) {
    std::vector<std::string> fixes = context.session().input().spec().fixes;
    fixes.insert(fixes.end(), more.begin(), more.end());
    context.document().runWithFixes(std::move(fixes));
}

void drawRemedy(const PanelContext& context, const Finding& finding) {
    if (finding.dropsAll()) return dimText("No fix: dropping these would leave no point.");
    const DoctorCheck& check = *finding.check;
    const std::string name(check.name);
    std::string& asked = context.state<DoctorPanel>().askedCheck;
    const bool asks = finding.dropsMost() && asked == name;
    if (asks)
        wrappedText("This drops " + grouped(finding.toDrop().size()) + " of " +
                    grouped(finding.present) + " points.");
    if (canFix(check) &&
        smallButton(context, asks ? "Apply it anyway" : "Apply the fix", "fix " + name,
                    std::string(fixText(check.fix)) + "\nCtrl+Z undoes it.")) {
        if (asks || !finding.dropsMost()) follow(context, {name});
        asked = asks ? "" : name;
    }
    const std::string command = commandFor(context, finding);
    if (command.empty()) return;
    if (canFix(check)) ImGui::SameLine();
    if (smallButton(context, "Copy the command", "copy " + name,
                    "For a terminal; it writes a new file and leaves yours unchanged.")) {
        ImGui::SetClipboardText(command.c_str());
        context.session().messages().say("Copied the command.");
    }
    wrappedIn(context.fonts.mono, command);
}

/// The fixes that were applied to the input, and a button to undo them.
void drawRepaired(const PanelContext& context) {
    const Session& session = context.session();
    if (session.input().spec().fixes.empty()) return;
    wrappedText("Repaired here, not in the file: " + fixesText(session.model()) + ".");
    if (smallButton(context, "Use the file as is", "doctor as it is",
                    "Open the input without any fixes"))
        context.document().runWithFixes({});
    ImGui::Spacing();
    ImGui::Separator();
}

void drawFixAll(const PanelContext& context) {
    const std::vector<std::string> fixes = safeFixes(context.session().doctorJob().findings());
    if (fixes.empty()) return;
    const std::string text = joined(
        fixes, "\n", [](const std::string& name) { return fixText(findDoctorCheck(name)->fix); });
    if (textButton(context, "Apply all safe fixes", "doctor fix all", text + "\nCtrl+Z undoes it."))
        follow(context, fixes);
}

/// The record of the input, and what its reader noted.
void drawFacts(const PanelContext& context) {
    const InputFacts& facts = context.session().doctorJob().facts();
    const PointFile& file = *context.session().input().file();
    std::vector<std::string> rows{sizeText(facts), piecesText(facts),
                                  averagedText(facts.averagedNormals)};
    if (facts.twins > 0)
        rows.push_back(withS(facts.twins, "point") + " much nearer to another than to the rest");
    if (!file.columns.reason.empty())
        rows.push_back("columns " + file.columns.names + ", " + file.columns.reason);
    if (const auto& at = file.viewpoint)
        rows.push_back(
            formatted("viewpoint %g %g %g, the place of the sensor", at->x, at->y, at->z));
    rows.insert(rows.end(), file.notes.begin(), file.notes.end());
    for (const std::string& row : rows) {
        if (row.empty()) continue;
        dimText(capitalized(row) + ".");
        nameItem(context, "fact " + row);
    }
}

void drawFinding(const PanelContext& context, const Finding& finding) {
    const Session& session = context.session();
    const std::string name(finding.check->name);
    const Highlights& highlights = session.highlights();
    const std::span<const Index> marks = highlights.marked();
    const bool inView = (!marks.empty() && marks.front() != kNone) || !highlights.lines().empty();
    const bool shown = context.state<DoctorPanel>().shownCheck == name && inView;
    ImGui::PushID(name.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(severityColor(context, finding.severity)));
    ImGui::PushFont(context.fonts.strong);
    const std::string title = std::string(severityName(finding.severity)) + "  " + name;
    if (ImGui::Selectable(title.c_str(), shown)) {
        context.state<DoctorPanel>().shownCheck = name;
        show(context, finding, shown);
    }
    ImGui::PopFont();
    ImGui::PopStyleColor();
    nameItem(context, "finding " + name,
             shown                     ? "Clear the marks"
             : !finding.points.empty() ? "Mark these points in the view, and frame them"
             : !finding.lines.empty()  ? "Show it in the view, by lines at some of the points"
                                       : "About the file as a whole");
    wrappedText(capitalized(finding.text) + ".");
    if (shown) {
        const std::string marked = markedText(session, finding);
        if (!marked.empty()) dimText(marked);
    }
    dimText("Section " + std::string(finding.check->section) + ": " +
            std::string(finding.check->upsets));
    if (finding.tried) dimText("Tried: " + finding.tried->text + ".");
    drawRemedy(context, finding);
    ImGui::PopID();
    ImGui::Spacing();
    ImGui::Separator();
}

}  // namespace

void drawDoctor(const PanelContext& context) {
    const Session& session = context.session();
    const DoctorJob& doctorJob = session.doctorJob();
    const std::size_t count = doctorJob.findings().size();
    partNote(count == 0 ? "" : withS(count, "finding"));
    drawAside(context);
    drawRepaired(context);
    if (!doctorJob.complaint().empty()) return dimText(doctorJob.complaint());
    if (!doctorJob.done()) {
        dimText(doctorJob.busy() ? "Examining the input ..."
                                 : "The doctor examines the points once the run is complete.");
        if (doctorJob.busy())
            ImGui::ProgressBar(static_cast<float>(doctorJob.share()), {-1.0F, 0.0F});
        return;
    }
    drawFacts(context);
    if (count == 0)
        return dimText("Nothing found: all " + std::to_string(doctorChecks().size()) +
                       " checks passed.");
    drawFixAll(context);
    dimText("Click a finding to see it in the view.");
    for (const Finding& finding : doctorJob.findings()) drawFinding(context, finding);
}

}  // namespace se::view
