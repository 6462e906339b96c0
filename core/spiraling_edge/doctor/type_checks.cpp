#include <algorithm>
#include <array>
#include <cmath>

#include "spiraling_edge/doctor/checks.h"

namespace se {

std::optional<Finding> findCornerBits(const ExaminedFile& examined) {
    std::vector<Index> points;
    for (Index p = 0; p < examined.file.type.size(); ++p) {
        if (withCornerBit(examined.file.type[p]) != examined.file.type[p]) points.push_back(p);
    }
    const std::string text = countText(points.size(), "point") +
                             " whose corner bit disagrees with the walls, or with a rim bit "
                             "beside those of walls";
    return findingAt(std::move(points), Severity::Warning, text);
}

namespace {

struct Face {
    std::uint8_t bit;
    Vec3::length_type axis;
    double sign;  ///< +1: the upper face of that axis.
};
constexpr std::array kFacesOfBox{Face{kPositiveX, 0, 1.0},  Face{kPositiveY, 1, 1.0},
                                 Face{kPositiveZ, 2, 1.0},  Face{kNegativeX, 0, -1.0},
                                 Face{kNegativeY, 1, -1.0}, Face{kNegativeZ, 2, -1.0}};

/// Coordinate of a face: the median of its points, the outer one of two. -infinity without any.
double levelOf(const ExaminedFile& examined, const Face& face) {
    std::vector<double> levels;
    for (Index p = 0; p < examined.size(); ++p) {
        if ((examined.file.type[p] & face.bit) != 0 && isFinite(examined.file.position[p]))
            levels.push_back(face.sign * examined.file.position[p][face.axis]);
    }
    if (levels.empty()) return -std::numeric_limits<double>::infinity();
    const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
    std::nth_element(levels.begin(), middle, levels.end());
    return *middle;
}

/// True if the surface runs along the wall at p: then it only touches it, and is not cut there.
bool touches(const ExaminedFile& examined, const Face& face, Index p) {
    constexpr double kAlong = 0.96592582628906829;  // within 15 degrees
    return examined.file.hasNormals() && std::abs(examined.normal[p][face.axis]) > kAlong;
}

}  // namespace

std::optional<Finding> findTypesOffBox(const ExaminedFile& examined) {
    const PointFile& file = examined.file;
    if (!file.hasTypes()) return std::nullopt;
    const WallBox box = boxAround(file.position);
    const Vec3 sides = box.high - box.low;
    const double reach = box.tolerance * std::max({sides.x, sides.y, sides.z});
    std::vector<bool> off(examined.size(), false);
    for (const Face& face : kFacesOfBox) {
        const double level = levelOf(examined, face);
        if (std::isinf(level)) continue;
        for (Index p = 0; p < examined.size(); ++p) {
            if (!isFinite(file.position[p])) continue;
            const double beyond = face.sign * file.position[p][face.axis] - level;
            const bool on = beyond >= -reach;
            const bool marked = (file.type[p] & face.bit) != 0;
            if (beyond > reach || (marked && !on) || (!marked && on && !touches(examined, face, p)))
                off[p] = true;
        }
    }
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        if (off[p]) points.push_back(p);
    }
    const std::string text = countText(points.size(), "point") +
                             " marked as on a wall but off it, or on or beyond a wall but not "
                             "marked";
    return findingAt(std::move(points), Severity::Warning, text);
}

}  // namespace se
