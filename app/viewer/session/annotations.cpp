#include "annotations.h"

#include <algorithm>
#include <iterator>

namespace se::view {

namespace {

Bookmarks::const_iterator placeOf(const Bookmarks& bookmarks, const Address& address) {
    return std::lower_bound(
        bookmarks.begin(), bookmarks.end(), address,
        [](const Bookmark& mark, const Address& to) { return isBefore(mark.address, to); });
}

}  // namespace

std::optional<std::size_t> bookmarkAt(const Bookmarks& bookmarks, const Address& address) {
    const auto found = placeOf(bookmarks, address);
    if (found == bookmarks.end() || found->address != address) return std::nullopt;
    return static_cast<std::size_t>(found - bookmarks.begin());
}

bool toggleBookmark(Bookmarks& bookmarks, const Address& address,
                    const std::optional<CameraPose>& camera) {
    const auto place = placeOf(bookmarks, address);
    if (place != bookmarks.end() && place->address == address) {
        bookmarks.erase(place);
        return false;
    }
    bookmarks.insert(place, {address, {}, camera});
    return true;
}

const Bookmark* nextBookmark(const Bookmarks& bookmarks, const Address& address, int direction) {
    const auto place = placeOf(bookmarks, address);  // The first not before the address.
    if (direction < 0) return place == bookmarks.begin() ? nullptr : &*std::prev(place);
    const bool here = place != bookmarks.end() && place->address == address;
    const auto next = here ? std::next(place) : place;
    return next == bookmarks.end() ? nullptr : &*next;
}

void insertBookmark(Bookmarks& bookmarks, Bookmark bookmark) {
    if (const auto at = bookmarkAt(bookmarks, bookmark.address)) {
        bookmarks[*at] = std::move(bookmark);
    } else {
        const auto place = placeOf(bookmarks, bookmark.address);
        bookmarks.insert(place, std::move(bookmark));
    }
}

std::string differenceOf(const Annotations& a, const Annotations& b) {
    std::vector<const char*> kinds;
    if (a.bookmarks != b.bookmarks) kinds.push_back("bookmarks");
    if (a.notes != b.notes) kinds.push_back("notes");
    if (a.breakpoints != b.breakpoints) kinds.push_back("breakpoints");
    if (a.watches != b.watches) kinds.push_back("watches");
    std::string words;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (i > 0) words += i + 1 == kinds.size() ? " and " : ", ";
        words += kinds[i];
    }
    return words;
}

}  // namespace se::view
