/// The question before unsaved annotations are left. Plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "run/model.h"

namespace se::view {

enum class LeaveFor : std::uint8_t { Quit, Open, Reload };
enum class LeaveAnswer : std::uint8_t { None, Save, Discard, Cancel };

/// Destination after the question.
struct Leave {
    LeaveFor what = LeaveFor::Quit;
    std::string path;                              ///< Of LeaveFor::Open: a path or `scene:ID`.
    std::string notice;                            ///< Message on arrival.
    std::optional<InputSpec> spec = std::nullopt;  ///< Input to open, with its options.
};

/// The question, while it is open.
struct LeaveQuestion {
    bool asked = false;
    bool justAsked = false;  ///< The first button gets the keyboard focus.
    Leave leave;
    std::string atStake;                     ///< Unsaved annotations: "bookmarks and watches".
    LeaveAnswer answer = LeaveAnswer::None;  ///< Carried out in the same frame.

    void ask(Leave to, std::string unsaved) {
        *this = {true, true, std::move(to), std::move(unsaved), LeaveAnswer::None};
    }
};

}  // namespace se::view
