// The card over the finished mesh: its faults, and the next actions.
#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "commands/alert_actions.h"
#include "commands/ask_actions.h"
#include "panel_state/side_panels.h"
#include "panel_state/ui_state.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/model.h"
#include "run/number_format.h"
#include "session/layout_preset.h"
#include "session/session.h"

namespace se::view {

namespace {

constexpr float kCardWidth = 27.0F;
/// In a view of less than these sizes, in em, the card has the verdict and the actions alone.
constexpr float kSmallWidth = 34.0F;
constexpr float kSmallHeight = 24.0F;
constexpr float kSmallCardWidth = 17.0F;
constexpr float kCardAlpha = 0.94F;
/// While the pointer is on Fix, whose tooltip has the numbers.
constexpr float kFadedAlpha = 0.15F;

bool isSmall(const PanelContext& context) {
    const Rect& view = context.rects.view;
    return view.size.x < kSmallWidth * context.em || view.size.y < kSmallHeight * context.em;
}

/// "19 304 triangles · farthest point 0.4 spacings away".
std::string meshText(const RunFailureSearch& found, const Model& model) {
    std::string text = withS(found.verdict.triangles, "triangle");
    const double farthest = found.verdict.fidelity.greatestDistance * model.scale / model.spacing;
    if (farthest > 0.0)
        text += " \xC2\xB7 farthest point " + formatted("%.1f", farthest) + " spacings away";
    return text;
}

/// The counts in which the open run and the best trial differ, one row each, and distances in
/// spacings.
void drawNumbers(const PanelContext& context, const MeshVerdict& now, const MeshVerdict& then) {
    const Model& model = context.session().model();
    if (!ImGui::BeginTable("##numbers", 3,
                           ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX))
        return;
    const auto row = [&](const std::string& what, const std::string& before,
                         const std::string& after) {
        for (const std::string& cell : {what, before, after}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(cell.c_str());
        }
    };
    const auto spacings = [&](double length) {
        return formatted("%.2g", length * model.scale / model.spacing);
    };
    row("", "now", "then");
    row("places with faults", grouped(now.places), grouped(then.places));
    for (const VerdictCount& count : verdictCounts()) {
        if (count.of(now) > 0 || count.of(then) > 0)
            row(std::string(count.plural), grouped(count.of(now)), grouped(count.of(then)));
    }
    row("mean distance", spacings(now.fidelity.meanDistance), spacings(then.fidelity.meanDistance));
    ImGui::EndTable();
    nameItem(context, "verdict numbers",
             "Places with faults, and whatever else is worse or better; the mean distance of the "
             "points from the mesh is in spacings");
}

/// The triangles that Fix would change, in the colors that they have in the view.
void drawChange(const PanelContext& context, const MeshChange& change) {
    const auto& [go, come] = wordsOf(change);
    wrappedText(go + ",", context.palette.rejected);
    ImGui::SameLine();
    wrappedText(come, context.palette.used);
    dimText("Point here or at Fix to see them.");
}

/// The trials of other settings: what is tried, and the numbers of the open run and of the best.
void drawTrials(const PanelContext& context) {
    TrialJob& job = context.session().trials();
    const bool idle = !job.busy() && !job.ended();
    if (idle && !context.session().input().spec().whatIf.empty()) return;
    ImGui::Spacing();
    if (idle) {
        if (smallButton(
                context, "Try other settings", "verdict try",
                "Rules, neighbors, normals and more: up to 19 more runs, in the background"))
            job.start();
        return;
    }
    const std::vector<Trial>& tried = job.trials().tried;
    if (const Trial* best = job.best()) {
        // In some count it can be worse: the table shows which.
        const bool better = worseIn(best->verdict, tried.front().verdict) == nullptr;
        const std::string when =
            std::string(better ? "Better" : "Fewer places") + (job.busy() ? " so far: " : ": ");
        wrappedText(when + wordsOf(best->change) + ". Then: " + headlineOf(best->verdict) + ".");
        ImGui::BeginGroup();
        // Dense, so that the card fits into a view of moderate height.
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ImGui::GetStyle().CellPadding.x, 0.0F});
        drawNumbers(context, tried.front().verdict, best->verdict);
        ImGui::PopStyleVar();
        if (job.ended()) drawChange(context, *job.change());
        ImGui::EndGroup();
        context.state<VerdictCard>().pointedAt |= ImGui::IsItemHovered();
    }
    if (job.busy()) {
        const std::string doing =
            context.state<VerdictCard>().fixing ? "Fix: " + job.trying() : job.trying();
        if (progressAndStop(context, job.share(), doing.c_str(), "verdict stop")) job.stop();
    } else if (!job.complaint().empty()) {
        dimText(job.complaint());
    } else if (job.best() == nullptr && !tried.empty()) {
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
    ImGui::SameLine();
    dimText(text.empty() ? "nothing is open" : text);
}

struct CardAction {
    const char* label;
    const char* name;
    std::string tip;
    void (*run)(const PanelContext& context);
};

void askWhyShown(const PanelContext& context) {
    if (context.session().alerts().shown() == nullptr) showPlace(context.commands, 0);
    actions::askWhySelected(context.commands);
}

std::vector<CardAction> actionsOf(const PanelContext& context, const AlertSearch& alerts) {
    std::vector<CardAction> list;
    if (!alerts.places().empty()) {
        list.push_back({"Worst first", "verdict worst",
                        "Show the places one by one: " + context.key("step.alert.next"),
                        [](const PanelContext& c) { showPlace(c.commands, 0); }});
        list.push_back(
            {"Why?", "verdict why",
             "Every decision about the shown fault, in the panel Ledger: " + context.key("ask.why"),
             askWhyShown});
    }
    if (canFix(context.commands) && !context.state<VerdictCard>().fixing) {
        list.push_back({"Fix", "verdict fix", fixText(context.session().trials()),
                        [](const PanelContext& c) { fixByTrials(c.commands); }});
    }
    list.push_back({"Save mesh...", "verdict save", context.key("file.savemesh"),
                    [](const PanelContext& c) { c.run("file.savemesh"); }});
    list.push_back({"Step through", "verdict steps",
                    "Go to the start of the run: " + context.key("run.start"),
                    [](const PanelContext& c) { c.run("run.start"); }});
    return list;
}

/// Buttons side by side, in as many rows as the width needs.
void drawActions(const PanelContext& context, const AlertSearch& alerts) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
    bool first = true;
    for (const CardAction& each : actionsOf(context, alerts)) {
        const float width = textWidth(each.label) + 2.0F * style.FramePadding.x;
        const float end = ImGui::GetItemRectMax().x + style.ItemSpacing.x + width;
        if (!std::exchange(first, false) && end <= right) ImGui::SameLine();
        if (textButton(context, each.label, each.name, each.tip)) each.run(context);
        if (std::string_view(each.label) != "Fix") continue;
        VerdictCard& card = context.state<VerdictCard>();
        card.faded = ImGui::IsItemHovered() && context.session().trials().ended();
        card.pointedAt |= card.faded;
    }
}

void drawClose(const PanelContext& context) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 1.2F * context.em);
    if (smallButton(context, "\xC3\x97", "verdict close",
                    "Close until another input is opened; View, Verdict shows it again"))
        context.state<VerdictCard>().closed = true;
}

void drawFound(const PanelContext& context, const AlertSearch& alerts) {
    const bool faulty = !alerts.sound();
    // The classes are on lines of their own.
    const std::string headline = verdictText(alerts);
    const std::size_t end = std::min(headline.find(": "), headline.size());
    std::string title = headline.substr(0, end);
    title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
    ImGui::PushStyleColor(ImGuiCol_Text,
                          toVec4(faulty ? context.palette.rejected : context.palette.used));
    textIn(context.fonts.strong, title);
    ImGui::PopStyleColor();
    drawClose(context);
    if (!isSmall(context)) {
        if (end < headline.size()) wrappedText(headline.substr(end + 2));
        // The table of the trials has the distances too.
        if (context.session().trials().best() == nullptr)
            dimText(meshText(*alerts.found(), context.session().model()));
        if (const std::string& by = context.session().model().judged; !by.empty())
            dimText("Judged " + by + ".");
        if (faulty) drawTrials(context);
        drawOpen(context, alerts.openLoops());
        ImGui::Spacing();
    }
}

void drawSearching(const PanelContext& context, const AlertSearch& alerts) {
    textIn(context.fonts.strong, "Checking the mesh");
    drawClose(context);
    ImGui::ProgressBar(static_cast<float>(alerts.share()), {-1.0F, 0.0F});
}

bool isShown(const PanelContext& context) {
    const Session& session = context.session();
    return session.ready() && session.input().phase() == SessionPhase::Ready && session.atEnd() &&
           !session.moves().busy() &&
           (session.alerts().search().done() || session.alerts().search().busy()) &&
           !context.state<VerdictCard>().closed && !session.showsEarlierMesh() &&
           !context.ui().coversView() && context.rects.layoutPreset == LayoutPreset::Debug;
}

}  // namespace

void drawVerdict(const PanelContext& context) {
    if (!isShown(context)) return;
    const float em = context.em;
    const Rect& view = context.rects.view;
    const float wanted = (isSmall(context) ? kSmallCardWidth : kCardWidth) * em;
    const float width = std::min(wanted, view.size.x - 1.4F * em);
    if (width < 12.0F * em) return;
    ImGui::SetNextWindowPos({view.min.x + 0.7F * em, view.min.y + 0.7F * em});
    ImGui::SetNextWindowSize({width, 0.0F});
    VerdictCard& card = context.state<VerdictCard>();
    const bool faded = std::exchange(card.faded, false);
    ImGui::SetNextWindowBgAlpha(faded ? kFadedAlpha : kCardAlpha);
    if (ImGui::Begin("##verdict", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_AlwaysAutoResize)) {
        const AlertSearch& alerts = context.session().alerts().search();
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, faded ? kFadedAlpha : 1.0F);
        alerts.done() ? drawFound(context, alerts) : drawSearching(context, alerts);
        ImGui::PopStyleVar();
        if (alerts.done()) drawActions(context, alerts);
        const ImVec2 at = ImGui::GetWindowPos();
        const ImVec2 size = ImGui::GetWindowSize();
        context.where()["verdict card"] = {{at.x, at.y}, {size.x, size.y}};
    }
    ImGui::End();
}

}  // namespace se::view
