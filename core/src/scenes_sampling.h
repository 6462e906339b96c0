/// Even sampling of implicit surfaces for the built-in scenes, after the particle systems that the
/// paper's points come from (§3): random points repel each other and are pulled back onto the
/// surface. Only + - * / and sqrt: equal on every machine.
#pragma once

#include <cstdint>

#include "spiraling_edge/io.h"

namespace se {

/// The points where value(x) = 0; the gradient points outwards.
struct ImplicitSurface {
    double (*value)(const Vec3&);
    Vec3 (*gradient)(const Vec3&);
    Vec3 low, high;  ///< A box around it; with walls, the box that it is cut by.
};

/// `count` points about `spacing` apart (the two must fit the area), with gradient normals.
PointFile sampleClosed(const ImplicitSurface& surface, std::size_t count, double spacing,
                       std::uint64_t seed);

/// A sheet z = f(x, y) over the rectangle of its box: `perSide` points besides the corners on each
/// of the four walls, typed, and `interior` points between them.
PointFile sampleSheet(const ImplicitSurface& sheet, std::size_t perSide, std::size_t interior,
                      std::uint64_t seed);

/// Surfaces to sample. Tori have a tube of radius 0.4 around a circle of radius 1.
ImplicitSurface unitSphere();
ImplicitSurface torus();
ImplicitSurface linkedTori();
ImplicitSurface doubleTorus();
/// The square |x|, |y| <= 1 of the plane z = 0.
ImplicitSurface flatSheet();
/// Waves over the square |x|, |y| <= 1.
ImplicitSurface wavySheet();

}  // namespace se
