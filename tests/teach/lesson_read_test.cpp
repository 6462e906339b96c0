#include "teach/lesson_read.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>

#include "lesson_files.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "teach/lesson_keys.h"
#include "teach/question.h"

namespace se::teach {
namespace {

/// The fault that a text has, as "LINE: KEY: MESSAGE"; empty without one.
std::string faultOf(const std::string& text) {
    const LessonReading reading = readLesson(text, "x.lesson.md");
    return reading.ok() ? std::string() : faultText(reading.faults.front(), "x.lesson.md");
}

std::string manySteps(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += "## S\n";
    return text;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("A kind or a view that is unknown is answered by all that there are") {
    const std::string kind = faultOf(lessonWith(stepWith("ask", "kind = \"word\"")));
    for (const QuestionKind& each : questionKinds())
        CHECK(kind.find(" " + std::string(each.name)) != std::string::npos);
    const std::string view = faultOf(lessonWith(stepWith("step", "view = \"above\"")));
    for (const LessonView& each : lessonViews())
        CHECK(view.find(" " + std::string(each.name)) != std::string::npos);
}

TEST_CASE("a lesson is read with title, text, steps, minutes and lines") {
    const std::string text =
        "# A *title*\n\nHello.\n\n" +
        fenced("lesson", "version = 1\ninput = \"scene:figure-8\"\nnames = { p = 15 }") +
        "\n## One\n\nText [so](se:9.sphere.3).\n\n" +
        fenced("step", "at = \"9.limits.2\"\nminutes = 2.5") + "\nMore.\n\n## Two\n\nOnly text.\n";
    const LessonReading reading = readLesson(text, "x.lesson.md");
    REQUIRE(reading.ok());
    const Lesson& lesson = reading.lesson;
    CHECK(lesson.title == "A title");
    CHECK(lesson.text == "Hello.\n");
    CHECK(lesson.input == "scene:figure-8");
    CHECK(lesson.names == std::vector<PointName>{{15, "p"}});
    REQUIRE(lesson.steps.size() == 2);
    CHECK(lesson.steps[0].title == "One");
    CHECK(lesson.steps[0].text == "Text [so](se:9.sphere.3).\n\nMore.\n");
    REQUIRE(lesson.steps[0].links.size() == 1);
    CHECK(lesson.steps[0].links[0].address == "9.sphere.3");
    CHECK(lesson.steps[0].links[0].line == 13);
    CHECK(lesson.steps[0].lines.of("minutes") == 17);
    CHECK(lesson.minutes() == 3.5);
    CHECK(lesson.questions() == 0);
    CHECK(lesson.hash.size() == 24);
}

TEST_CASE("a lesson with line ends of Windows is read alike") {
    const std::string text = figure8Question("\"refused\"");
    std::string windows;
    for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const LessonReading reading = readLesson(windows, "x");
    REQUIRE(reading.ok());
    CHECK(reading.lesson.steps[0].text == "Text.\n");
    CHECK(reading.lesson.steps[0].question->answer == "refused");
}

TEST_CASE("a lone carriage return ends a line of a lesson, as in Markdown") {
    const std::string text = "# A\rb\r" + figure8Question("\"refused\"").substr(3);
    const LessonReading reading = readLesson(text, "x");
    CHECK(reading.faults.empty());
    REQUIRE(reading.lesson.steps.size() == 1);
    CHECK(reading.lesson.steps[0].text == "Text.\n");
}

TEST_CASE("HTML and other fenced blocks are text") {
    const LessonReading reading = readLesson(
        lessonWith("## One\n\n<b onclick=\"x\">bold</b>\n\n```sh\nspiraling-edge\n```\n"), "x");
    REQUIRE(reading.ok());
    CHECK(contains(reading.lesson.steps[0].text, "<b onclick"));
    CHECK(contains(reading.lesson.steps[0].text, "```sh\nspiraling-edge\n```"));
}

TEST_CASE("brackets in texts and comments are no brackets") {
    const std::string toml =
        "select = [ # }\n 1]\nrules = \"paper\"\ncamera = '{\"a\": [1]}'\n"
        "frame = \"all\" # ] }\nwhat_if = ["
        "\"\"\"9.sphere keep 46\"\"\"]\ninput = \"scene:grid\"\nnames = { \"\\\"}\" = 3 }";
    const LessonReading reading = readLesson(lessonWith(stepWith("step", toml)), "x");
    for (const LessonFault& fault : reading.faults) MESSAGE(faultText(fault, "x"));
    CHECK(reading.ok());
}

TEST_CASE("bad lessons are refused with line, key and reason") {
    struct Bad {
        std::string text;
        std::string fault;
    };
    const std::string ask = "kind = \"choice\"\nat = \"9.limits.2\"\nanswer = \"A\"\n";
    const std::vector<Bad> table{
        {"", "no block `se lesson`"},
        {"# Only a title\n", "no block `se lesson`"},
        {lessonWith(""), "no step: begin one with `## Title`"},
        {lessonWith(stepWith("step", "untill = \"9.sphere.2\"")),
         "x.lesson.md:13: untill: no such key; the nearest is until"},
        {lessonWith(stepWith("step", "at = 9")), ":13: at: expected PIVOT"},
        {lessonWith(stepWith("step", "at = \"9.spere.2\"")), ":13: at: expected PIVOT"},
        {lessonWith(stepWith("step", "at = \"101%\"")), ":13: at: expected PIVOT"},
        {lessonWith(stepWith("step", "minutes = -1")), ":13: minutes: expected a number"},
        {lessonWith(stepWith("step", "\nat =")), ":14: Error while parsing"},
        {lessonWith(stepWith("step", "\nselect = [}")), ":14: a bracket that does not belong"},
        {lessonWith(stepWith("step", "select = [ # ]\n }")), ":14: a bracket that does not belong"},
        {lessonWith(stepWith("step", "names = { a = 1 ] }")),
         ":13: a bracket that does not belong"},
        {lessonWith(stepWith("step", "hide = [\xC3\xA9]")), ":13: a letter or sign that does not"},
        {lessonWith(stepWith("step", "\xC3\xA9 = 1")), ":13: a letter or sign that does not"},
        {lessonWith(stepWith("step", "at = 9x\"\xC3\xA9]")), ":13: a letter or sign that does not"},
        {lessonWith(stepWith("step", "at = }")), ":13: a bracket that does not belong"},
        {lessonWith(stepWith("step", "at = \"0\"\n [part]")),
         ":14: a bracket that does not belong"},
        {lessonWith(stepWith("step", "[.")), ":13: a bracket that does not belong"},
        {lessonWith(stepWith("step", "at = [[")), ":13: Error while parsing"},
        {lessonWith(std::string(201 * 3, '#')), "no step"},
        {lessonWith(manySteps(201)), "over 200 steps"},
        {lessonWith(stepWith("step", "view = \"above\"")), "view: expected one of front"},
        {lessonWith(stepWith("step", "frame = \"near\"")), "frame: expected one of all, pivot"},
        {lessonWith(stepWith("step", "play = \"pivot 2\"")), "play: expected a speed"},
        {lessonWith(stepWith("step", "play = \"pivot 2/s\"")), "play: needs until"},
        {lessonWith(stepWith("step", "camera = \"no\"")), "camera: expected JSON"},
        {lessonWith(stepWith("step", "select = [1, 2, 3, 4]")), "select: expected one to three"},
        {lessonWith(stepWith("step", "rules = \"none\"")), "rules: --rules none: no such set"},
        {lessonWith(stepWith("step", "rule = \"sphere=7\"")), "rule: --rule sphere=7"},
        {lessonWith(stepWith("step", "at = \"0\"\nrule = \"maxgap=500\"")),
         ":14: rule: --rule maxgap=500"},
        {lessonWith(stepWith("step", "rules = \"paper\"\nwhat_if = \"9.sphere hold 1\"")),
         ":14: what_if: --what-if"},
        {lessonWith(stepWith("step", "names = { z = 3 }")), ":13: names: needs input"},
        {lessonWith(stepWith("step", "pin = [\"spheres\", \"circle\"]")),
         ":13: pin: expected a list of layers"},
        {lessonWith(stepWith("step", "hide = [\"grid\"]")), ":13: hide: expected a list"},
        {lessonWith(stepWith("step", "facts = [[\" \", \"points: 50\"]]")),
         ":13: facts: expected a list of lists"},
        {lessonWith("## S\n\n```se step\nat = \"0\"\n## T\n"), ":10: the block has no end"},
        {"# T\n```se lesson\nversion = 1\n", ":2: the block has no end"},
        {lessonWith(stepWith("step", "compare = \"--fast 1\"")), "compare: --fast: no such option"},
        {lessonWith(stepWith("step", "compare = \"--rules\"")), "its value is missing"},
        {lessonWith(stepWith("steps", "")), "expected `se lesson`, `se step` or `se ask`"},
        {lessonWith(stepWith("step", "") + fenced("step", "")), "a second `se step`"},
        {lessonWith(stepWith("ask", ask + "options = [\"a\", \"b\"]") + fenced("ask", ask)),
         "a second question in this step"},
        {lessonWith(stepWith("lesson", "version = 1")), "a second `se lesson`"},
        {lessonWith(stepWith("ask", "at = \"9.limits.2\"")), "kind: missing"},
        {lessonWith(stepWith("ask", "kind = \"word\"")), "kind: expected one of points, point"},
        {lessonWith(stepWith("ask", "kind = \"points\"")), "answer: missing: a list of points"},
        {lessonWith(stepWith("ask", "kind = \"point\"\nanswer = \"refused\"")),
         "refused is an answer of questions of kind points"},
        {lessonWith(stepWith("ask", ask)), "options: expected two to four answers"},
        {lessonWith(stepWith("ask", ask + "options = [\"a\", \"a\"]")), "two of the answers"},
        {lessonWith(stepWith("ask", ask + "options = [\"a\", \"b\"]\nverdicts = [\"kept\"]")),
         "verdicts: expected one for each"},
        {lessonWith(
             stepWith("ask", ask + "options = [\"a\", \"b\"]\nverdicts = [\"kept\", \"kept\"]")),
         ":17: verdicts: two of them are the same"},
        {"# T\n\n" + fenced("lesson", "version = 1\ninput = \"scene:grid\"\nrule = [\"tie=no\"]") +
             "## S\n",
         ":6: rule: --rule tie=no"},
        {"# T\n\n" +
             fenced("lesson",
                    "version = 1\ninput = \"scene:grid\"\noptions = { neighbors = 12, radius = 0.5 "
                    "}") +
             "## S\n",
         ":6: options: expected a table of one of neighbors, radius and reach"},
        {"# T\n\n" + fenced("lesson", "version = 2\ninput = \"scene:figure-8\"") + "## S\n",
         ":4: version: expected 1"},
        {"# T\n\n" + fenced("lesson", "version = 1") + "## S\n", ":3: input: missing"},
        {"# T\n\n" + fenced("lesson", "version = 1\ninput = \"../a.ply\"") + "## S\n",
         ":5: input: ../a.ply is not in the folder"},
        {"# T\n\n" + fenced("lesson", "version = 1\ninput = \"/etc/passwd\"") + "## S\n",
         "is not in the folder"},
        {lessonWith("## S\n\n![a](../../a.png)\n"), "the image ../../a.png is not in the folder"},
        {lessonWith("## S\n\n![a](http://example.org/a.png)\n"), "is not in the folder"},
        {lessonWith("## S\n\nSee [this](se:nowhere).\n"), ":10: se:nowhere: expected an address"},
        {lessonWith("## S\n\n\xff\n"), "x.lesson.md:10: not UTF-8"},
        {lessonWith("## S\n\n\xe2\x82\n"), "not UTF-8"},
        {std::string(kLongestLesson + 1, 'a'), "over 1 MB"},
        {lessonWith("## S\n\n") + std::string(1, '\0'), "a zero byte"},
    };
    for (const Bad& each : table) {
        CAPTURE(each.fault);
        const std::string found = faultOf(each.text);
        CAPTURE(found);
        CHECK(contains(found, each.fault));
    }
}

TEST_CASE("a fault of a lesson quotes at most 80 characters of it") {
    const std::string word = "\\u001b" + std::string(5000, 'w');
    for (const std::string& text :
         {lessonWith(stepWith("step", word.substr(6) + " = 1")),
          lessonWith(stepWith("step", "compare = \"" + word + "\"")),
          lessonWith(stepWith("step", "compare = \"--rules " + word + "\"")),
          lessonWith(stepWith("step", "names = { \"" + word + "\" = 1 }")),
          lessonWith("## S\n\n![a](../" + word + ".png)\n"),
          lessonWith("## S\n\nSee [this](se:" + word + ").\n"),
          "# T\n\n" + fenced("lesson", "version = 1\ninput = \"../" + word + "\"") + "## S\n"}) {
        const std::string fault = faultOf(text);
        CAPTURE(fault);
        CHECK(fault != "");
        CHECK(fault.size() < 300);
    }
}

TEST_CASE("all faults of a lesson are found, in the order of the file") {
    const LessonReading reading =
        readLesson(lessonWith(stepWith("step", "untill = \"1\"\nframe = \"far\"") +
                              stepWith("step", "at = \"x\"")),
                   "x");
    REQUIRE(reading.faults.size() == 3);
    CHECK(reading.faults[0].key == "untill");
    CHECK(reading.faults[1].key == "frame");
    CHECK(reading.faults[2].key == "at");
}

TEST_CASE("the first line of faults of a lesson with an open block is that of the block") {
    const LessonReading reading = readLesson("# T\n```se lesson\nversion = 1\n## S\n", "x");
    REQUIRE(reading.faults.size() == 1);
    CHECK(reading.faults[0].line == 2);
    const std::string tilde =
        "# T\n\n~~~~se lesson\nversion = 1\ninput = \"scene:grid\"\n~~~~~  \n## S\n";
    CHECK(faultOf(tilde) == "");
}

TEST_CASE("a file that is none, or too long, is refused") {
    CHECK_FALSE(readLessonFile("no-such-file.lesson.md").ok());
    const auto path = std::filesystem::temp_directory_path() / "se-long.lesson.md";
    REQUIRE(writeFileAtomically(path, std::string(kLongestLesson + 1, 'a')));
    const Result<LessonReading> reading = readLessonFile(path);
    REQUIRE_FALSE(reading.ok());
    CHECK(contains(reading.error().message, "holds more than 1000000 bytes"));
    std::filesystem::remove(path);
}

TEST_CASE("a pipe, a device and a link out of the folder are neither image nor input of a lesson") {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "se-lesson-links";
    fs::remove_all(folder);
    fs::create_directories(folder / "mine");
    for (const char* name : {"outside.png", "mine/good.png"})
        REQUIRE(writeFileAtomically(folder / name, "x"));
    REQUIRE(::mkfifo((folder / "mine/pipe").c_str(), 0600) == 0);
    fs::create_symlink("/dev/zero", folder / "mine/zero");
    fs::create_symlink("../outside.png", folder / "mine/out.png");
    fs::create_directory_symlink("..", folder / "mine/up");
    fs::create_symlink("good.png", folder / "mine/link.png");
    const auto faultOf = [&](const std::string& input, const std::string& image) {
        const fs::path path = folder / "mine/a.lesson.md";
        const std::string text = "# T\n\n" +
                                 fenced("lesson", "version = 1\ninput = \"" + input + "\"") +
                                 "## S\n\n![so](" + image + ")\n";
        REQUIRE(writeFileAtomically(path, text));
        const Result<LessonReading> reading = readLessonFile(path);
        REQUIRE(reading.ok());
        const auto& faults = reading.value().faults;
        return faults.empty() ? std::string() : faults.front().message;
    };
    for (const char* name : {"pipe", "zero", "out.png", "up/outside.png"}) {
        CAPTURE(name);
        CHECK(contains(faultOf("scene:grid", name), "in the folder of the lesson"));
        CHECK(contains(faultOf(name, "good.png"), "in the folder of the lesson"));
    }
    // A missing file is reported when it is opened.
    for (const char* name : {"good.png", "link.png", "missing.png"}) {
        CAPTURE(name);
        CHECK(faultOf("scene:grid", name).empty());
        CHECK(faultOf(name, "good.png").empty());
    }
    fs::remove_all(folder);
}

TEST_CASE("each key of the table is in docs/lessons.md") {
    const Result<std::string> page =
        readBytes(std::filesystem::path(SPIRALING_EDGE_DOCS) / "lessons.md");
    REQUIRE(page.ok());
    for (const std::string_view key : lessonKeys()) {
        CAPTURE(key);
        CHECK(contains(page.value(), "`" + std::string(key) + "`"));
    }
}

TEST_CASE("each layer is in docs/lessons.md") {
    const Result<std::string> page =
        readBytes(std::filesystem::path(SPIRALING_EDGE_DOCS) / "lessons.md");
    REQUIRE(page.ok());
    const std::string list = page.value().substr(page.value().find("Layers: "));
    for (const std::string_view layer : kLayerNames) {
        CAPTURE(layer);
        CHECK(contains(list.substr(0, list.find("\n\n")), std::string(layer)));
    }
}

}  // namespace se::teach
