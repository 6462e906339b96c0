/// The pivot's tangent plane as a disc: every neighbor by angle, distance and height. Plain values,
/// no ImGui: the panel draws it, tests read it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/palette.h"
#include "spiraling_edge/points/point_name.h"
#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/stepper/params.h"

namespace se::view {

enum class DialRole : std::uint8_t {
    Neighbor,  ///< In the list, not examined yet.
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
    std::string sign;     ///< Before its name: "+" joins the ring, "\xE2\x88\x92" leaves it.
    bool named = false;   ///< A limit, or a point that the decision names.
    std::string note;     ///< Reason of the rejection; empty if it was not rejected.
    int rank = 0;         ///< Rank among the candidates that are kept, from start, counted from 1.
    bool passed = false;  ///< Passed the test of §6.3.
};

/// "20", or with a sign "+ 20".
inline std::string labelOf(const DialTick& tick, std::span<const PointName> names) {
    return (tick.sign.empty() ? "" : tick.sign + " ") + nameOf(tick.point, names);
}

/// A part of the full turn, with its meaning.
struct DialArc {
    enum class Kind : std::uint8_t {
        Range,     ///< From start to end: where candidates may be.
        OldRange,  ///< From first to last, where it differs.
        Gap,       ///< §6.3: from t to s, without q.
        TooWide,   ///< §6.3: from t to s, over 120 degrees; or §6.4: refused.
        Triangle,  ///< A triangle of this pivot.
        Angle,     ///< §6.1: from z to the tested angle.
    } kind = Kind::Range;
    double from = 0.0;  ///< Degrees.
    double to = 0.0;
};

/// §6.1, Fig. 6: the second disc, of a USED candidate e.
struct DialReciprocal {
    Index e = kNone;
    Index first = kNone;        ///< After e on the ring: efirst.
    Index last = kNone;         ///< Before e on the ring: elast.
    double pivotDegrees = 0.0;  ///< Angle of p at e.
    double limitDegrees = 0.0;  ///< The sector of e runs from 0 to here.
    bool kept = false;          ///< The candidate is kept.
    /// The sector runs from efirst, after e on the ring, to elast, before it; else from elast to
    /// efirst.
    bool printed = false;

    double firstDegrees() const { return printed ? 0.0 : limitDegrees; }
    double lastDegrees() const { return printed ? limitDegrees : 0.0; }
};

/// §6.2: the chord from start to end; the far side lies beyond it.
struct DialChord {
    double from = 0.0;
    double to = 0.0;
};

/// An angle on the rim that another one is compared with.
struct DialMark {
    double degrees = 0.0;
    std::string text;
};

/// §7: a neighbor of the pivot on the ring, tried as the third point.
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
    std::string caption;  ///< The comparison of the stage at the cursor, in a few words.
    bool empty() const { return pivot == kNone; }
};

/// The disc at the event of the picture, if it has one. Empty without a pivot.
Dial makeDial(const PointSet& points, const Params& params, const DecisionState& picture);

// Looks of the neighbors of a pivot, on the dial and in the section.

/// Look of a neighbor on the disc.
struct DialTickLook {
    Shape shape;
    Color Palette::*color;
};

inline const DialTickLook& lookOf(DialRole role) {
    static constexpr std::array<DialTickLook, 8> kLooks = {{
        {Shape::Circle, &Palette::unused},
        {Shape::Dot, &Palette::done},
        {Shape::Disc, &Palette::used},
        {Shape::Cross, &Palette::rejected},
        {Shape::Forward, &Palette::first},
        {Shape::Back, &Palette::last},
        {Shape::Forward, &Palette::first},
        {Shape::Back, &Palette::last},
    }};
    static_assert(static_cast<std::size_t>(DialRole::End) + 1 == kLooks.size());
    return kLooks[static_cast<std::size_t>(role)];
}

/// Color of a neighbor.
inline Color Palette::*colorOf(DialRole role, bool underTest) {
    return role == DialRole::Candidate && underTest ? &Palette::test : lookOf(role).color;
}

}  // namespace se::view
