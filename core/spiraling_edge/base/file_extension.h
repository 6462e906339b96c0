/// File extensions.
#pragma once

#include <filesystem>
#include <string>

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

}  // namespace se
