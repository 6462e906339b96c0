#include "export/formats.h"

#include <doctest/doctest.h>

#include <fstream>

#include "open_session.h"
#include "run/packed_file.h"

using namespace se::view;
using se::teach::textBlocks;

TEST_CASE("Text of a lesson is paragraphs and lists, with HTML shown as text") {
    CHECK(pageText(textBlocks("A *b* **c** `d<e>`\n\n- one\n- two\n\n1. three\n\n<b>x</b>"), {}) ==
          "<p>A <em>b</em> <strong>c</strong> <code>d&lt;e&gt;</code></p>\n"
          "<ul><li>one</li>\n<li>two</li>\n</ul><ol><li>three</li>\n</ol>"
          "<p>&lt;b&gt;x&lt;/b&gt;</p>\n");
}

TEST_CASE("Links lead to steps of the page, to the web, and to the program if it has an address") {
    PageLinks links;
    links.steps.emplace("9.sphere.2", 3);
    CHECK(pageText(textBlocks("[a](se:9.sphere.2)"), links) == "<p><a href=\"#3\">a</a></p>\n");
    CHECK(pageText(textBlocks("[a](se:9.sphere.3)"), links) ==
          "<p><span title=\"9.sphere.3\">a</span></p>\n");
    links.toProgram = [](const std::string& address) { return "v.html#a=b&goto=" + address; };
    CHECK(pageText(textBlocks("[a](se:9.sphere.2)"), links) == "<p><a href=\"#3\">a</a></p>\n");
    CHECK(pageText(textBlocks("[a](se:9.sphere.3)"), links) ==
          "<p><a href=\"v.html#a=b&amp;goto=9.sphere.3\" rel=\"noopener noreferrer\" "
          "target=\"_blank\">a</a></p>\n");
    CHECK(pageText(textBlocks("[a](javascript:x)"), links) == "<p>a</p>\n");
    CHECK(pageText(textBlocks("[a](https://b.org)"), links) ==
          "<p><a href=\"https://b.org\" rel=\"noopener noreferrer\" target=\"_blank\">a</a></p>\n");
}

TEST_CASE("An image is a part of the text, and its description if it cannot be read") {
    const test::OwnFolder folder;
    std::ofstream(folder / "a.png") << "abcd";
    PageLinks links;
    links.folder = folder.path();
    CHECK(pageText(textBlocks("![A \"ring\"](a.png)"), links)
              .find("<img alt=\"A &quot;ring&quot;\" src=\"data:image/png;base64,YWJjZA==\">") !=
          std::string::npos);
    CHECK(pageText(textBlocks("![A ring](b.png)"), links).find("<p>A ring</p>") !=
          std::string::npos);
}

TEST_CASE("Base 64 is padded to four signs") {
    CHECK(base64Of("") == "");
    CHECK(base64Of("a") == "YQ==");
    CHECK(base64Of("ab") == "YWI=");
    CHECK(base64Of("abc") == "YWJj");
    CHECK(base64Of("\xff\xfe\xfd") == "//79");
}
