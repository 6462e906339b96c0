/// Files: extensions, content within a limit, errors of the operating system.
#pragma once

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/base/word_list.h"

namespace se {

/// The extension in lower case, in every locale: ".ply" for "a/Scan.PLY"; empty if the name has
/// none.
inline std::string lowerExtension(const std::filesystem::path& path) {
    return lowerCase(path.extension().string());
}

/// Limit of the bytes that one input may hold, read or unpacked: 2 GiB by default.
struct ByteLimit {
    std::uint64_t bytes = std::uint64_t{1} << 31U;
    /// Ends the sentence of the error.
    std::string_view remedy = "--most-bytes N raises this limit";

    /// "NAME: holds more than 1000 bytes, read or unpacked; --most-bytes N raises this limit".
    Error exceededBy(const std::string& name) const;
};
/// Limit of texts that a program of this project has written: sessions, settings, answers.
inline constexpr ByteLimit kTextLimit{std::uint64_t{1} << 26U,
                                      "no such file of this program is as long"};

/// All bytes of a file or pipe, also of standard input as /dev/stdin. The size of a file is checked
/// before memory is taken; a source without an end is read up to the limit. Fails also once
/// `progress`, called after each MiB, returns false.
Result<std::string> readBytes(const std::filesystem::path& path, const ByteLimit& limit = {},
                              const Progress& progress = {});

/// True for a device, a pipe or a folder. One of these has no end, or blocks the program: a file
/// from elsewhere must not make it open one. False for a missing file, which opening reports.
bool isUnfit(const std::filesystem::path& path);
/// True if `path`, with its links followed, is outside of `folder` or isUnfit().
bool isUnfitIn(const std::filesystem::path& folder, const std::filesystem::path& path);

/// The text of errno: "No space left on device".
inline std::string systemReason() { return std::generic_category().message(errno); }

}  // namespace se
