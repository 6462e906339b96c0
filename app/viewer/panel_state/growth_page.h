/// The page on which new points spread: what it shows and what it asks for. Plain values.
#pragma once

#include <string>

#include "growth_form.h"
#include "jobs/growth.h"

namespace se::view {

/// Carried out in the same frame.
enum class GrowthAsk : std::uint8_t { None, Begin, PlayOrPause, Step, Finish, Use, Home, Leave };

/// The particles in numbers.
struct GrowthNumbers {
    int step = 0;
    std::size_t points = 0;
    std::size_t onWalls = 0;  ///< Corners among them.
    std::size_t corners = 0;
    double wanted = 0.0;  ///< Spacing that they are heading for.
    SampleQuality quality;
};

struct GrowthPage {
    bool open = false;
    GrowthForm form;
    GrowthAsk asked = GrowthAsk::None;
    std::string savePath;  ///< The points are to be saved there; empty: nothing.

    GrowthPhase phase = GrowthPhase::Idle;
    double found = 0.0;     ///< While the surface is looked for: the share done.
    std::string complaint;  ///< What is wrong with the form, the surface or the file.
    std::string said;       ///< What went well lately.
    SampleSpec made;        ///< Which points these are; of no use while there are none.
    GrowthNumbers numbers;  ///< Zero while there are none.

    bool moving() const { return phase == GrowthPhase::Finding || phase == GrowthPhase::Spreading; }
    bool hasPoints() const { return numbers.points > 0; }
};

}  // namespace se::view
