/// Tab walks: which panel has the keyboard, and which gets it next. Plain values, no ImGui.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace se::view {

/// In the order of walking. The view has the keyboard where no panel has; files and scenes are on
/// the start page, which stands in its place.
enum class KeyStop : std::uint8_t { View, Steps, Rings, RingPoints, Tabs, Content, Files, Scenes };
inline constexpr std::size_t kKeyStopCount = 8;

std::string_view keyStopName(KeyStop stop);

class KeyWalk {
  public:
    /// At the beginning of a frame, before panels offer themselves.
    void begin();
    /// A panel is drawn and has something to walk through. True if it gets the keyboard now.
    bool offer(KeyStop stop);
    /// To the next (+1) or previous (-1) of those offered lately, the view among them.
    void go(int direction);
    /// Back to the view, without being asked to by go().
    void leave() { at_ = wanted_ = KeyStop::View; }
    KeyStop at() const { return at_; }

  private:
    using Offers = std::array<bool, kKeyStopCount>;
    Offers offered_{true};  ///< In the frame before this one.
    Offers fresh_{true};
    KeyStop at_ = KeyStop::View;
    KeyStop wanted_ = KeyStop::View;  ///< Gets the keyboard as soon as it is drawn.
};

}  // namespace se::view
