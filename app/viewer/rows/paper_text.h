/// The paper's rules in our own words and as pseudo-code, stage by stage, for the panel that shows
/// where in them the cursor stands. Plain values, no ImGui.
#pragma once

#include <span>
#include <string>

#include "spiraling_edge/stepper/event.h"

namespace se::view {

struct PaperRule {
    Stage stage;
    const char* title;
    const char* words;
    std::span<const char* const> code;  ///< Lines, two blanks per level.
};

/// The rule of a stage. Stages that belong together share one.
const PaperRule& paperRule(Stage stage);

/// The line of the rule's code that the event stands on, counted from 0.
std::size_t presentLine(const Event& event);

/// The numbers that were compared there; empty if there are none.
std::string liveNumbers(const Event& event);

}  // namespace se::view
