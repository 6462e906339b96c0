// The strip below the view: transport, the cells of the pivot, figures; below them the lanes of the
// run, and the decisions of the stage.
#include <algorithm>
#include <utility>
#include <vector>

#include "document/alert_actions.h"
#include "document/ui_state.h"
#include "panel_state/side_panels.h"
#include "session/session.h"
#include "strips.h"

namespace se::view {

namespace {

constexpr float kMargin = 0.75F;
constexpr float kFold = 1.4F;
constexpr float kNotes = 2.2F;

/// The most important first.
std::vector<std::string> figuresOf(const PanelContext& context) {
    const Session& session = context.session();
    const DecisionState& picture = session.picture();
    const std::string triangles =
        withS(picture.finishedTriangles + picture.newTriangles.size(), "triangle");
    const AlertSearch& alerts = session.alerts().search();
    if (!alerts.done()) return {triangles};
    const std::size_t places = alerts.places().size();
    if (places > 0) return {triangles, withS(places, "fault")};
    return {triangles, alerts.sound() ? "sound" : "no faults"};
}

/// Counts of the run, right of the cells; the tooltip has those of the points.
void drawFigures(const PanelContext& context, const Rect& area) {
    if (area.size.x <= 0.0F || !context.session().ready()) return;
    const float em = context.em;
    std::string text;
    for (const std::string& each : figuresOf(context))
        text += (text.empty() ? "" : " \xC2\xB7 ") + each;
    const float room = area.size.x - (kMargin + kFold + kNotes + 0.8F) * em;
    text = fitted(text, room);
    const float width = textWidth(text);
    ImGui::SetCursorScreenPos({area.min.x + room - width, area.min.y + 0.5F * (area.size.y - em)});
    ImGui::TextDisabled("%s", text.c_str());
    const StatusCounts& counts = context.counts;
    nameItem(context, "figures",
             "UNUSED " + grouped(counts.unused) + ", USED " + grouped(counts.used) + ", DONE " +
                 grouped(counts.done));
}

/// Bookmarks and notes, in a menu above the strip.
void drawNotesMenu(const PanelContext& context, const Rect& area) {
    const float em = context.em;
    ImGui::SetCursorScreenPos({area.max().x - (kMargin + kFold + kNotes) * em,
                               area.min.y + 0.5F * (area.size.y - ImGui::GetFrameHeight())});
    // On a phone the menu has it.
    const bool phone = context.rects.phone;
    const bool clicked =
        !phone && iconButton("##notesButton", Icon::Bookmark, "Bookmarks and your own text",
                             context.session().ready(), false, context);
    if (!phone) nameItem(context, "notes menu");
    const Rect place = phone ? Rect{{area.max().x, area.min.y}, {}} : lastItem();
    if (std::exchange(context.state<Navigation>().opensNotes, false) || clicked)
        ImGui::OpenPopup("##notes");
    ImGui::SetNextWindowPos({place.max().x, place.min.y - 0.3F * em}, ImGuiCond_Always,
                            {1.0F, 1.0F});
    ImGui::SetNextWindowSize({std::min(26.0F * em, context.rects.window.x), 20.0F * em});
    if (!ImGui::BeginPopup("##notes")) return;
    drawNotes(context);
    ImGui::EndPopup();
}

void drawFold(const PanelContext& context, const Rect& area) {
    const float em = context.em;
    const bool folded = context.rects.stripFolded;
    ImGui::SetCursorScreenPos(
        {area.max().x - (kMargin + kFold) * em, area.min.y + 0.5F * (area.size.y - kFold * em)});
    if (ImGui::InvisibleButton("##fold", {kFold * em, kFold * em})) context.run("view.strips");
    nameItem(context, "fold strips",
             std::string(folded ? "Show the lanes of the run, and the decisions of the stage ("
                                : "Fold the strips to this row (") +
                 context.key("view.strips") + ")");
    const bool hovered = ImGui::IsItemHovered();
    drawChevron(context, lastItem(), folded, hovered);
}

}  // namespace

Rect beginStrip(const PanelContext& context, const char* name, const Rect& strip, float height,
                float top) {
    const float margin = kMargin * context.em;
    const Rect bars{{strip.min.x + margin, strip.min.y + top},
                    {std::max(1.0F, strip.size.x - 2.0F * margin), std::max(1.0F, height)}};
    context.where()[std::string("strip ") + name] = bars;
    return bars;
}

void keepSteps(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) return;
    context.state<Navigation>().steps.update(session.overview(), session.generation(),
                                             session.record(), session.cursor());
}

void drawStrip(const PanelContext& context) {
    const PanelRects& rects = context.rects;
    if (rects.strip.size.y <= 0.0F) return;
    if (beginRegion("##strip", rects.strip,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
        const auto isThere = [](const Rect& each) {
            return each.size.x > 0.0F && each.size.y > 0.0F;
        };
        if (isThere(rects.transport)) drawTransport(context, rects.transport);
        if (isThere(rects.pivotStrip)) drawPivotStrip(context, rects.pivotStrip);
        if (isThere(rects.runStrip)) drawRunStrip(context, rects.runStrip);
        if (isThere(rects.stageStrip)) drawStageStrip(context, rects.stageStrip);
        drawFigures(context, rects.figures);
        if (isThere(rects.figures)) drawFold(context, rects.figures);
        if (isThere(rects.figures) || rects.phone)
            drawNotesMenu(context, rects.phone ? rects.strip : rects.figures);
    }
    ImGui::End();
}

}  // namespace se::view
