#include "document/app_page.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "document/link.h"
#include "lesson/lesson_player.h"
#include "open_session.h"
#include "run/packed_file.h"

using namespace se;
using namespace se::view;

namespace {

const std::string kEmptyPage =
    "<head>\n<meta name=\"start\" content=\"\">\n<title>Spiraling Edge</title>\n</head>";

/// Options of `export SOURCE --app`.
Options exporting(const std::string& source) {
    Options o;
    o.input.source = source;
    o.exported = ExportOrder{};
    o.exported->program = true;
    const auto lesson = lessonOfSource(source);
    REQUIRE(lesson.ok());
    o.exported->lesson = lesson.value();
    return o;
}

PageContent mustContain(const Options& o) {
    const Result<PageContent> content = contentOf(o);
    REQUIRE_MESSAGE(content.ok(), content.error().message);
    return content.value();
}

/// The part of a text between two others.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const std::size_t begin = text.find(before) + before.size();
    return text.substr(begin, text.find(after, begin) - begin);
}

std::string unescaped(std::string text) {
    for (std::size_t at = 0; (at = text.find("&amp;", at)) != std::string::npos; ++at)
        text.replace(at, 5, "&");
    return text;
}

void write(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

std::vector<std::string> namesOf(const PageContent& content) {
    std::vector<std::string> names;
    for (const PackedFile& each : content.files) names.push_back(each.name);
    std::sort(names.begin(), names.end());
    return names;
}

std::string lessonOf(const std::string& input, const std::string& other) {
    return "# A & B\n```se lesson\nversion = 1\ninput = \"" + input +
           "\"\n```\n## One\nText.\n## Two\nText.\n```se step\ninput = \"" + other +
           "\"\nat = \"0\"\n```\n";
}

constexpr const char* kPoints =
    "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 1\n2 0 0 0 0 1\n2 1 0 0 0 1\n";

}  // namespace

TEST_CASE("A page begins with the options of its link, and with its title") {
    Options o = exporting("scene:torus");
    o.input = changed(o.input, specChange({{"rules", "robust"}, {"neighbors", "16"}}));
    o.goTo = "50%";
    const Result<std::string> page = pageWith(mustContain(o), kEmptyPage);
    REQUIRE(page.ok());
    const std::string link = unescaped(between(page.value(), "name=\"start\" content=\"", "\">"));
    const Result<Options> again = optionsFromLink(link);
    REQUIRE(again.ok());
    CHECK(again.value().input == o.input);
    CHECK(again.value().goTo == "50%");
    CHECK(page.value().find("<title>scene:torus</title>") != std::string::npos);
    CHECK_FALSE(pageWith(mustContain(o), "<title>Another page</title>").ok());
}

TEST_CASE("A page has a lesson of the program by its name") {
    for (const char* source : {"removal", "lesson:removal"}) {
        const PageContent content = mustContain(exporting(source));
        CHECK(linkText(content.options) == "lesson=removal");
        CHECK(content.title.find("removal") == std::string::npos);
        CHECK(content.files.empty());
    }
    Options ruled = exporting("removal");
    ruled.given = specChange({{"rules", "robust"}});
    CHECK_FALSE(contentOf(ruled).ok());
}

TEST_CASE("A page has the file of a lesson, and those that the lesson takes its points from") {
    const view::test::OwnFolder folder;
    write(folder / "data/a.xyz", kPoints);
    write(folder / "b.xyz", kPoints);
    write(folder / "first.lesson.md", lessonOf("b.xyz", "scene:torus"));
    write(folder / "mine.lesson.md", lessonOf("data/a.xyz", "first.lesson.md"));
    const PageContent content = mustContain(exporting((folder / "mine.lesson.md").string()));
    CHECK(linkText(content.options) == "file=mine.lesson.md");
    CHECK(content.title == "A & B");
    CHECK(namesOf(content) ==
          std::vector<std::string>{"b.xyz", "data/a.xyz", "first.lesson.md", "mine.lesson.md"});
    const std::string page = pageWith(content, kEmptyPage).value();
    CHECK(page.find("<title>A &amp; B</title>") != std::string::npos);
    CHECK(between(page, "data-file=\"data/a.xyz\">", "</script>") == base64Of(deflated(kPoints)));
    write(folder / "wrong.lesson.md", lessonOf("missing.xyz", "scene:torus"));
    CHECK_FALSE(lessonOfSource((folder / "wrong.lesson.md").string()).ok());
}

TEST_CASE("A page has the files of a run under their names alone") {
    const view::test::OwnFolder folder;
    write(folder / "a/scan.xyz", kPoints);
    write(folder / "b/other.ply", "ply");
    write(folder / "b/scan.xyz", "other bytes");
    Options o = exporting((folder / "a/scan.xyz").string());
    o.withText = (folder / "b/other.ply").string();
    o.with = CompareWith::otherMesh(o.withText);
    const PageContent content = mustContain(o);
    CHECK(linkText(content.options) == "file=scan.xyz&with=other.ply");
    CHECK(namesOf(content) == std::vector<std::string>{"other.ply", "scan.xyz"});
    o.with = CompareWith::otherMesh((folder / "b/scan.xyz").string());
    const Result<PageContent> two = contentOf(o);
    REQUIRE_FALSE(two.ok());
    CHECK(two.error().message.find("Two files are called scan.xyz") == 0);
    CHECK_FALSE(contentOf(exporting((folder / "missing.xyz").string())).ok());
    CHECK_FALSE(contentOf(exporting("-")).ok());
}

TEST_CASE("A page has a session with its notes and its start, and the points beside it") {
    const view::test::OwnFolder folder;
    write(folder / "a/scan.xyz", kPoints);
    Options o = exporting((folder / "a/scan.xyz").string());
    o.sessionPath = (folder / "work.sesession").string();
    o.session = SessionFile{};
    o.session->annotations.notes = "Look here.";
    o.input.start.triangles = {{0, 1, 2}};
    o.goTo = "0.seed";
    const PageContent content = mustContain(o);
    CHECK(linkText(content.options) == "file=page.sesession&goto=0.seed");
    CHECK(content.title == "work.sesession");
    REQUIRE(content.files.size() == 2);
    const Result<SessionFile> read = sessionFromJson(content.files[1].bytes, "page", {});
    REQUIRE_MESSAGE(read.ok(), read.error().message);
    CHECK(read.value().input.source == "scan.xyz");
    CHECK(read.value().input.start == o.input.start);
    CHECK(read.value().annotations.notes == "Look here.");
}

TEST_CASE("The empty page is found beside the program or in share, else it is said how to get it") {
    const view::test::OwnFolder folder;
    const auto program = folder / "bin";
    const Result<std::filesystem::path> none = findPage(program);
    REQUIRE_FALSE(none.ok());
    CHECK(none.error().message.find("app/web/build.sh") != std::string::npos);
    write(folder / "share/spiraling-edge/spiraling-edge.html", kEmptyPage);
    CHECK(findPage(program).value() == folder / "share/spiraling-edge/spiraling-edge.html");
    write(program / "spiraling-edge.html", kEmptyPage);
    CHECK(findPage(program).value() == program / "spiraling-edge.html");
}
