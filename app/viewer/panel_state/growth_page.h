/// The page on which new points spread: its content and its requests. Plain values.
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
    double wanted = 0.0;  ///< Target spacing.
    SampleQuality quality;
};

struct GrowthPage {
    bool open = false;
    GrowthForm form;
    GrowthAsk asked = GrowthAsk::None;
    std::string savePath;  ///< File to save the points to; empty: none.

    GrowthPhase phase = GrowthPhase::Idle;
    double found = 0.0;     ///< Share done of the search for the surface.
    std::string complaint;  ///< Error of the form, the surface or the file.
    std::string said;       ///< Last success message.
    SampleSpec made;        ///< Specification of these points; unused while there are none.
    GrowthNumbers numbers;  ///< Zero while there are none.

    bool moving() const { return phase == GrowthPhase::Finding || phase == GrowthPhase::Spreading; }
    bool hasPoints() const { return numbers.points > 0; }
};

}  // namespace se::view
