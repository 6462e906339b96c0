#include "alert_actions.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <utility>

#include "actions.h"
#include "ask_actions.h"
#include "compare/compared_runs.h"
#include "link_actions.h"
#include "run/model.h"
#include "run/overview.h"
#include "run/strings.h"
#include "session/playback.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

namespace {

/// The outcome of that request: "Closed 3 of 14 open loops; 9 wider than 0.2; for 2 no filling
/// without a fault was found.". Requires alerts of the new run.
std::string closedText(const HoleClosing& closing, const RunAlerts& alerts) {
    assert(alerts.done());
    const std::size_t wider = countWhere(alerts.found()->all, [&](const MeshFailure& each) {
        return isLoop(each) && widthOf(each) > closing.width;
    });
    const std::size_t open = alerts.openLoops().count;
    const std::size_t closed = closing.before > open ? closing.before - open : 0;
    std::string text = "Closed " + grouped(closed) + " of " + withS(closing.before, "open loop");
    if (wider > 0) text += "; " + grouped(wider) + " wider than " + shortNumber(closing.width);
    const std::size_t refused = open - wider;
    if (refused > 0) text += "; for " + grouped(refused) + " no filling without a fault was found";
    return text + ".";
}

/// "is sound", "has faults at 3 places", in the tense of the two verbs.
std::string stateText(const MeshVerdict& verdict, const std::string& is, const std::string& has) {
    if (verdict.isSound()) return is + " sound";
    if (verdict.triangles == 0) return has + " no triangle";
    if (verdict.places == 0) return has + " no fault that was found";
    return has + " faults at " + placesText(verdict);
}

/// Called when the alerts of an input are known. A newly opened input without any user action
/// yet opens on its finished mesh if that has faults. True if it does.
bool openOnVerdict(CommandContext& context) {
    Session& session = context.session;
    const bool untouched =
        session.event() == nullptr && !session.moves().busy() && !context.playback.playing() &&
        session.selection().kind == SelectionKind::None && session.highlights().marked().empty();
    if (session.alerts().sound() || !untouched || context.ui.layoutPreset != LayoutPreset::Debug)
        return false;
    // The notice about the input stays.
    const std::string notice = session.messages().notice();
    session.moves().toEnd();
    session.messages().say(notice);
    return true;
}

}  // namespace

std::string_view momentName(AlertMoment moment) {
    constexpr std::array<std::string_view, 3> kNames{"created", "decided", "first touched"};
    return kNames[static_cast<std::size_t>(moment)];
}

const LedgerLine& momentOf(const RunFailure& alert, AlertMoment moment) {
    if (moment == AlertMoment::Created) return alert.moments.created;
    const bool touched = moment == AlertMoment::Touched;
    return touched ? alert.moments.touched : alert.moments.decided;
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

std::string titleOf(const FailureClass& kind) { return nounFor(kind, 2); }

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
    assert(alert < session.alerts().failures().size());
    context.playback.pause();
    session.alerts().choose(alert);
    const RunFailure& chosen = *session.alerts().shown();
    session.highlights().mark({});
    const Selection subject = subjectOf(chosen);
    session.select(subject);
    // The answer is ready when the ledger is opened; its first sentence is shown with the alert.
    askInBackground(context, chosen);
    if (moment) session.moves().goTo(momentOf(chosen, *moment).event.address);
    context.ui.frame = FrameRequest::Fault;
    context.ui.alerts.reveal = true;
}

void showPlace(CommandContext& context, std::size_t place) {
    Session& session = context.session;
    RunAlerts& alerts = session.alerts();
    assert(place < alerts.places().size());
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

std::optional<std::size_t> alertAt(const RunAlerts& alerts, const Selection& what) {
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
    const RunAlerts& alerts = session.alerts();
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

std::string verdictText(const RunAlerts& alerts) {
    const MeshVerdict& verdict = alerts.found()->verdict;
    if (verdict.triangles == 0 || verdict.isSound())
        return "the mesh " + stateText(verdict, "is", "has");
    return (verdict.places > 0 ? "the mesh has faults at " : "") + headlineOf(verdict);
}

std::string verdictSentence(const RunAlerts& alerts) {
    if (!alerts.place()) return "The run is finished; " + verdictText(alerts) + ".";
    return "Place " + grouped(*alerts.place() + 1) + " of " + grouped(alerts.places().size()) +
           ": " + describe(alerts.places()[*alerts.place()], alerts.found()->all) + ".";
}

std::string endText(const Session& session) {
    const MeshVerdict& verdict = session.alerts().found()->verdict;
    const std::string end = verdict.places > 0  ? placesText(verdict)
                            : verdict.isSound() ? "sound"
                                                : "no faults";
    return (session.atEnd() ? "" : "at end: ") + end;
}

bool showsFinishedMesh(const CommandContext& context) {
    return context.ui.settings.meshStyle == MeshStyle::Faults && context.session.ready() &&
           context.session.atEnd();
}

void runWith(CommandContext& context, const FieldValue& change) {
    context.document.run(changed(context.session.input().spec(), {change}), Resume::End);
}

bool canFix(const CommandContext& context) {
    const Session& session = context.session;
    const bool whole =
        session.input().spec().whatIf.empty() && session.model().params.start.empty();
    const TrialJob& job = session.trials();
    return whole && !session.alerts().sound() && (job.best() != nullptr || !job.ended());
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
    context.ui.verdict.closing = {width, context.session.alerts().openLoops().count};
    context.document.rerun(withRule(rules, "holewidth", width), Resume::End);
}

void showBeside(CommandContext& context, const FieldValue& change) {
    actions::enterCompare(context);
    context.compare.begin(CompareWith::otherRun(changed(context.session.input().spec(), {change})));
}

namespace {

/// Reason why a run has no alert of the name CLASS:N.
std::string whyNone(const RunAlerts& alerts, const std::string& name) {
    const FailureClass* kind = findFailureClass(name.substr(0, name.find(':')));
    if (kind == nullptr && name != "first")
        return "no such class; spiraling-edge check --help lists them.";
    if (!alerts.complaint().empty()) return alerts.complaint();
    const std::span<const RunFailure> failures = alerts.failures();
    if (failures.empty()) return "the run has no such failure; it has none at all.";
    const std::size_t count =
        countWhere(failures, [&](const RunFailure& each) { return each.failure.kind == kind; });
    const char* has = alerts.complete() ? "the run has no such failure; it has "
                                        : "no such failure is listed; the run has ";
    return has + std::to_string(count) + " of this class and " + std::to_string(failures.size()) +
           " in all.";
}

/// A sentence about the place that was shown in the mesh before: "1 hole of 3 edges is gone. ";
/// empty if none was shown. The place is still there if a new one reaches its most severe fault.
std::string changeOfPlace(const Session& session) {
    const EarlierMesh& earlier = session.earlierMesh();
    if (!earlier.place || !earlier.faults) return "";
    const FaultPlace& place = earlier.faults->places[*earlier.place];
    const RunFailureSearch& now = *session.alerts().found();
    const bool stays =
        std::any_of(now.places.begin(), now.places.end(), [&](const FaultPlace& each) {
            return glm::length(each.center - place.center) <= each.radius + place.radius;
        });
    return "The place that was shown (" + describe(place, earlier.faults->all) +
           (stays ? ") still has faults. " : ") is gone. ");
}

}  // namespace

void AlertsShown::begin(const Options& options) {
    asked_ = options.alert;
    interactive_ = !options.onPaper();
    // A picture of a file shows where its faults are. Built-in inputs are small, and may be about
    // one.
    const bool own = isScene(options.input.source) || !options.lesson.empty();
    c_.session.alerts().setFollows(interactive_ || own || !asked_.empty() || options.session);
}

/// Applies the best settings that were tried, where the user has asked for it before all were.
void AlertsShown::fixWhenTried() {
    const TrialJob& job = c_.session.trials();
    if (!c_.ui.verdict.fixing || !job.ended()) return;
    c_.ui.verdict.fixing = false;
    if (job.best() != nullptr) return fixByTrials(c_);
    if (job.complaint().empty() && !job.trials().tried.empty())
        c_.session.messages().say(noneBetterText(job.trials()));
}

void AlertsShown::poll() {
    Session& session = c_.session;
    fixWhenTried();
    finishFailureLink(c_);
    if (!session.alerts().takeNews()) return;
    const std::string& source = session.input().spec().source;
    const bool fresh = std::exchange(source_, source) != source;
    if (fresh) {
        verdict_.reset();
        c_.ui.verdict = {};
    }
    reportChange();
    if (const auto closing = std::exchange(c_.ui.verdict.closing, std::nullopt);
        closing && session.alerts().done())
        session.messages().say(closedText(*closing, session.alerts()));
    startTrials();
    if (!asked_.empty()) return showAsked();
    if (const std::string kept = c_.document.takeAlert(); !kept.empty())
        session.alerts().choose(alertNamed(session.alerts(), kept));
    if (fresh) chooseOfGallery();
    // Scenes and sampled points are opened to watch the run, so they open at the start.
    const bool file = !isScene(source) && !isSample(source);
    if (!fresh || !file || !interactive_ || c_.document.placed()) return;
    opened_ = openOnVerdict(c_);
}

void AlertsShown::reportChange() {
    const RunAlerts& alerts = c_.session.alerts();
    if (!alerts.done()) return;
    const MeshVerdict& now = alerts.found()->verdict;
    const std::optional<MeshVerdict> before = std::exchange(verdict_, now);
    const RunSpec rules = c_.session.input().spec();
    const bool sameRules = std::exchange(rules_, rules) == rules;
    if (!before || (sameRules && headlineOf(*before) == headlineOf(now))) return;
    // The message about the position in the new run stays.
    const std::string said = c_.session.messages().last();
    const std::string is = stateText(now, "is", "has");
    const std::string change =
        is == stateText(*before, "is", "has")
            ? "As before, the mesh " + is + "."
            : "The mesh now " + is + "; before, it " + stateText(*before, "was", "had") + ".";
    const char* look =
        c_.session.hasEarlierMesh() ? " Hold the back-quote key to see the mesh before." : "";
    c_.session.messages().say(said + (said.empty() ? "" : " ") + changeOfPlace(c_.session) +
                              change + look);
}

/// Other settings are tried without a request where that is quick, and neither the addresses of
/// what-ifs nor the points of a given start are in the way.
void AlertsShown::startTrials() {
    const Session& session = c_.session;
    const bool quick = session.model().points.size() <= kManyForTrials;
    if (interactive_ && quick && canFix(c_)) c_.session.trials().start();
}

/// For a scene that fails, the alert that it demonstrates; its story is beside the paper's rule.
void AlertsShown::chooseOfGallery() {
    Session& session = c_.session;
    const FailureScene* failing = galleryScene(session.input().spec().source);
    if (failing == nullptr || session.alerts().chosen()) return;
    const auto failures = session.alerts().failures();
    const auto rate = [&](const RunFailure& each) {
        if (each.failure.kind->name != failing->failure) return 0;
        const auto address = addressFromString(failing->address);
        if (toString(each.moments.decided.event.address) == failing->address) return 3;
        return address && each.moments.created.event.address.pivot == address->pivot ? 2 : 1;
    };
    const auto best = std::max_element(
        failures.begin(), failures.end(),
        [&](const RunFailure& a, const RunFailure& b) { return rate(a) < rate(b); });
    if (best == failures.end() || rate(*best) == 0) return;
    session.alerts().choose(static_cast<std::size_t>(best - failures.begin()));
}

void AlertsShown::showAsked() {
    Session& session = c_.session;
    const std::string name = std::exchange(asked_, {});
    const auto alert = alertNamed(session.alerts(), name);
    actions::showPart(c_, kAlertsPart);
    // At the position that was named, if one was.
    std::optional<AlertMoment> moment;
    if (!c_.document.placed()) moment = AlertMoment::Created;
    if (alert) return showAlert(c_, *alert, moment);
    status_ = Error{"--alert " + name + ": " + whyNone(session.alerts(), name)};
    session.messages().say(status_.error().message);
}

}  // namespace se::view
