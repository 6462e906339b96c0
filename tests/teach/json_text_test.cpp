#include "teach/json_text.h"

#include <doctest/doctest.h>

#include "lesson_files.h"
#include "teach/lesson_read.h"
#include "teach/result.h"
#include "teach/spec_json.h"
#include "teach/trace/setrace.h"

namespace se::teach {
namespace {

using nlohmann::json;

std::string nested(std::size_t levels) {
    return std::string(levels, '[') + std::string(levels, ']');
}

std::string jsonFault(const std::string& text) {
    const Result<json> read = jsonFromText<json>(text, "x.json");
    return read ? "none" : read.error().message;
}

/// The messages of all readers for a document that has `value` somewhere.
std::vector<std::string> faultsOfReaders(const std::string& value) {
    const auto of = [](const auto& read) {
        return read ? std::string("none") : read.error().message;
    };
    const LessonReading lesson =
        readLesson(lessonWith(stepWith("step", "camera = '{\"target\": " + value + "}'")), "x");
    const std::string trace = "{\"setrace\":1,\"points\":6}\n{\"p\":" + value + "}\n";
    return {of(startFromText("{\"triangles\": " + value + "}", "x")),
            of(resultFromJson("{\"answers\": " + value + "}", "x")), of(readTrace(trace, "x")),
            lesson.faults.empty() ? "none" : lesson.faults.front().message};
}

}  // namespace

TEST_CASE("JSON: 64 levels are read, more are refused with their place, however many") {
    CHECK(jsonFault(nested(64)) == "none");
    const std::string refused =
        "x.json: line 1, column 65: expected at most 64 levels of lists and objects";
    CHECK(jsonFault(nested(65)) == refused);
    CHECK(jsonFault(std::string(100000, '[')) == refused);
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += "{\"a\":\n";
    CHECK(jsonFault(objects) ==
          "x.json: line 65, column 1: expected at most 64 levels of lists and objects");
    CHECK(jsonFault("[\"" + std::string(1000, '[') + "\\\"[\"]") == "none");
    CHECK(jsonFault("[" + std::string(100, ']')).starts_with("x.json: line 1, column 3: "));
}

TEST_CASE("JSON: a number beyond double is refused with its place and its keys") {
    const std::string expected = "expected a number within the range of double, up to 1.79e308, ";
    CHECK(jsonFault("[1,\n \"\xc3\xbc\", 1e400]") ==
          "x.json: line 2, column 7: " + expected + "got \"1e400\"");
    CHECK(jsonFault("{\"a\": {\"b\": [0, -1e400]}}") ==
          "x.json: line 1, column 17: \"a.b\": " + expected + "got \"-1e400\"");
    const std::string digits(400, '9');
    CHECK(jsonFault(digits) ==
          "x.json: line 1, column 1: " + expected + "got \"" + digits.substr(0, 80) + "...\"");
    CHECK(jsonFault("[1e-400, 1.7976931348623157e308, \"1e400\"]") == "none");
}

TEST_CASE("JSON: text that is none is refused with the place where it ends to be") {
    CHECK(jsonFault("") == "x.json: line 1, column 1: expected JSON, found the end");
    CHECK(jsonFault("{\"a\":\n") == "x.json: line 2, column 1: expected JSON, found the end");
    CHECK(jsonFault("[1, \x1b[31m]\nrest") ==
          "x.json: line 1, column 5: expected JSON, found \"\\x1b[31m]\"");
    for (const std::string text : {"\xff", "[1,]", "\"a", "{1: 2}", "1 2", "tru", "\"\\u12\"", "-"})
        CHECK(jsonFault(text).starts_with("x.json: line 1, column "));
}

TEST_CASE("JSON: every reader refuses deep lists and numbers beyond double, and quotes little") {
    for (const std::string& fault : faultsOfReaders(std::string(100000, '[')))
        CHECK(fault.find("64 levels of lists and objects") != std::string::npos);
    for (const std::string& fault : faultsOfReaders("[0, 1e400]"))
        CHECK(fault.find("got \"1e400\"") != std::string::npos);
    for (const std::string& fault : faultsOfReaders("\"\x1b[31m" + std::string(5000, 'a') + "\"")) {
        CHECK(fault.size() < 300);
        CHECK(printable(fault) == fault);
    }
    const Result<GivenStart> key =
        startFromText("{\"\\u001b" + std::string(5000, 'k') + "\": 1}", "x");
    REQUIRE(!key);
    CHECK(key.error().message.size() < 200);
    CHECK(printable(key.error().message) == key.error().message);
}

TEST_CASE("JSON: a written document is read back, and safe to show") {
    const json document{{"a", "\x1b\x7f\xc2\x9b\xe2\x80\xae \xc3\xbc\n"}, {"b", 1}};
    const std::string text = jsonText(document);
    CHECK(json::parse(text) == document);
    CHECK(printableLines(text) == text);
    CHECK(json::parse(jsonText(json("\xff"))) == "\xef\xbf\xbd");
}

}  // namespace se::teach
