// The failure gallery: the table of scenes that fail. tests/core/scenarios/gallery_test.cpp checks
// each failure and its decision.
#include <array>

#include "spiraling_edge/scenes/failure_scenes.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se {
namespace {

constexpr std::array kGallery{
    FailureScene{{"four-edge-hole", "A hole of four with a point behind it",
                  "At pivot 81 the ring is a hole of four. Point 50, on the other side of what is "
                  "finished, is its only candidate, and both triangles lie over finished ones.",
                  fourEdgeHole},
                 "intersecting_triangles",
                 "81.sphere.1",
                 "6.2",
                 "Note that the algorithm will not recognize a hole formed by more than three "
                 "points.",
                 "Shorter neighbor lists, or --rules corrected."},
    FailureScene{
        {"sparse-spot", "A sparse spot beyond the search range",
         "Where every second point is missing, the next point is farther than the radius "
         "of the lists: two points find only each other, over 180 degrees apart.",
         sparseSpot},
        "unused_points",
        "258.twopoint.1",
        "6.4",
        "This situation can arise when the neighboring points lie just outside the search "
        "range for p.",
        "A larger radius, or lists of the k nearest; --rules robust puts the points back."},
    FailureScene{
        {"close-sheets", "Two close sheets",
         "Lists reach from sheet to sheet: from pivot 31 on the ring runs over both, and at "
         "pivot 86 the step from one to the other is taken for a corner of the box.",
         closeSheets},
        "intersecting_triangles",
        "86.insert.1",
        "3",
        "The algorithm also assumes that there is only one point at any particular "
        "location.",
        "A spacing below the gap. Sheets whose normals oppose are kept apart by themselves."},
    FailureScene{{"sharp-crease", "A sharp crease",
                  "The first pivot's neighbors lie on both sides of a crease of 40 degrees; seen "
                  "along its normal they are no ring around it.",
                  sharpCrease},
                 "flipped_triangles",
                 "1.emit.2",
                 "3",
                 "We work locally to create a nearly planar triangulation between a point and its "
                 "nearest neighbors.",
                 "Points much closer than the crease is sharp, or --rules robust."},
    FailureScene{
        {"uneven-density", "Uneven density",
         "On the dense side of the step no point of the sparse side is listed: at pivot "
         "342 end moves over three points of the ring at once.",
         unevenDensity},
        "non_manifold_edges",
        "342.limits.2",
        "6.4",
        "The occurrence of this configuration indicates that p is insufficiently linked to "
        "its neighbors.",
        "--symmetric lists, or --rules robust."},
    FailureScene{
        {"noise", "Noise along the normal",
         "Heights vary as much as the spacing. What is left over at the end begins "
         "components of its own: pivot 283 makes two triangles on the same three points.",
         noiseAlongNormal},
        "duplicate_triangles",
        "283.emit.2",
        "4",
        "These points represent such a tiny surface area that only a single point will fit "
        "in that space.",
        "Smooth the points first; --rules robust makes no such pair."},
    FailureScene{{"wrong-lists", "Wrong neighbor lists",
                  "Every fortieth point lists points of the other side of the sphere: pivot 245 "
                  "takes one of them, and two rings that have nothing to do with each other join.",
                  wrongLists},
                 "intersecting_triangles",
                 "245.reciprocal.2",
                 "3",
                 "A list of each point's neighbors.",
                 "New lists: --neighbors 12."},
    FailureScene{
        {"flipped-patch", "A patch of flipped normals",
         "The normals of the cap point inwards. Pivot 5 is a point of it: counterclockwise "
         "about its normal is the other way round than everywhere else.",
         flippedPatch},
        "flipped_triangles",
        "5.emit.2",
        "3",
        "The edge ring traversal proceeds in counterclockwise order around the normal of "
        "the first point, thus providing an orientation for the triangulation that is "
        "consistent across the surface.",
        "--orient turns the normals to agree."},
    FailureScene{{"near-duplicates", "Points given twice",
                  "Every fifteenth point has a copy nearly at its place: the two compete for the "
                  "same edges, and one of them is stranded.",
                  nearDuplicates},
                 "unused_points",
                 "228.strand.1",
                 "3",
                 "The algorithm also assumes that there is only one point at any particular "
                 "location.",
                 "spiraling-edge doctor IN --fix OUT.ply --drop near_duplicates."},
    FailureScene{
        {"stranded-point", "Stranded points",
         "Three points are passed by at every pivot around them, and their neighbors are "
         "DONE before one of them begins.",
         strandedPoint},
        "unused_points",
        "98.strand.1",
        "4",
        "In the second case, the algorithm has rejected the point in the triangulations of "
        "all its neighbors and it has been left stranded.",
        "--rule unblocked=on, or --rules corrected."},
    FailureScene{{"tee-at-wall", "A T where a sheet meets a wall",
                  "One sheet stands on another. Where they meet, three sheets share a line: at "
                  "pivot 149 end moves across it, over a sheet that is finished.",
                  teeAtWall},
                 "intersecting_triangles",
                 "149.limits.2",
                 "3",
                 "The algorithm assumes that except at points with boundary type designations the "
                 "surface is closed and there are no non-manifold structures.",
                 "Give the sheets one by one."},
};

}  // namespace

std::span<const FailureScene> failureScenes() { return kGallery; }

}  // namespace se
