/// The question before unsaved work is left. Plain values.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

enum class LeaveFor : std::uint8_t { Quit, Open, Reload };
enum class LeaveAnswer : std::uint8_t { Save, Discard, Cancel };

/// Destination after the question.
struct Leave {
    LeaveFor what = LeaveFor::Quit;
    std::string path;                            ///< Of LeaveFor::Open: a path or `scene:ID`.
    std::string notice;                          ///< Message on arrival.
    std::optional<RunSpec> spec = std::nullopt;  ///< Input to open, with its options.
    std::function<void()> open = nullptr;        ///< Opens what a link names, instead of these.
};

/// The question, while it is open.
struct LeaveQuestion {
    bool asked = false;
    bool justAsked = false;  ///< The first button gets the keyboard focus.
    Leave leave;
    std::string atStake;  ///< Unsaved annotations: "bookmarks and watches".

    void ask(Leave to, std::string unsaved) {
        *this = {true, true, std::move(to), std::move(unsaved)};
    }
};

}  // namespace se::view
