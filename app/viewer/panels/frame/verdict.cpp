// The card over the finished mesh: what is wrong with it, and what to do next.
#include <algorithm>
#include <cctype>
#include <span>
#include <vector>

#include "commands/alert_actions.h"
#include "commands/ask_actions.h"
#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/model.h"
#include "run/number_format.h"
#include "session/layout_preset.h"
#include "session/session.h"

namespace se::view {

namespace {

constexpr float kCardWidth = 27.0F;
/// In a view of less than these sizes, in em, the card has the verdict and two actions.
constexpr float kSmallWidth = 34.0F;
constexpr float kSmallHeight = 24.0F;
constexpr float kSmallCardWidth = 17.0F;

bool isSmall(const PanelContext& context) {
    const Rect& view = context.rects.view;
    return view.size.x < kSmallWidth * context.em || view.size.y < kSmallHeight * context.em;
}

/// Classes with a number of their own.
constexpr std::size_t kNamedClasses = 3;

/// "3 holes · 12 intersecting pairs · 40 others", the most severe class first.
std::string classesText(const RunFailureSearch& found) {
    std::vector<std::size_t> classes;
    std::size_t others = faultCount(found.totals);
    for (std::size_t i = 0; i < found.totals.size(); ++i) {
        if (failureClasses()[i].fault && found.totals[i].total > 0) classes.push_back(i);
    }
    std::stable_sort(classes.begin(), classes.end(), [](std::size_t a, std::size_t b) {
        return failureClasses()[a].severity < failureClasses()[b].severity;
    });
    std::string text;
    for (const std::size_t i : std::span(classes).first(std::min(classes.size(), kNamedClasses))) {
        const std::size_t count = found.totals[i].total;
        text += (text.empty() ? "" : " \xC2\xB7 ") + grouped(count) + " " +
                nounFor(failureClasses()[i], count);
        others -= count;
    }
    if (others > 0) text += " \xC2\xB7 " + grouped(others) + (others == 1 ? " other" : " others");
    return text;
}

/// "19 304 triangles · farthest point 0.4 spacings from the mesh".
std::string meshText(const RunFailureSearch& found, const Model& model) {
    std::string text = withS(found.triangles, "triangle");
    const double farthest = found.fidelity.greatestDistance * model.scale / model.spacing;
    if (farthest > 0.0)
        text += " \xC2\xB7 farthest point " + formatted("%.1f", farthest) + " spacings away";
    return text;
}

void drawWhy(const PanelContext& context) {
    if (!textButton(
            context, "Why?", "verdict why",
            "Every decision about the shown fault, in the panel Ledger: " + context.key("ask.why")))
        return;
    if (context.session().alerts().shown() == nullptr) showPlace(context.commands, 0);
    actions::askWhySelected(context.commands);
}

void drawActions(const PanelContext& context, const AlertSearch& alerts) {
    if (!alerts.places().empty()) {
        if (textButton(context, "Worst first", "verdict worst",
                       "Show the places one by one: " + context.key("step.alert.next")))
            showPlace(context.commands, 0);
        ImGui::SameLine();
        if (!isSmall(context)) {
            drawWhy(context);
            ImGui::SameLine();
        }
        if (canFixByRules(context.commands)) {
            if (textButton(context, "Fix", "verdict fix",
                           "Run again with the rules of robust, to the end"))
                fixByRules(context.commands);
            ImGui::SameLine();
        }
        if (isSmall(context)) return ImGui::NewLine();
    }
    if (textButton(context, "Save mesh...", "verdict save", context.key("file.savemesh")))
        context.run("file.savemesh");
    if (isSmall(context)) return;
    ImGui::SameLine();
    if (textButton(context, "Step through", "verdict steps", "Go to the start of the run")) {
        context.state<VerdictCard>().closed = true;
        context.run("run.start");
    }
}

void drawClose(const PanelContext& context) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 1.2F * context.em);
    if (smallButton(context, "\xC3\x97", "verdict close", "Close, until another input is opened"))
        context.state<VerdictCard>().closed = true;
}

void drawFound(const PanelContext& context, const AlertSearch& alerts) {
    const bool faulty = !alerts.places().empty();
    std::string title = verdictText(alerts);
    title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
    ImGui::PushStyleColor(ImGuiCol_Text,
                          toVec4(faulty ? context.palette.rejected : context.palette.used));
    textIn(context.fonts.strong, title);
    ImGui::PopStyleColor();
    drawClose(context);
    if (!isSmall(context)) {
        if (faulty) wrappedText(classesText(*alerts.found()));
        dimText(meshText(*alerts.found(), context.session().model()));
        ImGui::Spacing();
    }
    drawActions(context, alerts);
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
           !context.state<VerdictCard>().closed && !context.ui().coversView() &&
           context.rects.layoutPreset == LayoutPreset::Debug;
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
    ImGui::SetNextWindowBgAlpha(0.94F);
    if (ImGui::Begin("##verdict", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_AlwaysAutoResize)) {
        const AlertSearch& alerts = context.session().alerts().search();
        alerts.done() ? drawFound(context, alerts) : drawSearching(context, alerts);
        const ImVec2 at = ImGui::GetWindowPos();
        const ImVec2 size = ImGui::GetWindowSize();
        context.where()["verdict card"] = {{at.x, at.y}, {size.x, size.y}};
    }
    ImGui::End();
}

}  // namespace se::view
