/// Checks of types: corner bits, marks against the walls of the box, and openings that no type
/// marks.
#include <algorithm>
#include <cmath>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/doctor/checks.h"

namespace se {

std::optional<Finding> findCornerBits(const ExaminedFile& examined) {
    const std::vector<std::uint8_t>& type = examined.file.type;
    auto points =
        pointsWhere(type.size(), [&](Index p) { return withCornerBit(type[p]) != type[p]; });
    return findingAt(std::move(points), Severity::Warning,
                     "whose corner bit disagrees with the walls, or with a rim bit beside those of "
                     "walls");
}

// ---- walls --------------------------------------------------------------------------------------

namespace {

/// Coordinate of a face: the median of its points, the outer one of two. -infinity without any.
double levelOf(const ExaminedFile& examined, const WallFace& face) {
    std::vector<double> levels;
    for (Index p = 0; p < examined.size(); ++p) {
        if ((examined.file.type[p] & face.bit) != 0 && isFinite(examined.file.position[p]))
            levels.push_back(face.sign * examined.file.position[p][face.axis]);
    }
    if (levels.empty()) return -std::numeric_limits<double>::infinity();
    return medianOf(levels);
}

/// True if the surface runs along the wall at p: then it only touches it, and is not cut there.
bool touches(const ExaminedFile& examined, const WallFace& face, Index p) {
    constexpr double kAlong = 0.96592582628906829;  // within 15 degrees
    return examined.file.hasNormals() && std::abs(examined.normal()[p][face.axis]) > kAlong;
}

}  // namespace

std::optional<Finding> findTypesOffBox(const ExaminedFile& examined) {
    const PointFile& file = examined.file;
    if (!file.hasTypes()) return std::nullopt;
    const WallBox box = boxAround(file.position);
    const Vec3 sides = box.high - box.low;
    const double reach = box.tolerance * std::max({sides.x, sides.y, sides.z});
    std::vector<bool> off(examined.size(), false);
    for (const WallFace& face : kWallFaces) {
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
    auto points = pointsWhere(examined.size(), [&](Index p) { return off[p]; });
    return findingAt(std::move(points), Severity::Warning,
                     "marked as on a wall but off it, or on or beyond a wall but not marked");
}

// ---- rims ---------------------------------------------------------------------------------------

std::optional<Finding> findOpenBorder(const ExaminedFile& examined) {
    if (!examined.normalsNear) return std::nullopt;
    const PointFile& file = examined.file;
    const auto isMarked = [&](Index p) { return file.hasTypes() && isRimPoint(file.type[p]); };
    std::vector<Index> points;
    std::size_t rims = 0;
    for (const std::vector<Index>& opening : examined.intake.judge->openings) {
        if (std::any_of(opening.begin(), opening.end(), isMarked)) continue;
        points.insert(points.end(), opening.begin(), opening.end());
        ++rims;
    }
    std::sort(points.begin(), points.end());
    return findingAt(std::move(points), Severity::Note,
                     "along " + counted(rims, "rim") +
                         " where the surface ends without a wall, and without types");
}

}  // namespace se
