// A step takes several frames: its input is opened, then the cursor goes to its position
// (entering_), then names, layers, horizon, comparison and camera of the step are set (enter()).
// What a step changes of the user's choices, it puts back when it is left (leaveStep()).

#include "lesson_player.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "compare/compared_runs.h"
#include "document/actions.h"
#include "document/ui_state.h"
#include "run/packed_file.h"
#include "session/view_position.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/lists.h"
#include "teach/embedded_lessons.h"
#include "teach/lesson_read.h"
#include "teach/lesson_skeleton.h"
#include "teach/practice.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

/// The input as it stands in a lesson in `folder`.
Result<std::string> inputFrom(const std::filesystem::path& folder, const std::string& source) {
    if (isSample(source) || isStandardInput(source) || isPacked(source))
        return Error{"A lesson begins with a scene or a file: save the points first."};
    if (isScene(source) || isPractice(source)) return source;
    const std::string input = std::filesystem::proximate(source, folder).generic_string();
    if (!input.starts_with("..")) return input;
    return Error{"The points of a lesson lie in its folder or below it: save it beside " + source +
                 "."};
}

/// The text of a lesson in `folder`: `notes` as its introduction, and a step for each bookmark.
/// Fails if the input could not be found from there. Requires a bookmark.
Result<std::string> lessonOfBookmarks(const RunSpec& spec, const Annotations& annotations,
                                      const std::filesystem::path& folder) {
    const Result<std::string> input = inputFrom(folder, spec.source);
    if (!input) return input.error();
    std::vector<teach::NotedPosition> positions;
    for (const Bookmark& each : annotations.bookmarks)
        positions.push_back({toString(each.address), each.note,
                             each.camera ? toText(ViewPosition{"", each.camera}) : std::string{}});
    return teach::lessonOfNotes(input.value(), spec, annotations.notes, positions);
}

/// Time in which an answer is shown, decision by decision.
constexpr double kSecondsOfAnswer = 8.0;
/// Maximum number of decisions that are played.
constexpr std::size_t kMaxShown = 400;
/// Entry of the state for the seed of the last pivot to play.
constexpr std::string_view kPracticeEntry = "practice";

/// Writes a file, and says so, or why not.
void saveText(Session& session, const std::string& file, const Result<std::string>& text) {
    const Status written = text ? writeFileAtomically(file, text.value()) : Status(text.error());
    session.messages().say(written ? "Saved " + file + "." : written.error().message);
}

}  // namespace

void LessonPlayer::begin(const Options& options) {
    resultFile_ = options.resultFile;
    const KeptState kept = c_.document.kept().read();
    const auto last = kept.lessons.find(std::string(kPracticeEntry));
    if (last != kept.lessons.end()) panel().nextPractice = last->second + 1;
    layoutGiven_ = options.layout.has_value();
    resultSource_ = options.lesson;
    if (!options.lesson.empty()) open(options.lesson, options.lessonStep);
}

void LessonPlayer::open(const std::string& source, std::optional<std::size_t> step) {
    toStep_ = step;
    watch_.begin(source);
    opening_.start([source](const Progress& progress) { return openLesson(source, progress); });
}

void LessonPlayer::waitUntilDone() {
    opening_.waitUntilDone();
    poll();
    for (int i = 0; i < 3; ++i) {
        c_.session.waitUntilDone();
        c_.document.poll();
        poll();
    }
}

bool LessonPlayer::poll() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> passed = now - std::exchange(polled_, now);
    bool changed = false;
    if (opening_.poll()) {
        changed = true;
        // If it failed, the lesson before stays.
        c_.session.messages().sayIfAny(opening_.complaint());
        if (auto lesson = opening_.takeAnswer()) take(std::move(*lesson));
    }
    if (!walk().isOpen()) return changed;
    watchFile();
    if (entering_ && !isUnderWay()) {
        changed = true;
        arrive();
        if (!walk().isOpen()) return true;
    }
    if (walk().asks()) walk().addSeconds(passed.count());
    const bool takes = walk().takesPoints() && !entering_ && hasInput();
    if (takes) c_.session.highlights().mark(walk().givenPoints());
    c_.session.highlights().label(takes ? possiblePoints() : std::vector<Index>{});
    panel().away = isAway();
    return changed;
}

/// Points that can be an answer: the neighbors of the pivot, after the sort without those that are
/// DONE, which it has left out; of a pivot to play, those beside it on the ring as well.
std::vector<Index> LessonPlayer::possiblePoints() const {
    const DecisionState& picture = c_.session.picture();
    if (picture.pivot == kNone) return {};
    const auto& neighbors = c_.session.shown().points.neighbors[picture.pivot];
    std::vector<Index> points(neighbors.begin(), neighbors.end());
    if (picture.event && picture.event->address.stage > Stage::Sort)
        std::erase_if(points, [&](Index point) { return picture.status[point] == kDone; });
    if (c_.ui.lesson.walk.question()->kind != "play" || picture.rings.empty()) return points;
    const std::vector<Index>& ring = picture.rings.front().points;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (ring[i] != picture.pivot) continue;
        points.push_back(ring[(i + ring.size() - 1) % ring.size()]);
        points.push_back(ring[(i + 1) % ring.size()]);
    }
    return points;
}

void LessonPlayer::take(SharedLesson lesson) {
    const bool again = walk().isOpen() && walk().source() == lesson->source;
    const std::size_t kept = again ? walk().step() : keptStep(*lesson);
    if (walk().isOpen()) leaveStep();
    c_.ui.offersTour = false;
    if (!layoutBefore_) layoutBefore_ = c_.ui.layoutPreset;
    walk().open(std::move(lesson), kept);
    const std::optional<LayoutPreset> layout = layoutPresetFromName(walk().lesson().layout);
    const bool stays =
        c_.ui.layoutPreset == LayoutPreset::Present || std::exchange(layoutGiven_, false) || again;
    if (!stays) actions::applyLayoutPreset(c_, layout.value_or(LayoutPreset::Debug));
    c_.ui.follow = Follow::EachDecision;
    c_.ui.column.choose(Task::Lesson);
    if (isLessonFile(walk().source())) c_.document.note(walk().source());
    goTo(std::exchange(toStep_, std::nullopt).value_or(kept));
}

/// The step that was shown last; the first one of a lesson that was read to its end.
std::size_t LessonPlayer::keptStep(const OpenedLesson& lesson) const {
    const KeptState state = c_.document.kept().read();
    const auto found = state.lessons.find(lesson.source);
    const bool inside =
        found != state.lessons.end() && found->second + 1 < lesson.lesson.steps.size();
    return inside ? found->second : 0;
}

/// Of pivots to play the last seed is kept.
void LessonPlayer::keepStep() {
    const auto seed = teach::practiceSeed(walk().source());
    const std::string source = seed ? std::string(kPracticeEntry) : walk().source();
    const std::size_t number = seed ? static_cast<std::size_t>(*seed) : walk().step();
    if (seed) panel().nextPractice = *seed + 1;
    // Its source is its text.
    if (isPacked(source)) return;
    c_.document.keep([&](KeptState& state) { state.lessons[source] = number; });
}

/// The file is read again when it has changed.
void LessonPlayer::watchFile() {
    if (opening_.busy() || !isLessonFile(walk().source())) return;
    // Another lesson was refused.
    if (watch_.path() != walk().source()) watch_.begin(walk().source());
    if (watch_.hasChanged()) open(walk().source());
}

/// The open run is that of the step.
bool LessonPlayer::hasInput() const {
    return c_.session.ready() && c_.session.input().phase() == SessionPhase::Ready &&
           c_.session.input().spec() == input_;
}

/// An input is being opened, or the cursor moves.
bool LessonPlayer::isUnderWay() const {
    return c_.session.input().phase() == SessionPhase::Loading || c_.document.arriving() ||
           c_.session.moves().busy();
}

/// Whether the cursor is at the position of the step, as far as that is an address of a decision.
bool LessonPlayer::isAtStep() const {
    const auto at = addressFromString(c_.ui.lesson.walk.setting().at);
    if (!at || at->stage == Stage::Pivot) return true;
    const PivotRecord& record = c_.session.record();
    return record.pivot == at->pivot && record.find(*at) == c_.session.cursor();
}

/// The run has come to rest: at the step, or the opening failed or was cancelled, or the user moved
/// meanwhile.
void LessonPlayer::arrive() {
    if (!c_.session.ready()) return leave();
    if (hasInput() && !isAtStep() && !std::exchange(retried_, true)) {
        (void)c_.session.moves().goToText(walk().setting().at);
        return;
    }
    entering_ = false;
    if (hasInput()) enter();
}

/// False if the step has no input, or its run not the position.
bool LessonPlayer::goTo(std::size_t step) {
    leaveStep();
    playsOnArrival_ = false;
    if (step != walk().step()) panel().countsHands = false;
    walk().goTo(step);
    keepStep();
    const Result<RunSpec> input = inputOfStep(walk().setting(), walk().folder());
    if (!input) {
        c_.session.messages().say(input.error().message);
        return false;
    }
    input_ = input.value();
    entering_ = true;
    retried_ = false;
    fresh_ = !hasInput();
    const std::string at = walk().setting().at.empty() ? "0" : walk().setting().at;
    if (fresh_) {
        c_.document.openStep(input_, at);
        return true;
    }
    const Status moved = c_.session.moves().goToText(at);
    if (!moved) c_.session.messages().say(moved.error().message);
    return moved.ok();
}

void LessonPlayer::enter() {
    Session& session = c_.session;
    const teach::LessonStep& step = walk().shownStep();
    home_ = session.address();
    walk().setPointCount(session.model().points.size());
    session.alerts().choose(std::nullopt);
    step_.enter(walk());
    aiming_ = true;
    const bool plays = std::exchange(playsOnArrival_, false);
    if (walk().asks()) {
        session.setHorizon(home_);
        if (c_.ui.layoutPreset == LayoutPreset::Compare) c_.ui.layoutPreset = LayoutPreset::Debug;
        return;
    }
    if (walk().state().shown) return show();
    if (!step.compare.empty()) step_.compare(walk());
    if (step.play || plays) playStep();
}

void LessonPlayer::leaveStep() {
    step_.leave();
    entering_ = aiming_ = false;
}

/// Plays from the cursor to `until`, at the speed of the step.
void LessonPlayer::playTo(const Address& until) {
    const std::optional<teach::PlaySpeed>& speed = walk().shownStep().play;
    const double usual = walk().question() == nullptr
                             ? 2.0
                             : static_cast<double>(walk().right().shown.size()) / kSecondsOfAnswer;
    home_ = until;
    step_.play(speed ? unitFromName(speed->unit).value_or(PlayUnit::SubStep) : PlayUnit::SubStep,
               speed ? speed->perSecond : std::max(2.0, usual), until);
}

/// Plays from the position of the step to its end.
void LessonPlayer::playStep() {
    const std::string& place = walk().setting().answerPlace;
    const auto until = addressFromString(place);
    if (until && !c_.session.reached(*until)) return playTo(*until);
    // A share of the run, such as 100%.
    if (!until && !place.empty()) (void)c_.session.moves().goToText(place);
}

/// Goes through the decisions from the question to its answer.
void LessonPlayer::show() {
    c_.session.setHorizon(std::nullopt);
    const std::vector<Event>& decisions = walk().right().shown;
    if (decisions.empty()) return;
    const Address until = decisions.back().address;
    home_ = until;
    if (walk().shownStep().frame == "all") aiming_ = true;
    if (!walk().shownStep().compare.empty()) step_.compare(walk());
    if (c_.session.reached(until)) return;
    if (!walk().shownStep().play && decisions.size() > kMaxShown)
        return c_.session.moves().playTo(until);
    playTo(until);
}

bool LessonPlayer::isAway() const {
    if (entering_ || c_.playback.playing() || isUnderWay()) return false;
    const LessonWalk& walk = c_.ui.lesson.walk;
    return !hasInput() || (home_ && c_.session.address() != *home_ && !walk.asks());
}

bool LessonPlayer::takeAim() {
    // Playback follows the pivot: all of an answer is framed at its end.
    if (aiming_ && walk().question() != nullptr && c_.playback.playing() &&
        walk().shownStep().frame == "all")
        return false;
    return aiming_ && !isUnderWay() && std::exchange(aiming_, false);
}

void LessonPlayer::aim() {
    const teach::LessonStep& step = walk().shownStep();
    const bool own = fresh_ || step.frame == "all" || !step.camera.empty() ||
                     teach::viewDirection(walk().setting());
    if (own && step_.aim(walk())) return;
    moveToDecision(c_, CameraMove::Kind::Requested);
}

void LessonPlayer::follow(const std::string& address) {
    c_.playback.pause();
    const Status moved = c_.session.moves().goToText(address);
    if (!moved) return c_.session.messages().say(moved.error().message);
    c_.ui.frame = FrameRequest::Decision;
}

void LessonPlayer::saveResult(const std::string& file) {
    if (!walk().isOpen()) return c_.session.messages().say(kNoLesson);
    saveText(c_.session, file, resultJson(walk().result()));
}

void LessonPlayer::save() {
    const bool asked = !resultFile_.empty() && walk().source() == resultSource_;
    if (!asked || !walk().hasAnswers()) return;
    const Status written = writeFileAtomically(resultFile_, resultJson(walk().result()));
    if (!written) c_.session.messages().say(written.error().message);
}

void LessonPlayer::saveLesson(const std::string& file) {
    if (!c_.session.ready()) return c_.session.messages().say("There is nothing open to save.");
    saveText(c_.session, file,
             lessonOfBookmarks(c_.session.input().spec(), annotationsOf(c_.ui),
                               std::filesystem::path(file).parent_path()));
}

void LessonPlayer::close() {
    whileOpen([this] { leave(); });
}

void LessonPlayer::leave() {
    opening_.cancel();
    leaveStep();
    if (layoutBefore_) c_.ui.layoutPreset = *std::exchange(layoutBefore_, std::nullopt);
    c_.ui.follow = followIn(c_.ui.layoutPreset);
    c_.ui.column.reset();
    const std::uint64_t next = panel().nextPractice;
    panel() = {};
    panel().nextPractice = next;
}

void LessonPlayer::closeForOther() {
    if (walk().isOpen() || opening_.busy()) leave();
}

/// Makes the call between two frames, unless the lesson is closed by then.
void LessonPlayer::whileOpen(const std::function<void()>& call) {
    c_.ui.betweenFrames([this, call] {
        if (walk().isOpen()) call();
    });
}

void LessonPlayer::toStep(std::size_t step) {
    whileOpen([this, step] {
        if (step < walk().lesson().steps.size()) goTo(step);
    });
}

void LessonPlayer::next() {
    if (!walk().isOpen()) return;
    if (c_.ui.layoutPreset == LayoutPreset::Present && walk().asks()) return showAnswer();
    if (walk().step() + 1 < walk().lesson().steps.size()) return toStep(walk().step() + 1);
    c_.session.messages().say("This is the last step of the lesson.");
}

void LessonPlayer::previous() {
    if (!walk().isOpen()) return;
    if (walk().step() > 0) return toStep(walk().step() - 1);
    c_.session.messages().say("This is the first step of the lesson.");
}

void LessonPlayer::returnToStep() {
    whileOpen([this] { goTo(walk().step()); });
}

void LessonPlayer::play() {
    whileOpen([this] { playsOnArrival_ = goTo(walk().step()); });
}

void LessonPlayer::answer() {
    whileOpen([this] {
        if (walk().asks()) walk().answer(), conclude();
    });
}

void LessonPlayer::showAnswer() {
    whileOpen([this] {
        if (walk().asks()) walk().showAnswer(), conclude();
    });
}

/// Keeps what was answered, and shows the right answer once the question is closed.
void LessonPlayer::conclude() {
    save();
    if (!walk().asks()) show();
}

void ShownStep::enter(const LessonWalk& walk) {
    const teach::LessonStep& step = walk.shownStep();
    std::vector<Index> points;
    points.reserve(step.select.size());
    for (const std::string& word : step.select)
        points.push_back(teach::pointOf(word, walk.setting().names));
    c_.session.giveNames(walk.setting().names);
    c_.session.select(Selection::of(points));
    for (const Layer& layer : layers()) {
        LayerMode& mode = modeOf(c_.ui.settings.layers, layer.id);
        const bool hides = isAmong(layer.name, step.hide);
        if (!hides && !isAmong(layer.name, step.pin)) continue;
        layers_.emplace_back(layer.id, mode);
        mode = hides ? LayerMode::PinnedOff : LayerMode::PinnedOn;
    }
}

Status ShownStep::aim(const LessonWalk& walk) {
    const teach::LessonStep& step = walk.shownStep();
    if (step.camera.empty()) {
        frameStep(c_, step.frame == "all", teach::viewDirection(walk.setting()));
        return success();
    }
    const Result<ViewPosition> place = viewPositionFromText(step.camera);
    if (!place || !place.value().camera)
        return Error{"expected a position with its address, as Ctrl+C copies it"};
    c_.camera.setPose(*place.value().camera);
    return success();
}

void ShownStep::play(PlayUnit unit, double rate, const Address& until) {
    if (!speed_) speed_ = c_.playback.speed();
    c_.playback.setUnit(unit);
    c_.playback.setRate(rate);
    c_.playback.play();
    c_.playback.until = until;
}

void ShownStep::compare(const LessonWalk& walk) {
    compares_ = true;
    c_.ui.compare.inPresent = true;
    if (c_.ui.layoutPreset != LayoutPreset::Present) {
        if (!layout_) layout_ = c_.ui.layoutPreset;
        c_.ui.layoutPreset = LayoutPreset::Compare;
    }
    // Both could be read: the lesson has no faults.
    const RunSpec input = inputOfStep(walk.setting(), walk.folder()).value();
    c_.compare.begin(
        CompareWith::otherRun(otherRun(input, changeFromWords(walk.shownStep().compare).value())));
}

void ShownStep::leave() {
    c_.session.setHorizon(std::nullopt);
    c_.session.giveNames({});
    c_.session.highlights().mark({});
    c_.session.highlights().label({});
    putBackChoices();
}

LayerModes ShownStep::layersOfUser() const {
    LayerModes modes = c_.ui.settings.layers;
    for (const auto& [layer, mode] : layers_) modeOf(modes, layer) = mode;
    return modes;
}

void ShownStep::putBackChoices() {
    c_.ui.settings.layers = layersOfUser();
    layers_.clear();
    c_.playback.pause();
    if (speed_) c_.playback.setSpeed(*std::exchange(speed_, std::nullopt));
    if (!std::exchange(compares_, false)) return;
    c_.compare.stop();
    c_.ui.compare.inPresent = false;
    const auto before = std::exchange(layout_, std::nullopt);
    // The user may have chosen another layout meanwhile.
    if (!before || c_.ui.layoutPreset != LayoutPreset::Compare) return;
    c_.ui.layoutPreset = *before;
    c_.ui.column.choose(Task::Lesson);
}

bool isAllowedDuringQuestion(const Command& command) {
    constexpr std::array<std::string_view, 3> kGroups = {"View", "Layers", "Help"};
    constexpr std::array<std::string_view, 13> kOthers = {
        "file.open",           "file.screenshot", "file.quit",           "step.pivot.next",
        "step.pivot.previous", "step.event.next", "step.event.previous", "step.pivot.finish",
        "run.start",           "lesson.next",     "lesson.previous",     "lesson.return",
        "lesson.close"};
    if (command.id == "view.layout.compare") return false;
    return isAmong(command.group, kGroups) || isAmong(command.id, kOthers);
}

namespace {

/// Adds a sign to the number that is the answer. One that was wrong is replaced by the next.
bool typeNumber(int key, LessonWalk& walk) {
    const bool sign = (key >= '0' && key <= '9') || key == '.' || key == '-';
    if (!sign && key != key::kBackspace) return false;
    std::string typed = walk.state().grade ? std::string{} : walk.state().typed;
    if (sign)
        typed += static_cast<char>(key);
    else if (!typed.empty())
        typed.pop_back();
    walk.type(std::move(typed));
    return true;
}

}  // namespace

bool answerByKey(const KeyChord& chord, CommandContext& context) {
    LessonPanel& panel = context.ui.lesson;
    if (chord.mods != kNoMods || !panel.hides() || panel.countsHands) return false;
    LessonWalk& walk = panel.walk;
    if (chord.key == key::kEnter || chord.key == key::kKeypadEnter) {
        if (walk.state().given == teach::Answer{})
            context.session.messages().say("Give an answer first, or show it.");
        else
            context.lesson.answer();
        return true;
    }
    if (walk.question()->kind == "number") return typeNumber(chord.key, walk);
    const std::size_t count = walk.question()->options.size();
    const auto option = static_cast<std::size_t>(chord.key - 'A');
    if (chord.key < 'A' || option >= count) return false;
    walk.choose(option);
    return true;
}

namespace actions {

void openTour(CommandContext& c) { c.document.open(embeddedLessonSource("tour")); }

void openPractice(CommandContext& c) {
    c.document.open(std::string(teach::kPracticePrefix) + std::to_string(c.ui.lesson.nextPractice));
}

}  // namespace actions

}  // namespace se::view
