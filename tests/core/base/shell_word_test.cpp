#include "spiraling_edge/base/shell_word.h"

#include <doctest/doctest.h>

using namespace se;

TEST_CASE("shell words: text that a shell would expand is put in single quotes") {
    CHECK(shellQuoted("/a/b-c_1.ply") == "/a/b-c_1.ply");
    CHECK(shellQuoted("$(touch pwned)") == "'$(touch pwned)'");
    CHECK(shellQuoted("a\nb") == "'a\nb'");
    CHECK(shellQuoted("it's") == "'it'\\''s'");
    CHECK(shellQuoted("") == "''");
}

TEST_CASE("shell words: a name in a comment is one line without control characters") {
    CHECK(oneLine("a b.ply") == "a b.ply");
    CHECK(oneLine("a\nrm -rf *") == "a\\nrm -rf *");
    CHECK(oneLine("\x1b[31m\r\x7f\\") == "\\x1b[31m\\x0d\\x7f\\\\");
    CHECK(oneLine("\xc2\x9b"
                  "1m") ==
          "\\xc2\\x9b"
          "1m");
    CHECK(oneLine("M\xc3\xbcller.ply") == "M\xc3\xbcller.ply");
}
