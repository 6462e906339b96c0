#include "go_to_box.h"

#include <cassert>
#include <utility>

#include "key_routing.h"

namespace se::view {

namespace {

constexpr std::size_t kLongest = 40;

}  // namespace

void GoToBox::open() {
    *this = {};
    active_ = true;
}

void GoToBox::clear() {
    text_.clear();
    caret_ = 0;
    marked_ = false;
}

void GoToBox::type(unsigned sign) {
    assert(active());
    if (sign <= ' ' || sign >= 127) return;
    if (marked_) clear();
    if (text_.size() < kLongest) text_.insert(caret_++, 1, static_cast<char>(sign));
}

void GoToBox::paste(std::string_view text) {
    for (const char sign : text) type(static_cast<unsigned char>(sign));
}

void GoToBox::move(int key) {
    const bool moves =
        key == key::kLeft || key == key::kRight || key == key::kHome || key == key::kEnd;
    if (moves) marked_ = false;
    if (key == key::kLeft && caret_ > 0) --caret_;
    if (key == key::kRight && caret_ < text_.size()) ++caret_;
    if (key == key::kHome) caret_ = 0;
    if (key == key::kEnd) caret_ = text_.size();
}

void GoToBox::erase(int key) {
    if (marked_) return clear();
    if (key == key::kBackspace && caret_ > 0) text_.erase(--caret_, 1);
    if (key == key::kDelete && caret_ < text_.size()) text_.erase(caret_, 1);
}

void GoToBox::letter(int key) {
    if (key == 'A') {
        marked_ = !text_.empty();
        caret_ = text_.size();
    }
    if (!marked_ || (key != 'C' && key != 'X')) return;
    copied_ = text_;
    if (key == 'X') clear();
}

bool GoToBox::press(const KeyChord& chord) {
    assert(active());
    if (!editsText(chord)) return false;
    if ((chord.mods & (kCtrl | kAlt)) == kCtrl && chord.key < key::kEscape) {
        letter(chord.key);
        return true;
    }
    // All other plain keys arrive again as characters, or have no function here.
    const bool enters = chord.key == key::kEnter || chord.key == key::kKeypadEnter;
    if (enters) submitted_ = !text_.empty();
    if (enters || chord.key == key::kEscape) active_ = false;
    if (chord.key == key::kBackspace || chord.key == key::kDelete) erase(chord.key);
    move(chord.key);
    return true;
}

bool GoToBox::takeSubmitted() { return std::exchange(submitted_, false); }

std::string GoToBox::takeCopied() { return std::exchange(copied_, {}); }

}  // namespace se::view
