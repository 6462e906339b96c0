#include "session.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "jobs/questions.h"
#include "spiraling_edge/run/reading.h"

namespace se::view {

// One job at a time: a position that arrives while the pivot of another is made waits for it, and
// replaces one that waits already. The search for the turn, which follows, is given up for it.

namespace {

/// Pivots that are made within this time are shown in the same frame.
constexpr std::chrono::milliseconds kSameFrame{12};
/// The turn is searched up to this multiple of the way so far, and over this many spacings.
constexpr double kFarther = 1.5;
constexpr double kLeastSearched = 2.0;

/// The test at the cursor, otherwise the tests of the point at that stage.
PointDecisions decisionsAt(const Session& session, Index point) {
    const Event* event = session.event();
    if (event == nullptr) return {Stage::Pivot, point};
    const Index subject = testedPoint(*event);
    return {event->address.stage, subject != kNone ? subject : point};
}

/// The end of the way along which the turn is searched.
Vec3 farEnd(const Model& model, const Vec3& from, const Vec3& to) {
    const double way = glm::distance(from, to);
    if (way == 0.0) return from;
    const double spacing = static_cast<double>(model.spacing) / model.scale;
    return from + (std::max(kFarther * way, kLeastSearched * spacing) / way) * (to - from);
}

}  // namespace

bool PointDrag::possible(Index point) const {
    if (!session_.ready() || session_.moves().busy() || session_.showsBefore()) return false;
    if (active()) return false;
    return point < session_.model().points.size() && session_.record().pivot > 0 &&
           session_.picture().pivot != kNone && !session_.picture().repaired;
}

void PointDrag::begin(Index point) {
    assert(possible(point));
    held_ = true;
    point_ = point;
    decisions_ = decisionsAt(session_, point);
    model_ = std::make_shared<Model>(session_.shown());
    from_ = to_ = model_->points.position[point];
    open_ = session_.record_;
    openCursor_ = session_.cursor_;
    ++revision_;
    ++session_.revision_;
}

void PointDrag::moveTo(const Vec3& to) {
    assert(held_);
    if (to == to_) return;
    to_ = to;
    turn_.reset();
    model_->points.position[point_] = to;
    model_->place[point_] = model_->toView(to);
    ++revision_;
    ++session_.revision_;
    waits_ = true;
    poll();
    if (!job_.waitFor(kSameFrame)) return;
    poll();
}

/// Makes the pivot for the present position, then searches the turn on the way there.
void PointDrag::start() {
    waits_ = recordTaken_ = false;
    const auto run = session_.sharedModel();
    const Vec3 end = farEnd(*model_, from_, to_);
    job_.start([run, end, known = pivot_, number = open_->pivot, point = point_, from = from_,
                to = to_, decisions = decisions_](BackgroundJob<Made>::Results& results) {
        const auto keepGoing = [&results] { return results.report(0.5); };
        std::shared_ptr<const MovedPivot> pivot = known;
        if (!pivot) {
            auto made = MovedPivot::make(run->points, run->params, number, keepGoing);
            if (!made) return;
            pivot = std::make_shared<const MovedPivot>(std::move(*made));
        }
        results.add({pivot, pivot->record(point, to), {}, false});
        if (!results.report(0.5)) return;
        const auto share = pivot->turn(point, from, end, decisions, keepGoing);
        if (share) {
            results.add({pivot, nullptr, from + *share * (end - from), true});
        } else {
            results.add({pivot, nullptr, {}, true});
        }
    });
}

/// The event of the present record that is about the same decision.
void PointDrag::showAtSameStep() {
    const bool any = openCursor_ < open_->events.size();
    const Address at =
        any ? open_->events[openCursor_].address : Address{open_->pivot, Stage::Pivot, 0};
    const Index subject = any ? subjectOf(open_->events[openCursor_]) : kNone;
    session_.setCursor(eventLike(session_.record_->events, at, subject));
}

bool PointDrag::take() {
    std::vector<Made> fresh = job_.take().items;
    for (Made& each : fresh) {
        pivot_ = each.pivot;
        if (each.complete && !waits_) turn_ = each.turn;
        if (!each.record) continue;
        recordTaken_ = true;
        session_.record_ = std::move(each.record);
        showAtSameStep();
    }
    return !fresh.empty();
}

bool PointDrag::poll() {
    if (!active()) return false;
    const bool any = take();
    if (waits_ && recordTaken_) job_.cancel();
    if (waits_ && !job_.busy()) start();
    return any;
}

void PointDrag::waitUntilDone() {
    while (active() && busy()) {
        job_.waitUntilDone();
        poll();
    }
}

WhatIf PointDrag::release() {
    assert(held_);
    held_ = false;
    return {WhatIfKind::Move, open_->pivot, Stage::Pivot, point_, to_, {}};
}

void PointDrag::takeBack() {
    if (!active()) return;
    session_.record_ = open_;
    const std::size_t cursor = openCursor_;
    forget();
    session_.setCursor(cursor);
}

void PointDrag::forget() {
    job_.cancel();
    held_ = false;
    waits_ = false;
    model_ = nullptr;
    open_ = nullptr;
    pivot_ = nullptr;
    turn_.reset();
}

namespace {

/// A notice of at most kShortNotice bytes is shown this long; each further byte adds kSignTime.
constexpr std::chrono::milliseconds kNoticeTime{3000};
constexpr std::chrono::milliseconds kSignTime{40};
constexpr std::size_t kShortNotice = 80;

}  // namespace

void Messages::say(std::string message) {
    message_ = std::move(message);
    saidAt_ = Clock::now();
}

void Messages::sayIfAny(std::string complaint) {
    if (!complaint.empty()) say(std::move(complaint));
}

void Messages::miss(std::string message) {
    missed_ = true;
    say(std::move(message));
}

void Messages::clear() {
    message_.clear();
    missed_ = false;
}

std::string Messages::notice(Clock::time_point now) const {
    // A long message takes longer to read.
    const std::size_t more = message_.size() > kShortNotice ? message_.size() - kShortNotice : 0;
    return now - saidAt_ < kNoticeTime + more * kSignTime ? message_ : std::string{};
}

void Highlights::mark(std::vector<Index> points, std::vector<EvidenceLine> lines) {
    if (marked_ == points && lines_ == lines) return;
    marked_ = std::move(points);
    lines_ = std::move(lines);
    ++revision_;
}

void Highlights::chooseRing(Index ring) {
    chosenRing_ = chosenRing_ == ring ? kNone : ring;
    ++revision_;
}

Session::Session() : moves_(*this), drag_(*this), questions_(std::make_unique<Questions>()) {}

Session::~Session() = default;

void Session::open(RunSpec spec) { input_.open(std::move(spec)); }

void Session::rerun(const RunSpec& rules, Resume resume) {
    const bool opens = input_.phase() == SessionPhase::Loading && !input_.isRerun();
    if (!ready() || opens) return;
    moves_.cancel();
    const Event* at = event();
    const bool end = resume == Resume::End || atEnd();
    input_.rerun(rules, model_, {address(), at != nullptr ? subjectOf(*at) : kNone, end});
}

void Session::cancelOpening() {
    input_.cancel();
    drag_.takeBack();
    dismissError();
    messages_.say(input_.isRerun() ? "Cancelled: the run is unchanged." : "Opening was cancelled.");
}

/// The old run stays if a new one is refused.
void Session::fail(std::string why) {
    drag_.takeBack();
    if (!input_.isRerun()) return input_.fail(std::move(why));
    dismissError();
    messages_.say(std::move(why));
}

void Session::keepFinishedMesh(const Opened& opened) {
    const bool same = ready() && atEnd() && !before_ &&
                      input_.spec().source == input_.opening().source &&
                      model_->points.position == opened.model->points.position;
    earlier_ = {};
    if (!same) return;
    const std::span<const Triangle> shown = shownTriangles();
    earlier_.triangles = std::make_shared<const std::vector<Triangle>>(shown.begin(), shown.end());
    if (const RunFailureSearch* found = alerts_.found())
        earlier_.faults = std::make_shared<const RunFailureSearch>(*found);
    earlier_.place = alerts_.place();
}

void Session::adopt(Opened opened) {
    keepFinishedMesh(opened);
    stopRunner();
    drag_.forget();
    model_ = std::move(opened.model);
    moved_ = std::move(opened.moved);
    record_.reset();
    triangles_.clear();
    meshIndex_ = {};
    overview_ = {};
    picture_ = {};
    input_.adopt(opened);
    if (!opened.place) {
        selection_ = {};
        highlights_.mark({});
    }
    highlights_.clearRings();
    if (opened.file) {
        problemFound_ = false;
        doctorJob_.enqueue(std::move(opened.file));
    }
    hits_.open(model_);
    watches_.open(model_);
    alerts_.open(model_);
    questions_->open(model_, input_.file(), withFixesAsOptions(input_.spec()));
    trials_.open(input_.file(), withFixesAsOptions(input_.spec()));
    ++generation_;
    ++revision_;
    const std::string notice = messages_.notice();
    const std::string changes = changesText(*model_);
    messages_.say(changes.empty() ? model_->watch : changes);
    messages_.forgetMiss();
    // The loader has requested the start of the run, and has waited for the answer.
    runner_ = std::move(opened.runner);
    moves_.open(opened.place);
    if (!opened.place) return;
    const bool undone = notice.starts_with("Undone:") || notice.starts_with("Redone:");
    messages_.say((undone ? notice + " " : "") + describe(*opened.place, address()));
}

/// A slice of work of the old run may take a while: nobody waits for its end.
void Session::stopRunner() {
    if (!runner_) return;
    runner_->stop();
    stopped_.push_back(std::move(runner_));
}

std::shared_ptr<const RunEnd> Session::runEnd() const { return runner_ ? runner_->end() : nullptr; }

double Session::madeShare() const {
    if (isMade()) return 1.0;
    // A closed surface has two triangles per point.
    const double expected =
        2.0 * static_cast<double>(std::max<std::size_t>(1, model_->points.size()));
    const double made = overview_.triangles.empty() ? 0.0 : overview_.triangles.back();
    return std::min(1.0, made / expected);
}

bool Session::poll() {
    bool changed = false;
    if (auto opened = input_.take()) {
        if (opened->ok()) {
            adopt(std::move(opened->value()));
        } else {
            fail(opened->error().message);
        }
        changed = true;
    }
    changed = moves_.poll() || changed;
    changed = drag_.poll() || changed;
    std::erase_if(stopped_, [](const auto& runner) { return runner->ended(); });
    if (runner_) {
        const bool made = runner_->made();
        changed = runner_->takeOverview(overview_) || changed;
        if (made) messages_.sayIfAny(runner_->takeComplaint());
        if (made) moves_.goToAwaited();
    }
    changed = questions_->poll() || changed;
    changed = hits_.poll() || changed;
    changed = watches_.poll() || changed;
    messages_.sayIfAny(hits_.takeComplaint());
    messages_.sayIfAny(watches_.takeComplaint());
    moves_.goToAwaitedStop();
    return pollLast() || changed;
}

/// Doctor and alerts come last: neither the first picture nor the run waits for them. They come one
/// after the other, since each takes hundreds of megabytes for a million points.
bool Session::pollLast() {
    if (!ready() || !runner_->made()) return false;
    doctorJob_.start();
    const bool examined = doctorJob_.poll();
    if (examined && doctorJob_.done()) doctorJob_.tryFixes();
    const bool tried = doctorJob_.pollFixes();
    if (!doctorJob_.busy()) alerts_.start(runner_->end());
    const bool alerted = alerts_.poll();
    const bool news = trials_.poll() || alerted || tried;
    if (!examined) return news;
    const auto found = doctorJob_.findings();
    problemFound_ =
        std::any_of(found.begin(), found.end(), [](const Finding& f) { return f.isProblem(); });
    return true;
}

void Session::waitUntilDone() {
    input_.waitUntilDone();
    poll();
    if (runner_) runner_->waitUntilMade();
    hits_.waitUntilDone();
    watches_.waitUntilDone();
    poll();
    while (moves_.busy()) {
        moves_.wait();
        if (moves_.awaitsStop()) hits_.waitUntilDone();
        poll();
    }
    drag_.waitUntilDone();
    doctorJob_.waitUntilDone();
    poll();
    questions_->waitUntilDone();
    alerts_.waitUntilDone();
    trials_.waitUntilDone();
    poll();
}

/// Takes over what the runner thread has seen.
void Session::take(RunnerAnswer& answer) {
    triangles_.insert(triangles_.end(), answer.newTriangles.begin(), answer.newTriangles.end());
    meshIndex_.append(*model_, triangles_);
    if (!answer.record) return;
    drag_.forget();
    record_ = answer.record;
}

const Model& Session::shown() const {
    if (drag_.active()) return drag_.model();
    const Model* found = model_.get();
    for (const MovedModel& each : moved_) {
        if (record_ != nullptr && each.from <= record_->pivot) found = each.model.get();
    }
    return *found;
}

void Session::select(const Selection& selection) {
    if (selection_ == selection) return;
    selection_ = selection;
    ++revision_;
}

std::span<const Triangle> Session::shownTriangles() const {
    if (picture_.repaired) return *picture_.repaired;
    const std::size_t shown = picture_.finishedTriangles + picture_.newTriangles.size();
    return std::span(triangles_).first(std::min(shown, triangles_.size()));
}

void Session::setCursor(std::size_t cursor) {
    if (horizon_ && record_->pivot == horizon_->pivot)
        cursor = std::min(cursor, record_->find(*horizon_).value_or(cursor));
    cursor_ = cursor;
    picture_ = before_ ? replay().before(cursor_) : replay().after(cursor_);
    if (showsEarlierMesh()) picture_.repaired = earlier_.triangles;
    ++revision_;
}

void Session::setCursorToLast() {
    setCursor(record_->events.empty() ? 0 : record_->events.size() - 1);
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

RunPosition Session::place() const {
    if (event() == nullptr) return {record_ ? record_->pivot : 0, 0};
    return {record_->pivot, static_cast<std::uint32_t>(cursor_)};
}

bool Session::atEnd() const {
    return ready() && atLastPivot() && cursor_ + 1 >= record_->events.size();
}

bool Session::atLastPivot() const {
    return record_->isLast || (overview_.complete && record_->pivot >= overview_.lastPivot);
}

bool Session::reached(const Address& address) const {
    if (!ready() || record_->pivot != address.pivot)
        return ready() && record_->pivot > address.pivot;
    const bool whole = address.stage == Stage::Pivot && address.n == 0;
    const auto place = whole ? std::nullopt : record_->find(address);
    return cursor_ >= place.value_or(record_->events.empty() ? 0 : record_->events.size() - 1);
}

std::optional<Address> Session::nextMark(int direction) const {
    if (!ready()) return std::nullopt;
    // The start comes before all events.
    const Address here = event() != nullptr ? address() : Address{0, Stage{}, 0};
    const auto isBeyond = [direction](const Address& a, const Address& b) {
        return direction > 0 ? isBefore(b, a) : isBefore(a, b);
    };
    std::optional<Address> best;
    for (const RunMark& mark : overview_.marks) {
        const Address place{mark.pivot, stageOf(mark.kind), mark.n};
        if (isBeyond(place, here) && (!best || isBeyond(*best, place))) best = place;
    }
    return best;
}

std::span<const LiveFailure> Session::noticedHere() const {
    if (event() == nullptr || before_) return {};
    return failuresAt(overview_, address());
}

std::string Session::noticedText() const {
    const auto noticed = noticedHere();
    if (noticed.empty()) return {};
    const std::size_t others = noticed.size() - 1;
    return " Alert: " + describe(noticed.front()) +
           (others > 0 ? " +" + std::to_string(others) + " more." : "");
}

}  // namespace se::view
