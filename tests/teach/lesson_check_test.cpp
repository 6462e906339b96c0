#include "teach/lesson_check.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "lesson_files.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/verdict_table.h"
#include "spiraling_edge/why/figure_check.h"
#include "teach/embedded_lessons.h"
#include "teach/lesson_read.h"
#include "teach/lesson_skeleton.h"
#include "teach/question.h"

namespace se::teach {
namespace {

std::vector<LessonFault> faultsOf(const std::string& text) {
    const LessonReading reading = readLesson(text, "x");
    for (const LessonFault& fault : reading.faults) MESSAGE(faultText(fault, "x"));
    REQUIRE(reading.ok());
    LessonRuns runs({});
    return checkLesson(reading.lesson, runs);
}

/// The first fault, with "malformed" or "disagrees"; "good" without one.
std::string checkedText(const std::string& text) {
    const std::vector<LessonFault> faults = faultsOf(text);
    if (faults.empty()) return "good";
    return (isMalformed(faults) ? "malformed " : "disagrees ") + faultText(faults.front(), "x");
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string stepCheck(const std::string& toml) {
    return checkedText(lessonWith(stepWith("step", toml)));
}
std::string askCheck(const std::string& toml) {
    return checkedText(lessonWith(stepWith("ask", toml)));
}

/// The lesson with nothing to check, ready for a fact of one step and the run that it compares.
Lesson withFactsOf(Lesson lesson, std::size_t step) {
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        LessonStep& each = lesson.steps[i];
        each.facts.clear();
        each.links.clear();
        each.expect.clear();
        each.question.reset();
        if (i != step) each.compare.clear();
    }
    return lesson;
}

/// The claim with a number that is one too large, or with the opposite relation.
std::string flippedClaim(std::string claim) {
    const std::size_t value = claim.rfind(": ") + 2;
    if (claim[value] == '<' || claim[value] == '>') {
        claim[value] = claim[value] == '<' ? '>' : '<';
        return claim;
    }
    if (claim[value] == 'A' || claim[value] == 'B') return claim.insert(value, "< ");
    return claim.substr(0, value) + std::to_string(std::stoi(claim.substr(value)) + 1);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a question to play is answered by the moves of the run") {
    const std::string play = "kind = \"play\"\nat = \"9.pivot.1\"\nanswer = ";
    CHECK(askCheck(play + "\"moves\"") == "good");
    CHECK(askCheck(play + "[\"keep t\", \"remove q\", \"keep s\", \"keep r\", \"fan first t s r "
                          "last\", \"next last\"]") == "good");
    CHECK(
        askCheck(play + "[\"keep t\", \"keep q\"]")
            .starts_with("disagrees x:15: answer: keep t; keep q is not what the run gives (moves: "
                         "keep t; remove q; keep s; keep r; fan first t s r last; next last)"));
    CHECK(has(askCheck(play + "[\"keep 99\"]"), "answer: 99: there are 50 points, from 0"));
    CHECK(has(askCheck(play + "[\"drop q\"]"), "answer: \"drop\": expected start, end,"));
    CHECK(has(askCheck("kind = \"play\"\nat = \"9.limits.2\"\nanswer = \"moves\""),
              "`at` has to be where an interior pivot begins"));
}

TEST_CASE("every embedded lesson agrees with its runs, and has a length") {
    CHECK(embeddedLessons().size() == 9);
    for (const EmbeddedLesson& each : embeddedLessons()) {
        CAPTURE(each.id);
        CHECK(checkedText(std::string(each.text)) == "good");
        CHECK(readLesson(each.text, "x").lesson.minutes() > 0.0);
    }
    CHECK(readLesson(findEmbeddedLesson("class")->text, "x").lesson.minutes() == 20.0);
    CHECK(readLesson(findEmbeddedLesson("tour")->text, "x").lesson.minutes() == 1.5);
}

TEST_CASE("questions of the lesson for a class can be answered by hands") {
    const Lesson lesson = readLesson(findEmbeddedLesson("class")->text, "x").lesson;
    CHECK(lesson.questions() >= 5);
    for (const LessonStep& step : lesson.steps) {
        if (step.question) CHECK(step.question->options.size() >= 2);
    }
}

TEST_CASE("the example of docs/lessons.md agrees with its run") {
    const Result<std::string> page =
        readBytes(std::filesystem::path(SPIRALING_EDGE_DOCS) / "lessons.md");
    REQUIRE(page.ok());
    const std::string begin = "````markdown\n";
    const std::size_t from = page.value().find(begin);
    REQUIRE(from != std::string::npos);
    const std::size_t first = from + begin.size();
    const std::string example =
        page.value().substr(first, page.value().find("````", first) - first);
    CHECK(checkedText(example) == "good");
    CHECK(readLesson(example, "x").lesson.questions() == 1);
}

TEST_CASE("docs/lessons.md lists the outcomes of decisions") {
    const Result<std::string> page =
        readBytes(std::filesystem::path(SPIRALING_EDGE_DOCS) / "lessons.md");
    REQUIRE(page.ok());
    std::string list = page.value().substr(page.value().find("Outcomes: "));
    std::replace(list.begin(), list.end(), '\n', ' ');
    for (const std::string_view words : outcomeWords()) {
        CAPTURE(std::string(words));
        CHECK(isPossibleOutcome(words));
    }
    for (const VerdictRow& row : verdictTable()) {
        CAPTURE(std::string(row.text));
        CHECK(has(list, " " + std::string(row.text)));
    }
    CHECK(isPossibleOutcome("splits into 19 and 13"));
    CHECK_FALSE(isPossibleOutcome("split"));
}

TEST_CASE("a flipped expectation of any step is found") {
    for (const EmbeddedLesson& each : embeddedLessons()) {
        const Lesson lesson = readLesson(each.text, "x").lesson;
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            if (lesson.steps[i].expect.empty()) continue;
            Lesson flipped = lesson;
            const bool seed = lesson.steps[i].expect == "seed";
            flipped.steps[i].expect = seed ? "freed" : "seed";
            LessonRuns runs({});
            const std::vector<LessonFault> faults = checkLesson(flipped, runs);
            REQUIRE(faults.size() == 1);
            CHECK(faults[0].key == "expect");
            CHECK(faults[0].sort == FaultSort::Disagrees);
        }
    }
}

TEST_CASE("a flipped claim of any lesson is found, and so are words that are not in its text") {
    std::size_t claims = 0;
    for (const EmbeddedLesson& each : embeddedLessons()) {
        CAPTURE(each.id);
        const Lesson lesson = readLesson(each.text, "x").lesson;
        LessonRuns runs({});
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            Lesson flipped = withFactsOf(lesson, i);
            for (const LessonFact& fact : lesson.steps[i].facts) {
                flipped.steps[i].facts = {fact};
                flipped.steps[i].facts[0].words += " (not)";
                CHECK(checkLesson(flipped, runs).size() == 1);
                for (std::size_t claim = 0; claim < fact.claims.size(); ++claim) {
                    ++claims;
                    CAPTURE(fact.claims[claim]);
                    flipped.steps[i].facts = {fact};
                    flipped.steps[i].facts[0].claims = {flippedClaim(fact.claims[claim])};
                    const std::vector<LessonFault> faults = checkLesson(flipped, runs);
                    REQUIRE(faults.size() == 1);
                    CHECK(faults[0].sort == FaultSort::Disagrees);
                    CHECK(faults[0].key == "facts");
                }
            }
        }
    }
    CHECK(claims > 100);
}

TEST_CASE("facts are checked against the run: numbers of the mesh, rules, angles, decisions") {
    const auto fact = [](const std::string& words, const std::string& claim) {
        return stepCheck("compare = \"--rule sphere=off\"\nfacts = [[\"" + words + "\", \"" +
                         claim + "\"]]");
    };
    CHECK(fact("Text", "at=9 stage=emit: 4") == "good");
    CHECK(fact("Text", "at=9 stage=sphere verdict=removed point=46: 1") == "good");
    CHECK(fact("Text", "maxgap: 120") == "good");
    CHECK(fact("Text", "angle p t q: 6") == "good");
    CHECK(fact("Text", "points: 50") == "good");
    CHECK(fact("Text", "thin_triangles: < B") == "good");
    CHECK(fact("Text", "B thin_triangles: > A") == "good");
    CHECK(has(fact("Text", "shared_triangles: 0"),
              "disagrees x:14: facts: shared_triangles: 0: it is "));
    CHECK(fact("Text", "at=9 stage=emit: 5") ==
          "disagrees x:14: facts: at=9 stage=emit: 5: it is 4");
    CHECK(fact("Text", "second_layers: > 0") ==
          "disagrees x:14: facts: second_layers: > 0: it is 0");
    CHECK(fact("Other", "points: 50") ==
          "disagrees x:14: facts: \"Other\" is not in the text of the step");
    CHECK(has(fact("Text", "points 50"),
              "malformed x:14: facts: points 50: expected SUBJECT: NUMBER"));
    CHECK(has(fact("Text", "points: many"), "malformed x:14: facts: points: many: "));
    CHECK(has(fact("Text", "angle p t: 6"), "malformed x:14: facts: angle p t: 6: an angle is of"));
    CHECK(has(fact("Text", "at=nine: 6"), "malformed x:14: facts: at=nine: 6: "));
    CHECK(has(stepCheck("facts = [[\"Text\", \"B points: 50\"]]"),
              "facts: B points: 50: there is no second run"));
    CHECK(has(stepCheck("facts = [[\"Text\", \"points: B\"]]"),
              "facts: points: B: there is no second run"));
}

TEST_CASE("a wrong typed answer is found, a right one is not") {
    CHECK(checkedText(figure8Question("\"refused\"")) == "good");
    CHECK(checkedText(figure8Question("[\"q\"]")) == "good");
    CHECK(checkedText(figure8Question("[46]")) == "good");
    CHECK(checkedText(figure8Question("[\"t\", \"s\", \"r\"]")) == "good");  // those that are kept
    const std::string wrong = checkedText(figure8Question("[\"t\"]"));
    CHECK(has(wrong, "disagrees x:16: answer: t is not what the run gives (refused: q; kept: "));
    CHECK(has(checkedText(figure8Question("[\"x\"]")), "malformed x:16: answer: x: no such name"));
    CHECK(has(checkedText(figure8Question("[5000]")), "there are"));
    CHECK(checkedText(replaced(figure8Question("[\"t\"]"), "why", "unchecked = true\nwhy")) ==
          "good");
}

TEST_CASE("numbers and choices are checked against the run") {
    const std::string number = "kind = \"number\"\nat = \"9.sphere.4\"\nuntil = \"9.emit.4\"\n";
    CHECK(askCheck(number + "answer = \"count:triangles\"") == "good");
    CHECK(askCheck(number + "answer = 4") == "good");
    CHECK(has(askCheck(number + "answer = 5"), "disagrees x:16: answer: 5 is not"));
    CHECK(has(askCheck(number + "answer = \"many\""), "malformed x:16: answer: many: expected"));
    CHECK(askCheck(number + "answer = 4\noptions = [\"3\", \"4\"]") == "good");
    CHECK(has(askCheck(number + "answer = 4\noptions = [\"3\", \"5\"]"),
              "disagrees x:17: options: exactly one of them"));
    CHECK(has(askCheck(number + "answer = 4\nwithin = 1\noptions = [\"3\", \"5\"]"), "options:"));
    const std::string choice =
        "kind = \"choice\"\nat = \"9.sphere.1\"\nuntil = \"9.sphere.2\"\noptions = [\"goes\", "
        "\"stays\"]\n";
    const std::string verdicts = "verdicts = [\"removed\", \"inside sphere\"]\n";
    CHECK(askCheck(choice + verdicts + "answer = \"verdict\"") == "good");
    CHECK(askCheck(choice + verdicts + "answer = \"A\"") == "good");
    CHECK(has(askCheck(choice + verdicts + "answer = \"B\""), "disagrees"));
    CHECK(has(askCheck(choice + "answer = \"verdict\""), "is not one of the options"));
    CHECK(has(askCheck(choice + "verdicts = [\"removed\", \"insight sphere\"]\nanswer = \"A\""),
              "malformed x:17: verdicts: \"insight sphere\" is no outcome of a decision; the "
              "nearest is \"inside sphere\""));
    CHECK(has(askCheck(choice + "answer = \"C\""), "malformed"));
}

TEST_CASE("faults that only the run shows name line, key and what is there") {
    CHECK(has(stepCheck("at = \"9.sphere.5\""),
              "malformed x:13: at: pivot 9 has 4 decisions of sphere, not 5"));
    CHECK(has(stepCheck("at = \"9.split.1\""), "at: pivot 9 has no decision of split"));
    CHECK(has(stepCheck("at = \"900.sphere.1\""),
              "at: the run ends at pivot 77, there is no pivot 900"));
    CHECK(has(stepCheck("until = \"9.sphere.5\""), "until: pivot 9 has"));
    CHECK(has(stepCheck("at = \"9.sphere.2\"\nexpect = \"inside sphere\""),
              "disagrees x:14: expect: the outcome there is \"removed\""));
    CHECK(has(stepCheck("at = \"9.sphere.2\"\nexpect = \"remove\""),
              "malformed x:14: expect: \"remove\" is no outcome of a decision; the nearest is "
              "\"removed\""));
    CHECK(has(stepCheck("select = \"u\""), "select: u: no such name; add it to names"));
    CHECK(has(stepCheck("at = \"9.sphere.2\"\ncompare = \"--rule delay=off\""),
              "disagrees x:14: compare: both runs make the same triangles"));
    CHECK(has(stepCheck("what_if = \"9.sphere keep 9\""), "malformed x:13: what_if:"));
    CHECK(has(stepCheck("input = \"scene:nothing\""), "input: scene:nothing: no such scene"));
    CHECK(has(stepCheck("input = \"missing.ply\""), "malformed x:13: input: "));
    CHECK(has(stepCheck("input = \"scene:grid\"\nnames = { a = 81 }"),
              "names: a = 81: there are 81 points, from 0"));
    CHECK(has(checkedText(lessonWith("## S\n\n[x](se:9.sphere.9)\n")), "x:10: pivot 9 has 4"));
    const std::string backward =
        "kind = \"points\"\nat = \"9.sphere.2\"\nuntil = \"9.sphere.1\"\nanswer = \"refused\"";
    CHECK(has(askCheck(backward), "until: 9.sphere.1 is not after 9.sphere.2"));
    CHECK(has(stepCheck("at = \"9.sphere.2\"\nuntil = \"9.sphere.1\""),
              "malformed x:14: until: 9.sphere.1 is not after 9.sphere.2"));
    CHECK(has(stepCheck("at = \"9\"\nuntil = \"3\""), "until: 3 is not after 9"));
    CHECK(stepCheck("at = \"9.sphere.2\"\nuntil = \"9.emit.1\"") == "good");
    CHECK(stepCheck("at = \"0\"\nuntil = \"1\"") == "good");
    CHECK(stepCheck("at = \"50%\"") == "good");
    CHECK(stepCheck("at = \"0\"") == "good");
    CHECK(stepCheck("at = \"100%\"") == "good");
}

TEST_CASE("inputs that are lessons in a cycle are refused") {
    const auto folder = std::filesystem::temp_directory_path() / "se-lesson-cycle";
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& input) {
        const std::string text =
            "# T\n\n" + fenced("lesson", "version = 1\ninput = \"" + input + "\"") + "## S\n";
        REQUIRE(writeFileAtomically(folder / name, text));
    };
    write("a.lesson.md", "b.lesson.md");
    write("b.lesson.md", "a.lesson.md");
    write("c.lesson.md", "d.lesson.md");
    write("d.lesson.md", "scene:grid");
    const auto checked = [&](const std::string& name) {
        const Result<LessonReading> reading = readLessonFile(folder / name);
        REQUIRE(reading.ok());
        REQUIRE(reading.value().ok());
        LessonRuns runs(folder);
        return checkLesson(reading.value().lesson, runs);
    };
    REQUIRE(checked("a.lesson.md").size() == 1);
    CHECK(has(checked("a.lesson.md")[0].message, "the inputs form a cycle"));
    CHECK(checked("c.lesson.md").empty());
    std::filesystem::remove_all(folder);
}

TEST_CASE("a new lesson on any scene agrees with its run") {
    for (const Scene& scene : scenes()) {
        CAPTURE(scene.id);
        const std::string source = "scene:" + std::string(scene.id);
        const Result<PreparedRun> run = prepareRun(scene.build(), source, {});
        REQUIRE(run.ok());
        const Result<std::string> text = lessonSkeleton(source, run.value());
        REQUIRE(text.ok());
        CHECK(checkedText(text.value()) == "good");
    }
}

}  // namespace se::teach
