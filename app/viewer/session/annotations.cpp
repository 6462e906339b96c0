#include "annotations.h"

namespace se::view {

std::string differenceOf(const Noted& a, const Noted& b) {
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
