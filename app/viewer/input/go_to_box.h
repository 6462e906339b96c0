/// The box that takes an address. It reads keys from our own queue, not through ImGui 1.86, which
/// loses a key that is pressed and released between two frames.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "keys.h"

namespace se::view {

class GoToBox {
  public:
    bool active() const { return active_; }
    const std::string& text() const { return text_; }
    /// Where the next sign goes, in [0, text().size()].
    std::size_t caret() const { return caret_; }
    /// All of it is marked: what is typed next takes its place.
    bool marked() const { return marked_; }
    /// Takes the keys from now on.
    void open();
    void close() { active_ = false; }
    /// Requires active(). Signs that no address has are left out.
    void type(unsigned sign);
    /// Requires active(). As if it were typed at once.
    void paste(std::string_view text);
    /// Requires active(). True if the key was for the box, as those that edit text are; then
    /// takeSubmitted() may have become true. Ctrl+V is left to who has the clipboard.
    bool press(const KeyChord& chord);
    /// True once after Enter; the box is closed then and text() is what to go to.
    bool takeSubmitted();
    /// What Ctrl+C or Ctrl+X have put on the clipboard, once; empty: nothing.
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
