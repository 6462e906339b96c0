/// The box that takes an address. It reads keys from our own queue, not through ImGui 1.86, which
/// loses a key that is pressed and released between two frames.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "key_map.h"

namespace se::view {

class GoToBox {
  public:
    bool active() const { return active_; }
    const std::string& text() const { return text_; }
    /// Position of the next character, in [0, text().size()].
    std::size_t caret() const { return caret_; }
    /// All of it is selected: the next input replaces it.
    bool marked() const { return marked_; }
    /// Opens the box, which takes the keys from now on.
    void open();
    void close() { active_ = false; }
    /// Requires active(). Characters that no address has are ignored.
    void type(unsigned sign);
    /// Requires active(). Inserts the text as if it were typed.
    void paste(std::string_view text);
    /// Requires active(). True if the key was for the box, like all that edit text; then
    /// takeSubmitted() may have become true. Ctrl+V is left to the owner of the clipboard.
    bool press(const KeyChord& chord);
    /// True once after Enter; the box is closed then and text() is the target.
    bool takeSubmitted();
    /// Text that Ctrl+C or Ctrl+X put on the clipboard, once; empty: none.
    std::string takeCopied();

  private:
    void move(int key);
    void erase(int key);
    void letter(int key);
    void clear();

    bool active_ = false;
    bool submitted_ = false;
    bool marked_ = false;
    std::size_t caret_ = 0;
    std::string text_;
    std::string copied_;
};

}  // namespace se::view
