/// What a person noted about an input, all of which a session file holds. Plain values.
///
/// Places in a run that a person wants to find again. Plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "spiraling_edge/replay/breakpoint.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

struct Bookmark {
    Address address;
    std::string note;  ///< One line of the person's own; may be empty.
    friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// Does `a` come first in the run?
bool isBefore(const Address& a, const Address& b);

/// In the order of the run, one per address at most.
using Bookmarks = std::vector<Bookmark>;

/// How many can be gone to by a key: Ctrl+1 to Ctrl+9, then Ctrl+0.
inline constexpr std::size_t kBookmarkKeys = 10;

/// Sets a bookmark, or takes it away if there is one. True if it is there now.
bool toggleBookmark(Bookmarks& bookmarks, const Address& address);
/// The position of the bookmark at an address, if there is one.
std::optional<std::size_t> bookmarkAt(const Bookmarks& bookmarks, const Address& address);
/// The nearest one behind an address (direction 1) or before it (-1); null if there is none.
const Bookmark* nextBookmark(const Bookmarks& bookmarks, const Address& address, int direction);
/// Adds one in its place; an older one at the same address gives way.
void insertBookmark(Bookmarks& bookmarks, Bookmark bookmark);

struct Noted {
    Bookmarks bookmarks;
    std::string notes;
    std::vector<Breakpoint> breakpoints;
    std::vector<std::string> watches;

    bool operator==(const Noted&) const = default;
};

/// What is not the same in both, in words: "bookmarks and watches". Empty if all is.
std::string differenceOf(const Noted& a, const Noted& b);

}  // namespace se::view
