/// What a person is asked before something noted that no file holds is left. Plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "run/model.h"

namespace se::view {

enum class LeaveFor : std::uint8_t { Quit, Open, Reload };
enum class LeaveAnswer : std::uint8_t { None, Save, Discard, Cancel };

/// Where one is about to go.
struct Leave {
    LeaveFor what = LeaveFor::Quit;
    std::string path;                              ///< Of LeaveFor::Open: a path or `scene:ID`.
    std::string notice;                            ///< To be said on arriving.
    std::optional<InputSpec> spec = std::nullopt;  ///< What to open, with its options.
};

/// The question, as long as it stands there.
struct LeaveQuestion {
    bool asked = false;
    bool justAsked = false;  ///< The first button gets the keyboard.
    Leave leave;
    std::string atStake;                     ///< What no file holds: "bookmarks and watches".
    LeaveAnswer answer = LeaveAnswer::None;  ///< Carried out in the same frame.

    void ask(Leave to, std::string unsaved) {
        *this = {true, true, std::move(to), std::move(unsaved), LeaveAnswer::None};
    }
};

}  // namespace se::view
