// Failures of the finished run by class. The chosen one shows its three moments, the answer of the
// ledger about it, and the rules that would have prevented it, each found by a re-run. Rows above
// and below the details are clipped lists of their own, so that only visible ones cost time.
#include <imgui.h>

#include <algorithm>
#include <span>
#include <vector>

#include "commands/alert_actions.h"
#include "commands/ask_actions.h"
#include "jobs/questions.h"
#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/number_format.h"
#include "session/session.h"
#include "spiraling_edge/replay/event_text.h"

namespace se::view {

namespace {

/// Number of alerts above which classes are folded at first.
constexpr std::size_t kManyAlerts = 40;

/// A line of the list: the head of a class, or an alert.
struct AlertRow {
    const AlertGroup* head = nullptr;
    std::size_t alert = 0;
};

bool isOpen(const PanelContext& context, const AlertGroup& group) {
    const auto& byHand = context.state<AlertsPanel>().open;
    const auto found = byHand.find(std::string(group.kind->name));
    const auto chosen = context.session().alerts().chosen();
    const bool holdsChosen =
        chosen && *chosen >= group.first && *chosen < group.first + group.count;
    if (holdsChosen && context.state<AlertsPanel>().reveal) return true;
    if (found != byHand.end()) return found->second;
    return holdsChosen || context.session().alerts().search().failures().size() <= kManyAlerts;
}

std::vector<AlertRow> rowsOf(const PanelContext& context) {
    std::vector<AlertRow> rows;
    for (const AlertGroup& group : context.session().alerts().search().groups()) {
        rows.push_back({&group, 0});
        if (!isOpen(context, group)) continue;
        for (std::size_t i = 0; i < group.count; ++i) rows.push_back({nullptr, group.first + i});
    }
    return rows;
}

/// Arrow that points down if unfolded, otherwise to the right.
void drawArrow(const PanelContext& context, ImVec2 at, bool open) {
    const float r = 0.3F * context.em;
    const ImVec2 c(at.x + 0.5F * context.em, at.y + 0.5F * ImGui::GetTextLineHeight());
    const ImVec2 right[3] = {{c.x - 0.7F * r, c.y - r}, {c.x + r, c.y}, {c.x - 0.7F * r, c.y + r}};
    const ImVec2 down[3] = {{c.x - r, c.y - 0.7F * r}, {c.x + r, c.y - 0.7F * r}, {c.x, c.y + r}};
    const ImVec2* p = open ? down : right;
    ImGui::GetWindowDrawList()->AddTriangleFilled(p[0], p[1], p[2], toU32(context.palette.textDim));
}

/// "12", "first 430 of at least 1 204 331".
std::string amountOf(const AlertGroup& group) {
    const ClassTotal& total = group.total;
    const std::string known = grouped(total.total);
    if (total.all()) return known;
    return "first " + grouped(total.listed) + " of " + (total.exact ? "" : "at least ") + known;
}

void drawHead(const PanelContext& context, const AlertGroup& group) {
    const bool open = isOpen(context, group);
    ImGui::PushID(group.kind);
    ImGui::PushFont(context.fonts.strong);
    ImGui::PushStyleColor(
        ImGuiCol_Text, toVec4(group.kind->fault ? context.palette.rejected : context.palette.text));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetCursorPosX();
    const std::string name(group.kind->name);
    const std::string help = std::string(group.kind->meaning) + (open ? "\nFold" : "\nUnfold");
    if (selectable(context, "##head", false, "alerts " + name, help))
        context.state<AlertsPanel>().open[name] = !open;
    drawArrow(context, at, open);
    ImGui::SameLine(left + 1.3F * context.em);
    const std::string count = amountOf(group);
    const float end = ImGui::GetContentRegionMax().x;
    const float room =
        end - ImGui::GetCursorPosX() - ImGui::CalcTextSize(count.c_str()).x - context.em;
    ImGui::TextUnformatted(fitted(titleOf(*group.kind), room).c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
    dimAtRight(count);
    ImGui::PopID();
}

void drawRow(const PanelContext& context, std::size_t index) {
    const Session& session = context.session();
    const RunFailure& alert = session.alerts().search().failures()[index];
    const bool chosen = session.alerts().chosen() == index;
    ImGui::PushID(static_cast<int>(index));
    const float left = ImGui::GetCursorPosX();
    if (selectable(context, "##alert", chosen,
                   "alert " + alertName(session.alerts().search(), index),
                   "Go to where it was created, frame it, and show why"))
        showAlert(context.commands, index, AlertMoment::Created);
    ImGui::SameLine(left + 1.3F * context.em);
    textIn(context.fonts.mono, toString(alert.moments.created.event.address));
    const float width = ImGui::GetItemRectSize().x;
    const float at = left + std::max(8.6F * context.em, width + 2.0F * context.em);
    ImGui::SameLine(at);
    const std::string points = pointsText(alert.failure, 6);
    ImGui::TextDisabled("%s", fitted(points, ImGui::GetContentRegionMax().x - at).c_str());
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
    if (line.reading) {
        const Reading& r = *line.reading;
        const std::string unit(r.unit.empty() ? "" : " " + std::string(r.unit));
        dimText(std::string(r.quantity) + " " + numberText(r.value) + unit + " against " +
                numberText(r.threshold) + unit + ", margin " + numberText(r.margin));
    }
    ImGui::PopID();
    ImGui::Spacing();
}

/// Answer of the ledger for the faulty thing.
void drawWhy(const PanelContext& context, const RunFailure& alert) {
    Session& session = context.session();
    const Selection subject = subjectOf(alert);
    const Questions& questions = session.questions();
    if (smallButton(context, "Why? " + selectionText(subject), "alert why",
                    "Every decision about it, in the panel Ledger"))
        askWhy(context.commands, subject);
    const bool mine = questions.subject() == subject;
    const WhyAnswer* answer = mine ? questions.ledger().answer() : nullptr;
    if (answer != nullptr) dimText(withShortNumbers(answer->answer));
    ImGui::Spacing();
}

/// A rule with its effect, and a button that turns it on.
void drawRemedy(const PanelContext& context, const Remedy& remedy) {
    const std::string name(nameOf(remedy));
    ImGui::PushID(name.c_str());
    if (smallButton(context, "Switch on", "remedy " + name,
                    remedy.rule != nullptr ? std::string(remedy.rule->summary)
                                           : "All rules of the set; see docs/robust.md."))
        switchOn(context.commands, remedy);
    ImGui::SameLine();
    if (smallButton(context, "Compare", "beside " + name,
                    "This run and the one with it side by side, at this position"))
        showBeside(context.commands, remedy);
    ImGui::SameLine();
    textIn(context.fonts.mono, name);
    ImGui::SameLine();
    const std::string left = "leaves " + grouped(remedy.all);
    const float at = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(left.c_str()).x;
    ImGui::SameLine(std::max(at, ImGui::GetCursorPosX()));
    ImGui::TextDisabled("%s", left.c_str());
    ImGui::PopID();
}

void drawTried(const PanelContext& context, const Remedies& remedies) {
    std::string others;
    std::string unknown;
    bool any = false;
    for (const Remedy& each : remedies.tried) {
        if (each.prevents) {
            if (!any)
                dimText("Prevented by each of these alone. The run has " + grouped(remedies.all) +
                        " alerts now; the number with each rule "
                        "is shown at the right.");
            any = true;
            drawRemedy(context, each);
        } else {
            std::string& list = each.unknown ? unknown : others;
            list += (list.empty() ? "" : ", ") + std::string(nameOf(each));
        }
    }
    if (!any) wrappedText("No rule beyond the paper prevents this.");
    if (!others.empty()) dimText("It stays with: " + others + ".");
    if (!unknown.empty())
        dimText("Unknown, since too many alerts are left, with: " + unknown + ".");
}

/// Rules beyond the paper that would have prevented the alert.
void drawRemedies(const PanelContext& context) {
    Session& session = context.session();
    const BackgroundQuery<Remedies>& search = session.alerts().remedies();
    const bool mine = session.alerts().remediesOf() == session.alerts().chosen();
    heading(context, "What would have prevented it");
    if (mine && search.answer() != nullptr) return drawTried(context, *search.answer());
    if (mine && search.busy()) {
        ImGui::ProgressBar(static_cast<float>(search.share()), {-1.0F, 0.0F});
        if (ImGui::SmallButton("Stop")) session.alerts().remedies().stop();
        return;
    }
    if (mine && !search.complaint().empty()) dimText(search.complaint());
    if (smallButton(context, "Try the rules beyond the paper", "alert remedies",
                    "Re-runs with each of them on, one at a time"))
        session.alerts().seekRemedies();
}

void drawChosen(const PanelContext& context) {
    const Session& session = context.session();
    const RunFailure* alert = session.alerts().shown();
    const MeshFailure& failure = alert->failure;
    std::string what =
        (failure.points.size() == 1 ? "Point " : "Points ") + pointsText(failure, 12);
    if (!failure.triangles.empty()) {
        what += failure.triangles.size() == 1 ? "; triangle " : "; triangles ";
        for (std::size_t i = 0; i < std::min<std::size_t>(6, failure.triangles.size()); ++i)
            what += (i == 0 ? "" : ", ") + std::to_string(failure.triangles[i]);
        if (failure.triangles.size() > 6) what += ", ...";
    }
    if (failure.length > 0.0)
        what += "; length " + numberText(failure.length) + ", area " + numberText(failure.area);
    wrappedText(what + ".");
    ImGui::Spacing();
    for (const AlertMoment moment : kAlertMoments) drawMoment(context, *alert, moment);
    drawWhy(context, *alert);
    drawRemedies(context);
}

void drawRows(const PanelContext& context, std::span<const AlertRow> rows) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), ImGui::GetTextLineHeightWithSpacing());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const AlertRow& row = rows[static_cast<std::size_t>(i)];
            row.head != nullptr ? drawHead(context, *row.head) : drawRow(context, row.alert);
        }
    }
    clipper.End();
}

/// All rows; details of the chosen alert are below its row.
void drawList(const PanelContext& context) {
    const std::vector<AlertRow> rows = rowsOf(context);
    const auto chosen = context.session().alerts().chosen();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const AlertRow& each) {
        return chosen && each.head == nullptr && each.alert == *chosen;
    });
    if (found == rows.end()) return drawRows(context, rows);
    const auto above = static_cast<std::size_t>(found - rows.begin());
    const float pitch = ImGui::GetTextLineHeightWithSpacing();
    if (context.state<AlertsPanel>().reveal) {
        // At the top: the details take the room below.
        const float y = ImGui::GetCursorPosY() + static_cast<float>(above) * pitch;
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

/// List of the checks, if nothing was found.
void drawNothing(const AlertSearch& alerts) {
    ImGui::TextUnformatted(alerts.sound() ? "No failures found: the mesh is sound."
                                          : "No failures found, but the search ended early.");
    ImGui::Spacing();
    std::string checked;
    for (const FailureClass& each : failureClasses())
        checked += (checked.empty() ? "" : ", ") + titleOf(each);
    dimText("Searched for: " + checked + ".");
}

void drawSearch(const PanelContext& context) {
    Session& session = context.session();
    const AlertSearch& alerts = session.alerts().search();
    const std::string& complaint = alerts.complaint();
    if (alerts.stopped() || !complaint.empty()) {
        dimText(alerts.stopped() ? "The search was stopped." : complaint);
        if (smallButton(context, "Search for failures", "alerts resume"))
            session.alerts().search().resume();
        return;
    }
    dimText(alerts.busy() ? "Searching for alerts ..."
                          : "The search for alerts starts once the run is complete.");
    if (!alerts.busy()) return;
    ImGui::ProgressBar(static_cast<float>(alerts.share()), {-1.0F, 0.0F});
    if (smallButton(context, "Stop", "alerts stop")) session.alerts().search().stop();
}

std::string headingNote(const AlertSearch& alerts) {
    const std::size_t count = alerts.failures().size();
    if (!alerts.done() || count == 0) return {};
    if (!alerts.complete()) return "first " + grouped(count) + " alerts";
    return withS(count, "alert") + (alerts.sound() ? ", the mesh is sound" : "");
}

}  // namespace

void drawAlerts(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) return ImGui::TextDisabled("Nothing is open.");
    const AlertSearch& alerts = session.alerts().search();
    heading(context, "Alerts", headingNote(alerts));
    const std::string note =
        watchNote(session.shown().points.size(), session.overview().failures.size());
    if (!note.empty()) dimText(note);
    if (!alerts.done()) return drawSearch(context);
    if (alerts.failures().empty()) return drawNothing(alerts);
    if (!alerts.complete())
        dimText(
            "There are too many failures to follow all of them: the first of each class are "
            "listed.");
    if (!session.alerts().chosen()) {
        dimText(
            "Click an alert to go to where it was created, frame it, and list its three "
            "moments. " +
            context.key("step.alert.next") + " goes to the next one.");
    }
    drawList(context);
    context.state<AlertsPanel>().reveal = false;
}

}  // namespace se::view
