// The context menu of a point, edge or triangle: queries, what-ifs, breakpoints, watches.
#include <algorithm>

#include "compare/compared_runs.h"
#include "compare/comparison.h"
#include "document/actions.h"
#include "document/alert_actions.h"
#include "document/ask_actions.h"
#include "document/document.h"
#include "panel_state/column.h"
#include "panel_state/side_panels.h"
#include "panel_state/what_if_offers.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

namespace {

/// The edge or triangle of the selection and this point: a way to query one that is not
/// there.
std::optional<Selection> together(const Selection& selected, const Selection& what) {
    if (what.kind != SelectionKind::Point) return std::nullopt;
    const Index p = what.points[0];
    const auto corners = selected.corners();
    if (std::find(corners.begin(), corners.end(), p) != corners.end()) return std::nullopt;
    if (selected.kind == SelectionKind::Point) return Selection::ofEdge(corners[0], p);
    if (selected.kind == SelectionKind::Edge)
        return Selection::ofTriangle({corners[0], corners[1], p});
    return std::nullopt;
}

void drawTogether(const PanelContext& context, const Selection& what) {
    const auto both = together(context.session().selection(), what);
    if (!both) return;
    const std::string title = "Why, or why not: " + selectionText(*both);
    if (ImGui::MenuItem(title.c_str())) askWhy(context.commands, *both);
    nameItem(context, "menu together");
}

/// What-ifs for a point: the run forks.
void drawWhatIfs(const PanelContext& context, Index point) {
    Session& session = context.session();
    ImGui::Separator();
    ImGui::TextDisabled("What if ...");
    const RunSpec rules = session.input().rules();
    const auto offers = offersAbout(session, point);
    for (std::size_t i = 0; i < offers.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::MenuItem(offers[i].label.c_str())) {
            context.document().rerun(withWhatIf(rules, offers[i].what));
        }
        ImGui::PopID();
        nameItem(context, "menu what if " + std::to_string(i + 1), describe(offers[i].what));
    }
    if (ImGui::MenuItem("Move it, or edit its list...")) {
        session.select(point);
        context.run("view.whatif");
    }
}

void drawWhyEntry(const PanelContext& context, const char* label, const Selection& what) {
    if (ImGui::MenuItem(label, context.key("ask.why").c_str())) askWhy(context.commands, what);
    nameItem(context, "menu why");
}

void drawSelectEntries(const PanelContext& context, const Selection& what) {
    Session& session = context.session();
    if (ImGui::MenuItem("Select", nullptr, session.selection() == what)) session.select(what);
    if (ImGui::MenuItem("Frame", context.key("view.frame").c_str())) {
        session.select(what);
        context.ui().frame = FrameRequest::Focus;
    }
}

/// Entry about a fault, only where there is one.
void drawWrongEntry(const PanelContext& context, const Selection& what) {
    const auto alert = alertAt(context.session().alerts(), what);
    if (!alert) return;
    if (ImGui::MenuItem("What is wrong here?")) {
        showAlert(context.commands, *alert, std::nullopt);
        actions::showPart(context.commands, kAlertsPart);
    }
    nameItem(context, "menu wrong", "The fault, when it was created, and what would prevent it");
}

void drawEntries(const PanelContext& context, const Selection& what) {
    Session& session = context.session();
    drawWrongEntry(context, what);
    drawWhyEntry(context, "Why? Why not?", what);
    drawTogether(context, what);
    ImGui::Separator();
    drawSelectEntries(context, what);
    if (ImGui::MenuItem("Breakpoint", context.key("run.break").c_str())) {
        session.select(what);
        context.run("run.break");
    }
    nameItem(context, "menu break");
    if (what.kind == SelectionKind::Point) {
        if (ImGui::MenuItem("Go to its next decision")) {
            session.select(what);
            jumpingMoves(context.commands).goToPoint(what.points[0]);
        }
        drawWhatIfs(context, what.points[0]);
    } else if (ImGui::MenuItem("Go to where it was made")) {
        session.select(what);
        context.run("step.birth");
    }
}

/// Menu of a thing in the view of the other run: its queries and actions.
void drawBeside(const PanelContext& context, const Selection& what) {
    const Comparison* now = context.state<ComparePage>().now;
    if (what.kind == SelectionKind::None || now == nullptr || now->other() == nullptr) {
        ImGui::TextDisabled("B is a finished mesh: it has no decisions.");
        return nameItem(context, "menu beside");
    }
    ImGui::TextDisabled("B: %s", selectionText(what).c_str());
    drawWhyEntry(context, "Why? Why not? In both runs", what);
    ImGui::Separator();
    drawSelectEntries(context, what);
    ImGui::Separator();
    ImGui::TextDisabled("Breakpoints and what-ifs are those of A.");
    if (ImGui::MenuItem("Make B the run A (Swap)")) {
        context.session().select(what);
        context.commands.compare.swap();
    }
    nameItem(context, "menu swap");
}

void drawMenu(const PanelContext& context, const SubjectMenu& menu) {
    if (menu.other) return drawBeside(context, menu.what);
    ImGui::TextDisabled("%s",
                        menu.ring ? nameOf(*menu.ring).c_str() : selectionText(menu.what).c_str());
    if (!menu.ring) return drawEntries(context, menu.what);
    if (ImGui::MenuItem("Why? What made it?")) askWhy(context.commands, *menu.ring);
    nameItem(context, "menu why");
}

}  // namespace

void drawSubjectMenu(const PanelContext& context) {
    SubjectMenu& menu = context.state<SubjectMenu>();
    if (!context.session().ready()) return;
    if (std::exchange(menu.wanted, false)) ImGui::OpenPopup("##subjectMenu");
    if (!ImGui::BeginPopup("##subjectMenu")) return;
    drawMenu(context, menu);
    ImGui::EndPopup();
}

}  // namespace se::view
