/// Files: extensions, content, errors of the operating system.
#pragma once

#include <cerrno>
#include <filesystem>
#include <string>

#include "spiraling_edge/base/result.h"

namespace se {

/// The extension in lower case, in every locale: ".ply" for "a/Scan.PLY"; empty if the name has
/// none.
inline std::string lowerExtension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return extension;
}

/// All bytes of a file or pipe.
Result<std::string> readBytes(const std::filesystem::path& path);

/// The text of errno: "No space left on device".
inline std::string systemReason() { return std::generic_category().message(errno); }

}  // namespace se
