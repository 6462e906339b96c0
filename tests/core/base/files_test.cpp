#include "spiraling_edge/base/files.h"

#include <sys/stat.h>

#include <thread>

#include "spiraling_edge/io/read_points.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

namespace fs = std::filesystem;

/// The bytes of a source under `limit`, or the message of the error.
std::string readWithin(const fs::path& path, const ByteLimit& limit) {
    const Result<std::string> bytes = readBytes(path, limit);
    return bytes.ok() ? bytes.value() : bytes.error().message;
}

void putText(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

TEST_CASE("Bytes: a file is read up to the limit, and refused beyond it with the way out") {
    const TemporaryFolder folder;
    putText(folder / "a", "12345");
    putText(folder / "empty", "");
    CHECK(readWithin(folder / "a", {5}) == "12345");
    CHECK(readWithin(folder / "empty", {1}).empty());
    const std::string refused = readWithin(folder / "a", {4});
    CHECK(refused == (folder / "a").string() +
                         ": holds more than 4 bytes, read or unpacked; --most-bytes N raises this "
                         "limit");
    CHECK(contains(readWithin(folder / "a", {4, "cut it"}), "; cut it"));
}

TEST_CASE("Bytes: a huge file is refused before memory is taken") {
    const TemporaryFolder folder;
    putText(folder / "huge.ply", "ply\n");
    fs::resize_file(folder / "huge.ply", std::uintmax_t{1} << 40U);  // Sparse: it takes no room.
    const Result<PointFile> points = readPoints(folder / "huge.ply");
    REQUIRE_FALSE(points.ok());
    CHECK(contains(points.error().message, "more than 2147483648 bytes"));
}

TEST_CASE("Bytes: a source without an end stops at the limit, and at once when it is cancelled") {
    CHECK(contains(readWithin("/dev/zero", {5'000'000}), "/dev/zero: holds more than 5000000"));
    std::size_t reports = 0;
    const Result<std::string> cancelled =
        readBytes("/dev/zero", {}, [&](double) { return ++reports < 3; });
    CHECK_FALSE(cancelled.ok());
    CHECK(reports == 3);
}

TEST_CASE("Bytes: a pipe is read in pieces to its end") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    std::string text;
    while (text.size() < 3'000'000) text += std::to_string(text.size()) + ' ';
    std::thread writer([&] { putText(folder / "pipe", text); });
    const std::string read = readWithin(folder / "pipe", {});
    writer.join();
    CHECK(read == text);
}

TEST_CASE("Bytes: what a file from elsewhere must not make the program open") {
    const TemporaryFolder folder;
    const TemporaryFolder other;
    putText(folder / "a", "a");
    putText(other / "b", "b");
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    fs::create_symlink(other / "b", folder / "out");
    fs::create_symlink("a", folder / "in");
    fs::create_symlink("/dev/zero", folder / "zero");
    const fs::path root = folder / "";
    for (const char* name : {"pipe", "zero", "."}) CHECK(isUnfit(folder / name));
    for (const char* name : {"a", "in", "out", "missing"}) CHECK_FALSE(isUnfit(folder / name));
    for (const char* name : {"pipe", "zero", "out"}) CHECK(isUnfitIn(root, folder / name));
    for (const char* name : {"a", "in", "missing"}) CHECK_FALSE(isUnfitIn(root, folder / name));
    // The folder itself may be reached by a link.
    fs::create_directory_symlink(root, other / "link");
    CHECK_FALSE(isUnfitIn(other / "link", other / "link/a"));
    CHECK(isUnfitIn(other / "link", other / "link/out"));
}
