/// The user's annotations of an input, which a session file stores: bookmarked positions, notes and
/// breakpoints. Plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "spiraling_edge/run/breakpoint.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

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

}  // namespace se::view
