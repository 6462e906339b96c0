#include "paper_words.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace se::view {

namespace {

constexpr std::array kWords = {
    PaperWord{"edge ring|rings|ring", "4",
              "The ring of points along the edge of the triangulated patch, linked both ways; one "
              "after the other becomes the pivot."},
    PaperWord{
        "ring that waits|ring stack|stack depth", "6.5",
        "An edge ring that was split off and waits on a stack; when a point is met again, the "
        "most recent one is searched first."},
    PaperWord{"neighbor ring|candidate", "6.1",
              "The neighbors of the pivot sorted by angle about it from start to end; those that "
              "pass all tests get triangles."},
    PaperWord{"pivot", "6", "The center point, which is being surrounded by triangles."},
    PaperWord{"first", "6",
              "The point that precedes the pivot on the edge ring; angles are measured from it."},
    PaperWord{"last", "6",
              "The point that succeeds the pivot on the edge ring; its angle is the largest "
              "allowed."},
    PaperWord{"first, last", "6",
              "The points that precede and succeed the pivot on the edge ring."},
    PaperWord{"start", "6.1",
              "The point at the smallest angle of the neighbor ring: at first it is the point "
              "called first, and it advances along the edge ring where that is concave."},
    PaperWord{
        "end", "6.1",
        "The point at the largest angle of the neighbor ring: at first it is the point called "
        "last, and it moves back along the edge ring where that is concave."},
    PaperWord{"free sector|limits", "6.1",
              "The angles about the pivot from start to end: beyond them a triangle would overlap "
              "finished ones."},
    PaperWord{"dial|angle|sort", "6.1",
              "Neighbors are sorted by angle about the normal of the pivot, counterclockwise from "
              "first."},
    PaperWord{"convex", "6.1",
              "Where the edge ring is convex at start or end, the next point on it is removed from "
              "the neighbor ring."},
    PaperWord{"reciprocal", "6.1",
              "A USED point joins the neighbor ring only if the pivot could be in that point's own "
              "neighbor ring."},
    PaperWord{"hole", "6.2",
              "A gap between the pivot, first and last: neighbors on its far side are removed."},
    PaperWord{"circumsphere|sphere", "6.3",
              "The sphere whose equator passes through the pivot and the two points beside the one "
              "under test, which is kept if it lies inside."},
    PaperWord{"gap", "6.3",
              "The angle that removing a point would leave: over 120 degrees it is kept."},
    PaperWord{
        "twopoint", "6.4",
        "A neighbor ring of two points closes a hole if they are less than 180 degrees apart, "
        "and is discarded otherwise."},
    PaperWord{"new triangle|emit", "6.4",
              "Each two adjacent points of the neighbor ring form a triangle with the pivot, which "
              "is never removed again."},
    PaperWord{"winding", "6.4",
              "The order of a triangle's corners, counterclockwise about the surface normal."},
    PaperWord{"split", "6.5",
              "A point that is met again in the active edge ring divides it in two, and one of the "
              "rings is pushed onto a stack."},
    PaperWord{"join", "6.5",
              "A point that is met again in a stacked edge ring makes one ring of both, with that "
              "point in it twice."},
    PaperWord{"advance|next pivot", "6.5",
              "Once the edge ring is updated, the point that was end becomes the pivot."},
    PaperWord{"UNUSED", "4", "The status of every point before it is used in a triangulation."},
    PaperWord{"USED|kept, USED", "4",
              "The status of a point on the edge ring, which also counts how often it is there."},
    PaperWord{
        "DONE", "4",
        "The status of a point that left the edge ring, entirely surrounded by triangles, and "
        "of one without any neighbor to go on with."},
    PaperWord{"seed", "4",
              "A new edge ring of two: a point that is not DONE, and its nearest neighbor that is "
              "not DONE."},
    PaperWord{"component|components", "3",
              "A disconnected part of the surface, finished each time that the edge ring becomes "
              "empty."},
    PaperWord{"manifold", "3",
              "A surface in which every edge has at most two triangles; the algorithm assumes that "
              "there are no non-manifold structures."},
    PaperWord{"wall|on walls|skip", "7",
              "The surface ends at boundary points, which are a pivot in a few exceptions only."},
};

bool same(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

/// True if `word` is one of those between the bars.
bool isNamed(const PaperWord& row, std::string_view word) {
    for (std::string_view rest = row.words; !rest.empty();) {
        const std::size_t bar = std::min(rest.find('|'), rest.size());
        if (same(rest.substr(0, bar), word)) return true;
        rest.remove_prefix(std::min(bar + 1, rest.size()));
    }
    return false;
}

}  // namespace

std::span<const PaperWord> paperWords() { return kWords; }

std::string definitionOf(std::string_view word) {
    const auto found = std::find_if(kWords.begin(), kWords.end(),
                                    [&](const PaperWord& row) { return isNamed(row, word); });
    if (found == kWords.end()) return {};
    const std::string_view name = found->words.substr(0, found->words.find('|'));
    return std::string(name)
        .append(" (paper, ")
        .append(found->section)
        .append("): ")
        .append(found->sentence);
}

}  // namespace se::view
