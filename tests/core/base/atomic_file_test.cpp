#include "spiraling_edge/base/atomic_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <new>
#include <thread>

#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

namespace fs = std::filesystem;

/// Calls of fsync(), which this program replaces by its own.
struct Syncs {
    std::string kinds;  ///< 'f' for a file, 'd' for a folder, in their order.
    char fails = 0;     ///< The kind that fails.
    fs::path watched;
    std::string content;  ///< Of `watched`, when a file was synced.
} syncs;

fs::perms modeOf(const fs::path& path) { return fs::status(path).permissions(); }

/// Runs `work` in a process of its own; its status as by waitpid().
template <typename Work>
int statusOf(Work&& work) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        work();
        ::_exit(0);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    return status;
}

NamedFile named(const char* role, const fs::path& path) { return {role, path}; }

}  // namespace

extern "C" int fsync(int descriptor) {
    struct stat status {};
    ::fstat(descriptor, &status);
    const char kind = S_ISDIR(status.st_mode) ? 'd' : 'f';
    syncs.kinds += kind;
    if (kind == 'f' && !syncs.watched.empty()) syncs.content = bytesOf(syncs.watched);
    if (kind != syncs.fails) return static_cast<int>(::syscall(SYS_fsync, descriptor));
    errno = EIO;
    return -1;
}

TEST_CASE("Write: the bytes are on the disk before the name, and the name before the end") {
    const TemporaryFolder folder;
    REQUIRE(writeFileAtomically(folder / "a", "old").ok());
    syncs = {"", 0, folder / "a", ""};
    REQUIRE(writeFileAtomically(folder / "a", "new").ok());
    CHECK(syncs.kinds == "fd");
    CHECK(syncs.content == "old");
    CHECK(bytesOf(folder / "a") == "new");
    syncs = {};
}

TEST_CASE("Write: bytes that do not reach the disk are an error, and the old file stays") {
    const TemporaryFolder folder;
    REQUIRE(writeFileAtomically(folder / "a", "old").ok());
    syncs = {"", 'f', {}, ""};
    const Status status = writeFileAtomically(folder / "a", "new");
    REQUIRE_FALSE(status.ok());
    CHECK(contains(status.error().message, "cannot be written: Input/output error"));
    CHECK(bytesOf(folder / "a") == "old");
    CHECK(folder.fileCount() == 1);
    syncs = {"", 'd', {}, ""};
    CHECK_FALSE(writeFileAtomically(folder / "a", "new").ok());
    syncs = {};
}

TEST_CASE("Write: a folder that may not be listed can be written to") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "closed");
    fs::permissions(folder / "closed", fs::perms::owner_write | fs::perms::owner_exec);
    CHECK(writeFileAtomically(folder / "closed/a", "new").ok());
    fs::permissions(folder / "closed", fs::perms::owner_all);
}

TEST_CASE("Write: an output that is an input by any of its names would be lost") {
    const TemporaryFolder folder;
    std::ofstream(folder / "in.ply") << "points";
    fs::create_directory(folder / "sub");
    fs::create_symlink("in.ply", folder / "link.ply");
    fs::create_symlink("../link.ply", folder / "sub/far.ply");
    fs::create_hard_link(folder / "in.ply", folder / "hard.ply");
    fs::create_directory_symlink(".", folder / "here");
    const std::vector<NamedFile> inputs{named("", folder / "in.ply"), named("", "scene:torus")};
    for (const char* name :
         {"in.ply", "sub/../in.ply", "link.ply", "sub/far.ply", "hard.ply", "here/in.ply"}) {
        CAPTURE(name);
        const std::vector<NamedFile> outputs{named("-o", folder / name)};
        const Status status = requireKept(inputs, outputs);
        REQUIRE_FALSE(status.ok());
        CHECK(contains(status.error().message, "-o " + (folder / name).string()));
        CHECK(contains(status.error().message, "the input " + (folder / "in.ply").string()));
        CHECK(contains(status.error().message, "--force"));
    }
    for (const char* name : {"out.ply", "sub/in.ply", "none/in.ply"})
        CHECK(requireKept(inputs, std::vector<NamedFile>{named("-o", folder / name)}).ok());
    // What is read from and written to a device is not lost.
    const std::vector<NamedFile> device{named("", "/dev/null")};
    CHECK(requireKept(device, device).ok());
}

TEST_CASE("Write: two outputs are two files, also before they exist") {
    const TemporaryFolder folder;
    fs::create_symlink("later", folder / "link");
    fs::create_directory_symlink(".", folder / "here");
    const auto apart = [&](const fs::path& a, const fs::path& b) {
        return requireApart(std::vector<NamedFile>{named("-o", a), named("--report", b)}).ok();
    };
    CHECK_FALSE(apart(folder / "later", folder / "later"));
    CHECK_FALSE(apart(folder / "later", folder / "here/./later"));
    CHECK_FALSE(apart(folder / "later", folder / "link"));
    CHECK_FALSE(apart("-", "-"));
    CHECK_FALSE(apart("-", "/dev/stdout"));
    CHECK(apart(folder / "later", folder / "other"));
    CHECK(apart("/dev/null", "/dev/null"));
    CHECK(apart("-", folder / "later"));
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK_FALSE(apart(folder / "pipe", folder / "pipe"));
}

TEST_CASE("Write: a link stays a link, and its target is replaced") {
    const TemporaryFolder folder;
    REQUIRE(writeFileAtomically(folder / "target", "old").ok());
    fs::create_symlink("target", folder / "link");
    REQUIRE(writeFileAtomically(folder / "link", "new").ok());
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(bytesOf(folder / "target") == "new");
    CHECK(folder.fileCount() == 2);
}

TEST_CASE("Write: a link to a file that does not exist yet creates that file") {
    const TemporaryFolder folder;
    fs::create_symlink("target", folder / "link");
    REQUIRE(writeFileAtomically(folder / "link", "new").ok());
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(bytesOf(folder / "target") == "new");
}

TEST_CASE("Write: links that lead round in a circle are an error, and stay") {
    const TemporaryFolder folder;
    fs::create_symlink("a", folder / "a");
    CHECK_FALSE(writeFileAtomically(folder / "a", "new").ok());
    CHECK(fs::is_symlink(folder / "a"));
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("Write: an open pipe is written to by its name in /dev/fd") {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    const fs::path name = "/dev/fd/" + std::to_string(ends[1]);
    if (fs::exists(name)) {
        CHECK(AtomicFile::check(name).ok());
        REQUIRE(writeFileAtomically(name, "bytes").ok());
        std::array<char, 8> read{};
        CHECK(::read(ends[0], read.data(), read.size()) == 5);
        CHECK(std::string(read.data()) == "bytes");
    }
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST_CASE("Write: a file that is open under /dev/fd is appended to") {
    const TemporaryFolder folder;
    std::ofstream(folder / "log") << "before ";
    const int log = ::open((folder / "log").c_str(), O_WRONLY | O_APPEND);
    REQUIRE(log >= 0);
    const fs::path name = "/dev/fd/" + std::to_string(log);
    if (fs::exists(name)) {
        REQUIRE(writeFileAtomically(name, "after").ok());
        CHECK(bytesOf(folder / "log") == "before after");
    }
    ::close(log);
}

TEST_CASE("Write: no folder, a folder in the way, a full disk have their own errors") {
    const TemporaryFolder folder;
    const auto error = [](const fs::path& path) {
        const Status status = writeFileAtomically(path, "bytes");
        REQUIRE_FALSE(status.ok());
        return status.error().message;
    };
    CHECK(contains(error(folder / "none/a.ply"), "there is no folder"));
    CHECK(contains(error(folder / ""), "is a folder"));
    CHECK(contains(error(""), "the file name is empty"));
    if (fs::exists("/dev/full")) {
        CHECK(contains(error("/dev/full"), "cannot be written: No space left"));
    }
    CHECK(folder.fileCount() == 0);
}

TEST_CASE("Write: until commit() the target stays, without commit() nothing is left") {
    const TemporaryFolder folder;
    REQUIRE(writeFileAtomically(folder / "a", "old").ok());
    for (const bool commits : {false, true}) {
        Result<AtomicFile> file = AtomicFile::create(folder / "a");
        REQUIRE(file.ok());
        REQUIRE(file.value().write("first ").ok());
        REQUIRE(file.value().write("second").ok());
        CHECK(bytesOf(folder / "a") == "old");
        CHECK(folder.fileCount() == 2);
        if (commits) CHECK(file.value().commit().ok());
    }
    CHECK(bytesOf(folder / "a") == "first second");
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("Write: the temporary file has another name each time, which no link can wait under") {
    const TemporaryFolder folder;
    const auto nameOf = [&] {
        const Result<AtomicFile> file = AtomicFile::create(folder / "a");
        REQUIRE(file.ok());
        REQUIRE(folder.fileCount() == 1);
        return fs::directory_iterator(folder / "")->path().filename().string();
    };
    const std::string first = nameOf();
    CHECK(first != nameOf());
    // Random characters may end in an "a".
    CHECK(first != "a.part");
    CHECK(first != ".a.part");
}

TEST_CASE("Write: files of the user that are called .part stay") {
    const TemporaryFolder folder;
    const std::array<const char*, 3> own{"a.part", "a.part0", "a.part1"};
    for (const char* name : own) std::ofstream(folder / name) << "mine";
    REQUIRE(writeFileAtomically(folder / "a", "new").ok());
    for (const char* name : own) CHECK(bytesOf(folder / name) == "mine");
}

TEST_CASE("Write: the mode of a file is kept, and a new one obeys the umask") {
    const TemporaryFolder folder;
    const mode_t before = ::umask(027);
    REQUIRE(writeFileAtomically(folder / "a", "old").ok());
    CHECK(modeOf(folder / "a") == fs::perms(0640));
    fs::permissions(folder / "a", fs::perms(0666));
    REQUIRE(writeFileAtomically(folder / "a", "new").ok());
    CHECK(modeOf(folder / "a") == fs::perms(0666));
    ::umask(before);
}

TEST_CASE("Write: a write-protected file stays, also for root") {
    const TemporaryFolder folder;
    REQUIRE(writeFileAtomically(folder / "a", "old").ok());
    fs::permissions(folder / "a", fs::perms(0444));
    CHECK_FALSE(AtomicFile::check(folder / "a").ok());
    const Status status = writeFileAtomically(folder / "a", "new");
    REQUIRE_FALSE(status.ok());
    CHECK(contains(status.error().message, "cannot be written: Permission denied"));
    CHECK(bytesOf(folder / "a") == "old");
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("Write: checking a path creates nothing") {
    const TemporaryFolder folder;
    CHECK(AtomicFile::check(folder / "a").ok());
    CHECK(folder.fileCount() == 0);
    CHECK(contains(AtomicFile::check(folder / "none/a").error().message, "there is no folder"));
}

TEST_CASE("Write: signals that end the program leave no part of a file") {
    const TemporaryFolder folder;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ}) {
        const int status = statusOf([&] {
            removeUnfinishedFilesAtSignals("");
            const Result<AtomicFile> file = AtomicFile::create(folder / "a");
            std::raise(signal);
        });
        if (signal == SIGINT) {
            CHECK(WIFEXITED(status));
            CHECK(WEXITSTATUS(status) == 130);
        } else {
            CHECK(WIFSIGNALED(status));
            CHECK(WTERMSIG(status) == signal);
        }
        CHECK(folder.fileCount() == 0);
    }
}

TEST_CASE("Write: nothing runs after an interrupt, in no thread, unless it is ignored") {
    // Shared with the process that is interrupted.
    void* const memory = ::mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                                MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    REQUIRE(memory != MAP_FAILED);
    auto& worked = *new (memory) std::atomic<int>(0);
    for (const bool ignored : {false, true}) {
        worked = 0;
        const int status = statusOf([&] {
            if (ignored) std::signal(SIGINT, SIG_IGN);
            removeUnfinishedFilesAtSignals("");
            std::thread other([&] {
                std::raise(SIGINT);
                ++worked;
            });
            other.join();
            ++worked;
        });
        CHECK(worked == (ignored ? 2 : 0));
        CHECK(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == (ignored ? 0 : 130));
    }
    ::munmap(memory, sizeof(std::atomic<int>));
}
