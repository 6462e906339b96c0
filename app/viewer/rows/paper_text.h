/// The paper's rules in this program's words and as pseudo-code, stage by stage, for the panel that
/// highlights the current line. Plain values, no ImGui.
#pragma once

#include <string>
#include <vector>

#include "spiraling_edge/stepper/event.h"

namespace se::view {

struct PaperRule {
    std::string stages;  ///< Names, with spaces between them.
    std::string title;
    std::string words;
    std::vector<std::string> code;  ///< Lines, two spaces per level.
};

/// The rule of a stage. Stages that belong together share one.
const PaperRule& paperRule(Stage stage);

/// The line of the rule's code for the event, counted from 0.
std::size_t presentLine(const Event& event);

/// The numbers compared in that line; empty if there are none.
std::string liveNumbers(const Event& event);

}  // namespace se::view
