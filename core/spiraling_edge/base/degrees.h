/// Conversion between angles in degrees and the cosines that decide.
#pragma once

#include <array>
#include <cmath>

namespace se {

/// The cosine of an angle from 0 to 180 degrees by + - * / alone, so that it is the same on every
/// machine; correctly rounded where rules have their default values.
inline double cosineOfDegrees(double degrees) {
    struct Known {
        double degrees, cosine;
    };
    constexpr std::array kKnown{
        Known{0.0, 1.0},    Known{45.0, 0.70710678118654752},  Known{60.0, 0.5},   Known{90.0, 0.0},
        Known{120.0, -0.5}, Known{150.0, -0.8660254037844386}, Known{180.0, -1.0},
    };
    for (const Known& each : kKnown) {
        if (each.degrees == degrees) return each.cosine;
    }
    constexpr double kPi = 3.14159265358979323846;
    // About 90 degrees: cos(90 + x) = -sin(x), |x| <= pi / 2, where the series is short.
    const double x = (degrees - 90.0) * kPi / 180.0;
    double term = x;
    double sine = x;
    for (int n = 1; n <= 12; ++n) {
        term *= -x * x / (2.0 * n * (2.0 * n + 1.0));
        sine += term;
    }
    return -sine;
}

/// The inverse of cosineOfDegrees(), rounded to nine digits after the point for display.
inline double degreesOfCosine(double cosine) {
    constexpr double kPi = 3.14159265358979323846;
    constexpr double kDigits = 1e9;
    return std::round(std::acos(cosine) * 180.0 / kPi * kDigits) / kDigits;
}

}  // namespace se
