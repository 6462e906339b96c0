#include "go_to_box.h"

#include <utility>

namespace se::view {

namespace {

constexpr std::size_t kLongest = 40;

}  // namespace

void GoToBox::type(unsigned sign) {
    if (sign > ' ' && sign < 127 && text_.size() < kLongest) text_ += static_cast<char>(sign);
}

bool GoToBox::press(const KeyChord& chord) {
    if (chord.isFunctionKey() || (chord.mods & (kCtrl | kAlt)) != 0) return false;
    if (chord.key == key::kEnter || chord.key == key::kKeypadEnter) {
        active_ = false;
        submitted_ = !text_.empty();
    } else if (chord.key == key::kEscape) {
        active_ = false;
    } else if (chord.key == key::kBackspace && !text_.empty()) {
        text_.pop_back();
    }
    // All other plain keys come again as signs, or mean nothing here.
    return true;
}

bool GoToBox::takeSubmitted() { return std::exchange(submitted_, false); }

}  // namespace se::view
