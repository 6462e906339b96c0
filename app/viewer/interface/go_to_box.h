/// The box that takes an address. It reads keys from our own queue, not through ImGui 1.86, which
/// loses a key that is pressed and released between two frames.
#pragma once

#include <string>

#include "keys.h"

namespace se::view {

class GoToBox {
  public:
    bool active() const { return active_; }
    const std::string& text() const { return text_; }
    /// Takes the keys from now on.
    void open() {
        active_ = true;
        text_.clear();
    }
    void close() { active_ = false; }
    /// Requires active(). Signs that no address has are left out.
    void type(unsigned sign);
    /// Requires active(). True if the key was for the box; then submitted() may have become true.
    bool press(const KeyChord& chord);
    /// True once after Enter; the box is closed then and text() is what to go to.
    bool takeSubmitted();

  private:
    bool active_ = false;
    bool submitted_ = false;
    std::string text_;
};

}  // namespace se::view
