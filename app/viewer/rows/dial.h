/// The pivot's tangent plane as a disc: where every neighbor stands by angle, distance and height.
/// Plain values, no ImGui: the panel draws it, tests read it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/model.h"
#include "run/picture.h"

namespace se::view {

enum class DialRole : std::uint8_t {
    Neighbor,  ///< In the list, not looked at yet.
    Done,      ///< In the list, DONE.
    Candidate,
    Rejected,
    First,
    Last,
    Start,
    End,
};

/// One neighbor on the disc.
struct DialTick {
    Index point = kNone;
    double degrees = 0.0;  ///< Angle of §6.1, from first, counterclockwise about the normal.
    float reach = 0.0F;    ///< Distance in the plane, 1 for the farthest neighbor.
    float height = 0.0F;   ///< Above the plane, in the same unit.
    DialRole role = DialRole::Neighbor;
    bool underTest = false;
    std::string
        letter;        ///< What the paper calls it: "S", "E", "first", "last", "t", "q", "s", "e".
    std::string note;  ///< Why it was rejected; empty if it was not.
    int rank = 0;      ///< Among the candidates that are kept, from start, counted from 1.
    bool passed = false;  ///< It was tested by §6.3 and stayed.
};

/// A part of the turn, with what it means.
struct DialArc {
    enum class Kind : std::uint8_t {
        Range,     ///< From start to end: where candidates may be.
        OldRange,  ///< From first to last, where it differs.
        Gap,       ///< §6.3: from t to s, without q.
        TooWide,   ///< The same over 120 degrees; or §6.4: over 180.
        Triangle,  ///< A triangle of this pivot.
        Angle,     ///< §6.1: from z to what is tested.
    } kind = Kind::Range;
    double from = 0.0;  ///< Degrees.
    double to = 0.0;
};

/// §6.1, Fig. 6: the second disc, of a USED candidate e.
struct DialReciprocal {
    Index e = kNone;
    double pivotDegrees = 0.0;  ///< Where p stands at e.
    double limitDegrees = 0.0;  ///< The free sector of e runs from 0 to here.
    bool inside = false;
};

/// §6.2: the chord from start to end; what lies beyond it is the far side.
struct DialChord {
    double from = 0.0;
    double to = 0.0;
};

/// A place on the rim that an angle is compared with.
struct DialMark {
    double degrees = 0.0;
    std::string text;
};

/// §7: a place on the ring before or after the pivot, for a third point.
struct DialSlot {
    double degrees = 0.0;
    std::string text;
    bool filled = false;
};

struct Dial {
    Index pivot = kNone;
    std::vector<DialMark> marks;
    std::vector<DialSlot> slots;
    std::vector<DialTick> ticks;
    std::vector<DialArc> arcs;
    std::optional<DialReciprocal> reciprocal;
    std::optional<DialChord> chord;
    std::string caption;  ///< What the stage at the cursor compares, in a few words.
    bool empty() const { return pivot == kNone; }
};

/// The disc at the event `event` (null: none), which the picture shows. Empty without a pivot.
Dial makeDial(const Model& model, const Picture& picture, const Event* event);

}  // namespace se::view
