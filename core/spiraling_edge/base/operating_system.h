/// Calls of the operating system beyond the C++ library, in one file: the sources here are for
/// POSIX, with what is of Linux or of GNU alone marked. docs/porting.md names what other systems
/// need, and the two parts of the viewer that call the system on their own.
///
/// A descriptor is the number of an open file, -1 if opening failed; a call that fails leaves its
/// reason in errno (systemReason() of files.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace se::os {

/// A standard stream of this process for text.
enum class Stream { Output, Error };

/// True if a standard stream of this process is shown on a terminal.
bool isTerminal(Stream stream);

/// The file of the running program; empty if the system does not tell. Linux: /proc.
std::filesystem::path programPath();

/// Replaces this process by a program: `arguments` begin after its name. Returns only if that
/// failed.
void becomeProgram(const std::filesystem::path& program, std::vector<std::string> arguments);

/// Lowers the priority of this thread, and of those that it starts, so that the window and the
/// user's own work come first. Elsewhere than on Linux, where that is one call, nothing changes.
void lowerPriority();

/// From now on blocks of a megabyte and more go back to the system as soon as they are freed. By
/// default the C library of GNU keeps them once some were freed, and the peak of a run is the sum
/// of its parts. For programs, once at their start; does nothing with other C libraries.
void returnFreedMemory();

/// The path that stands for standard input.
inline constexpr const char* kStandardInputDevice = "/dev/stdin";
/// Opens a file for reading. Standard input as /dev/stdin is duplicated, not opened: a socket
/// cannot be opened, and of a file some may have been read.
int openToRead(const std::filesystem::path& path);
/// Opens an existing file, pipe or device for writing, at its end if `append`.
int openToWrite(const std::filesystem::path& path, bool append);
/// Makes a file that does not exist yet, with these permission bits before the umask.
int makeFile(const std::filesystem::path& path, unsigned mode);
/// Opens a folder, to sync it.
int openFolder(const std::filesystem::path& folder);

/// Reads up to `count` bytes to `to`: their number, 0 at the end, negative after a failure.
std::ptrdiff_t readSome(int descriptor, char* to, std::size_t count);
/// Writes all bytes. May be called in a handler of signals.
bool writeAll(int descriptor, std::string_view bytes);
/// Writes to standard error. May be called in a handler of signals.
void writeToStandardError(std::string_view bytes);
/// Waits until what was written is on the disk. True also where the file system has no such call.
bool sync(int descriptor);
/// Closes a descriptor. False if what was written may be lost.
bool close(int descriptor);
/// The size of a regular file; 0 for other sources.
std::uint64_t sizeOf(int descriptor);
/// Sets the permission bits, regardless of the umask. A failure is ignored.
void setMode(int descriptor, unsigned mode);

/// Closes a descriptor at its end, if opening succeeded.
class Closing {
  public:
    explicit Closing(int descriptor) : descriptor_(descriptor) {}
    Closing(const Closing&) = delete;
    Closing& operator=(const Closing&) = delete;
    ~Closing() {
        if (descriptor_ >= 0) close(descriptor_);
    }

  private:
    int descriptor_;
};

/// Removes a file. May be called in a handler of signals.
void removeFile(const char* path);
/// True if this user may write to a file, or into a folder.
bool mayWrite(const std::filesystem::path& path);

/// The status of a file, with its links followed.
struct FileStatus {
    enum class Kind { Regular, Folder, Block, Character, Other };
    Kind kind = Kind::Regular;
    unsigned mode = 0;         ///< Permission bits.
    std::uint64_t device = 0;  ///< With `number`, the identity of the file.
    std::uint64_t number = 0;  ///< Of its inode.
};
/// Empty if there is no such file, or if it cannot be reached.
std::optional<FileStatus> statusOf(const std::filesystem::path& path);

/// Calls `handler` at an interrupt (SIGINT) and at the other signals that end a program while it
/// writes, except those that the caller of the program ignores.
void handleEndingSignals(void (*handler)(int));
/// Ends the program as the signal would have ended it without a handler.
void endBySignal(int signal);
/// Ends the program at once, whatever its threads are doing. May be called in a handler.
[[noreturn]] void endAtOnce(int exitCode);

}  // namespace se::os
