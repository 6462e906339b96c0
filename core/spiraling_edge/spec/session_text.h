/// A session file (docs/file-formats.md): how it is recognized, and the one writer of its options.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "spiraling_edge/spec/spec_fields.h"

namespace se {

/// Extension of a session file.
inline constexpr std::string_view kSessionExtension = ".sesession";

/// True if the path has that extension, or the file begins with a brace, as no point file does.
bool looksLikeSession(const std::filesystem::path& path);

/// The content of a session: points, run, and the place to open at.
struct SessionStart {
    std::string points;   ///< Path of the points, relative to the session.
    RunSpec spec;         ///< Its source is not used.
    std::string address;  ///< Of the decision to open at.
    std::string alert{};  ///< "holes:1"; empty: none.
    std::string notes{};
};

/// The session as JSON.
std::string sessionText(const SessionStart& start);

}  // namespace se
