/// Looks of what is on the dial: the same in the panel and in drawings.
#pragma once

#include <array>

#include "pivot_dial.h"
#include "scene/draw_list.h"
#include "scene/palette.h"

namespace se::view {

/// Look of a neighbor on the disc.
struct DialTickLook {
    Shape shape;
    Color Palette::*color;
};

/// Look of a part of the full turn.
struct DialArcLook {
    float reach;  ///< Radius of the sector and of the line, in radii of the disc.
    Color Palette::*color;
    float fill = 0.0F;    ///< Opacity of the sector; 0: none.
    float width = 0.0F;   ///< Of the line, in em; 0: none.
    bool dashed = false;  ///< In the panel.
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

inline const DialArcLook& lookOf(DialArc::Kind kind) {
    static constexpr std::array<DialArcLook, 6> kLooks = {{
        {1.0F, &Palette::pivot, 0.15F, 0.16F},
        {1.05F, &Palette::textDim, 0.0F, 0.1F, true},
        {0.5F, &Palette::test, 0.0F, 0.22F},
        {0.5F, &Palette::rejected, 0.0F, 0.22F, true},
        {0.9F, &Palette::test, 0.3F},
        {0.4F, &Palette::test, 0.0F, 0.16F},
    }};
    static_assert(static_cast<std::size_t>(DialArc::Kind::Angle) + 1 == kLooks.size());
    return kLooks[static_cast<std::size_t>(kind)];
}

/// True for a neighbor that is no candidate: it is drawn small, without a spoke.
inline bool isFaint(const DialTick& tick) {
    return tick.role == DialRole::Neighbor || tick.role == DialRole::Done;
}

/// Color of a neighbor.
inline Color Palette::*colorOf(const DialTick& tick) {
    const bool tested = tick.role == DialRole::Candidate && tick.underTest;
    return tested ? &Palette::test : lookOf(tick.role).color;
}

/// Width of a neighbor's mark, in em.
inline float sizeOf(const DialTick& tick) {
    if (tick.role == DialRole::Done) return 0.4F;
    return isFaint(tick) ? 0.5F : 0.72F;
}

}  // namespace se::view
