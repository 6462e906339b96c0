#include "alerts_shown.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "actions.h"
#include "alert_actions.h"
#include "failure_link.h"
#include "panel_state/side_panels.h"
#include "run/model.h"

namespace se::view {

namespace {

/// Reason why a run has no alert of the name CLASS:N.
std::string whyNone(const AlertSearch& alerts, const std::string& name) {
    const FailureClass* kind = findFailureClass(name.substr(0, name.find(':')));
    if (kind == nullptr && name != "first")
        return "no such class; spiraling-edge check --help lists them.";
    if (!alerts.complaint().empty()) return alerts.complaint();
    const std::span<const RunFailure> failures = alerts.failures();
    if (failures.empty()) return "the run has no such failure; it has none at all.";
    const auto count = std::count_if(failures.begin(), failures.end(), [&](const RunFailure& each) {
        return each.failure.kind == kind;
    });
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
    const RunFailureSearch& now = *session.alerts().search().found();
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
    c_.session.alerts().search().setFollows(interactive_ || own || !asked_.empty() ||
                                            options.session);
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
        verdict_.clear();
        c_.ui.verdict = {};
    }
    reportChange();
    if (const auto closing = std::exchange(c_.ui.verdict.closing, std::nullopt);
        closing && session.alerts().search().done())
        session.messages().say(closedText(*closing, session.alerts().search()));
    startTrials();
    if (!asked_.empty()) return showAsked();
    if (const std::string kept = c_.document.takeAlert(); !kept.empty())
        session.alerts().choose(alertNamed(session.alerts().search(), kept));
    if (fresh) chooseOfGallery();
    // Scenes and sampled points are opened to watch the run, so they open at the start.
    const bool file = !isScene(source) && !isSample(source);
    if (!fresh || !file || !interactive_ || c_.document.placed()) return;
    opened_ = openOnVerdict(c_);
}

void AlertsShown::reportChange() {
    const AlertSearch& alerts = c_.session.alerts().search();
    if (!alerts.done()) return;
    const std::string before = std::exchange(verdict_, verdictText(alerts));
    const RunSpec rules = c_.session.input().spec();
    const bool sameRules = std::exchange(rules_, rules) == rules;
    if (before.empty() || (before == verdict_ && sameRules)) return;
    // The message about the position in the new run stays.
    const std::string said = c_.session.messages().last();
    const std::string change = before == verdict_ ? "As before, " + verdict_ + "."
                                                  : "Now " + verdict_ + "; before, " + before + ".";
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
    const auto failures = session.alerts().search().failures();
    const auto rate = [&](const RunFailure& each) {
        if (each.failure.kind->name != failing->failure) return 0;
        const auto address = addressFromString(failing->address);
        if (toString(each.moments.unavoidable.event.address) == failing->address) return 3;
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
    const auto alert = alertNamed(session.alerts().search(), name);
    actions::showPart(c_, kAlertsPart);
    // At the position that was named, if one was.
    std::optional<AlertMoment> moment;
    if (!c_.document.placed()) moment = AlertMoment::Created;
    if (alert) return showAlert(c_, *alert, moment);
    status_ = Error{"--alert " + name + ": " + whyNone(session.alerts().search(), name)};
    session.messages().say(status_.error().message);
}

}  // namespace se::view
