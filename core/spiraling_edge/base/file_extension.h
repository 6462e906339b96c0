/// File extensions.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace se {

/// The extension in lower case: ".ply" for "a/Scan.PLY"; empty if the name has none.
inline std::string lowerExtension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

}  // namespace se
