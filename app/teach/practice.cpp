// The points of a seed are a sample of a flat square, of which some are taken away, rounded to
// thousandths; of its run those pivots are tasks at which start or end moves, a candidate is kept,
// another removed, and no decision is near. On an even sample such pivots are all alike: of five
// seeds four have an uneven one, and a pivot at which something else happens, too (kSorts). A
// sample without such a pivot is passed over.
#include "practice.h"

#include <algorithm>
#include <cmath>

#include "lesson.h"
#include "spiraling_edge/base/random.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/scenes/surface_scenes.h"
#include "trace/setrace.h"

namespace se::teach {
namespace {

constexpr std::size_t kPracticePerSide = 3;

/// The random choice of points.
struct PracticeSample {
    std::size_t interior;
    double taken;   ///< Share of the interior points taken away.
    double strewn;  ///< Side of the square in which each of the others is moved at random.
    std::size_t neighbors;
};
constexpr PracticeSample kEvenSample{22, 0.12, 0.0, 9};
constexpr PracticeSample kUnevenSample{26, 0.3, 0.6, 10};

PointSet practicePoints(const PracticeSample& sample, SplitMix& random) {
    const PointFile sheet =
        sampleSheet(flatSheet(), kPracticePerSide, sample.interior, random.bits());
    PointFile file;
    for (std::size_t i = 0; i < sheet.position.size(); ++i) {
        if (!isBoundary(sheet.type[i]) && random.unit() < sample.taken) continue;
        file.position.push_back(sheet.position[i]);
        file.normal.push_back(sheet.normal[i]);
        file.type.push_back(sheet.type[i]);
    }
    constexpr double kInside = 0.95;
    for (std::size_t p = 0; p < file.position.size(); ++p) {
        Vec3& x = file.position[p];
        if (sample.strewn > 0.0 && !isBoundary(file.type[p])) {
            for (int i = 0; i < 2; ++i)
                x[i] = std::clamp(x[i] + sample.strewn * (random.unit() - 0.5), -kInside, kInside);
        }
        // Thousandths, and no -0.
        for (int i = 0; i < 3; ++i) x[i] = std::round(1000.0 * x[i]) / 1000.0 + 0.0;
    }
    PrepareOptions options;
    options.neighbors.reach = KNearest{sample.neighbors};
    return prepare(file, options).value().points;
}

/// True if no two candidates of the angle sort are at nearly the same angle, so that their order is
/// clear.
bool hasClearOrder(std::span<const Event> events) {
    constexpr double kDegrees = 57.295779513082320877;
    std::vector<double> angles;
    for (const Event& event : events) {
        const auto* sort = as<SortEvidence>(event);
        if (sort != nullptr && sort->verdict == Verdict::Kept) angles.push_back(sort->degrees);
    }
    std::sort(angles.begin(), angles.end());
    return std::adjacent_find(angles.begin(), angles.end(), [](double a, double b) {
               return b - a <= kPracticeMargin * kDegrees;
           }) == angles.end();
}

/// True if every decision of a pivot is clear, so that rounded numbers decide the same.
bool isClear(std::span<const Event> events, const ReadingContext& context) {
    return hasClearOrder(events) &&
           std::all_of(events.begin(), events.end(), [&](const Event& event) {
               const std::optional<Reading> reading = readingOf(event, context);
               return !reading || std::abs(reading->margin) > kPracticeMargin;
           });
}

std::ptrdiff_t countOf(MoveKind kind, const std::vector<RunMove>& moves) {
    return std::count_if(moves.begin(), moves.end(),
                         [&](const RunMove& each) { return each.move.kind == kind; });
}
std::ptrdiff_t limitMoves(const std::vector<RunMove>& moves) {
    return countOf(MoveKind::MoveStart, moves) + countOf(MoveKind::MoveEnd, moves);
}

/// True if the moves are worth playing.
bool isTask(const std::vector<RunMove>& moves) {
    return limitMoves(moves) > 0 && countOf(MoveKind::Keep, moves) > 0 &&
           countOf(MoveKind::Remove, moves) > 0 && !moves.back().move.points.empty();
}

bool hasVerdict(const PracticeTask& task, Verdict verdict) {
    return std::any_of(task.events.begin(), task.events.end(),
                       [&](const Event& event) { return verdictOf(event) == verdict; });
}

/// A sort of tasks: the sample, and what happens in them.
struct PracticeSort {
    const PracticeSample& sample;
    bool (*holds)(const PracticeTask& task);
};
/// The sorts, by the remainder of the seed.
constexpr PracticeSort kSorts[] = {
    {kEvenSample, [](const PracticeTask&) { return true; }},
    // A point outside its sphere stays, since the gap would be too wide.
    {kUnevenSample, [](const PracticeTask& task) { return hasVerdict(task, Verdict::GapTooWide); }},
    // A point of the edge ring is a candidate.
    {kUnevenSample,
     [](const PracticeTask& task) {
         return std::any_of(task.solution.begin(), task.solution.end(), [&](const RunMove& each) {
             const MoveKind kind = each.move.kind;
             return (kind == MoveKind::Keep || kind == MoveKind::Remove) &&
                    std::find(task.ring.begin(), task.ring.end(), each.move.points.front()) !=
                        task.ring.end();
         });
     }},
    {kUnevenSample, [](const PracticeTask& task) { return limitMoves(task.solution) > 1; }},
    // A candidate is no longer between start and end.
    {kUnevenSample, [](const PracticeTask& task) { return hasVerdict(task, Verdict::Outside); }},
};

bool hasOpenStep(const EdgeRings& rings) {
    for (const Index entry : rings.entriesOf(rings.active())) {
        if (rings.open(entry)) return true;
    }
    return false;
}

/// Records the rings and the DONE points before a pivot.
void recordBefore(const State& state, PracticeTask& task) {
    const EdgeRings& rings = state.rings;
    task.ring = ringFrom(rings, state.pivot.pivot);
    for (const Index ring : rings.stack()) task.stack.push_back(ringFrom(rings, rings.head(ring)));
    task.done = state.done;
    std::sort(task.done.begin(), task.done.end());
}

/// All tasks of a run.
std::vector<PracticeTask> tasksOf(std::uint64_t seed, const SharedPoints& points) {
    std::vector<PracticeTask> tasks;
    EventLog log;
    Stepper stepper(points, {}, &log);
    while (true) {
        const State before = stepper.state();
        log.clear();
        if (!stepper.stepPivot()) return tasks;
        const std::vector<Event>& events = log.events();
        const auto begins = std::find_if(events.begin(), events.end(), isA<PivotEvidence>);
        // No seeds and third points: all that counts is on the ring.
        if (begins != events.begin() || events.empty() || hasOpenStep(before.rings)) continue;
        const auto& pivot = *as<PivotEvidence>(*begins);
        if (isBoundary(points->type[pivot.pivot])) continue;
        PracticeTask task{seed, points};
        task.address = begins->address;
        task.p = pivot.pivot;
        task.first = pivot.first;
        task.last = pivot.last;
        task.solution = movesOfRun(events);
        task.events = events;
        if (task.solution.empty() || !isTask(task.solution)) continue;
        if (!isClear(events, {*points, task.params, pivot.pivot})) continue;
        recordBefore(before, task);
        tasks.push_back(std::move(task));
    }
}

}  // namespace

PracticeTask practiceTask(std::uint64_t seed) {
    SplitMix random(seed);
    const PracticeSort& sort = kSorts[seed % std::size(kSorts)];
    while (true) {
        const SharedPoints points(practicePoints(sort.sample, random));
        std::vector<PracticeTask> tasks = tasksOf(seed, points);
        std::erase_if(tasks, [&](const PracticeTask& task) { return !sort.holds(task); });
        if (!tasks.empty()) return std::move(tasks[random.bits() % tasks.size()]);
    }
}

std::vector<PointName> practiceNames(const PracticeTask& task) {
    return {{task.p, "p"}, {task.first, "first"}, {task.last, "last"}};
}

PracticeGrade gradePractice(const PracticeTask& task, const std::vector<PlayMove>& moves) {
    PracticeGrade grade;
    grade.rightMoves = movesAlike(moves, movesOf(task.solution));
    grade.right = grade.rightMoves == task.solution.size() && moves.size() == grade.rightMoves;
    if (grade.right) return grade;
    const RunMove* expected =
        grade.rightMoves < task.solution.size() ? &task.solution[grade.rightMoves] : nullptr;
    const Event* event = expected != nullptr ? &expected->event : nullptr;
    if (grade.rightMoves < moves.size())
        event = decisionAgainst(task.events, moves[grade.rightMoves], expected);
    if (event == nullptr) event = &task.solution.back().event;
    grade.section = stageSection(event->address.stage);
    grade.stage = stageName(event->address.stage);
    grade.address = toString(event->address);
    grade.sentence = moveReasonText(*event, practiceNames(task));
    return grade;
}

LessonResult practiceResult(const std::vector<PlayMove>& moves, const PracticeGrade& grade,
                            const PracticeTask& task) {
    GivenAnswer answer;
    answer.step = 1;
    answer.title = "Play a pivot";
    answer.kind = "play";
    answer.tries = 0;
    const std::vector<PointName> names = practiceNames(task);
    for (const PlayMove& each : moves) answer.given.push_back(moveText(each, names));
    if (!grade.right) answer.wrong = {grade.section + ' ' + grade.stage};
    answer.right = grade.right;
    answer.score =
        static_cast<double>(grade.rightMoves) / static_cast<double>(task.solution.size());
    return {"Practice", "practice 1", {}, {std::move(answer)}};
}

Result<std::vector<PlayMove>> readMoves(std::string_view text, const std::string& file,
                                        const PracticeTask& task) {
    const std::vector<PointName> names = practiceNames(task);
    const std::size_t pointCount = task.points->size();
    std::vector<PlayMove> moves;
    io::LineReader lines(text);
    while (lines.nextContent('#')) {
        Result<PlayMove> move = moveFromText(lines.line(), names);
        const auto fail = [&](const std::string& what) {
            return io::errorAt(file, io::lineText(lines.number()), what);
        };
        if (!move) return fail(move.error().message);
        for (const Index point : move.value().points) {
            if (point >= pointCount)
                return fail(absentPointText(std::to_string(point), pointCount));
        }
        moves.push_back(std::move(move.value()));
    }
    if (moves.empty()) return Error{file + ": expected moves, one a line, such as \"keep 12\""};
    return moves;
}

std::optional<std::uint64_t> practiceSeed(std::string_view source) {
    if (!source.starts_with(kPracticePrefix)) return std::nullopt;
    return numberIn<std::uint64_t>(source.substr(kPracticePrefix.size()));
}

PointFile practiceFile(std::uint64_t seed) { return fileOf(*practiceTask(seed).points); }

std::string practiceLesson(std::uint64_t seed) {
    const PracticeTask task = practiceTask(seed);
    const std::string number = std::to_string(seed);
    const std::string pivot = std::to_string(task.address.pivot);
    return "# Practice " + number + "\n\n```se lesson\nversion = 1\ninput = \"" +
           std::string(kPracticePrefix) + number +
           "\"\nview = \"top\"\nnames = { p = " + std::to_string(task.p) +
           ", first = " + std::to_string(task.first) + ", last = " + std::to_string(task.last) +
           " }\n```\n\n## Play pivot " + pivot + "\n\nThe pivot p is " + std::to_string(task.p) +
           ", between *first*, " + std::to_string(task.first) + ", and *last*, " +
           std::to_string(task.last) +
           ". Do what the algorithm does with it, in its order:\n\n"
           "1. **start** and **end** move along the edge ring, where it is concave (6.1);\n"
           "2. each candidate between them, by increasing angle from *first*: **keep** or "
           "**remove** it (6.1 to 6.3);\n"
           "3. the **fan**, from *first* to *last* (6.4);\n"
           "4. the **next** pivot (6.5).\n\n"
           "```se step\nminutes = 3\nframe = \"pivot\"\npin = [\"links\"]\n```\n\n```se ask\nkind "
           "= \"play\"\nat = "
           "\"" +
           toString(task.address) + "\"\nuntil = \"" + toString(task.events.back().address) +
           "\"\nanswer = \"moves\"\n```\n";
}

}  // namespace se::teach
