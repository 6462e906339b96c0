#include "spiraling_edge/base/operating_system.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/resource.h>
#endif

namespace se::os {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kPermissionBits = 0777;

FileStatus::Kind kindOf(mode_t mode) {
    using Kind = FileStatus::Kind;
    if (S_ISREG(mode)) return Kind::Regular;
    if (S_ISDIR(mode)) return Kind::Folder;
    if (S_ISBLK(mode)) return Kind::Block;
    return S_ISCHR(mode) ? Kind::Character : Kind::Other;
}

}  // namespace

bool isTerminal(Stream stream) {
    return ::isatty(stream == Stream::Output ? STDOUT_FILENO : STDERR_FILENO) == 1;
}

fs::path programPath() {
    std::error_code problem;
    return fs::read_symlink("/proc/self/exe", problem);
}

void becomeProgram(const fs::path& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program.string());
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    ::execv(program.c_str(), pointers.data());
}

void lowerPriority() {
#ifdef __linux__
    constexpr int kLow = 10;
    static_cast<void>(::setpriority(PRIO_PROCESS, 0, kLow));
#endif
}

void returnFreedMemory() {
#ifdef __GLIBC__
    // A threshold that is set is no longer raised by every block that is freed.
    constexpr int kLargeBlock = 1 << 20;  // bytes
    ::mallopt(M_MMAP_THRESHOLD, kLargeBlock);
#endif
}

int openToRead(const fs::path& path) {
    if (path == kStandardInputDevice) return ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0);
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
}

int openToWrite(const fs::path& path, bool append) {
    return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | (append ? O_APPEND : 0));
}

int makeFile(const fs::path& path, unsigned mode) {
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
}

int openFolder(const fs::path& folder) {
    return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

std::ptrdiff_t readSome(int descriptor, char* to, std::size_t count) {
    ssize_t got = 0;
    do {
        got = ::read(descriptor, to, count);
    } while (got < 0 && errno == EINTR);
    return got;
}

bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

void writeToStandardError(std::string_view bytes) { writeAll(STDERR_FILENO, bytes); }

bool sync(int descriptor) {
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

bool close(int descriptor) { return ::close(descriptor) == 0; }

std::uint64_t sizeOf(int descriptor) {
    struct stat status {};
    const bool regular = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    return regular ? static_cast<std::uint64_t>(status.st_size) : 0;
}

void setMode(int descriptor, unsigned mode) { static_cast<void>(::fchmod(descriptor, mode)); }

void removeFile(const char* path) { ::unlink(path); }

bool mayWrite(const fs::path& path) { return ::access(path.c_str(), W_OK) == 0; }

std::optional<FileStatus> statusOf(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return std::nullopt;
    return FileStatus{kindOf(status.st_mode), status.st_mode & kPermissionBits, status.st_dev,
                      status.st_ino};
}

void handleEndingSignals(void (*handler)(int)) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ, SIGXCPU}) {
        // A signal ignored by the caller, as by nohup, stays ignored.
        if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
    }
}

void endBySignal(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void endAtOnce(int exitCode) { ::_exit(exitCode); }

}  // namespace se::os
