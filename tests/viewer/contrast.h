/// Contrast of two colors.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/palette.h"

namespace se::view::test {

inline double linear(float component) {
    const double c = component;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

inline double luminance(const Color& c) {
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

/// Contrast ratio by WCAG 2, from 1 to 21.
inline double contrast(const Color& a, const Color& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace se::view::test
