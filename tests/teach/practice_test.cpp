#include "teach/practice.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/stepper.h"
#include "teach/result.h"
#include "teach/trace/setrace.h"
#include "trace/traced_scenes.h"

namespace se::teach {
namespace {

PlayMove moveOf(std::string_view text) { return moveFromText(text).value(); }

/// The moves of a pivot of a scene, one a line.
std::string playedText(std::string_view id, std::uint32_t pivot) {
    const TracedScene scene = tracedScene(id);
    EventLog log;
    Stepper stepper(scene.points, scene.params, &log);
    for (std::uint32_t i = 0; i < pivot; ++i) {
        log.clear();
        stepper.stepPivot();
    }
    std::string text;
    for (const RunMove& each : movesOfRun(log.events())) text += moveText(each.move) + "\n";
    return text;
}

/// Task 10: end 14, remove 6, keep 10, fan 28 10 14 25, next 14.
const PracticeTask& taskTen() {
    static const PracticeTask task = practiceTask(10);
    return task;
}

std::vector<PlayMove> solutionWith(std::size_t place, std::string_view move) {
    std::vector<PlayMove> moves = movesOf(taskTen().solution);
    moves[place] = moveOf(move);
    return moves;
}

}  // namespace

TEST_CASE("the moves of a pivot are those of start and end, candidates by angle, fan and next") {
    CHECK(playedText("figure-8", 9) ==
          "keep 9\nremove 46\nkeep 31\nkeep 35\nfan 20 9 31 35 39\nnext 39\n");
    CHECK(playedText("figure-4", 1) ==
          "start 5\nend 6\nremove 8\nkeep 7\nremove 9\n"
          "fan 1 5 7 6 2\nnext 6\n");
}

TEST_CASE("a refused fan has no points, and a pivot that is passed over no moves") {
    CHECK(playedText("figure-9", 1) == "fan none\nnext 2\n");
    CHECK(playedText("figure-13", 1).empty());
}

TEST_CASE("a candidate stays if one of its ring entries passes the reciprocal test") {
    EventLog log;
    log.add(1, Stage::Sort, SortEvidence{4, 0.0, false, 90.0, 180.0, Verdict::Kept, kNone});
    log.add(1, Stage::Reciprocal, ReciprocalEvidence{4, 1, 2, 9.0, 8.0, Verdict::NotReciprocal});
    log.add(1, Stage::Reciprocal, ReciprocalEvidence{4, 5, 6, 7.0, 8.0, Verdict::Kept});
    log.add(1, Stage::Reciprocal, ReciprocalEvidence{4, 7, 8, 9.0, 8.0, Verdict::NotReciprocal});
    log.add(1, Stage::Emit, EmitEvidence{0, {0, 1, 4}});
    log.add(1, Stage::Emit, EmitEvidence{1, {0, 4, 2}});
    log.add(1, Stage::Advance, AdvanceEvidence{2, 0, false});
    const std::vector<RunMove> moves = movesOfRun(log.events());
    REQUIRE(moves.size() == 3);
    CHECK(moveText(moves[0].move) == "keep 4");
    CHECK(toString(moves[0].event.address) == "1.reciprocal.2");
    CHECK(moveText(moves[1].move) == "fan 1 4 2");
}

TEST_CASE("points that start has passed are neither kept nor removed") {
    EventLog log;
    for (const Index x : {4U, 5U, 6U}) {
        const double cosine = 1.0 - 0.1 * x;
        log.add(1, Stage::Sort, SortEvidence{x, cosine, false, 0.0, 180.0, Verdict::Kept, kNone});
    }
    log.add(1, Stage::Limits, LimitEvidence{Side::Start, 1, 4, 1.0, 0.0, 0.0, Verdict::Moved});
    log.add(1, Stage::Limits, LimitEvidence{Side::Start, 4, 5, 1.0, 0.0, 0.0, Verdict::Moved});
    log.add(1, Stage::Limits, DropEvidence{4, Side::Start, 0.0, Verdict::Outside});
    log.add(1, Stage::Limits, DropEvidence{5, Side::Start, 0.0, Verdict::NowStart});
    log.add(1, Stage::Advance, AdvanceEvidence{2, 0, false});
    std::string text;
    for (const RunMove& each : movesOfRun(log.events())) text += moveText(each.move) + "; ";
    CHECK(text == "start 4; start 5; keep 6; fan none; next 2; ");
}

TEST_CASE("moves read back as they are written, by names too") {
    const std::vector<PointName> names{{46, "q"}, {9, "t"}};
    for (const std::string_view text :
         {"start 5", "end 0", "keep q", "remove t", "fan 1 t q 2", "fan none", "next none"})
        CHECK(moveText(moveFromText(text, names).value(), names) == text);
    CHECK(moveFromText("keep").error().message == "keep: expected one point");
    CHECK(moveFromText("keep none").error().message == "keep: expected one point");
    CHECK(moveFromText("fan 1").error().message == "fan: expected two points or more, or none");
    CHECK(moveFromText("next 1 2").error().message == "next: expected one point, or none");
    CHECK(moveFromText("keep x").error().message ==
          "keep: \"x\" is no name and no number of a point");
    CHECK(moveFromText("drop 4").error().message.starts_with("\"drop\": expected start, end,"));
}

TEST_CASE("a hundred seeds give distinct tasks with clear decisions") {
    std::set<std::string> seen;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const PracticeTask task = practiceTask(seed);
        CAPTURE(seed);
        seen.insert(pointsHash(*task.points));
        CHECK(gradePractice(task, movesOf(task.solution)).right);
        CHECK(task.points->size() <= 40);
        CHECK(task.ring.front() == task.p);
        CHECK(task.ring[1] == task.last);
        CHECK(task.ring.back() == task.first);
        for (const Event& event : task.events) {
            const auto reading = readingOf(event, {*task.points, task.params, task.p});
            if (reading) CHECK(std::abs(reading->margin) > kPracticeMargin);
        }
        const auto has = [&](MoveKind kind) {
            return std::any_of(task.solution.begin(), task.solution.end(),
                               [&](const RunMove& each) { return each.move.kind == kind; });
        };
        CHECK((has(MoveKind::MoveStart) || has(MoveKind::MoveEnd)));
        CHECK((has(MoveKind::Keep) && has(MoveKind::Remove)));
    }
    CHECK(seen.size() == 100);
}

TEST_CASE("pivots with a near decision, or two candidates at nearly one angle, are no tasks") {
    // Without either test these seeds draw such a pivot.
    for (const std::uint64_t seed : {388U, 893U, 339U, 583U}) {
        const PracticeTask task = practiceTask(seed);
        CAPTURE(seed);
        double before = -1.0;
        for (const RunMove& each : task.solution) {
            const auto reading = readingOf(each.event, {*task.points, task.params, task.p});
            if (reading) CHECK(std::abs(reading->margin) > kPracticeMargin);
            const bool isCandidate =
                each.move.kind == MoveKind::Keep || each.move.kind == MoveKind::Remove;
            if (!isCandidate) continue;
            const Index point = each.move.points.front();
            const auto sort =
                std::find_if(task.events.begin(), task.events.end(), [&](const Event& event) {
                    return isA<SortEvidence>(event) && testedPoint(event) == point;
                });
            CHECK(as<SortEvidence>(*sort)->degrees > before + 0.05);
            before = as<SortEvidence>(*sort)->degrees;
        }
    }
}

TEST_CASE("the same seed gives the same task, at the address that it names") {
    const PracticeTask task = practiceTask(10);
    CHECK(toString(task.address) == "33.pivot.1");
    CHECK(movesOf(task.solution) == movesOf(taskTen().solution));
    CHECK(pointsHash(*task.points) == pointsHash(*taskTen().points));
    Stepper stepper(task.points, task.params);
    for (int i = 0; i < 32; ++i) stepper.stepPivot();
    CHECK(stepper.state().rings.point(stepper.state().pivot.pivot) == task.p);
    CHECK(stepper.state().done.size() == task.done.size());
}

TEST_CASE("the first wrong decision is named with its section and sentence") {
    const PracticeGrade kept = gradePractice(taskTen(), solutionWith(1, "keep 6"));
    CHECK_FALSE(kept.right);
    CHECK(kept.rightMoves == 1);
    CHECK(kept.section == "6.3");
    CHECK(kept.address == "33.sphere.1");
    CHECK(kept.sentence.starts_with("Point 6 lies "));
    CHECK(gradePractice(taskTen(), solutionWith(0, "end 10")).address == "33.limits.2");
    CHECK(gradePractice(taskTen(), solutionWith(3, "fan 28 10 25")).address == "33.emit.2");
    CHECK(gradePractice(taskTen(), solutionWith(4, "next 28")).section == "6.5");
    // A move of start that the run does not make, and a point that is no candidate.
    const PracticeGrade start = gradePractice(taskTen(), solutionWith(0, "start 16"));
    CHECK(start.address == "33.limits.1");
    CHECK(start.sentence.find("start = first") != std::string::npos);
    CHECK(start.sentence.find("start stays") != std::string::npos);
    CHECK(gradePractice(taskTen(), solutionWith(1, "keep 20")).section == "6.1");
    // A point that end has moved to, and a next pivot: the rule, not the answer.
    CHECK(gradePractice(taskTen(), solutionWith(1, "keep 14")).address == "33.limits.2");
    const PracticeGrade next = gradePractice(taskTen(), solutionWith(4, "next 28"));
    CHECK(next.sentence.find("where end stands") != std::string::npos);
    CHECK(next.sentence.find("14") == std::string::npos);
}

TEST_CASE("the seed decides what happens: a gap too wide, a ring point, two moves, one left out") {
    const auto has = [](const PracticeTask& task, Verdict verdict) {
        return std::any_of(task.events.begin(), task.events.end(),
                           [&](const Event& event) { return verdictOf(event) == verdict; });
    };
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const PracticeTask task = practiceTask(seed);
        CAPTURE(seed);
        std::size_t limits = 0;
        bool onRing = false;
        for (const RunMove& each : task.solution) {
            const MoveKind kind = each.move.kind;
            limits += kind == MoveKind::MoveStart || kind == MoveKind::MoveEnd ? 1U : 0U;
            onRing = onRing ||
                     ((kind == MoveKind::Keep || kind == MoveKind::Remove) &&
                      std::count(task.ring.begin(), task.ring.end(), each.move.points.front()) > 0);
        }
        if (seed % 5 == 1) CHECK(has(task, Verdict::GapTooWide));
        if (seed % 5 == 2) CHECK(onRing);
        if (seed % 5 == 3) CHECK(limits > 1);
        if (seed % 5 == 4) CHECK(has(task, Verdict::Outside));
    }
}

TEST_CASE("missing and surplus moves are wrong") {
    std::vector<PlayMove> moves = movesOf(taskTen().solution);
    moves.push_back(moveOf("keep 10"));
    CHECK_FALSE(gradePractice(taskTen(), moves).right);
    CHECK(gradePractice(taskTen(), moves).rightMoves == 5);
    moves.resize(2);
    const PracticeGrade grade = gradePractice(taskTen(), moves);
    CHECK(grade.rightMoves == 2);
    CHECK(grade.address == "33.sphere.2");
    CHECK_FALSE(gradePractice(taskTen(), {}).right);
    // Left out: the decision about the point that is due.
    moves = {moveOf("end 14"), moveOf("keep 10")};
    CHECK(gradePractice(taskTen(), moves).address == "33.sphere.1");
}

TEST_CASE("an answer file has a move a line, and faults have their line") {
    const auto fault = [](std::string_view text) {
        return readMoves(text, "a.txt", taskTen()).error().message;
    };
    CHECK(readMoves("# mine\n\nend 14  # why\nkeep 34\n", "a.txt", taskTen()).value() ==
          std::vector<PlayMove>{moveOf("end 14"), moveOf("keep 34")});
    CHECK(readMoves("fan first 10 14 last", "a.txt", taskTen()).value() ==
          std::vector<PlayMove>{moveOf("fan 28 10 14 25")});
    CHECK(fault("end 14\n\nkeep 35\n") == "a.txt: line 3: 35: there are 35 points, from 0");
    CHECK(fault("end 14\nkeep\n") == "a.txt: line 2: keep: expected one point");
    CHECK(fault("# nothing\n") == "a.txt: expected moves, one a line, such as \"keep 12\"");
}

TEST_CASE("thirty results of practice make one row, with the section most often wrong") {
    std::vector<LessonResult> results;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const PracticeTask task = practiceTask(seed);
        std::vector<PlayMove> moves = movesOf(task.solution);
        if (seed % 3 == 0) std::swap(moves.back().points.front(), moves.front().points.front());
        if (seed % 3 == 1) moves.resize(moves.size() - 1);
        const PracticeGrade grade = gradePractice(task, moves);
        const std::string json = resultJson(practiceResult(moves, grade, task));
        results.push_back(resultFromJson(json, "x").value());
        CHECK(results.back().answers[0].tries == 0);
        CHECK_FALSE(results.back().answers[0].first.has_value());
    }
    const std::vector<QuestionSummary> rows = summarize(results);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].people == 30);
    CHECK(rows[0].right >= 10);
    CHECK(rows[0].kind == "play");
    CHECK(mostFrequentOf(rows[0].wrong) == "6.5 advance");
    CHECK(rows[0].wrong.at("6.5 advance") >= 10);
    CHECK_FALSE(rows[0].rightAtFirstShare().has_value());
}

}  // namespace se::teach
