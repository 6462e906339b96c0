/// The clipboard: of the desktop once it is connected, until then a text in memory.
#pragma once

#include <functional>
#include <string>
#include <utility>

namespace se::view {

class Clipboard {
  public:
    using Read = std::function<std::string()>;
    using Write = std::function<void(const std::string& text)>;

    void connect(Read read, Write write) {
        read_ = std::move(read);
        write_ = std::move(write);
    }
    std::string text() const { return read_ ? read_() : text_; }
    void copy(const std::string& text) {
        text_ = text;
        if (write_) write_(text);
    }
    /// The last text that this program has copied.
    const std::string& copied() const { return text_; }

  private:
    Read read_;
    Write write_;
    std::string text_;
};

// Files of the reader's machine where the program sees only its own, as in a page.

struct HostFiles {
    /// Lets the reader choose files, which arrive as dropped ones. Empty: the program sees the
    /// machine's files itself.
    std::function<void()> pick;

    /// Files are known only as long as the page: saved ones go to the downloads.
    bool apart() const { return static_cast<bool>(pick); }
};

}  // namespace se::view
