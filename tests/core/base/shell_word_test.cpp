#include "spiraling_edge/base/shell_word.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "spiraling_edge/base/outside_text.h"

using namespace se;

namespace {

/// The bytes that a shell passes to a program for `word`.
std::string readByShell(const std::string& word) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("spiraling-edge-word-" + std::to_string(::getpid()));
    const std::string command = "printf %s " + word + " > " + file.string();
    REQUIRE(std::system(command.c_str()) == 0);
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    std::filesystem::remove(file);
    return bytes.str();
}

}  // namespace

TEST_CASE("shell words: a shell reads every word as the bytes that were quoted") {
    const std::string names[] = {"/a/b-c_1.ply",
                                 "a b.ply",
                                 "x;touch H;.ply",
                                 "$(touch pwned)",
                                 "`id`",
                                 "it's",
                                 "\"",
                                 "",
                                 "~",
                                 "*?[a]",
                                 "a\\nb",
                                 "%s%d",
                                 "!x",
                                 "a\nb",
                                 "a\n",
                                 "\n\n",
                                 "-n\n",
                                 "\t",
                                 "\x1b[31mred",
                                 "\xff%\xfe'\\",
                                 "\xc2\x9b",
                                 "a\xe2\x80\xae"
                                 "b",
                                 "M\xc3\xbcller.ply"};
    for (const std::string& name : names) {
        CAPTURE(name);
        const std::string word = shellQuoted(name);
        CHECK(readByShell(word) == name);
        CHECK(printable(word) == word);
    }
    CHECK(shellQuoted("/a/b-c_1.ply") == "/a/b-c_1.ply");
    CHECK(shellQuoted("$(touch pwned)") == "'$(touch pwned)'");
    CHECK(shellQuoted("it's") == "'it'\\''s'");
    CHECK(shellQuoted("") == "''");
}

TEST_CASE("shell words: the path of a file is never taken for an option") {
    CHECK(shellPath("-x.ply") == "./-x.ply");
    CHECK(readByShell(shellPath("--fix\n.ply")) == "./--fix\n.ply");
    CHECK(shellPath("a-b.ply") == "a-b.ply");
    CHECK(shellPath("-") == "-");
    CHECK(shellPath("") == "''");
}
