// The part Verdict: the faults of the finished mesh, and the next actions.

#include "document/alert_actions.h"
#include "document/ask_actions.h"
#include "document/ui_state.h"
#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/model.h"
#include "run/strings.h"
#include "session/session.h"
#include "spiraling_edge/base/lists.h"

namespace se::view {

namespace {

/// "19 304 triangles · farthest point 0.4 spacings away".
std::string meshText(const RunFailureSearch& found, const Model& model) {
    std::string text = withS(found.verdict.triangles, "triangle");
    const double farthest = found.verdict.fidelity.greatestDistance * model.scale / model.spacing;
    if (farthest >= 0.05)
        text += " \xC2\xB7 farthest point " + formatted("%.1f", farthest) + " spacings away";
    return text;
}

/// "12", or "≥ 12" if there may be more.
std::string knownText(std::size_t count, bool all) {
    return (all ? "" : "\xE2\x89\xA5 ") + grouped(count);
}

/// Height of the column, in em, from which it has room for the numbers and the list of places; and
/// for the details of a place as well.
constexpr float kRoomForPlaces = 40.0F;
constexpr float kRoomForDetails = 52.0F;

/// True where the numbers are shown: with less room they are folded at first, so that the buttons
/// and the places are in sight together.
bool showsNumbers(const PanelContext& context) {
    const bool details = context.session().alerts().place().has_value();
    const float needed = details ? kRoomForDetails : kRoomForPlaces;
    if (ImGui::GetWindowHeight() >= needed * context.em) return true;
    const bool open = ImGui::TreeNodeEx("Numbers", ImGuiTreeNodeFlags_NoTreePushOnOpen);
    nameItem(context, "verdict fold");
    return open;
}

/// The counts of the open run, and of the best trial if there is one: points amiss, by which
/// settings are compared, a row for each other that is not 0, and distances in spacings.
void drawNumbers(const PanelContext& context, const MeshVerdict& now, const MeshVerdict* then) {
    const Model& model = context.session().model();
    const int columns = then != nullptr ? 3 : 2;
    if (!showsNumbers(context) || !ImGui::BeginTable("##numbers", columns)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    for (int i = 1; i < columns; ++i)
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, 3.6F * context.em);
    const auto row = [&](const std::string& what, const std::string& before,
                         const std::string& after) {
        ImGui::TableNextColumn();
        dimText(what);
        ImGui::TableNextColumn();
        textAtRight(before, context.palette.text);
        if (then == nullptr) return;
        ImGui::TableNextColumn();
        textAtRight(after, context.palette.text);
    };
    const auto both = [&](const std::string& what, const auto& textOf) {
        row(what, textOf(now), then != nullptr ? textOf(*then) : std::string{});
    };
    if (then != nullptr) row("", "now", "then");
    both("places with faults",
         [](const MeshVerdict& of) { return knownText(of.places, of.allPlaces); });
    both("points amiss", [](const MeshVerdict& of) { return grouped(of.amiss); });
    for (const VerdictCount& count : verdictCounts()) {
        if (count.of(now) > 0 || (then != nullptr && count.of(*then) > 0))
            both(std::string(count.plural),
                 [&](const MeshVerdict& of) { return grouped(count.of(of)); });
    }
    for (const FailureClass& kind : failureClasses()) {
        const auto total = [&](const MeshVerdict& of) { return of.totals[rankOf(kind)]; };
        if (!kind.fault || isCounted(kind)) continue;
        if (total(now).total > 0 || (then != nullptr && total(*then).total > 0))
            both(titleOf(kind), [&](const MeshVerdict& of) {
                return knownText(total(of).total, total(of).exact);
            });
    }
    both("mean distance, spacings", [&](const MeshVerdict& of) {
        const double mean = of.fidelity.meanDistance * model.scale / model.spacing;
        return mean == 0.0 ? "0" : mean < 0.001 ? "< 0.001" : formatted("%.3f", mean);
    });
    ImGui::EndTable();
    nameItem(context, "verdict numbers",
             "The mean distance of the points from the mesh is in spacings of the points. An "
             "opening of the scan is an end of its points that a mesh should leave open.");
}

/// The triangles that Fix would change, in the colors that they have in the view.
void drawChange(const PanelContext& context, const MeshChange& change) {
    const auto& [go, come] = wordsOf(change);
    wrappedText(go + ",", context.palette.rejected);
    wrappedText(come, context.palette.used);
    dimText("Point here or at Fix to see them.");
}

/// The other settings that were tried, beside the open run.
void drawBest(const PanelContext& context, const TrialJob& job, const Trial& best) {
    const MeshVerdict& now = job.trials().tried.front().verdict;
    textIn(context.fonts.strong, std::string("Better settings") + (job.busy() ? " so far" : ""));
    wrappedText(wordsOf(best.change));
    ImGui::BeginGroup();
    drawNumbers(context, now, &best.verdict);
    if (job.ended()) drawChange(context, *job.change());
    ImGui::EndGroup();
    context.state<VerdictPart>().pointedAt |= ImGui::IsItemHovered();
}

/// The trials of other settings: what is tried, and the numbers of the open run and of the best.
void drawTrials(const PanelContext& context, const MeshVerdict& now) {
    TrialJob& job = context.session().trials();
    const Trial* best = job.best();
    if (best == nullptr) drawNumbers(context, now, nullptr);
    const bool idle = !job.busy() && !job.ended();
    if (idle && !context.session().input().spec().whatIf.empty()) return;
    ImGui::Spacing();
    if (best != nullptr) drawBest(context, job, *best);
    if (idle) {
        if (textButton(context, "Try other settings", "verdict try",
                       "Rules, neighbors, normals and more: up to 19 more runs, in the background"))
            job.start();
    } else if (job.busy()) {
        const std::string doing =
            context.state<VerdictPart>().fixing ? "Fix: " + job.trying() : job.trying();
        if (progressAndStop(context, job.share(), doing.c_str(), "verdict stop")) job.stop();
    } else if (!job.complaint().empty()) {
        dimText(job.complaint());
    } else if (best == nullptr && !job.trials().tried.empty()) {
        dimText(noneBetterText(job.trials()));
    }
}

/// Loops that stay open, and the width up to which they are to be closed.
void drawOpen(const PanelContext& context, const OpenLoops& loops) {
    static const RuleSetting& limit = *findRuleSetting("holewidth");
    double width = valueOf(context.session().input().rules(), limit);
    const std::string text = openText(loops);
    if (text.empty() && width == 0.0) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Close holes up to");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(5.0F * context.em);
    if (ImGui::InputDouble("##holes", &width, 0.0, 0.0, "%.4g", kEntered) && isValue(limit, width))
        closeHoles(context.commands, width);
    nameItem(context, "verdict close holes",
             "The largest hole to close, openings of the scan too, in the unit of the file; 0: as "
             "the rules say. Enter runs the points again.");
    dimText(text.empty() ? "Nothing is open." : text);
}

void askWhyShown(const PanelContext& context) {
    if (context.session().alerts().shown() == nullptr) showPlace(context.commands, 0);
    actions::askWhySelected(context.commands);
}

/// The next actions of an engineer: Fix and Save mesh; then a look at the places.
void drawActions(const PanelContext& context, const RunAlerts& alerts) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const bool fixes = canFix(context.commands) && !context.state<VerdictPart>().fixing;
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    if (fixes) {
        const bool clicked = accentButton(context, true, "Fix", "verdict fix",
                                          fixText(context.session().trials()), half);
        context.state<VerdictPart>().pointedAt |=
            ImGui::IsItemHovered() && context.session().trials().ended();
        if (clicked) fixByTrials(context.commands);
        ImGui::SameLine();
    }
    if (textButton(context, "Save mesh...", "verdict save", context.key("file.savemesh"), half))
        context.run("file.savemesh");
    if (alerts.places().empty()) return;
    if (textButton(context, "Worst first", "verdict worst",
                   "Show the places one by one: " + context.key("step.alert.next"), half))
        showPlace(context.commands, 0);
    ImGui::SameLine();
    if (textButton(context, "Why?", "verdict why",
                   "Every decision about the shown fault: " + context.key("ask.why"), half))
        askWhyShown(context);
}

/// The record of an input in which points were set aside, or problems found: "1 350 points; set
/// aside: 450 where a missing value was written; 0.02 between points". Empty for others.
std::string inputText(const Model& model, const DoctorJob& doctor) {
    const std::size_t problems =
        countWhere(doctor.findings(), [](const Finding& each) { return each.isProblem(); });
    if (!doctor.done() || (model.aside.empty() && problems == 0)) return {};
    std::string text = withS(model.pointsInPiece, "point");
    const char* before = "; set aside: ";
    for (const AsidePoints& each : model.aside)
        text += std::exchange(before, ", ") + grouped(each.count) + " " + reasonText(each);
    if (const std::string spacing = spacingText(doctor.facts()); !spacing.empty())
        text += "; " + spacing;
    return problems == 0 ? text : text + "; " + withS(problems, "problem") + " of the input";
}

/// A line that leads to the panel with all of that.
void drawInputLine(const PanelContext& context) {
    const Session& session = context.session();
    const std::string lines = withBreaks(inputText(session.model(), session.doctorJob()));
    if (lines.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.textDim));
    if (selectable(context, lines, false, "verdict input", "About the input, in the panel Doctor"))
        context.run("view.doctor");
    ImGui::PopStyleColor();
}

void drawFound(const PanelContext& context, const RunAlerts& alerts) {
    const bool faulty = !alerts.sound();
    const MeshVerdict& verdict = alerts.found()->verdict;
    // The counts are in the table.
    const std::string title = !faulty              ? "The mesh is sound"
                              : verdict.places > 0 ? "Not sound: " + placesText(verdict)
                                                   : verdictText(alerts);
    textIn(context.fonts.strong, title, faulty ? context.palette.rejected : context.palette.used);
    nameItem(context, "verdict title", verdictText(alerts));
    dimText(meshText(*alerts.found(), context.session().model()));
    if (const std::string& by = context.session().model().judged; !by.empty())
        dimText("Judged " + by + ".");
    drawInputLine(context);
    // Above the table, which grows while results arrive: buttons do not move under the pointer.
    drawActions(context, alerts);
    ImGui::Spacing();
    if (faulty) drawTrials(context, verdict);
    drawOpen(context, alerts.openLoops());
}

}  // namespace

void drawVerdict(const PanelContext& context) {
    const Session& session = context.session();
    const RunAlerts& alerts = session.alerts();
    if (alerts.done()) return drawFound(context, alerts);
    if (!alerts.complaint().empty()) return wrappedText(alerts.complaint());
    if (alerts.stopped()) return dimText("The search for faults was stopped.");
    if (!alerts.busy()) return dimText("The mesh is checked once the run is complete.");
    dimText("Checking the mesh");
    ImGui::ProgressBar(static_cast<float>(alerts.share()), {-1.0F, 0.0F});
}

}  // namespace se::view
