/// The points by which a mesh is judged, as they were given, with what is known of them without any
/// mesh: which of them no mesh needs, where their surface ends, how far apart they are.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "spiraling_edge/points/input_facts.h"

namespace se {

/// The given points as a judge of meshes: equal for every run of them, and for a later check.
struct MeshJudge {
    /// With positions and types of the file, or of the walls of the options, never derived rims.
    /// Normals are those of the file if they fit (normalsFit()), the flipped ones among them
    /// (sidesOf()) turned; else derived ones. Without lists. Set aside are points that a mesh need
    /// not have: not usable, noise, strays.
    PointSet points;
    InputFacts facts{};
    /// Of a point much nearer to another one than to the rest, that other one; else kNone. Of the
    /// two a mesh needs one.
    std::vector<Index> twin{};
    /// The distance to the third nearest point, scene units; where points lie in lines, at least
    /// the distance of lines; 0 for points that are not usable.
    std::vector<double> spacing{};
    /// The distance to the twelfth nearest point, or to the last of fewer; else as `spacing`.
    std::vector<double> reach{};
    /// The rims of the points (findRim()), each where the surface ends.
    std::vector<std::vector<Index>> openings{};

    /// Given normals fit and agree: nothing but the user's word turns them or derives others.
    bool areRight() const { return facts.normalsFit && facts.flippedNormals == 0; }
    /// The twin of `p`, or kNone.
    Index twinOf(Index p) const { return p < twin.size() ? twin[p] : kNone; }
};
/// True for each point where the surface ends, by the points alone: on their rims, or on walls.
std::vector<bool> endsOf(const MeshJudge& judge);
/// How the judge departs from the given normals, as a piece of a sentence: "by derived normals: the
/// given ones are 40 degrees off the surface (median)"; empty if it does not.
std::string departureText(const MeshJudge& judge);

}  // namespace se
