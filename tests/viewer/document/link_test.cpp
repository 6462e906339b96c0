#include "document/link.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "jobs/open_lesson.h"
#include "run/embedded_files.h"
#include "run/packed_file.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/spec_fields.h"
#include "teach/embedded_lessons.h"

using namespace se;
using namespace se::view;

namespace {

/// The link that the options of a link give.
std::string again(const std::string& link) {
    const Result<Options> read = optionsFromLink(link);
    CAPTURE(link);
    if (!read) return read.error().message;
    return linkText(read.value());
}

std::string complaintOf(const std::string& link) {
    const Result<Options> read = optionsFromLink(link);
    return read ? "none" : read.error().message;
}

/// A value of each name, with an input that it goes with.
const std::vector<std::string> kLinks = {
    "scene=torus",
    "lesson=tour&step=3",
    "lesson=practice:7",
    "sample=torus,n=500",
    "file=a%20b/bunny.ply",
    "file=https://example.org/bunny.ply%3Fraw%26x",
    "scene=torus&goto=137.sphere.3",
    "scene=torus&goto=50%25",
    "scene=torus&goto=difference&with=--rules%20robust%20-k%2010",
    "scene=torus&alert=holes:2",
    "scene=torus&camera=0.1235,-2,1e-05,3.4,-60,24",
    "scene=torus&camera=0,0,0,1,2,3,orthographic,y",
    "scene=torus&hash=00ab3f9e10c24d77",
    "scene=torus&layout=present",
    "scene=torus&layout=learn",
    "scene=torus&theme=light&mesh-style=wire&point-tint=margin",
    "scene=torus&play=20&focus"};

}  // namespace

TEST_CASE("Every name of a link is read and written again") {
    std::string all;
    for (const std::string& link : kLinks) {
        CHECK(again(link) == link);
        all += "&" + link;
    }
    all += "&" + std::string("pack=");
    for (const LinkPart& each : linkParts()) {
        CAPTURE(std::string(each.name));
        const bool tried = all.find("&" + std::string(each.name) + "=") != std::string::npos ||
                           all.find("&" + std::string(each.name)) != std::string::npos;
        CHECK(tried);
    }
}

TEST_CASE("Every field of a run stands in a link by its key") {
    const std::vector<std::string> fields = {"crop=0,0,0,1,1,1",
                                             "thin=0.5",
                                             "scale=2,2,0.001",
                                             "left_out=3..9,40",
                                             "doctor=duplicates",
                                             "rules=robust",
                                             "switches=fill=on",
                                             "neighbors=16",
                                             "radius=0.5",
                                             "reach=2.5",
                                             "symmetric=on",
                                             "normals=derived",
                                             "normals=oriented",
                                             "scanner=1,2,3",
                                             "box=auto",
                                             "rim=on",
                                             "what_if=137.sphere%20keep%20812"};
    std::string all;
    for (const std::string& field : fields) {
        const std::string link = "scene=torus&" + field;
        CHECK(again(link) == link);
        all += "&" + field;
    }
    for (const SpecField& each : specFields()) {
        // What is kept is written as a rule.
        if (each.key.empty() || each.key.starts_with("keep_")) continue;
        CAPTURE(std::string(each.key));
        CHECK(all.find("&" + std::string(each.key) + "=") != std::string::npos);
    }
    CHECK(again("scene=torus&keep_noise=on") == "scene=torus&switches=noise=off");
    const std::string lists = "scene=torus&what_if=1.sphere%20keep%202&what_if=3.sphere%20drop%204";
    CHECK(again(lists) == lists);
    CHECK(optionsFromLink("scene=torus&neighbors=16&rules=robust").value().input ==
          changed({"scene:torus"}, specChange({{"rules", "robust"}, {"neighbors", "16"}})));
}

TEST_CASE("A link names every scene and every lesson") {
    for (const Scene& scene : scenes()) {
        const Result<Options> read = optionsFromLink("#scene=" + std::string(scene.id));
        REQUIRE(read.ok());
        CHECK(read.value().input.source == "scene:" + std::string(scene.id));
    }
    for (const teach::EmbeddedLesson& lesson : teach::embeddedLessons()) {
        const Result<Options> read = optionsFromLink("#lesson=" + std::string(lesson.id));
        REQUIRE(read.ok());
        CHECK(read.value().lesson == "lesson:" + std::string(lesson.id));
    }
}

TEST_CASE("A link is read as a whole address, from its sign, and from behind it") {
    for (const char* link : {"https://example.org/spiraling-edge/#scene=torus&goto=137.sphere.3",
                             "#scene=torus&goto=137.sphere.3", "scene=torus&goto=137%2Esphere.3&",
                             " spiraling-edge.html#scene=torus&goto=137.sphere.3\n"})
        CHECK(again(link) == "scene=torus&goto=137.sphere.3");
    CHECK(isLink("https://example.org/#scene=torus"));
    CHECK(isLink("a.html#focus&scene=torus"));
    CHECK(isLink("#anything"));
    CHECK_FALSE(isLink("points#2.ply"));
    CHECK_FALSE(isLink("scene:torus"));
    CHECK(optionsFromLink("scene=torus&goto=%2B10").value().goTo == "+10");
    CHECK(optionsFromLink("scene=torus&goto=+10").value().goTo == "+10");
}

TEST_CASE("A wrong link gets a sentence that names what is wrong") {
    CHECK(complaintOf("scene=torus&gto=1") == "\"gto\" is no part of a link: did you mean goto?");
    CHECK(complaintOf("scene=toros") ==
          "In the link, scene=toros: there is no scene of that name: did you mean torus?");
    CHECK(complaintOf("lesson=tuor") ==
          "In the link, lesson=tuor: there is no lesson of that name: did you mean tour?");
    CHECK(complaintOf("scene=torus&goto=1&goto=2") == "\"goto\" stands twice in the link.");
    CHECK(complaintOf("scene=torus&rules=paper&rules=robust") ==
          "\"rules\" stands twice in the link.");
    CHECK(complaintOf("scene=torus&lesson=tour") ==
          "A link has one input, not both scene and lesson.");
    CHECK(complaintOf("scene=torus&neighbors=5&radius=1") ==
          "A link has only one of neighbors and radius.");
    CHECK(complaintOf("scene=torus&neighbors=0") ==
          "In the link, neighbors=0: expected a whole number from 1 to 1000000");
    CHECK(complaintOf("step=2") == "In the link, step needs a lesson.");
    CHECK(complaintOf("lesson=tour&rules=robust") ==
          "In the link, rules does not go with a lesson, which has its own options.");
    CHECK(complaintOf("rules=robust") == "In the link, rules needs an input, such as scene=torus.");
    for (const char* link : {"scene=%",
                             "scene=%4",
                             "scene=%zz",
                             "scene=a%00b",
                             "scene",
                             "scene=",
                             "=",
                             "lesson=tour&step=0",
                             "lesson=tour&step=-1",
                             "lesson=tour&step=x",
                             "goto=",
                             "alert=",
                             "with=",
                             "file=",
                             "camera=nan,0,0,1,0,0",
                             "camera=0,0,0,inf,0,0",
                             "camera=0,0,0,0,0,0",
                             "camera=0,0,0,-1,0,0",
                             "camera=0,0,0,1,0",
                             "camera=0,0,0,1,0,0,w",
                             "camera=1e9,0,0,1,0,0",
                             "camera=",
                             "camera=,,,",
                             "layout=wide",
                             "theme=red",
                             "mesh-style=x",
                             "point-tint=x",
                             "play=0",
                             "play=nan",
                             "focus=1",
                             "sample=torus,m=3",
                             "pack=",
                             "pack=:",
                             "pack=a.xyz",
                             "pack=a.xyz:",
                             "pack=a.xyz:!",
                             "pack=a.xyz:A",
                             "pack=../a.xyz:AwA",
                             "switches=fill"}) {
        CAPTURE(std::string(link));
        const std::string complaint = complaintOf(link);
        CHECK(complaint != "none");
        CHECK(complaint.size() > 15);
    }
}

TEST_CASE("A packed file is read from the link, whole or not at all") {
    std::string bytes;
    for (int i = 0; i < 300; ++i) bytes += std::to_string(i * i % 97) + " 0.5 " + "1\n";
    const std::string source = packedSource({"some/where/a.xyz", bytes});
    CHECK(source.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                   "0123456789-_:.") == std::string::npos);
    CHECK(source.size() < bytes.size() / 2);
    CHECK(packedName(source) == "a.xyz");
    const Result<PackedFile> file = unpackedFile(source);
    REQUIRE(file.ok());
    CHECK(file.value().name == "a.xyz");
    CHECK(file.value().bytes == bytes);
    CHECK(again("pack=" + source.substr(5)) == "pack=" + source.substr(5));
    for (std::size_t length = 0; length < source.size(); ++length) {
        CAPTURE(length);
        CHECK_FALSE(unpackedFile(source.substr(0, length)).ok());
    }
    CHECK_FALSE(unpackedFile(source + "AAAA").ok());
    CHECK(unpackedFile(packedSource({"empty.xyz", ""})).value().bytes.empty());
    std::string every;
    for (int i = 0; i < 256; ++i) every += static_cast<char>(i);
    CHECK(unpackedFile(packedSource({"b.bin", every})).value().bytes == every);
}

TEST_CASE("A packed file of more than 4 MiB is refused") {
    const std::string fits(kMostUnpacked, ' ');
    CHECK(unpackedFile(packedSource({"a.xyz", fits})).ok());
    const Result<PackedFile> large = unpackedFile(packedSource({"a.xyz", fits + ' '}));
    REQUIRE_FALSE(large.ok());
    CHECK(large.error().message == "The packed file is larger than 4 MiB, the limit of a link.");
}

TEST_CASE("A packed session is read, with the options of the link in place of its own") {
    SessionFile session;
    session.input = changed({"scene:torus"}, specChange({{"rules", "robust"}}));
    session.place.address = "12.sort.2";
    const std::string line = packedSource({"s.sesession", sessionToJson(session, {})}).substr(5);
    const Result<Options> read = optionsFromLink("pack=" + line + "&neighbors=9");
    REQUIRE(read.ok());
    REQUIRE(read.value().session.has_value());
    CHECK(read.value().session->place.address == "12.sort.2");
    CHECK(read.value().input ==
          changed({"scene:torus"}, specChange({{"rules", "robust"}, {"neighbors", "9"}})));
    CHECK(complaintOf("pack=" + packedSource({"s.sesession", "{"}).substr(5)) != "none");
}

TEST_CASE("A packed lesson opens, unless it reads files") {
    for (const teach::EmbeddedLesson& each : teach::embeddedLessons()) {
        CAPTURE(std::string(each.id));
        const std::string name = std::string(each.id) + ".lesson.md";
        const std::string source = packedSource({name, std::string(each.text)});
        CHECK(source.size() < 8000);
        const Result<Options> read = optionsFromLink("#pack=" + source.substr(5) + "&step=2");
        REQUIRE(read.ok());
        CHECK(read.value().lesson == source);
    }
    const teach::EmbeddedLesson& tour = *teach::findEmbeddedLesson("tour");
    const auto open = [](std::string text) {
        return openLesson(packedSource({"x.lesson.md", std::move(text)}),
                          [](double) { return true; });
    };
    const Result<SharedLesson> opened = open(std::string(tour.text));
    REQUIRE(opened.ok());
    CHECK(opened.value()->lesson.steps.size() > 3);
    std::string text(tour.text);
    const std::size_t at = text.find("scene:");
    REQUIRE(at != std::string::npos);
    text.replace(at, text.find('"', at) - at, "points.ply");
    const Result<SharedLesson> refused = open(text);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.error().message ==
          "x.lesson.md: a lesson inside a link has scenes alone, not \"points.ply\".");
}

TEST_CASE("The manual has every name of a link, with its value and meaning") {
    const std::string_view page = embeddedFile("viewer.md");
    for (const LinkPart& each : linkParts()) {
        std::string row = "| `" + std::string(each.name) + "` | ";
        if (!each.value.empty()) row += "`" + std::string(each.value) + "`";
        row += " | " + std::string(each.help) + " |\n";
        CAPTURE(row);
        CHECK(page.find(row) != std::string_view::npos);
    }
}
