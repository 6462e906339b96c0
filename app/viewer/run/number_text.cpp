#include "number_text.h"

#include <cstdio>

namespace se::view {

namespace {

std::string withoutMinusZero(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    std::string result(text);
    // A sign before nothing but zeros says something that is not so.
    const bool zero = result.find_first_of("123456789in") == std::string::npos;
    if (zero && (result[0] == '-' || result[0] == '+')) result.erase(0, 1);
    return result;
}

}  // namespace

std::string numberText(double value) { return withoutMinusZero("%.4g", value); }

std::string signedText(double value) { return withoutMinusZero("%+.4g", value); }

std::string degreesText(double degrees) { return withoutMinusZero("%.1f", degrees) + "\xC2\xB0"; }

std::string numbersText(const Vec3& values) {
    return numberText(values.x) + ", " + numberText(values.y) + ", " + numberText(values.z);
}

std::string percentText(double share) { return withoutMinusZero("%+.1f", 100.0 * share) + " %"; }

std::string durationText(double seconds) {
    return seconds < 1.0 ? withoutMinusZero(seconds < 0.1 ? "%.2g" : "%.0f", 1e3 * seconds) + " ms"
                         : withoutMinusZero("%.3g", seconds) + " s";
}

}  // namespace se::view
