/// The user's annotations of an input, which a session file stores. Plain values.
#pragma once

#include <string>
#include <vector>

#include "bookmarks.h"
#include "spiraling_edge/breakpoint.h"

namespace se::view {

struct Noted {
    Bookmarks bookmarks;
    std::string notes;
    std::vector<Breakpoint> breakpoints;
    std::vector<std::string> watches;

    bool operator==(const Noted&) const = default;
};

/// Differences in words: "bookmarks and watches". Empty if there are none.
std::string differenceOf(const Noted& a, const Noted& b);

}  // namespace se::view
