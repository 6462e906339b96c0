/// The session file: input, options, position and annotations, as JSON
/// (docs/file-formats.md).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "annotations.h"
#include "compare_with.h"
#include "layers/layer.h"
#include "layout_preset.h"
#include "run/model.h"
#include "run/selection.h"
#include "spiraling_edge/base/result.h"
#include "view_position.h"

namespace se::view {

inline constexpr std::string_view kSessionExtension = ".sesession";

struct SessionFile {
    RunSpec input;          ///< With a path relative to the working directory.
    std::string inputHash;  ///< Hash of the input when it was saved; empty if unknown.
    ViewPosition place;
    std::optional<LayerModes> layers;
    std::optional<LayoutPreset> layout;
    bool lessons = false;  ///< The layout "learn" of version 0.2: the column opens at Lesson.
    Selection selected;
    std::string alert;  ///< Alert that was shown, see alertName(); empty: none.
    CompareWith with;   ///< The other run or mesh.
    Annotations annotations;
    std::string query;    ///< Text in the line of the panel Query.
    std::string leftOut;  ///< A sentence about unknown layers; empty: none.
    /// JSON that it was read from: unknown fields are written back. Empty for a new session.
    std::string original;
};

/// A source; its path, if it has one, is changed by `move`.
std::string movedSource(const std::string& source,
                        const std::function<std::string(const std::string&)>& move);

/// Decided by extension, otherwise by the first character: no point file begins with a brace.
bool looksLikeSession(const std::filesystem::path& path);

/// Parses a session in `folder`; errors call it `name`. Errors name what was expected; nothing is
/// guessed.
Result<SessionFile> sessionFromJson(std::string_view text, const std::string& name,
                                    const std::filesystem::path& folder);
/// JSON of a session, with the path of the input relative to `folder`.
std::string sessionToJson(const SessionFile& session, const std::filesystem::path& folder);

Result<SessionFile> readSessionFile(const std::filesystem::path& path);
/// Writes the file atomically: old or new, never a part.
Status writeSessionFile(const std::filesystem::path& path, const SessionFile& session);

}  // namespace se::view
