#include "tab_order.h"

#include <utility>

namespace se::view {

namespace {

std::size_t placeOf(KeyStop stop) { return static_cast<std::size_t>(stop); }

}  // namespace

std::string_view keyStopName(KeyStop stop) {
    constexpr std::array<std::string_view, kKeyStopCount> kNames = {
        "view", "rail", "content", "steps", "rings", "ring points", "files", "scenes"};
    return kNames[placeOf(stop)];
}

void KeyWalk::begin() {
    offered_ = std::exchange(fresh_, Offers{true});
    // Its panel is gone, for example in another layout.
    if (!offered_[placeOf(at_)]) leave();
}

bool KeyWalk::offer(KeyStop stop) {
    fresh_[placeOf(stop)] = true;
    if (wanted_ != stop) return false;
    at_ = std::exchange(wanted_, KeyStop::View);
    return true;
}

bool KeyWalk::go(int direction) {
    const int count = static_cast<int>(kKeyStopCount);
    int place = static_cast<int>(placeOf(at_));
    do {
        place = (place + direction + count) % count;
    } while (!offered_[static_cast<std::size_t>(place)]);
    wanted_ = static_cast<KeyStop>(place);
    if (wanted_ != KeyStop::View) return false;
    at_ = KeyStop::View;
    return true;
}

}  // namespace se::view
