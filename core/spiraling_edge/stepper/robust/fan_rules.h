/// Beyond the paper (docs/robust.md): rules that examine the whole fan before it is made. Each
/// returns the spoke or triangle it objects to. guard.cpp has their table, and those on edges;
/// these, on shapes, are in fan_shape.cpp.
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

/// A triangle against its normals, or folded onto an old one (RobustRules::noFold).
Objection fold(const StepContext& context);
/// A wide triangle between points where the surface ends (RobustRules::rim).
Objection overRim(const StepContext& context);
/// A triangle on the outer side of a side between two points of one wall (RobustRules::rim).
Objection beyondWall(const StepContext& context);
/// A steep triangle, while such are delayed (RobustRules::delay).
Objection steep(const StepContext& context);
/// A new edge across a ring step nearby, in the tangent plane (RobustRules::noCross).
Objection crossing(const StepContext& context);
/// True if the normals of the pivot's neighborhood all lie within 45 degrees of its own, as is
/// usual: flat enough for RobustRules::noCross to see every overlap.
bool isFlatAround(const StepContext& context);
/// A triangle that meets a finished one nearby (RobustRules::noMeet), or is a second layer of one
/// (RobustRules::noLayer).
Objection conflictsWithFinished(const StepContext& context);

}  // namespace se
