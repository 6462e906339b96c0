/// Surfaces given by a formula, shared by the built-in scenes, the shapes of field.h and the tests.
/// All but the gyroid use only + - * / and sqrt: equal on every machine.
#pragma once

#include "spiraling_edge/base/types.h"

namespace se {

/// The points where value(x) = 0; the gradient points outward.
struct ImplicitSurface {
    double (*value)(const Vec3&);
    Vec3 (*gradient)(const Vec3&);
    Vec3 low, high;  ///< A box around it; with walls, the box that cuts it.
};

/// Tori have a tube of radius 0.4 around a circle of radius 1.
ImplicitSurface unitSphere();
ImplicitSurface torus();
ImplicitSurface linkedTori();
ImplicitSurface doubleTorus();
/// The square |x|, |y| <= 1 of the plane z = 0.
ImplicitSurface flatSheet();
/// Waves over the square |x|, |y| <= 1.
ImplicitSurface wavySheet();
/// The gyroid, a minimal surface of Schoen (1970), approximated by a level set: saddle-shaped
/// everywhere, and branching.
ImplicitSurface gyroid();

}  // namespace se
