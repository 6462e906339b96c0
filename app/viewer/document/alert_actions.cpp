#include "alert_actions.h"

#include <algorithm>
#include <cassert>

#include "actions.h"
#include "compare/compared_runs.h"
#include "document.h"
#include "jobs/questions.h"
#include "panel_state/side_panels.h"
#include "run/overview.h"
#include "run/strings.h"
#include "session/playback.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

namespace {

RunSpec rulesWith(const RunSpec& rules, const Remedy& remedy) {
    if (remedy.rule == nullptr) return withSet(rules, remedy.set);
    return withRule(rules, remedy.rule->name, 1.0);
}

}  // namespace

std::string_view momentName(AlertMoment moment) {
    constexpr std::array<std::string_view, 3> kNames{"created", "unavoidable", "first touched"};
    return kNames[static_cast<std::size_t>(moment)];
}

const LedgerLine& momentOf(const RunFailure& alert, AlertMoment moment) {
    if (moment == AlertMoment::Created) return alert.moments.created;
    const bool touched = moment == AlertMoment::Touched;
    return touched ? alert.moments.touched : alert.moments.unavoidable;
}

Selection subjectOf(const RunFailure& alert) {
    const MeshFailure& failure = alert.failure;
    if (failure.points.size() == 1) return Selection::ofPoint(failure.points[0]);
    if (isLoop(failure)) return {};
    if (failure.points.size() == 2) return Selection::ofEdge(failure.points[0], failure.points[1]);
    if (failure.triangles.empty()) return {};
    const auto* made = std::get_if<EmitEvidence>(&alert.moments.created.event.evidence);
    return Selection::ofTriangle(made != nullptr ? made->corners : alert.corners.back());
}

std::string titleOf(const FailureClass& kind) {
    std::string title(kind.name);
    std::replace(title.begin(), title.end(), '_', ' ');
    return title;
}

std::string pointsText(const MeshFailure& failure, std::size_t limit) {
    std::string text;
    for (std::size_t i = 0; i < std::min(limit, failure.points.size()); ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(failure.points[i]);
    if (failure.points.size() > limit)
        text += ", ... (" + std::to_string(failure.points.size()) + ")";
    return text;
}

std::string watchNote(std::size_t points, std::size_t noticed) {
    if (points > kMaxWatched)
        return "Runs on more than " + grouped(kMaxWatched) +
               " points are not checked during stepping: their failures are listed only here.";
    if (noticed >= kMaxNoticed)
        return "During stepping only the first " + grouped(kMaxNoticed) +
               " failures are reported: the others are listed only here.";
    return {};
}

void showAlert(CommandContext& context, std::size_t alert, std::optional<AlertMoment> moment) {
    Session& session = context.session;
    assert(alert < session.alerts().search().failures().size());
    context.playback.pause();
    session.alerts().choose(alert);
    const RunFailure& chosen = *session.alerts().shown();
    session.highlights().mark({});
    const Selection subject = subjectOf(chosen);
    session.select(subject);
    // The answer is ready when the ledger is opened; its first sentence is shown with the alert.
    if (subject.kind == SelectionKind::None)
        session.questions().askWhy(chosen);
    else if (session.questions().subject() != subject)
        session.questions().askWhy(subject);
    if (moment) session.moves().goTo(momentOf(chosen, *moment).event.address);
    context.ui.frame = FrameRequest::Fault;
    context.ui.alerts.reveal = true;
}

void showPlace(CommandContext& context, std::size_t place) {
    Session& session = context.session;
    RunAlerts& alerts = session.alerts();
    assert(place < alerts.search().places().size());
    context.playback.pause();
    alerts.choosePlace(place);
    session.highlights().mark({});
    session.select(alerts.shown() != nullptr ? subjectOf(*alerts.shown()) : Selection{});
    if (!session.atEnd()) session.moves().toEnd();
    context.ui.frame = FrameRequest::Fault;
    context.ui.alerts.reveal = true;
    actions::showPart(context, kAlertsPart);
    session.messages().say(verdictSentence(alerts));
}

std::optional<std::size_t> alertAt(const AlertSearch& alerts, const Selection& what) {
    const auto corners = what.corners();
    if (corners.empty()) return {};
    std::optional<std::size_t> worst;
    for (std::size_t i = 0; i < alerts.failures().size(); ++i) {
        const MeshFailure& failure = alerts.failures()[i].failure;
        if (!failure.kind->fault) continue;
        if (worst && alerts.failures()[*worst].failure.kind->severity <= failure.kind->severity)
            continue;
        // The points of a failure are in order.
        const bool all = std::all_of(corners.begin(), corners.end(), [&](Index p) {
            return std::binary_search(failure.points.begin(), failure.points.end(), p);
        });
        if (all) worst = i;
    }
    return worst;
}

void nextPlace(CommandContext& context, int direction) {
    Session& session = context.session;
    if (!session.ready()) return;
    const AlertSearch& alerts = session.alerts().search();
    if (!alerts.done())
        return session.messages().say(alerts.busy() ? "The search for faults is still running."
                                                    : "The search for faults has not started yet.");
    const auto count = static_cast<std::ptrdiff_t>(alerts.places().size());
    if (count == 0) {
        const bool sound = alerts.sound();
        return session.messages().say(sound ? "No faults found."
                                            : "No place to show: " + verdictText(alerts) + ".");
    }
    const auto chosen = session.alerts().chosen();
    const auto from = session.alerts().place()    ? session.alerts().place()
                      : chosen && session.atEnd() ? alerts.placeOf(*chosen)
                                                  : std::nullopt;
    const std::ptrdiff_t next = from            ? static_cast<std::ptrdiff_t>(*from) + direction
                                : direction > 0 ? 0
                                                : count - 1;
    if (next < 0) return session.messages().say("This is the first place.");
    if (next >= count) return session.messages().say("This is the last place.");
    showPlace(context, static_cast<std::size_t>(next));
}

std::string verdictText(const AlertSearch& alerts) {
    if (alerts.sound()) return "the mesh is sound";
    return headlineOf(alerts.found()->verdict);
}

std::string verdictSentence(const RunAlerts& alerts) {
    const AlertSearch& search = alerts.search();
    if (!alerts.place()) return "The run is finished: " + verdictText(search) + ".";
    return "Place " + grouped(*alerts.place() + 1) + " of " + grouped(search.places().size()) +
           ": " + describe(search.places()[*alerts.place()], search.found()->all) + ".";
}

bool showsFinishedMesh(const CommandContext& context) {
    return context.ui.settings.meshStyle == MeshStyle::Faults && context.session.ready() &&
           context.session.atEnd();
}

void switchOn(CommandContext& context, const Remedy& remedy) {
    context.document.rerun(rulesWith(context.session.input().spec(), remedy), Resume::End);
}

bool canFix(const CommandContext& context) {
    const Session& session = context.session;
    const bool whole =
        session.input().spec().whatIf.empty() && session.model().params.start.empty();
    const TrialJob& job = session.trials();
    return whole && !session.alerts().search().sound() && (job.best() != nullptr || !job.ended());
}

void fixByTrials(CommandContext& context) {
    TrialJob& job = context.session.trials();
    context.ui.verdict.fixing = !job.ended();
    if (context.ui.verdict.fixing) return job.start();
    assert(job.best() != nullptr);
    context.document.run(changed(context.session.input().spec(), job.best()->change), Resume::End);
}

std::string fixText(const TrialJob& job) {
    if (!job.ended()) return "Try other settings, then run again with the best of them";
    const auto& [go, come] = wordsOf(*job.change());
    return "Run again, to the end: " + wordsOf(job.best()->change) + ". " + go + ", " + come;
}

const MeshChange* shownChange(const CommandContext& context) {
    const Session& session = context.session;
    const bool shown = context.ui.verdict.pointedAt && session.ready() && session.atEnd() &&
                       !session.showsEarlierMesh() && session.trials().ended();
    return shown ? session.trials().change() : nullptr;
}

std::string openText(const OpenLoops& loops) {
    if (loops.count == 0) return "";
    return grouped(loops.count) + (loops.count == 1 ? " open, " : " open, up to ") +
           shortNumber(loops.width) + " across";
}

void closeHoles(CommandContext& context, double width) {
    RunSpec rules = context.session.input().spec();
    const RuleSetting* closes = findRuleSetting("closeholes");
    assert(closes != nullptr);
    if (width > 0.0 && valueOf(rules, *closes) == 0.0) rules.rules = "robust";
    context.ui.verdict.closing = {width, context.session.alerts().search().openLoops().count};
    context.document.rerun(withRule(rules, "holewidth", width), Resume::End);
}

std::string closedText(const HoleClosing& closing, const AlertSearch& alerts) {
    assert(alerts.done());
    const std::vector<MeshFailure>& all = alerts.found()->all;
    const auto wider = static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(),
        [&](const MeshFailure& each) { return isLoop(each) && widthOf(each) > closing.width; }));
    const std::size_t open = alerts.openLoops().count;
    const std::size_t closed = closing.before > open ? closing.before - open : 0;
    std::string text = "Closed " + grouped(closed) + " of " + grouped(closing.before) +
                       (closing.before == 1 ? " open loop" : " open loops");
    if (wider > 0) text += "; " + grouped(wider) + " wider than " + shortNumber(closing.width);
    const std::size_t refused = open - wider;
    if (refused > 0) text += "; for " + grouped(refused) + " no filling without a fault was found";
    return text + ".";
}

void showBeside(CommandContext& context, const Remedy& remedy) {
    const RunSpec& spec = context.session.input().spec();
    actions::enterCompare(context);
    context.compare.begin(CompareWith::otherRun(withRulesOf(spec, rulesWith(spec, remedy))));
}

bool openOnVerdict(CommandContext& context) {
    Session& session = context.session;
    const bool untouched =
        session.event() == nullptr && !session.moves().busy() && !context.playback.playing() &&
        session.selection().kind == SelectionKind::None && session.highlights().marked().empty();
    if (session.alerts().search().sound() || !untouched ||
        context.ui.layoutPreset != LayoutPreset::Debug)
        return false;
    // The notice about the input stays.
    const std::string notice = session.messages().notice();
    session.moves().toEnd();
    session.messages().say(notice);
    return true;
}

}  // namespace se::view
