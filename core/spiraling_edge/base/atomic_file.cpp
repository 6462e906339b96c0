/// Write to a temporary file in the folder of the target, then rename: readers see the old or the
/// new file. A fixed table of unfinished files lets signal handlers remove them without locks or
/// memory.
#include "spiraling_edge/base/atomic_file.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <random>
#include <string>
#include <system_error>
#include <tuple>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/operating_system.h"

namespace se {
namespace {

namespace fs = std::filesystem;

/// A temporary file that a signal handler must be able to remove: fixed storage, since a handler
/// may neither lock nor allocate.
struct UnfinishedFile {
    enum Use : int { Free, Claimed, Listed };
    std::atomic<int> use{Free};
    std::array<char, 4096> path{};
};
static_assert(std::atomic<int>::is_always_lock_free);
std::array<UnfinishedFile, 16> unfinishedFiles;

/// The slot of `path`, from 1; 0 if the table is full or the path too long: then a signal does not
/// remove the file.
std::size_t listUnfinished(const std::string& path) {
    if (path.size() >= unfinishedFiles[0].path.size()) return 0;
    for (std::size_t i = 0; i < unfinishedFiles.size(); ++i) {
        UnfinishedFile& file = unfinishedFiles[i];
        int expected = UnfinishedFile::Free;
        if (!file.use.compare_exchange_strong(expected, UnfinishedFile::Claimed)) continue;
        std::memcpy(file.path.data(), path.c_str(), path.size() + 1);
        file.use = UnfinishedFile::Listed;
        return i + 1;
    }
    return 0;
}

void unlistUnfinished(std::size_t slot) {
    if (slot > 0) unfinishedFiles[slot - 1].use = UnfinishedFile::Free;
}

/// The text for an interrupted user. Set before the handler is.
std::string_view interruptFarewell;

extern "C" void removeAndEnd(int signal) {
    for (UnfinishedFile& file : unfinishedFiles) {
        if (file.use == UnfinishedFile::Listed) os::removeFile(file.path.data());
    }
    if (signal == SIGINT) {
        os::writeToStandardError(interruptFarewell);
        // No phase of the work can delay this; a flag would have to be polled by all of them.
        os::endAtOnce(128 + SIGINT);
    }
    os::endBySignal(signal);
}

/// True for the name of a file that this process has open, which must be appended to, not replaced.
bool isOpenFile(const fs::path& path) {
    const std::string name = path.string();
    return name == "/dev/stdout" || name == "/dev/stderr" || name.rfind("/dev/fd/", 0) == 0 ||
           name.rfind("/proc/self/fd/", 0) == 0;
}

/// A random name, so that no link can have been placed there.
fs::path unpredictableName(const fs::path& folder) {
    std::random_device random;
    std::array<char, 48> name;
    std::snprintf(name.data(), name.size(), ".spiraling-edge-%08x%08x.part", random(), random());
    return folder / name.data();
}

/// True for a write-protected file. rename() would replace it, as it checks only the permissions of
/// the folder, and root may write everywhere.
bool isWriteProtected(const fs::path& target, unsigned mode) {
    constexpr unsigned kAnyWriteBit = 0222;
    if ((mode & kAnyWriteBit) == 0) {
        errno = EACCES;
        return true;
    }
    return !os::mayWrite(target);
}

/// The folder of a file.
fs::path folderOf(const fs::path& file) {
    const fs::path parent = file.parent_path();
    return parent.empty() ? "." : parent;
}

}  // namespace

fs::path withLinksFollowed(fs::path path) {
    constexpr int kMaxLinks = 40;
    std::error_code problem;
    for (int i = 0; i < kMaxLinks; ++i) {
        if (!fs::is_symlink(fs::symlink_status(path, problem))) return path;
        const fs::path to = fs::read_symlink(path, problem);
        if (problem) return path;
        path = path.parent_path() / to;  // an absolute `to` replaces the rest
    }
    errno = ELOOP;
    return {};
}

Status AtomicFile::locate(const fs::path& path) {
    if (path.empty()) return Error{"the file name is empty; name a file"};
    path_ = path;
    using Kind = os::FileStatus::Kind;
    errno = 0;
    const std::optional<os::FileStatus> status = os::statusOf(path);
    exists_ = status.has_value();
    if (exists_ && status->kind == Kind::Folder)
        return Error{path.string() + ": is a folder; name a file in it"};
    // The link of an open file, as /dev/stdout, may read as "pipe:[123]", which is no path.
    direct_ = (exists_ && status->kind != Kind::Regular) || isOpenFile(path);
    target_ = direct_ ? path : withLinksFollowed(path);
    if (target_.empty()) return failure();
    if (exists_) mode_ = status->mode;
    if (direct_) return os::mayWrite(target_) ? success() : Status(failure());
    const fs::path folder = folderOf(target_);
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
        return Error{path.string() + ": cannot be written: there is no folder " + folder.string() +
                     "; make it first"};
    }
    errno = 0;
    if (exists_ && isWriteProtected(target_, mode_)) return failure();
    if (!os::mayWrite(folder)) return failure();
    return success();
}

Result<AtomicFile> AtomicFile::create(const fs::path& path) {
    AtomicFile file;
    if (const Status status = file.locate(path); !status) return status.error();
    if (!(file.direct_ ? file.openTarget() : file.openTemporary())) return file.failure();
    return file;
}

Status AtomicFile::check(const fs::path& path) { return AtomicFile().locate(path); }

bool AtomicFile::openTarget() {
    descriptor_ = os::openToWrite(target_, isOpenFile(target_));
    return descriptor_ >= 0;
}

bool AtomicFile::openTemporary() {
    temporary_ = unpredictableName(target_.parent_path());
    slot_ = listUnfinished(temporary_.string());
    errno = 0;
    descriptor_ = os::makeFile(temporary_, mode_);
    if (descriptor_ >= 0) {
        // The mode of the old file. A failure here does not prevent the write.
        if (exists_) os::setMode(descriptor_, mode_);
        return true;
    }
    unlistUnfinished(slot_);
    slot_ = 0;
    temporary_.clear();
    return false;
}

AtomicFile::~AtomicFile() { closeAndRemove(); }

void AtomicFile::swap(AtomicFile& other) noexcept {
    path_.swap(other.path_);
    target_.swap(other.target_);
    temporary_.swap(other.temporary_);
    std::swap(exists_, other.exists_);
    std::swap(direct_, other.direct_);
    std::swap(mode_, other.mode_);
    std::swap(slot_, other.slot_);
    std::swap(descriptor_, other.descriptor_);
}

Error AtomicFile::failure() const {
    return Error{path_.string() + ": cannot be written: " + systemReason()};
}

Status AtomicFile::write(std::string_view bytes) {
    errno = 0;
    if (!os::writeAll(descriptor_, bytes)) return failure();
    return success();
}

Status AtomicFile::commit() {
    errno = 0;
    // Else a power failure after the rename could leave the new name with none of the bytes.
    if (!temporary_.empty() && !os::sync(descriptor_)) return failure();
    if (!os::close(std::exchange(descriptor_, -1))) return failure();
    if (temporary_.empty()) return success();
    // -1 if it may be written to but not read.
    const int folder = os::openFolder(folderOf(target_));
    const os::Closing closing(folder);
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) return failure();
    temporary_.clear();
    unlistUnfinished(std::exchange(slot_, 0));
    return folder < 0 || os::sync(folder) ? success() : Status(failure());
}

void AtomicFile::closeAndRemove() {
    if (descriptor_ >= 0) os::close(descriptor_);
    if (!temporary_.empty()) os::removeFile(temporary_.c_str());
    unlistUnfinished(slot_);
}

Status writeFileAtomically(const fs::path& path, std::string_view bytes) {
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file) return file.error();
    if (const Status status = file.value().write(bytes); !status) return status;
    return file.value().commit();
}

namespace {

constexpr std::string_view kStandardStream = "-";

/// A file, whatever it is called: by device and inode; one that does not exist yet by those of its
/// folder, and its name there.
struct FileIdentity {
    using Kind = os::FileStatus::Kind;
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::string name;  ///< Empty if the file exists.
    Kind kind = Kind::Regular;

    /// Its content stays, and a write would replace it: no pipe, terminal or socket.
    bool keepsContent() const { return kind == Kind::Regular || kind == Kind::Block; }
    friend bool operator==(const FileIdentity& a, const FileIdentity& b) {
        return std::tie(a.device, a.inode, a.name) == std::tie(b.device, b.inode, b.name);
    }
};

std::optional<FileIdentity> identityOf(const fs::path& path) {
    if (const auto file = os::statusOf(path))
        return FileIdentity{file->device, file->number, {}, file->kind};
    const fs::path target = withLinksFollowed(path);
    if (target.empty()) return std::nullopt;
    const auto folder = os::statusOf(folderOf(target));
    if (!folder) return std::nullopt;
    return FileIdentity{folder->device, folder->number, target.filename().string()};
}

bool isStandardStream(const NamedFile& file) { return file.path == kStandardStream; }

/// True for `-` and the other names of standard output.
bool isStandardOutput(const NamedFile& file) {
    return isStandardStream(file) || file.path == "/dev/stdout" || file.path == "/dev/fd/1" ||
           file.path == "/proc/self/fd/1";
}

std::optional<FileIdentity> identityOf(const NamedFile& file, const char* stream) {
    return identityOf(isStandardStream(file) ? fs::path(stream) : file.path);
}

/// Devices such as /dev/null, and a terminal, may be written to twice; not so what one name of it
/// opened.
bool areSameOutput(const NamedFile& a, const NamedFile& b) {
    if (isStandardOutput(a) && isStandardOutput(b)) return true;
    const auto first = identityOf(a, "/dev/stdout");
    const auto second = identityOf(b, "/dev/stdout");
    return first && first == second && first->kind != FileIdentity::Kind::Character;
}

bool isReplacedBy(const NamedFile& input, const NamedFile& output) {
    const auto first = identityOf(input, "/dev/stdin");
    const auto second = identityOf(output, "/dev/stdout");
    return first && first == second && first->keepsContent() && first->name.empty();
}

}  // namespace

Status requireApart(std::span<const NamedFile> outputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const NamedFile& first = outputs[k];
            const NamedFile& second = outputs[i];
            if (!areSameOutput(first, second)) continue;
            std::string text = first.role + " and " + second.role + " both name " +
                               second.path.string() + "; give two names";
            if (first.path != second.path) text += ": " + first.path.string() + " is the same file";
            return Error{text};
        }
    }
    return success();
}

Status requireKept(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs) {
    for (const NamedFile& output : outputs) {
        for (const NamedFile& input : inputs) {
            if (!isReplacedBy(input, output)) continue;
            return Error{output.role + " " + output.path.string() + ": is the same file as " +
                         (input.role.empty() ? "the input" : input.role) + " " +
                         input.path.string() + ", which would be replaced; choose another name, " +
                         "or add " + std::string(kForceOption) + " to replace it"};
        }
    }
    return success();
}

void removeUnfinishedFilesAtSignals(std::string_view farewell) noexcept {
    interruptFarewell = farewell;
    os::handleEndingSignals(removeAndEnd);
}

}  // namespace se
