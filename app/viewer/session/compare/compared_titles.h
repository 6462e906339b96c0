/// Titles of two views that are compared.
#pragma once

#include <array>
#include <string>

#include "comparison.h"
#include "scene/palette.h"

namespace se::view {

struct ComparedTitle {
    std::string letter;     ///< "A" or "B".
    std::string name;       ///< "paper rules", and what B has instead.
    std::string note;       ///< "212.sphere.3   12 only here"; empty: not known yet.
    Color Palette::*color;  ///< Of the triangles that are only in this one.

    /// "A, paper rules"
    std::string text() const { return letter + ", " + name; }
};

/// Titles of the open run and of what it is compared with; `now`: null if nothing can be.
std::array<ComparedTitle, 2> comparedTitles(const Session& run, const Comparison* now);

}  // namespace se::view
