/// The session file: input, options, position and annotations, as JSON
/// (docs/file-formats.md).
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare_with.h"
#include "layers/layer.h"
#include "layout_preset.h"
#include "run/model.h"
#include "run/selection.h"
#include "scene/camera.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/run/breakpoint.h"
#include "spiraling_edge/spec/session_text.h"
#include "spiraling_edge/stepper/event.h"
#include "view_position.h"

namespace se::view {

// The user's annotations of an input, which a session file stores: bookmarked positions, notes and
// breakpoints. Plain values.

struct Bookmark {
    Address address;
    std::string note;                                 ///< One line by the user; may be empty.
    std::optional<CameraPose> camera = std::nullopt;  ///< The view when it was set.
    friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// Bookmarks in the order of the run, one per address at most.
using Bookmarks = std::vector<Bookmark>;

/// Number of bookmarks with a key: Ctrl+1 to Ctrl+9, then Ctrl+0.
inline constexpr std::size_t kBookmarkKeys = 10;

/// Sets a bookmark with that camera, or removes an existing one. True if it is set now.
bool toggleBookmark(Bookmarks& bookmarks, const Address& address,
                    const std::optional<CameraPose>& camera = std::nullopt);
/// The position of the bookmark at an address, if there is one.
std::optional<std::size_t> bookmarkAt(const Bookmarks& bookmarks, const Address& address);
/// The nearest one after an address (direction 1) or before it (-1); null if there is none.
const Bookmark* nextBookmark(const Bookmarks& bookmarks, const Address& address, int direction);
/// Inserts a bookmark in order; it replaces an older one at the same address.
void insertBookmark(Bookmarks& bookmarks, Bookmark bookmark);

struct Annotations {
    Bookmarks bookmarks;
    std::string notes;
    std::vector<Breakpoint> breakpoints;
    std::vector<std::string> watches;

    bool operator==(const Annotations&) const = default;
};

/// Differences in words: "bookmarks and watches". Empty if there are none.
std::string differenceOf(const Annotations& a, const Annotations& b);

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
