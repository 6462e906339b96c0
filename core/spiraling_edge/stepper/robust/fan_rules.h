/// Beyond the paper (docs/robust.md): rules that examine the whole fan before it is made. Each
/// returns the spoke or triangle it objects to. guard.cpp has their table.
#pragma once

#include "spiraling_edge/stepper/step_context.h"

namespace se {

/// The objection of a rule to spoke `at` of the fan, or to its triangle `at`, `at + 1`.
struct Objection {
    Verdict verdict = Verdict::Kept;
    std::size_t at = 0;
    bool triangle = false;

    explicit operator bool() const { return verdict != Verdict::Kept; }
};

using Fan = std::vector<FanPoint>;

// fan_edges.cpp
/// A gap of 180 degrees or more between two spokes (RobustRules::gap).
Objection wideGap(const StepContext& context);
/// An edge that is taken, or a ring step closed away from its entries (RobustRules::guard).
Objection takenEdge(const StepContext& context);
/// A second triangle on the same three points (RobustRules::noPillow).
Objection pillow(const StepContext& context);
// fan_shape.cpp
/// A triangle against its normals, or folded onto an old one (RobustRules::noFold).
Objection fold(const StepContext& context);
/// A wide triangle between points where the surface ends (RobustRules::rim).
Objection overRim(const StepContext& context);
/// A steep triangle, while such are delayed (RobustRules::delay).
Objection steep(const StepContext& context);
// fan_crossings.cpp
/// A new edge across a ring step nearby, in the tangent plane (RobustRules::noCross).
Objection crossing(const StepContext& context);
/// A triangle that meets a finished one nearby (RobustRules::noMeet).
Objection meetsFinished(const StepContext& context);

}  // namespace se
