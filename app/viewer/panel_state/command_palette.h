/// State of the command palette. Plain values.
#pragma once

#include <array>

namespace se::view {

/// The command palette.
struct CommandPalette {
    bool open = false;
    bool justOpened = false;  ///< The input line gets the keyboard focus.
    std::array<char, 64> filter{};
    int chosen = 0;

    void show() { *this = {true, true, {}, 0}; }
};

}  // namespace se::view
