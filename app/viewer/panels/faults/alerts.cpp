// Failures of the finished run by class. The chosen one shows its three moments, the answer of the
// ledger about it, and what prevents it. Rows above and below the details are clipped
// lists of their own, so that only visible ones cost time.
#include <imgui.h>

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include "document/alert_actions.h"
#include "document/ask_actions.h"
#include "document/link_actions.h"
#include "jobs/questions.h"
#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/decision_rows.h"
#include "panels/widgets/widgets.h"
#include "rows/evidence_rows.h"
#include "run/strings.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

namespace {

/// Number of alerts above which classes are folded at first.
constexpr std::size_t kManyAlerts = 40;

/// The heads that the user has folded (false) or unfolded (true), by name.
struct UnfoldedAlerts {
    std::map<std::string, bool> heads;
};

/// A line of the list: the head of a place, or of a class that is no fault, or an alert of it.
struct AlertRow {
    enum class Kind : std::uint8_t { Place, Class, Alert } kind;
    std::size_t number;  ///< Of the place, the group or the alert.
};

/// Whether the rows under a head are shown; `holds`: the chosen alert is among them.
bool isOpen(const PanelContext& context, const std::string& head, bool holds) {
    const auto& byHand = context.state<UnfoldedAlerts>().heads;
    const auto found = byHand.find(head);
    if (holds && context.state<AlertsPanel>().reveal) return true;
    if (found != byHand.end()) return found->second;
    return holds || context.session().alerts().failures().size() <= kManyAlerts;
}

std::string placeName(std::size_t place) { return "place " + std::to_string(place + 1); }

bool isOpen(const PanelContext& context, std::size_t place) {
    const RunAlerts& alerts = context.session().alerts();
    const auto chosen = alerts.chosen();
    return isOpen(context, placeName(place),
                  alerts.place() == place || (chosen && alerts.placeOf(*chosen) == place));
}

bool isOpen(const PanelContext& context, const AlertGroup& group) {
    const auto chosen = context.session().alerts().chosen();
    return isOpen(context, std::string(group.kind->name),
                  chosen && *chosen >= group.first && *chosen < group.first + group.count);
}

std::vector<AlertRow> rowsOf(const PanelContext& context) {
    std::vector<AlertRow> rows;
    const RunAlerts& alerts = context.session().alerts();
    for (std::size_t place = 0; place < alerts.places().size(); ++place) {
        rows.push_back({AlertRow::Kind::Place, place});
        if (!isOpen(context, place)) continue;
        for (const std::size_t alert : alerts.alertsAt(place))
            rows.push_back({AlertRow::Kind::Alert, alert});
    }
    for (std::size_t i = 0; i < alerts.groups().size(); ++i) {
        const AlertGroup& group = alerts.groups()[i];
        if (group.kind->fault) continue;
        rows.push_back({AlertRow::Kind::Class, i});
        if (!isOpen(context, group)) continue;
        for (std::size_t k = 0; k < group.count; ++k)
            rows.push_back({AlertRow::Kind::Alert, group.first + k});
    }
    return rows;
}

/// "12", "first 430 of at least 1 204 331".
std::string amountOf(const AlertGroup& group) {
    const ClassTotal& total = group.total;
    const std::string known = grouped(total.total);
    if (total.all()) return known;
    return "first " + grouped(total.listed) + " of " + (total.exact ? "" : "at least ") + known;
}

/// Head of rows: an arrow, a title in strong type, and a dim note at the right. True if clicked.
bool drawHead(const PanelContext& context, const std::string& name, const std::string& title,
              const std::string& note, bool open, bool chosen, const std::string& help) {
    ImGui::PushID(name.c_str());
    ImGui::PushFont(context.fonts.strong);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetCursorPosX();
    const bool clicked = selectable(context, "##head", chosen, "alerts " + name, help);
    drawFoldArrow({at.x + 0.5F * context.em, at.y + 0.5F * ImGui::GetTextLineHeight()},
                  0.3F * context.em, open, context.palette.textDim);
    ImGui::SameLine(left + 1.3F * context.em);
    const float room =
        ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX() - textWidth(note) - context.em;
    ImGui::TextUnformatted(fittedWords(title, room).c_str());
    ImGui::PopFont();
    dimAtRight(note);
    ImGui::PopID();
    return clicked;
}

void drawPlace(const PanelContext& context, std::size_t place) {
    const RunAlerts& alerts = context.session().alerts();
    const std::string name = placeName(place);
    const std::string what = describe(alerts.places()[place], alerts.found()->all);
    const bool open = isOpen(context, place);
    const bool shown = alerts.place() == place;
    if (!drawHead(
            context, name, std::to_string(place + 1) + "  " + what, "", open, shown,
            what + ".\n" + (shown ? (open ? "Fold" : "Unfold") : "Show it on the finished mesh")))
        return;
    bool& unfolded = context.state<UnfoldedAlerts>().heads[name];
    unfolded = shown ? !open : true;
    if (!shown) showPlace(context.commands, place);
}

void drawClass(const PanelContext& context, const AlertGroup& group) {
    const std::string name(group.kind->name);
    const bool open = isOpen(context, group);
    if (drawHead(context, name, titleOf(*group.kind), amountOf(group), open, false,
                 std::string(group.kind->meaning) + (open ? "\nFold" : "\nUnfold")))
        context.state<UnfoldedAlerts>().heads[name] = !open;
}

void drawRow(const PanelContext& context, std::size_t index) {
    const Session& session = context.session();
    const RunFailure& alert = session.alerts().failures()[index];
    const bool chosen = session.alerts().chosen() == index;
    ImGui::PushID(static_cast<int>(index));
    const float left = ImGui::GetCursorPosX();
    if (selectable(context, "##alert", chosen, "alert " + alertName(session.alerts(), index),
                   "Go to where it was created, frame it, and show why"))
        showAlert(context.commands, index, AlertMoment::Created);
    ImGui::SameLine(left + 1.3F * context.em);
    textIn(context.fonts.mono, toString(alert.moments.created.event.address));
    const float width = ImGui::GetItemRectSize().x;
    const float at = left + std::max(8.6F * context.em, width + 2.0F * context.em);
    ImGui::SameLine(at);
    const std::string points =
        std::string(alert.failure.kind->singular) + " " + firstNumbers(alert.failure.points, 6);
    dimShortText(points, ImGui::GetContentRegionMax().x - at);
    ImGui::PopID();
}

/// Name and address of a moment, as a link, and below it the decision there.
void drawMoment(const PanelContext& context, const RunFailure& alert, AlertMoment moment) {
    const Session& session = context.session();
    const LedgerLine& line = momentOf(alert, moment);
    const Address& address = line.event.address;
    const bool here = session.event() != nullptr && session.address() == address;
    ImGui::PushID(static_cast<int>(moment));
    const float left = ImGui::GetCursorPosX();
    const std::string name(momentName(moment));
    if (selectable(context, "##moment", here, "alert " + name))
        showAlert(context.commands, *session.alerts().chosen(), moment);
    ImGui::SameLine(left);
    textIn(context.fonts.strong, name);
    ImGui::PushFont(context.fonts.mono);
    const std::string text = toString(address);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
    wrappedText(shortSentence(line.event));
    tooltip(describe(line.event));
    if (line.reading) dimText(readingText(*line.reading));
    ImGui::PopID();
    ImGui::Spacing();
}

/// Answer of the ledger about the alert.
void drawWhy(const PanelContext& context, const RunFailure& alert) {
    const Questions& questions = context.session().questions();
    if (smallButton(context, "Why?", "alert why",
                    "The decisions that led to it, in the panel Why: " + context.key("ask.why")))
        askWhy(context.commands, alert);
    const Ledger* answer = questions.isAbout(alert.failure) ? questions.why() : nullptr;
    if (answer != nullptr) {
        dimText(withShortNumbers(answer->answer));
        if (answer->preventedBy) drawPreventing(context, *answer->preventedBy);
    }
    ImGui::Spacing();
}

/// The link to the alert, or how far its points are reduced.
void drawLink(const PanelContext& context) {
    BackgroundQuery<Reduced>& reduction = context.session().alerts().reduction();
    if (!reduction.complaint().empty()) dimText(reduction.complaint());
    if (reduction.busy()) {
        ImGui::ProgressBar(static_cast<float>(reduction.share()), {-1.0F, 0.0F});
        if (ImGui::SmallButton("Stop")) reduction.stop();
        return;
    }
    const std::string_view reason = reasonAgainstFailureLink(context.commands);
    ImGui::BeginDisabled(!reason.empty());
    if (smallButton(context, "Copy link to this failure", "alert link",
                    "With the fewest points that still end in it"))
        actions::copyFailureLink(context.commands);
    ImGui::EndDisabled();
    if (!reason.empty()) dimText(std::string(reason));
}

void drawChosen(const PanelContext& context) {
    const Session& session = context.session();
    const RunFailure* alert = session.alerts().shown();
    const MeshFailure& failure = alert->failure;
    std::string what =
        (failure.points.size() == 1 ? "Point " : "Points ") + firstNumbers(failure.points, 12);
    if (!failure.triangles.empty()) {
        what += failure.triangles.size() == 1 ? "; triangle " : "; triangles ";
        constexpr std::size_t kShown = 6;
        const std::size_t count = std::min(kShown, failure.triangles.size());
        what += joinedNumbers(std::span(failure.triangles).first(count));
        if (failure.triangles.size() > kShown) what += ", ...";
    }
    if (failure.length > 0.0)
        what += "; length " + numberText(failure.length) + ", area " + numberText(failure.area);
    wrappedText(std::string(failure.kind->meaning));
    dimText(what + ".");
    ImGui::Spacing();
    for (const AlertMoment moment : kAlertMoments) drawMoment(context, *alert, moment);
    drawWhy(context, *alert);
    drawLink(context);
}

void drawRows(const PanelContext& context, std::span<const AlertRow> rows) {
    drawSeen(rows.size(), ImGui::GetTextLineHeightWithSpacing(), [&](std::size_t i) {
        const AlertRow& row = rows[i];
        if (row.kind == AlertRow::Kind::Place) drawPlace(context, row.number);
        if (row.kind == AlertRow::Kind::Alert) drawRow(context, row.number);
        if (row.kind == AlertRow::Kind::Class)
            drawClass(context, context.session().alerts().groups()[row.number]);
    });
}

/// All rows; details of the chosen alert are below its row.
void drawList(const PanelContext& context) {
    const std::vector<AlertRow> rows = rowsOf(context);
    const auto chosen = context.session().alerts().chosen();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const AlertRow& each) {
        return chosen && each.kind == AlertRow::Kind::Alert && each.number == *chosen;
    });
    if (found == rows.end()) return drawRows(context, rows);
    const auto above = static_cast<std::size_t>(found - rows.begin());
    const float pitch = ImGui::GetTextLineHeightWithSpacing();
    if (context.state<AlertsPanel>().reveal) {
        // At the top: the details take the room below. A place has its head above its first alert.
        const std::size_t top = above - (context.session().alerts().place() ? 1 : 0);
        const float y = ImGui::GetCursorPosY() + static_cast<float>(top) * pitch;
        ImGui::SetScrollY(std::max(0.0F, y - 0.3F * pitch));
    }
    drawRows(context, std::span(rows).first(above + 1));
    ImGui::Indent(1.3F * context.em);
    ImGui::Spacing();
    drawChosen(context);
    ImGui::Spacing();
    ImGui::Unindent(1.3F * context.em);
    drawRows(context, std::span(rows).subspan(above + 1));
}

/// The verdict on a mesh without failures: "No failures found: the mesh is sound."
std::string noneText(const RunAlerts& alerts) {
    if (alerts.sound()) return "No failures found: the mesh is sound.";
    const bool none = alerts.found()->verdict.triangles == 0;
    return std::string("No failures found, but ") +
           (none ? "the mesh has no triangle." : "the search ended early.");
}

/// List of the checks, if nothing was found.
void drawNothing(const RunAlerts& alerts) {
    ImGui::TextUnformatted(noneText(alerts).c_str());
    ImGui::Spacing();
    dimText("Searched for: " + joined(failureClasses(), ", ", titleOf) + ".");
}

void drawSearch(const PanelContext& context) {
    Session& session = context.session();
    const RunAlerts& alerts = session.alerts();
    const std::string& complaint = alerts.complaint();
    if (alerts.stopped() || !complaint.empty()) {
        dimText(alerts.stopped() ? "The search was stopped." : complaint);
        if (smallButton(context, "Search for failures", "alerts resume")) session.alerts().resume();
        return;
    }
    dimText(alerts.busy() ? "Searching for alerts ..."
                          : "The search for alerts starts once the run is complete.");
    if (!alerts.busy()) return;
    ImGui::ProgressBar(static_cast<float>(alerts.share()), {-1.0F, 0.0F});
    if (smallButton(context, "Stop", "alerts stop")) session.alerts().stop();
}

}  // namespace

void drawAlerts(const PanelContext& context) {
    const Session& session = context.session();
    const RunAlerts& alerts = session.alerts();
    const std::string note =
        watchNote(session.shown().points.size(), session.overview().failures.size());
    if (!note.empty()) dimText(note);
    if (!alerts.done()) return drawSearch(context);
    if (alerts.found()->all.empty()) return drawNothing(alerts);
    if (!alerts.complete())
        dimText(
            "There are too many failures to follow all of them: places list the first of each "
            "class.");
    if (!alerts.chosen()) {
        const std::string places =
            "The most severe place first: " + context.key("step.alert.next") +
            " shows the next one. ";
        dimText((alerts.places().empty() ? "" : places) +
                "A click on an alert goes to where it was created.");
    }
    drawList(context);
    context.state<AlertsPanel>().reveal = false;
}

}  // namespace se::view
