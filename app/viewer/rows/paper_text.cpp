#include "paper_text.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "run/strings.h"

namespace se::view {

namespace {

constexpr const char* kSeedCode[] = {
    "while a point is not DONE:",
    "  p = the first such point",
    "  q = its nearest neighbor that is not DONE",
    "  if there is none: p is DONE, look for the next",
    "  else: edge ring = p, q",
};
constexpr const char* kPivotCode[] = {
    "p = the pivot, an entry of the edge ring",
    "first = the entry before p, last = the entry after it",
    "z = direction from p to first, n = normal x z",
    "if p lies on a wall: see section 7",
};
constexpr const char* kWallCode[] = {
    "if the ring is p and one more boundary point:", "  insert a third boundary point (7.1)",
    "if the ring passes from wall to wall at p:",    "  insert a point of the wall between (7.2)",
    "if none can be inserted: pass over p",
};
constexpr const char* kSortCode[] = {
    "for each listed neighbor q of p:",
    "  if q is DONE, or is at first or last: leave it out",
    "  angle = arccos(z . v); beyond the plane of n: 360 - angle",
    "  if start < angle < end: q is a candidate",
    "sort the candidates by angle",
    "of two with the same angle keep the nearer",
};
constexpr const char* kLimitsCode[] = {
    "repeat at start, then at end:",
    "  e = the next ring point beyond it",
    "  if e is listed by p, lies between start and end,",
    "  and the ring is concave there:",
    "    move start (or end) to e",
    "drop candidates outside the new limits",
};
constexpr const char* kConvexCode[] = {
    "if the ring is convex at start (or end):",
    "  drop the ring point next to it:",
    "  the straight way to it is not the ring's",
};
constexpr const char* kReciprocalCode[] = {
    "for each candidate e that is USED:",
    "  a = angle of p as seen from e",
    "  if a is not within e's free sector: drop e",
};
constexpr const char* kHoleCode[] = {
    "if p, start and end form a hole of three:",
    "  plane through start and end, along their mean normal",
    "  drop candidates on the far side of it from p",
};
constexpr const char* kSphereCode[] = {
    "for each candidate q, with t before and s after it:",
    "  c, r = circle through p, s and t",
    "  if |q - c| < r: keep q",
    "  else if the gap from t to s exceeds 120 degrees: keep q",
    "  else: remove q",
};
constexpr const char* kTwoPointCode[] = {
    "if only first and last are left:",
    "  if their angle at p exceeds 180 degrees:",
    "    no triangle: continue at the next pivot",
    "  else: it is a hole, one triangle fills it",
};
constexpr const char* kEmitCode[] = {
    "for each two neighbors a, b in the neighbor ring:",
    "  make the triangle p, a, b",
};
constexpr const char* kRingCode[] = {
    "take p, and the points that start and end passed, off the ring",
    "insert the candidates between start and end",
    "count entries: a point without any is DONE",
    "if an inserted point was on a ring already:",
    "  on the active ring: split it in two, push one",
    "  on a stacked ring: join the two",
};
constexpr const char* kAdvanceCode[] = {
    "the next pivot is the point at end",
    "after a full circuit without a triangle:",
    "  free the ring, take the next from the stack",
    "no ring left: the component is complete",
};
// Rules beyond the paper, docs/robust.md.
constexpr const char* kGuardCode[] = {
    "lay out the fan: first, candidates, last",
    "test the fan by each rule that is on",
    "  a rule that delays fans objects: refuse the fan",
    "  else drop the candidate at fault, repeat 6.3",
    "  no candidate is at fault: refuse the fan",
};
constexpr const char* kFillCode[] = {
    "instead of freeing a ring with interior points:",
    "  if it is long, wide or an opening: free it",
    "  of all ears without a fault take the one",
    "  with the best least angle: one triangle",
    "  no such ear: the best with a fault, if it must close",
};
constexpr const char* kReinsertCode[] = {
    "for each point x that no triangle uses:",
    "  try, with the triangles about its neighbors:",
    "    split one, split an edge, join the border",
    "  no fault, best least angle: put x in",
};
constexpr const char* kFlipCode[] = {
    "for each edge u v between triangles u v x, v u y:",
    "  count the faults of both, and across their rim",
    "  fewer with x y, or where it is flat",
    "  a larger least angle: flip u v to x y",
};
constexpr const char* kRemoveFoldedCode[] = {
    "for each corner x of a flipped triangle:",
    "  close the hole that its triangles would leave",
    "  if that works without a fault: take x out",
    "  reinsert may put it back",
};

constexpr PaperRule kSeed{Stage::Seed, "Finding a start",
                          "A component starts as a ring of two: the first point that is not done, "
                          "and its nearest neighbor.",
                          kSeedCode};
constexpr PaperRule kPivot{Stage::Pivot, "The pivot",
                           "The ring is walked from point to point. Around each, the sector still "
                           "free lies between the ring point before it and the one after it.",
                           kPivotCode};
constexpr PaperRule kWalls{Stage::Insert, "Boundary points",
                           "Where the surface meets a wall of the box it ends. A boundary point is "
                           "a pivot only where the ring crosses from wall to wall, or where two of "
                           "them begin a component.",
                           kWallCode};
constexpr PaperRule kSort{Stage::Sort, "Neighbors by angle",
                          "The free neighbors of the pivot are put in order counterclockwise about "
                          "its normal, from first to last.",
                          kSortCode};
constexpr PaperRule kLimits{Stage::Limits, "Start and end move",
                            "Where the ring bends inwards at an end, its next point can be joined "
                            "to the pivot directly: the limit moves there.",
                            kLimitsCode};
constexpr PaperRule kConvex{Stage::Convex, "Convexity",
                            "Beyond a convex end the next ring point would be reached across the "
                            "finished mesh.",
                            kConvexCode};
constexpr PaperRule kReciprocal{Stage::Reciprocal, "Reciprocity",
                                "A ring point may be a neighbor of the pivot only if the pivot may "
                                "be one of its own.",
                                kReciprocalCode};
constexpr PaperRule kHolesOfThree{
    Stage::Hole, "Holes of three",
    "The last triangle of a hole must not reach for points beyond it.", kHoleCode};
constexpr PaperRule kSphere{
    Stage::Sphere, "The circumsphere",
    "A candidate stays if it lies inside the sphere through the pivot and "
    "the two beside it, centered in their plane, or if more than 120\xC2\xB0 "
    "would lie between those two without it.",
    kSphereCode};
constexpr PaperRule kTwoPoint{
    Stage::TwoPoint, "Two points left",
    "With no candidate left, the pivot and its two ring neighbors are "
    "either the last triangle of a hole or, beyond 180\xC2\xB0, a triangle "
    "over finished ones.",
    kTwoPointCode};
constexpr PaperRule kEmit{Stage::Emit, "Triangles",
                          "Neighboring spokes of the pivot make triangles, all turning the same "
                          "way about the normal.",
                          kEmitCode};
constexpr PaperRule kRing{Stage::Ring, "The edge ring",
                          "The ring now runs outside of the new fan. Where it meets itself it "
                          "splits, where it meets another ring the two join.",
                          kRingCode};
constexpr PaperRule kAdvance{
    Stage::Advance, "The next pivot",
    "The spiral continues at the end of the fan, until no pivot of the ring "
    "makes a triangle.",
    kAdvanceCode};
constexpr PaperRule kGuard{Stage::Guard, "Beyond the paper: guard",
                           "The whole fan is tested before it is made. A rule may refuse a "
                           "triangle that crosses, folds over or tangles the mesh.",
                           kGuardCode};
constexpr PaperRule kFill{Stage::Fill, "Beyond the paper: fill",
                          "A ring that cannot grow any further, with interior points on it, is a "
                          "hole: it is closed by ears, one pivot each.",
                          kFillCode};
constexpr PaperRule kReinsert{Stage::Reinsert, "Beyond the paper: reinsert",
                              "After the last pivot a point that was left out goes into the "
                              "triangle or the edge it lies over, or beside the border.",
                              kReinsertCode};
constexpr PaperRule kFlip{Stage::Flip, "Beyond the paper: flip",
                          "After the last pivot an edge is flipped in the quadrilateral "
                          "of its two triangles, where that is better.",
                          kFlipCode};
constexpr PaperRule kRemoveFolded{
    Stage::RemoveFolded, "Beyond the paper: reseat",
    "After the last pivot a point at a flipped triangle is removed, so "
    "that it can be put in at a better position.",
    kRemoveFoldedCode};

/// One line per kind of evidence.
struct LineOfPaper {
    Stage stage;
    std::size_t operator()(const SeedEvidence&) const { return 4; }
    std::size_t operator()(const StrandEvidence&) const { return 3; }
    std::size_t operator()(const PivotEvidence&) const { return 1; }
    std::size_t operator()(const SkipEvidence&) const { return 4; }
    std::size_t operator()(const InsertEvidence& e) const {
        if (e.verdict == Verdict::NoThirdPoint || e.verdict == Verdict::OtherSideOpen) return 4;
        return e.corner ? 3 : 1;
    }
    std::size_t operator()(const SortEvidence& e) const {
        if (e.verdict == Verdict::SameAngle) return 5;
        return e.verdict == Verdict::AlreadyDone || e.verdict == Verdict::OnRingEnd ? 1 : 3;
    }
    std::size_t operator()(const LimitEvidence& e) const {
        if (e.moves()) return 4;
        return e.verdict == Verdict::NotConcave || e.verdict == Verdict::Blocked ? 3 : 2;
    }
    std::size_t operator()(const DropEvidence&) const { return stage == Stage::Convex ? 1 : 5; }
    std::size_t operator()(const ReciprocalEvidence&) const { return 2; }
    std::size_t operator()(const HoleEvidence&) const { return 2; }
    std::size_t operator()(const SphereEvidence& e) const {
        if (e.verdict == Verdict::InsideSphere) return 2;
        return e.verdict == Verdict::Removed ? 4 : 3;
    }
    std::size_t operator()(const TwoPointEvidence& e) const {
        return e.verdict == Verdict::Discarded ? 2 : 3;
    }
    std::size_t operator()(const EmitEvidence&) const { return 1; }
    std::size_t operator()(const RingEvidence& e) const { return e.inserted ? 1 : 0; }
    std::size_t operator()(const CloseEvidence&) const { return 2; }
    std::size_t operator()(const SplitEvidence&) const { return 4; }
    std::size_t operator()(const JoinEvidence& e) const { return e.depthFromTop == kNone ? 4 : 5; }
    std::size_t operator()(const AdvanceEvidence& e) const { return e.popped ? 2 : 0; }
    std::size_t operator()(const GuardEvidence& e) const {
        if (e.dropped != kNone) return 3;
        const bool waits = e.verdict == Verdict::WideGap || e.verdict == Verdict::OverRim ||
                           e.verdict == Verdict::Steep;
        return waits ? 2 : 4;
    }
    std::size_t operator()(const FillEvidence& e) const { return e.forced ? 4 : 3; }
    std::size_t operator()(const ReinsertEvidence&) const { return 3; }
    std::size_t operator()(const FlipEvidence&) const { return 3; }
    std::size_t operator()(const RemoveFoldedEvidence&) const { return 2; }
    std::size_t operator()(const FreeEvidence&) const { return 2; }
    std::size_t operator()(const ComponentEvidence&) const { return 3; }
    template <typename Other>
    std::size_t operator()(const Other&) const {
        return 0;
    }
};

/// The numbers of one kind of evidence.
struct Numbers {
    std::string operator()(const SeedEvidence& e) const {
        return formatted("distance %.4g", e.distance);
    }
    std::string operator()(const PivotEvidence& e) const {
        return formatted("free: %.1f\xC2\xB0", e.sectorDegrees);
    }
    std::string operator()(const SortEvidence& e) const {
        return formatted("angle %.1f\xC2\xB0, end %.1f\xC2\xB0", e.degrees, e.endDegrees);
    }
    std::string operator()(const LimitEvidence& e) const {
        return formatted("turn %+.3g (concave if > 0)", e.turn);
    }
    std::string operator()(const ReciprocalEvidence& e) const {
        return formatted("a = %.1f\xC2\xB0, free to %.1f\xC2\xB0", e.degrees, e.limitDegrees);
    }
    std::string operator()(const HoleEvidence& e) const {
        return formatted("side %+.3g, that of p %+.3g", e.side, e.pivotSide);
    }
    std::string operator()(const SphereEvidence& e) const {
        if (e.verdict == Verdict::NoCircle)
            return formatted("in line; gap %.1f\xC2\xB0", e.gapDegrees);
        return formatted("|q - c| = %.4g, r = %.4g, gap %.1f\xC2\xB0", e.distance, e.radius,
                         e.gapDegrees);
    }
    std::string operator()(const TwoPointEvidence& e) const {
        return formatted("angle %.1f\xC2\xB0", e.degrees);
    }
    std::string operator()(const FillEvidence& e) const {
        return formatted("least angle %.1f\xC2\xB0", e.leastDegrees);
    }
    template <typename Other>
    std::string operator()(const Other&) const {
        return {};
    }
};

}  // namespace

const PaperRule& paperRule(Stage stage) {
    switch (stage) {
        case Stage::Seed:
        case Stage::Strand:
            return kSeed;
        case Stage::Pivot:
            return kPivot;
        case Stage::Skip:
        case Stage::Insert:
            return kWalls;
        case Stage::Sort:
            return kSort;
        case Stage::Limits:
            return kLimits;
        case Stage::Convex:
            return kConvex;
        case Stage::Reciprocal:
            return kReciprocal;
        case Stage::Hole:
            return kHolesOfThree;
        case Stage::Sphere:
            return kSphere;
        case Stage::TwoPoint:
            return kTwoPoint;
        case Stage::Emit:
            return kEmit;
        case Stage::Ring:
        case Stage::Split:
        case Stage::Join:
            return kRing;
        case Stage::Advance:
        case Stage::Done:
            return kAdvance;
        case Stage::Guard:
            return kGuard;
        case Stage::Fill:
            return kFill;
        case Stage::Reinsert:
            return kReinsert;
        case Stage::Flip:
            return kFlip;
        case Stage::RemoveFolded:
            return kRemoveFolded;
    }
    return kSeed;
}

std::size_t presentLine(const Event& event) {
    return std::visit(LineOfPaper{event.address.stage}, event.evidence);
}

std::string liveNumbers(const Event& event) { return std::visit(Numbers{}, event.evidence); }

}  // namespace se::view
