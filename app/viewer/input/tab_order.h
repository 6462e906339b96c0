/// Keyboard focus of the panels: the current owner, and the next one for Tab. Plain values, no
/// ImGui.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace se::view {

/// In the order of Tab. The view has the keyboard where no panel has; files and scenes are on
/// the start page, which replaces it.
enum class KeyStop : std::uint8_t { View, Rail, Content, Steps, Rings, RingPoints, Files, Scenes };
inline constexpr std::size_t kKeyStopCount = 8;

std::string_view keyStopName(KeyStop stop);

class KeyWalk {
  public:
    /// At the beginning of a frame, before panels are drawn.
    void begin();
    /// A panel is drawn and has rows to choose from. True if it gets the keyboard now.
    bool offer(KeyStop stop);
    /// To the next (+1) or previous (-1) of the panels drawn lately, the view among them; true if
    /// that is the view.
    bool go(int direction);
    /// Back to the view, without a request by go().
    void leave() { at_ = wanted_ = KeyStop::View; }
    KeyStop at() const { return at_; }

  private:
    using Offers = std::array<bool, kKeyStopCount>;
    Offers offered_{true};  ///< Panels of the previous frame.
    Offers fresh_{true};
    KeyStop at_ = KeyStop::View;
    KeyStop wanted_ = KeyStop::View;  ///< Gets the keyboard as soon as it is drawn.
};

}  // namespace se::view
