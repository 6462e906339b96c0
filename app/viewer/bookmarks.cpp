#include "bookmarks.h"

#include <algorithm>
#include <tuple>

namespace se::view {

namespace {

bool before(const Bookmark& bookmark, const Address& address) {
    const Address& a = bookmark.address;
    return std::tie(a.pivot, a.stage, a.n) < std::tie(address.pivot, address.stage, address.n);
}

Bookmarks::const_iterator placeOf(const Bookmarks& bookmarks, const Address& address) {
    return std::lower_bound(bookmarks.begin(), bookmarks.end(), address, before);
}

}  // namespace

std::optional<std::size_t> bookmarkAt(const Bookmarks& bookmarks, const Address& address) {
    const auto found = placeOf(bookmarks, address);
    if (found == bookmarks.end() || found->address != address) return std::nullopt;
    return static_cast<std::size_t>(found - bookmarks.begin());
}

bool toggleBookmark(Bookmarks& bookmarks, const Address& address) {
    const auto place = placeOf(bookmarks, address);
    if (place != bookmarks.end() && place->address == address) {
        bookmarks.erase(place);
        return false;
    }
    bookmarks.insert(place, {address, {}});
    return true;
}

void insertBookmark(Bookmarks& bookmarks, Bookmark bookmark) {
    if (const auto at = bookmarkAt(bookmarks, bookmark.address)) {
        bookmarks[*at] = std::move(bookmark);
    } else {
        const auto place = placeOf(bookmarks, bookmark.address);
        bookmarks.insert(place, std::move(bookmark));
    }
}

}  // namespace se::view
