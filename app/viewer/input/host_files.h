/// Files of the reader's machine where the program sees only its own, as in a page.
#pragma once

#include <functional>

namespace se::view {

struct HostFiles {
    /// Lets the reader choose files, which arrive as dropped ones. Empty: the program sees the
    /// machine's files itself.
    std::function<void()> pick;

    /// Files are known only as long as the page: saved ones go to the downloads.
    bool apart() const { return static_cast<bool>(pick); }
};

}  // namespace se::view
