// A step takes several frames: its input is opened, then the cursor goes to its position
// (entering_), then names, layers, horizon, comparison and camera of the step are set (enter()).
// What a step changes of the user's choices, it puts back when it is left (leaveStep()).
#include "lesson.h"

#include <algorithm>
#include <array>
#include <utility>

#include "commands/camera_actions.h"
#include "commands/command_actions.h"
#include "scene/decision_view.h"
#include "session/view_position.h"
#include "spiraling_edge/base/atomic_file.h"
#include "teach/lesson_skeleton.h"
#include "teach/practice.h"

namespace se::view {

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{500};
/// An answer is shown in about this time, decision by decision, up to so many decisions.
constexpr double kSecondsOfAnswer = 8.0;
constexpr std::size_t kMaxShown = 400;
/// Entry of the state for the seed of the last pivot to play.
constexpr std::string_view kPracticeEntry = "practice";

std::filesystem::file_time_type writeTimeOf(const std::filesystem::path& path) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(path, error);
    return error ? std::filesystem::file_time_type{} : time;
}

/// The selection of points by name.
std::optional<Selection> selectionOf(const std::vector<std::string>& words,
                                     const std::vector<teach::NamedPoint>& names) {
    std::array<Index, 3> points{};
    if (words.empty() || words.size() > points.size()) return std::nullopt;
    for (std::size_t i = 0; i < words.size(); ++i) points[i] = teach::pointOf(words[i], names);
    if (words.size() == 1) return Selection::ofPoint(points[0]);
    if (words.size() == 2) return Selection::ofEdge(points[0], points[1]);
    return Selection::ofTriangle({points[0], points[1], points[2]});
}

/// The text of a lesson in `folder` with a step for each bookmark. Fails if the input could not be
/// found from there.
Result<std::string> lessonOfBookmarks(const InputSpec& spec, const Bookmarks& bookmarks,
                                      const std::string& intro,
                                      const std::filesystem::path& folder) {
    std::string input = spec.source;
    if (isSample(input) || isStandardInput(input))
        return Error{"A lesson begins with a scene or a file: save the points first."};
    if (!isScene(input)) {
        input = std::filesystem::proximate(input, folder).generic_string();
        if (input.starts_with(".."))
            return Error{"The points of a lesson lie in its folder or below it: save it beside " +
                         spec.source + "."};
    }
    teach::LessonOptions options;
    const NeighborOptions& lists = spec.neighbors;
    options.symmetric = lists.symmetric;
    if (lists.recompute) {
        if (const auto* nearest = std::get_if<KNearest>(&lists.reach))
            options.neighbors = nearest->k;
        if (const auto* within = std::get_if<WithinRadius>(&lists.reach))
            options.radius = within->radius;
        if (const auto* within = std::get_if<WithinSpacings>(&lists.reach))
            options.reach = within->spacings;
    }
    teach::LessonRules rules;
    if (spec.rules != "paper") rules.set = spec.rules;
    for (const RuleValue& each : spec.choices) rules.rule.push_back(lineOf(each));
    for (const WhatIf& each : spec.whatIf) rules.whatIfs.push_back(lineOf(each));
    std::vector<teach::NotedPosition> notes;
    for (const Bookmark& each : bookmarks)
        notes.push_back({toString(each.address), each.note,
                         each.camera ? toText(ViewPosition{"", each.camera}) : std::string{}});
    return teach::lessonOfNotes(input, options, rules, intro, notes);
}

PlayUnit unitFromName(std::string_view name) {
    for (const PlayUnit unit : {PlayUnit::Pivot, PlayUnit::Event}) {
        if (unitName(unit) == name) return unit;
    }
    return PlayUnit::SubStep;
}

}  // namespace

void LessonController::begin(const Options& options) {
    resultFile_ = options.resultFile;
    const KeptState kept = document_.kept().read();
    const auto last = kept.lessons.find(std::string(kPracticeEntry));
    if (last != kept.lessons.end()) panel().nextPractice = last->second + 1;
    if (!options.lesson.empty()) open(options.lesson, options.lessonStep);
}

void LessonController::open(const std::string& source, std::optional<std::size_t> step) {
    toStep_ = step;
    panel().opening = true;
    panel().share = 0.0;
    panel().complaint.clear();
    opening_.start([source](const Progress& progress) { return openLesson(source, progress); });
}

void LessonController::waitUntilDone() {
    opening_.waitUntilDone();
    poll();
    for (int i = 0; i < 3; ++i) {
        c_.session.waitUntilDone();
        document_.poll();
        poll();
    }
}

bool LessonController::poll() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> passed = now - std::exchange(polled_, now);
    panel().share = opening_.share();
    bool changed = false;
    if (opening_.poll()) {
        changed = true;
        panel().opening = false;
        if (auto lesson = opening_.takeAnswer()) {
            take(std::move(*lesson));
        } else {
            // The lesson before stays.
            status_ = Error{opening_.complaint()};
            panel().complaint = opening_.complaint();
            c_.session.messages().say(opening_.complaint());
        }
    }
    if (!walk().isOpen()) return changed;
    watchFile();
    if (entering_ && arrived()) {
        entering_ = false;
        changed = true;
        enter();
    }
    const bool closed = document_.takeForeignOpening();
    if (closed) close();
    if (closed) return true;
    if (walk().asks()) walk().addSeconds(passed.count());
    if (walk().takesPoints() && arrived()) c_.session.highlights().mark(walk().givenPoints());
    panel().away = isAway();
    return changed;
}

void LessonController::take(OpenedLesson lesson) {
    const bool again = walk().isOpen() && walk().source() == lesson.source;
    const std::size_t kept = again ? walk().step() : keptStep(lesson);
    if (walk().isOpen()) leaveStep();
    written_ = writeTimeOf(lesson.source);
    walk().open(std::move(lesson), 0);
    const std::optional<LayoutPreset> layout = layoutPresetFromName(walk().lesson().layout);
    const bool present = c_.ui.layoutPreset == LayoutPreset::Present;
    if (!again && !present) actions::applyLayoutPreset(c_, layout.value_or(LayoutPreset::Learn));
    c_.ui.tab.wanted = kLessonTab;
    if (isLessonFile(walk().source())) document_.note(walk().source());
    goTo(std::exchange(toStep_, std::nullopt).value_or(kept));
}

/// The step that was shown last; the first one of a lesson that was read to its end.
std::size_t LessonController::keptStep(const OpenedLesson& lesson) const {
    const KeptState state = document_.kept().read();
    const auto found = state.lessons.find(lesson.source);
    const bool inside =
        found != state.lessons.end() && found->second + 1 < lesson.lesson.steps.size();
    return inside ? found->second : 0;
}

/// Of pivots to play the last seed is kept.
void LessonController::keepStep() {
    const auto seed = teach::practiceSeed(walk().source());
    const std::string source = seed ? std::string(kPracticeEntry) : walk().source();
    const std::size_t number = seed ? static_cast<std::size_t>(*seed) : walk().step();
    if (seed) panel().nextPractice = *seed + 1;
    const Status kept =
        document_.kept().change([&](KeptState& state) { state.lessons[source] = number; });
    if (!kept) c_.session.messages().say(kept.error().message);
}

/// The file is read again when it has changed.
void LessonController::watchFile() {
    if (polled_ - looked_ < kBetweenLooks || opening_.busy()) return;
    looked_ = polled_;
    if (!isLessonFile(walk().source())) return;
    const auto time = writeTimeOf(walk().source());
    if (std::exchange(written_, time) != time) open(walk().source(), walk().step());
}

/// The open run is that of the step.
bool LessonController::hasInput() const {
    return c_.session.ready() && c_.session.input().spec() == input_;
}

bool LessonController::arrived() const {
    const Session& session = c_.session;
    return session.ready() && session.input().phase() == SessionPhase::Ready &&
           !document_.arriving() && !session.moves().busy();
}

void LessonController::goTo(std::size_t step) {
    leaveStep();
    walk().goTo(step);
    keepStep();
    const Result<InputSpec> input = inputOfStep(walk().setting(), walk().folder());
    if (!input) return c_.session.messages().say(input.error().message);
    input_ = input.value();
    c_.playback.pause();
    entering_ = true;
    fresh_ = !hasInput();
    c_.session.setHorizon(std::nullopt);
    const std::string at = walk().setting().at.empty() ? "0" : walk().setting().at;
    if (fresh_) return document_.openStep(input_, at);
    const Status moved = c_.session.moves().goToText(at);
    if (!moved) c_.session.messages().say(moved.error().message);
}

void LessonController::enter() {
    Session& session = c_.session;
    const teach::LessonStep& step = walk().shownStep();
    home_ = session.address();
    session.giveNames(walk().names());
    session.highlights().mark({});
    session.select(selectionOf(step.select, walk().setting().names).value_or(Selection{}));
    applyLayers();
    aiming_ = true;
    if (walk().asks()) session.setHorizon(home_);
    if (walk().state().shown) show();
    if (!walk().asks() && !step.compare.empty()) compare();
    if (step.play && step.question == std::nullopt) play();
}

void LessonController::leaveStep() {
    c_.session.setHorizon(std::nullopt);
    c_.session.giveNames({});
    c_.playback.pause();
    if (layers_) c_.ui.settings.layers = *std::exchange(layers_, std::nullopt);
    if (rate_) c_.playback.setRate(*std::exchange(rate_, std::nullopt));
    if (layout_) {
        c_.ui.compare.ask = CompareAsk::Stop;
        c_.ui.layoutPreset = *std::exchange(layout_, std::nullopt);
        c_.ui.tab.wanted = kLessonTab;
    }
    entering_ = aiming_ = false;
}

void LessonController::applyLayers() {
    const teach::LessonStep& step = walk().shownStep();
    if (step.pin.empty() && step.hide.empty()) return;
    layers_ = c_.ui.settings.layers;
    for (const Layer& layer : layers()) {
        const auto among = [&](const std::vector<std::string>& names) {
            return std::find(names.begin(), names.end(), layer.name) != names.end();
        };
        if (among(step.pin)) modeOf(c_.ui.settings.layers, layer.id) = LayerMode::PinnedOn;
        if (among(step.hide)) modeOf(c_.ui.settings.layers, layer.id) = LayerMode::PinnedOff;
    }
}

void LessonController::compare() {
    const Result<InputSpec> other =
        comparedInput(input_, walk().setting(), walk().shownStep().compare);
    if (!other) return c_.session.messages().say(other.error().message);
    layout_ = c_.ui.layoutPreset;
    c_.ui.layoutPreset = LayoutPreset::Compare;
    c_.ui.compare.begin = CompareWith::otherRun(other.value());
}

/// Plays from the position of the step to its end.
void LessonController::play() {
    const auto until = addressFromString(walk().setting().answerPlace);
    if (!until || (c_.session.ready() && c_.session.reached(*until))) return;
    const std::optional<teach::PlaySpeed>& speed = walk().shownStep().play;
    if (!rate_) rate_ = c_.playback.rate();
    c_.playback.setUnit(speed ? unitFromName(speed->unit) : PlayUnit::SubStep);
    c_.playback.setRate(speed ? speed->perSecond : 2.0);
    c_.playback.play();
    c_.playback.until = until;
    home_ = until;
}

/// Goes through the decisions from the question to its answer.
void LessonController::show() {
    c_.session.setHorizon(std::nullopt);
    const std::vector<Event>& decisions = walk().right().shown;
    if (decisions.empty()) return;
    const Address until = decisions.back().address;
    home_ = until;
    if (c_.session.reached(until)) return;
    if (walk().shownStep().play) return play();
    if (decisions.size() > kMaxShown) return c_.session.moves().playTo(until);
    if (!rate_) rate_ = c_.playback.rate();
    c_.playback.setUnit(PlayUnit::SubStep);
    c_.playback.setRate(std::max(2.0, static_cast<double>(decisions.size()) / kSecondsOfAnswer));
    c_.playback.play();
    c_.playback.until = until;
}

bool LessonController::isAway() const {
    if (entering_ || c_.playback.playing() || !arrived()) return false;
    const LessonWalk& walk = c_.ui.lesson.walk;
    return !hasInput() || (home_ && c_.session.address() != *home_ && !walk.asks());
}

bool LessonController::takeAim() {
    return aiming_ && arrived() ? std::exchange(aiming_, false) : false;
}

void LessonController::aim() {
    const teach::LessonStep& step = walk().shownStep();
    if (!step.camera.empty()) {
        const Result<ViewPosition> place = viewPositionFromText(step.camera);
        if (place && place.value().camera) return c_.camera.setPose(*place.value().camera);
    }
    const std::optional<Vec3> direction = teach::viewDirection(walk().setting());
    const bool all = step.frame == "all" || c_.session.picture().pivot == kNone;
    if (all) {
        if (direction) c_.camera.faceStraight(glm::vec3(*direction));
        return actions::frameAll(c_);
    }
    if (direction) {
        frameFocus(c_);
        return c_.camera.faceStraight(glm::vec3(*direction));
    }
    if (!fresh_) return moveToDecision(c_, CameraMove::Kind::Requested);
    frameFocus(c_);
    lookAtDecision(c_.session.shown(), c_.session.picture(), c_.session.shownTriangles(), c_.camera,
                   c_.ui.viewEms);
}

void LessonController::follow(const std::string& address) {
    c_.playback.pause();
    const Status moved = c_.session.moves().goToText(address);
    if (!moved) c_.session.messages().say(moved.error().message);
}

void LessonController::save() {
    if (resultFile_.empty() || !walk().hasAnswers()) return;
    const Status written = writeFileAtomically(resultFile_, resultJson(walk().result()));
    if (!written) c_.session.messages().say(written.error().message);
}

/// Writes the bookmarks as the steps of a lesson.
void LessonController::saveLesson(const std::string& file) {
    const InputSpec& spec = c_.session.input().spec();
    const auto text = lessonOfBookmarks(spec, c_.ui.bookmarks, c_.ui.notes,
                                        std::filesystem::path(file).parent_path());
    const Status written = text ? writeFileAtomically(file, text.value()) : Status(text.error());
    c_.session.messages().say(written ? "Saved " + file + "." : written.error().message);
}

void LessonController::close() {
    leaveStep();
    const std::uint64_t next = panel().nextPractice;
    panel() = {};
    panel().nextPractice = next;
}

void LessonController::carryOut() {
    LessonPanel& panel = this->panel();
    if (!panel.open.empty()) open(std::exchange(panel.open, {}), std::nullopt);
    const LessonAsk ask = std::exchange(panel.ask, LessonAsk::None);
    const auto step = std::exchange(panel.toStep, std::nullopt);
    const std::string link = std::exchange(panel.follow, {});
    const std::string file = std::exchange(panel.saveResult, {});
    const std::string lesson = std::exchange(panel.saveLesson, {});
    if (!lesson.empty() && c_.session.ready()) saveLesson(lesson);
    if (!walk().isOpen()) {
        if (ask == LessonAsk::Next || ask == LessonAsk::Previous)
            c_.session.messages().say("No lesson is open: Help > Tour opens the first one.");
        return;
    }
    if (!file.empty()) {
        const Status written = writeFileAtomically(file, resultJson(walk().result()));
        c_.session.messages().say(written ? "Saved " + file + "." : written.error().message);
    }
    if (!link.empty()) follow(link);
    if (step) goTo(*step);
    carryOut(ask);
}

void LessonController::carryOut(LessonAsk ask) {
    const std::size_t count = walk().lesson().steps.size();
    const bool present = c_.ui.layoutPreset == LayoutPreset::Present;
    switch (ask) {
        case LessonAsk::None:
            return;
        case LessonAsk::Next:
            if (present && walk().asks()) return carryOut(LessonAsk::Show);
            if (walk().step() + 1 < count) return goTo(walk().step() + 1);
            return c_.session.messages().say("This is the last step of the lesson.");
        case LessonAsk::Previous:
            if (walk().step() > 0) return goTo(walk().step() - 1);
            return c_.session.messages().say("This is the first step of the lesson.");
        case LessonAsk::Return:
            return goTo(walk().step());
        case LessonAsk::Play:
            return play();
        case LessonAsk::Answer:
        case LessonAsk::Show:
            if (!walk().asks()) return;
            ask == LessonAsk::Show ? walk().showAnswer() : walk().answer();
            save();
            if (!walk().asks()) show();
            return;
        case LessonAsk::Close:
            return close();
    }
}

}  // namespace se::view
