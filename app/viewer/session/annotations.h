/// What a person noted about an input, all of which a session file holds. Plain values.
#pragma once

#include <string>
#include <vector>

#include "bookmarks.h"
#include "spiraling_edge/replay/breakpoint.h"

namespace se::view {

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
