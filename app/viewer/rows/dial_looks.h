/// Looks of the neighbors of a pivot, on the dial and in the section.
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
