// Colors of points in OBJ, OFF and GLB. These formats do not say which of two scales they use, or
// programs write both.
#include <algorithm>
#include <cmath>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/io/formats.h"

namespace se::io {

void PointColors::add(Fields& fields) {
    Vec3 color{0.0};
    if (!parseVector(fields, color)) return;
    add(color);
    if (!fields.next().empty()) leaveOutAlpha();
}

void PointColors::take(PointFile& file) const {
    if (colors_.empty()) return;
    if (colors_.size() != file.position.size()) {
        const bool more = colors_.size() > file.position.size();
        const std::size_t missing = file.position.size() - colors_.size();
        file.notes.push_back("left out: colors, " +
                             (more ? "more than there are points"
                                   : "without those of " + counted(missing, "point")));
        return;
    }
    if (hasAlpha_) file.notes.emplace_back("left out: transparency of colors");
    double most = 0.0;
    bool whole = true;
    bool negative = false;
    std::size_t unknown = 0;
    for (const Vec3& color : colors_) {
        if (!isFinite(color)) {
            ++unknown;
            continue;
        }
        for (int channel = 0; channel < 3; ++channel) {
            most = std::max(most, color[channel]);
            negative = negative || color[channel] < 0.0;
            whole = whole && color[channel] == std::floor(color[channel]);
        }
    }
    const bool fractions = most <= 1.0;
    if (negative || !(fractions || (whole && most <= 255.0))) {
        file.notes.push_back("left out: colors that are neither from 0 to 1 nor whole up to 255");
        return;
    }
    addColorColumns(file, [&](std::size_t p, int channel) {
        const double value = isFinite(colors_[p]) ? colors_[p][channel] : 0.0;
        return fractions ? std::round(255.0 * value) : value;
    });
    file.notes.push_back(std::string("colors ") + (fractions ? "from 0 to 1 " : "") +
                         "are kept as red, green and blue from 0 to 255");
    if (unknown > 0)
        file.notes.push_back(counted(unknown, "color") + " with a number that is none: black");
}

}  // namespace se::io
