/// The record of an input: numbers of its points, found once, before any run of them.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Numbers of the points of a file, by themselves. Lengths in the unit of the file.
struct InputFacts {
    std::size_t points = 0;  ///< In the file.
    /// By the reason for which `robust` would set points aside; Aside::No: the others.
    std::array<std::size_t, kAsides> aside{};
    std::size_t twins = 0;  ///< Points that are much nearer to another one than to the rest.

    std::size_t measured = 0;    ///< Points that are finite, no copies, no sentinels, no strays:
    Vec3 low{0.0}, high{0.0};    ///< The box around them.
    double nearestLeast = 0.0;   ///< Distance of a point to its nearest but its twin: the least,
    double nearestMean = 0.0;    ///< the mean, of which WithinSpacings counts multiples,
    double nearestMedian = 0.0;  ///< the median,
    double nearestMost = 0.0;    ///< the greatest; all 0 without two points.
    double along = 0.0;          ///< Distance of points within lines, and
    double across = 0.0;         ///< of lines; both 0 where points do not lie in lines.

    bool hasNormals = false;           ///< Given ones, most of them with a direction.
    std::size_t completedNormals = 0;  ///< Of these without a direction: derived.
    std::size_t unscaledNormals = 0;   ///< Of these not of unit length, by more than 1e-3.
    std::size_t averagedNormals = 0;   ///< Places with several, of which the mean is used.
    bool normalsFit = false;           ///< The given normals fit: normalsFit().
    double normalDegrees = 0.0;        ///< Median angle of given normals to the planes of points.
    std::size_t measuredNormals = 0;   ///< Places where that was measured, and of these
    std::size_t nearNormals = 0;       ///< those within 30 degrees.
    std::size_t flippedNormals = 0;    ///< Of fitting ones, against those about them.
    std::size_t sideParts = 0;         ///< Without given normals: parts oriented by themselves,
    std::size_t unknownSides = 0;      ///< and those of which the outer side is not known.

    std::size_t pieces = 0;    ///< Connected by mutual neighbors within two spacings; 0: unknown.
    std::size_t openings = 0;  ///< Rims, each where the surface ends.

    /// The points that every run sets aside, and those that `robust` sets aside besides, by reason.
    std::array<std::size_t, kAsides> asideAlways() const;
    std::array<std::size_t, kAsides> asideByRobust() const;
    std::size_t count(Aside reason) const { return aside[static_cast<std::size_t>(reason)]; }
    Vec3 extent() const { return high - low; }
};

/// "0.14 between points", or where they lie in lines "0.02 along lines, 0.2 across"; empty without
/// two points.
std::string spacingText(const InputFacts& facts);
/// "2 pieces, 1 opening"; empty where neither is known.
std::string piecesText(const InputFacts& facts);
/// "0.14 between points, 2 x 1.99 x 2": that, and the extent; empty without two points.
std::string sizeText(const InputFacts& facts);

}  // namespace se
