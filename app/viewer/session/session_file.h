/// The session file: what is open, how, where one stands and what one noted, as JSON
/// (docs/file-formats.md).
#pragma once

#include <filesystem>
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
#include "spiraling_edge/replay/breakpoint.h"
#include "view_position.h"

namespace se::view {

inline constexpr std::string_view kSessionExtension = ".sesession";

struct SessionFile {
    InputSpec input;        ///< Its path is one from where the program runs.
    std::string inputHash;  ///< Of the input when it was saved; empty if not known.
    Place place;
    std::optional<LayerModes> layers;
    std::optional<Arrangement> layout;
    Selection selected;
    std::string alert;  ///< That was looked at, see alertName(); empty: none.
    CompareWith with;   ///< What the run is compared with.
    Bookmarks bookmarks;
    std::string notes;
    std::string query;  ///< What stands in the line of the panel Query.
    std::vector<Breakpoint> breakpoints;
    std::vector<std::string> watches;
    std::string leftOut;  ///< A sentence about layers that are not known here; empty: none.
    /// What it was read from: fields that we do not know are written back. Empty for a new one.
    std::string original;
};

/// By extension, else by the first sign of the content: no point file begins with a brace.
bool looksLikeSession(const std::filesystem::path& path);

/// Reads a session that lies in `folder`; `name` is what errors call it. Errors say what was
/// expected; nothing is guessed.
Result<SessionFile> sessionFromJson(std::string_view text, const std::string& name,
                                    const std::filesystem::path& folder);
/// With the path of the input relative to `folder`.
std::string sessionToJson(const SessionFile& session, const std::filesystem::path& folder);

Result<SessionFile> readSessionFile(const std::filesystem::path& path);
/// Old or new, never half written.
Status writeSessionFile(const std::filesystem::path& path, const SessionFile& session);

}  // namespace se::view
