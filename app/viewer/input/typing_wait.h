/// Delay of keys until a text field opened by a command has the keyboard focus: Dear ImGui
/// assigns it some frames later. Plain values.
#pragma once

#include <algorithm>

namespace se::view {

/// Text fields that commands open.
enum TypedField : unsigned {
    kNoField = 0,
    kPaletteField = 1,
    kBrowserField = 2,
    kQueryField = 4,
    kLedgerField = 8,
};

class TypingWait {
  public:
    /// The fields that are open or about to be, as bits of TypedField: to be called
    /// after every command and every frame. A new one makes keys wait.
    void see(unsigned fields) {
        if ((fields & ~seen_) != 0) begin();
        seen_ = fields;
    }
    /// The opened field is drawn and accepts input.
    void takesKeys() { takes_ = true; }
    /// At the end of a frame. `routed`: plain keys go to a text field and to no action.
    void endFrame(bool routed) {
        frames_ = takes_ && routed ? 0 : std::max(0, frames_ - 1);
        takes_ = false;
    }
    bool waits() const { return frames_ > 0; }

  private:
    /// Dear ImGui needs about four, another layout one more. A field that never appears, for
    /// example because nothing is open, must not block the keys.
    static constexpr int kMaxFrames = 10;

    void begin() {
        frames_ = kMaxFrames;
        takes_ = false;
    }

    unsigned seen_ = kNoField;
    int frames_ = 0;
    bool takes_ = false;
};

}  // namespace se::view
