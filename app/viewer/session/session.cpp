#include "session.h"

#include <algorithm>

#include "jobs/questions.h"

namespace se::view {

namespace {

/// A notice of at most kShortNotice bytes is shown this long; each further byte adds kSignTime.
constexpr std::chrono::milliseconds kNoticeTime{3000};
constexpr std::chrono::milliseconds kSignTime{40};
constexpr std::size_t kShortNotice = 80;

}  // namespace

Session::Session() : questions_(std::make_unique<Questions>()) {}

Session::~Session() = default;

void Session::open(InputSpec spec) {
    anew_ = false;
    opening_ = std::move(spec);
    error_.clear();
    phase_ = SessionPhase::Loading;
    loader_.start(opening_);
}

void Session::runAnew(const RuleSet& rules, Resume resume) {
    if (!ready() || (phase_ == SessionPhase::Loading && !anew_)) return;
    cancelMove();
    anew_ = true;
    anewSince_ = Clock::now();
    opening_ = withRules(spec_, rules);
    error_.clear();
    phase_ = SessionPhase::Loading;
    const Event* at = event();
    const bool end = resume == Resume::End || atEnd();
    loader_.start(opening_,
                  {model_, spec_, {address(), at != nullptr ? subjectOf(*at) : kNone, end}});
}

const std::string& Session::whatIfProblem(std::size_t i) const {
    static const std::string none;
    return i < whatIfProblems_.size() ? whatIfProblems_[i] : none;
}

const Model& Session::shown() const {
    const Model* found = model_.get();
    for (const MovedModel& each : moved_) {
        if (record_ != nullptr && each.from <= record_->pivot) found = each.model.get();
    }
    return *found;
}

void Session::cancelOpening() {
    loader_.cancel();
    dismissError();
    say(anew_ ? "Cancelled: the run is unchanged." : "Opening was cancelled.");
}

/// The old run stays if a new one is refused.
void Session::fail(std::string why) {
    if (anew_) {
        dismissError();
        return say(std::move(why));
    }
    error_ = std::move(why);
    phase_ = SessionPhase::Failed;
}

void Session::adopt(Opened opened) {
    overviewJob_.reset();
    runner_ = std::move(opened.runner);
    model_ = std::move(opened.model);
    spec_ = opening_;
    record_.reset();
    triangles_.clear();
    meshIndex_ = {};
    overview_ = {};
    picture_ = {};
    moves_.clear();
    waiting_ = false;
    awaitedShare_.reset();
    awaitedStop_ = 0;
    whatIfProblems_ = std::move(opened.whatIfs);
    moved_ = std::move(opened.moved);
    if (!opened.place) {
        selection_ = {};
        marked_.clear();
    }
    if (opened.given) file_ = std::move(opened.given);
    if (opened.file) {
        problemFound_ = false;
        doctorJob_.enqueue(std::move(opened.file));
    }
    questions_->open(model_);
    hits_.open(model_);
    watches_.open(model_);
    alerts_.enqueue(model_);
    alert_.reset();
    remedies_.cancel();
    alertNews_ = false;
    highlightedRing_ = hoveredRing_ = kNone;
    ++generation_;
    ++revision_;
    phase_ = SessionPhase::Ready;
    overviewJob_ = std::make_unique<OverviewJob>(model_);
    const std::string said = notice();
    say(model_->fixed ? "Repaired: " + fixesText(*model_) + "." : model_->watch);
    missed_ = false;
    // The loader has requested the start of the run, and has waited for the answer.
    landing_ = opened.place ? Landing::AtSamePosition : Landing::Last;
    if (opened.place) samePosition_ = *opened.place;
    target_ = {};
    takeAnswer();
    if (opened.place) {
        const bool undone = said.starts_with("Undone:") || said.starts_with("Redone:");
        say((undone ? said + " " : "") + describe(samePosition_, address()));
    }
}

bool Session::poll() {
    bool changed = false;
    if (auto opened = loader_.take()) {
        if (opened->ok()) {
            adopt(std::move(opened->value()));
        } else {
            fail(opened->error().message);
        }
        changed = true;
    }
    if (waiting_) changed = takeAnswer() || changed;
    processMoves();
    if (overviewJob_) {
        const bool gone = overviewJob_->done();
        changed = overviewJob_->poll(overview_) || changed;
        if (gone) sayIfAny(overviewJob_->takeComplaint());
        if (gone) goToAwaited();
    }
    changed = questions_->poll() || changed;
    changed = hits_.poll() || changed;
    changed = watches_.poll() || changed;
    sayIfAny(hits_.takeComplaint());
    sayIfAny(watches_.takeComplaint());
    goToAwaitedStop();
    return pollDoctor() || changed;
}

/// Doctor and alerts come last: neither the first picture nor the run waits for them.
bool Session::pollDoctor() {
    if (!ready() || !overviewJob_ || !overviewJob_->done()) return false;
    doctorJob_.start();
    alerts_.start();
    const bool alerted = alerts_.poll();
    alertNews_ = alertNews_ || alerted;
    const bool tried = remedies_.poll();
    if (!doctorJob_.poll()) return alerted || tried;
    const auto found = doctorJob_.findings();
    problemFound_ =
        std::any_of(found.begin(), found.end(), [](const Finding& f) { return f.isProblem(); });
    return true;
}

void Session::waitUntilDone() {
    loader_.waitUntilDone();
    poll();
    if (overviewJob_) overviewJob_->waitUntilDone();
    hits_.waitUntilDone();
    watches_.waitUntilDone();
    poll();
    while (busy()) {
        if (waiting_) runner_->waitFor(std::chrono::milliseconds(200));
        if (awaitsStop()) hits_.waitUntilDone();
        poll();
    }
    doctorJob_.waitUntilDone();
    questions_->waitUntilDone();
    alerts_.waitUntilDone();
    remedies_.waitUntilDone();
    poll();
}

void Session::sayIfAny(std::string complaint) {
    if (!complaint.empty()) say(std::move(complaint));
}

void Session::miss(std::string message) {
    missed_ = true;
    say(std::move(message));
}

void Session::setCursor(std::size_t cursor) {
    cursor_ = cursor;
    picture_ = before_ ? makePictureBefore(*record_, cursor_) : makePicture(*record_, cursor_);
    ++revision_;
}

void Session::showBefore(bool on) {
    if (before_ == on) return;
    before_ = on;
    if (ready()) setCursor(cursor_);
}

std::optional<Stage> Session::stage() const {
    if (!ready() || !picture_.event) return std::nullopt;
    return picture_.event->address.stage;
}

const Event* Session::event() const {
    return ready() && cursor_ < record_->events.size() ? &record_->events[cursor_] : nullptr;
}

Address Session::address() const {
    const Event* at = event();
    return at != nullptr ? at->address : Address{record_ ? record_->pivot : 0, Stage::Pivot, 0};
}

void Session::select(const Selection& selection) {
    if (selection_ == selection) return;
    selection_ = selection;
    ++revision_;
}

void Session::mark(std::vector<Index> points) {
    if (marked_ == points) return;
    marked_ = std::move(points);
    ++revision_;
}

void Session::chooseAlert(std::optional<std::size_t> alert) {
    if (alert_ == alert) return;
    alert_ = alert;
    ++revision_;
}

void Session::seekRemedies() { remedies_.start(model_, *alert_, alert()->failure); }

std::span<const LiveFailure> Session::noticedHere() const {
    if (event() == nullptr || before_) return {};
    return failuresAt(overview_, address());
}

std::string Session::noticedText() const {
    std::string text;
    for (const LiveFailure& each : noticedHere()) text += " Alert: " + describe(each);
    return text;
}

std::span<const Triangle> Session::shownTriangles() const {
    if (picture_.repaired) return *picture_.repaired;
    const std::size_t shown = picture_.finishedTriangles + picture_.newTriangles.size();
    return std::span(triangles_).first(std::min(shown, triangles_.size()));
}

void Session::hover(Index point) {
    if (point == hovered_) return;
    hovered_ = point;
    ++revision_;
}

void Session::highlightRing(Index ring) {
    highlightedRing_ = highlightedRing_ == ring ? kNone : ring;
    ++revision_;
}

void Session::hoverRing(Index ring) {
    if (ring == hoveredRing_) return;
    hoveredRing_ = ring;
    ++revision_;
}

void Session::say(std::string message) {
    message_ = std::move(message);
    saidAt_ = Clock::now();
}

std::string Session::notice(Clock::time_point now) const {
    // A long message takes longer to read.
    const std::size_t more = message_.size() > kShortNotice ? message_.size() - kShortNotice : 0;
    return now - saidAt_ < kNoticeTime + more * kSignTime ? message_ : std::string{};
}

}  // namespace se::view
