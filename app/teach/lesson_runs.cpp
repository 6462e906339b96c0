#include "lesson_runs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "lesson_read.h"
#include "practice.h"
#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se::teach {
namespace {

/// Why an address is not in the run.
std::string absenceText(RunCursor& cursor, const Address& address) {
    const std::string pivot = "pivot " + std::to_string(address.pivot);
    const std::string stage(stageName(address.stage));
    if (!cursor.goTo({address.pivot, Stage::Pivot, 0})) {
        cursor.goToEnd();
        return "the run ends at pivot " + std::to_string(cursor.pivot().pivot) + ", there is no " +
               pivot;
    }
    const std::vector<Event>& events = cursor.pivot().events;
    const auto count = std::count_if(events.begin(), events.end(), [&](const Event& event) {
        return event.address.stage == address.stage;
    });
    if (count == 0) return pivot + " has no decision of " + stage;
    return pivot + " has " + counted(static_cast<std::size_t>(count), "decision") + " of " + stage +
           ", not " + std::to_string(address.n);
}

void goToShare(RunCursor& cursor, double share) {
    cursor.goToEnd();
    if (share >= 1.0 || cursor.event() == nullptr) return;
    const auto pivot = static_cast<std::uint32_t>(std::floor(share * cursor.pivot().pivot));
    if (pivot == 0) return cursor.goToStart();
    cursor.goTo({pivot, Stage::Advance, 0}) || cursor.goTo({pivot, Stage::Pivot, 0});
}

std::string keyOf(const RunSpec& spec) {
    std::string key;
    for (const auto& [field, text] : valuesOf(spec)) key.append(field->key).append(text + '\n');
    return key;
}

/// Triangles of the run up to a state.
std::size_t trianglesAt(const DecisionState& state) {
    return state.repaired != nullptr ? state.repaired->size()
                                     : state.finishedTriangles + state.newTriangles.size();
}

}  // namespace

Result<PointFile> buildScene(const std::string& source) {
    const Scene* scene = findScene(source.substr(kScenePrefix.size()));
    if (scene != nullptr) return scene->build();
    return Error{excerpt(source) + ": no such scene; `spiraling-edge scenes` lists the scenes"};
}

Result<std::string> pointsSource(std::string source) {
    std::set<std::string> seen;
    while (source.ends_with(kLessonExtension)) {
        if (!seen.insert(source).second) return Error{source + ": the inputs form a cycle"};
        const Result<LessonReading> reading = readLessonFile(source);
        if (!reading) return reading.error();
        if (!reading.value().ok()) return Error{faultText(reading.value().faults.front(), source)};
        source =
            lessonSource(reading.value().lesson.input, std::filesystem::path(source).parent_path());
    }
    return source;
}

std::string lessonSource(const std::string& input, const std::filesystem::path& folder) {
    if (input.starts_with(kScenePrefix) || practiceSeed(input)) return input;
    return (folder / input).lexically_normal().string();
}

Result<PreparedRun> prepareRun(const PointFile& file, const std::string& source, RunSpec spec) {
    spec.source = source;
    Result<Params> params = paramsOf(spec);
    if (!params) return params.error();
    const Result<PrepareOptions> options = prepareOptionsOf(spec, params.value(), file);
    if (!options) return Error{source + ": " + options.error().message};
    Result<Prepared> prepared = prepare(file, options.value());
    if (!prepared) return Error{source + ": " + prepared.error().message};
    const Status possible = requireWhatIfs(prepared.value().points, params.value());
    if (!possible) return possible.error();
    return PreparedRun{SharedPoints(std::move(prepared.value().points)), std::move(params.value())};
}

Status goToPlace(RunCursor& cursor, std::string_view place) {
    if (place.empty() || place == "0") {
        cursor.goToStart();
        return success();
    }
    if (place.ends_with('%')) {
        const auto share = numberIn<double>(place.substr(0, place.size() - 1));
        if (!share) return Error{excerpt(place) + ": expected a share such as 50%"};
        goToShare(cursor, *share / 100.0);
        return success();
    }
    const auto address = addressFromString(place);
    if (!address) return Error{excerpt(place) + ": expected an address such as 9.sphere.2"};
    if (cursor.goTo(*address)) return success();
    return Error{absenceText(cursor, *address)};
}

// A built-in scene, a task, or a file, also a packed one if there is an `unpack_`.
Result<PointFile> LessonRuns::pointsOf(const std::string& source) const {
    const Result<std::string> input = pointsSource(source);
    if (!input) return input.error();
    if (isScene(input.value())) return buildScene(input.value());
    if (const auto seed = practiceSeed(input.value())) return practiceFile(*seed);
    return readPoints(std::filesystem::path(input.value()), limit_, unpack_);
}

LessonRuns::LessonRuns(std::filesystem::path folder, const ByteLimit& limit, Unpack unpack)
    : folder_(std::move(folder)), limit_(limit), unpack_(unpack) {}

Result<RunCursor*> LessonRuns::cursorOf(const StepSetting& setting) {
    const Result<RunSpec> spec = runSpec(setting);
    if (!spec) return spec.error();
    return cursorOf(setting, spec.value());
}

Result<RunCursor*> LessonRuns::cursorOf(const StepSetting& setting, const RunSpec& spec) {
    const std::string source = lessonSource(setting.input, folder_);
    const std::string key = source + '\n' + keyOf(spec);
    if (const auto known = cursors_.find(key); known != cursors_.end()) return known->second.get();
    if (files_.count(source) == 0) {
        Result<PointFile> file = pointsOf(source);
        if (!file) return file.error();
        files_.emplace(source, std::move(file.value()));
    }
    Result<PreparedRun> run = prepareRun(files_.at(source), source, spec);
    if (!run) return run.error();
    auto cursor = std::make_unique<RunCursor>(run.value().points, run.value().params);
    return cursors_.emplace(key, std::move(cursor)).first->second.get();
}

Result<RunRange> rangeOf(RunCursor& cursor, const StepSetting& setting, const Question& question) {
    RunRange range;
    Status moved = goToPlace(cursor, setting.at);
    if (!moved) return moved.error();
    if (setting.answerPlace.empty()) {
        cursor.forward(StepUnit::Pivot);
    } else if (moved = goToPlace(cursor, setting.answerPlace); !moved) {
        return moved.error();
    }
    const std::optional<Event> last =
        cursor.event() ? std::optional(*cursor.event()) : std::nullopt;
    range.after = cursor.state();
    range.trianglesAfter = trianglesAt(range.after);
    (void)goToPlace(cursor, setting.at);
    range.before = cursor.state();
    range.trianglesBefore = trianglesAt(range.before);
    const bool isHere = last && cursor.event() && cursor.event()->address == last->address;
    if (isHere && question.answer == "verdict") {
        range.events = {*last};
        return range;
    }
    while (cursor.forward()) {
        range.events.push_back(*cursor.event());
        if (last && cursor.event()->address == last->address) return range;
    }
    return Error{(question.until.empty() ? std::string("the end") : setting.answerPlace) +
                 " is not after " + setting.at};
}

Result<RightAnswer> rightAnswer(const Lesson& lesson, std::size_t step, LessonRuns& runs) {
    assert(lesson.steps[step].question.has_value());
    const Question& question = *lesson.steps[step].question;
    const StepSetting setting = settingOf(lesson, step);
    const QuestionContext context{question, setting.names};
    const QuestionKind* kind = findQuestionKind(question.kind);
    if (kind == nullptr) return Error{excerpt(question.kind) + ": no such kind of question"};
    Result<RunCursor*> cursor = runs.cursorOf(setting);
    if (!cursor) return cursor.error();
    Result<RunRange> range = rangeOf(*cursor.value(), setting, question);
    if (!range) return range.error();
    const RunAnswer* source = findRunAnswer(question.answer);
    Result<Answer> answer = source != nullptr ? source->find(range.value(), context)
                                              : kind->read(question.typed, context);
    if (!answer) return answer.error();
    RightAnswer right{std::move(answer.value()), {}, {}, std::move(range.value().events)};
    right.text = kind->text(right.answer, context);
    if (question.why.empty()) return right;
    const Status moved = goToPlace(*cursor.value(), question.why);
    if (!moved) return Error{"why: " + moved.error().message};
    if (const Event* event = cursor.value()->event())
        right.reason = describe(*event, setting.names);
    return right;
}

}  // namespace se::teach
