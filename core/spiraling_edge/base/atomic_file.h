/// Files that are either old or new, never half written: the one place where the programs open a
/// file for writing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "spiraling_edge/base/result.h"

namespace se {

/// A file that is being written. The bytes go to a temporary file in the folder of the target,
/// created exclusively under an unpredictable name; commit() renames it to the target once it is on
/// the disk. Until then the target stays as it was, and without commit() the temporary file is
/// removed. Links are followed to their target; the mode of an existing file is kept. A pipe, a
/// device and the open files of this process (/dev/stdout, /dev/fd/3) are written to directly.
/// Errors name the path and the reason.
class AtomicFile {
  public:
    /// Fails if `path` is a folder or write-protected, or if its folder does not exist or does not
    /// permit a new file.
    static Result<AtomicFile> create(const std::filesystem::path& path);

    /// The reason why create() would fail. Creates nothing. Call it before long work.
    static Status check(const std::filesystem::path& path);

    AtomicFile(AtomicFile&& other) noexcept { swap(other); }
    AtomicFile& operator=(AtomicFile&& other) noexcept {
        swap(other);
        return *this;
    }
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    /// Appends `bytes`.
    Status write(std::string_view bytes);
    /// Completes the file: unless the target is written to directly, syncs it, renames it and syncs
    /// its folder. No further call may follow. An error leaves the old file, except one in syncing
    /// the folder: then the new one may be lost with the power.
    Status commit();

  private:
    AtomicFile() = default;
    void swap(AtomicFile& other) noexcept;
    /// The last failure of the operating system, as an error that names the path.
    Error failure() const;
    /// Finds the target and whether it can be written.
    Status locate(const std::filesystem::path& path);
    bool openTarget();
    bool openTemporary();
    void closeAndRemove();

    std::filesystem::path path_;       ///< As the caller named it, for messages.
    std::filesystem::path target_;     ///< path_ with its links followed.
    std::filesystem::path temporary_;  ///< Empty if the target is written to directly.
    bool exists_ = false;
    bool direct_ = false;   ///< The target is written to itself: it is not a regular file.
    unsigned mode_ = 0666;  ///< Permission bits of the target, for a new one before the umask.
    std::size_t slot_ = 0;  ///< Of temporary_ in the table of unfinished files, from 1.
    int descriptor_ = -1;
};

/// `path` with its links followed, also where the last leads to a file that does not exist yet: the
/// file that an AtomicFile replaces. Empty if they form a cycle.
std::filesystem::path withLinksFollowed(std::filesystem::path path);

/// Writes `bytes` as an AtomicFile.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// A file that a command reads or writes.
struct NamedFile {
    std::string role;            ///< The option that names it: "--report"; empty: the input itself.
    std::filesystem::path path;  ///< `-`: standard input or standard output.
};

/// The option by which a user agrees to lose data, and its help.
inline constexpr std::string_view kForceOption = "--force";
inline constexpr std::string_view kForceHelp =
    "Write also where a file that is read would be replaced";

/// Fails if two outputs of one command are the same file, also one that does not exist yet, or the
/// same pipe. A device such as /dev/null may be named twice. Call it before long work.
Status requireApart(std::span<const NamedFile> outputs);
/// Fails if an output is the same file as an input, by device and inode with links followed, so
/// that the input would be lost. Inputs that are no files (`scene:torus`) are ignored. Not called
/// if the user gave kForceOption. Call it before long work.
Status requireKept(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs);

/// Makes SIGINT, SIGTERM, SIGHUP and the other signals that end a program while it writes remove
/// unfinished files first, unless they are ignored. SIGINT then ends the program within the signal
/// handler, with exit code 130, whatever its threads are doing; `farewell` is written to stderr and
/// must outlive the program. For programs, once, at the start of main().
void removeUnfinishedFilesAtSignals(std::string_view farewell) noexcept;

}  // namespace se
