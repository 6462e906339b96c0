#include "session.h"

#include <algorithm>

namespace se::view {

namespace {

/// A notice of at most kShortNotice bytes stays this long, each byte more adds kSignTime.
constexpr std::chrono::milliseconds kNoticeTime{3000};
constexpr std::chrono::milliseconds kSignTime{40};
constexpr std::size_t kShortNotice = 80;

}  // namespace

void Session::open(InputSpec spec) {
    opening_ = std::move(spec);
    error_.clear();
    phase_ = SessionPhase::Loading;
    loader_.begin(opening_);
}

void Session::cancelOpening() {
    loader_.cancel();
    dismissError();
    say("Opening was cancelled.");
}

void Session::adopt(Opened opened) {
    overviewThread_.reset();
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
    selection_ = {};
    marked_.clear();
    accused_ = false;
    checkup_.wait(std::move(opened.file));
    highlightedRing_ = hoveredRing_ = kNone;
    ++generation_;
    ++revision_;
    phase_ = SessionPhase::Ready;
    overviewThread_ = std::make_unique<OverviewThread>(model_);
    say(model_->cured ? "Mended: " + mendedText(*model_) + "." : model_->watch);
    missed_ = false;
    // The loader has asked for the start of the run, and has waited for the answer.
    landing_ = Landing::Last;
    target_ = {};
    takeAnswer();
}

bool Session::poll() {
    bool changed = false;
    if (auto opened = loader_.take()) {
        if (opened->ok()) {
            adopt(std::move(opened->value()));
        } else {
            error_ = opened->error().message;
            phase_ = SessionPhase::Failed;
        }
        changed = true;
    }
    if (waiting_) changed = takeAnswer() || changed;
    processMoves();
    if (overviewThread_) {
        const bool gone = overviewThread_->done();
        changed = overviewThread_->update(overview_) || changed;
        if (gone) goToAwaited();
    }
    return pollCheckup() || changed;
}

/// The doctor comes last: neither the first picture nor the run waits for it.
bool Session::pollCheckup() {
    if (!ready() || !overviewThread_ || !overviewThread_->done()) return false;
    checkup_.begin();
    if (!checkup_.poll()) return false;
    const auto found = checkup_.findings();
    accused_ =
        std::any_of(found.begin(), found.end(), [](const Finding& f) { return f.accuses(); });
    return true;
}

void Session::settle() {
    loader_.finish();
    poll();
    if (overviewThread_) overviewThread_->finish();
    poll();
    while (busy()) {
        if (waiting_) runner_->wait(std::chrono::milliseconds(200));
        poll();
    }
    checkup_.finish();
    poll();
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

std::span<const Triangle> Session::shownTriangles() const {
    if (picture_.mended) return *picture_.mended;
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
    // A long one takes longer to read.
    const std::size_t more = message_.size() > kShortNotice ? message_.size() - kShortNotice : 0;
    return now - saidAt_ < kNoticeTime + more * kSignTime ? message_ : std::string{};
}

}  // namespace se::view
