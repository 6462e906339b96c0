/// Checks of types: corner bits, marks against the walls of the box, and rims (prepare/rim.h) that
/// no type marks.
#include <algorithm>
#include <array>
#include <cmath>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/prepare/rim.h"

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
    return medianOf(levels);
}

/// True if the surface runs along the wall at p: then it only touches it, and is not cut there.
bool touches(const ExaminedFile& examined, const Face& face, Index p) {
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
    auto points = pointsWhere(examined.size(), [&](Index p) { return off[p]; });
    return findingAt(std::move(points), Severity::Warning,
                     "marked as on a wall but off it, or on or beyond a wall but not marked");
}

// ---- rims ---------------------------------------------------------------------------------------

namespace {

/// The normals of the points, with flipped ones corrected.
std::vector<Vec3> sidesOfPoints(const ExaminedFile& examined) {
    std::vector<Vec3> side(examined.size(), Vec3(0.0));
    for (Index p = 0; p < examined.size(); ++p) {
        if (examined.hasSide(p)) side[p] = examined.side(p);
    }
    return side;
}

/// True if each point and those nearest to it have normals that agree: then lists without opposing
/// ones are those of the examination.
bool allAgree(const ExaminedFile& examined, const std::vector<Vec3>& side) {
    for (Index p = 0; p < examined.size(); ++p) {
        if (examined.present()[p] != examined.hasSide(p)) return false;
        const auto list = examined.nearest()[p];
        if (std::any_of(list.begin(), list.end(),
                        [&](Index q) { return normalsOppose(side[p], side[q]); }))
            return false;
    }
    return true;
}

Result<Rim> rimOf(const ExaminedFile& examined) {
    const PointFile& file = examined.file;
    const std::vector<Vec3> side = sidesOfPoints(examined);
    if (allAgree(examined, side))
        return findRim(file.position, side, examined.nearest(), file.type);
    std::vector<bool> usable(examined.size());
    for (Index p = 0; p < examined.size(); ++p) usable[p] = examined.hasSide(p);
    const Result<NeighborLists> lists = findNeighbors(file.position, side, usable, {});
    if (!lists) return lists.error();
    return findRim(file.position, side, lists.value(), file.type);
}

bool isMarked(const PointFile& file, Index p) {
    return file.hasTypes() && isRimPoint(file.type[p]);
}

}  // namespace

std::optional<Finding> findOpenBorder(const ExaminedFile& examined) {
    const PointFile& file = examined.file;
    if (!examined.normalsNear) return std::nullopt;
    const Result<Rim> rim = rimOf(examined);
    if (!rim) return std::nullopt;
    // Rim points in the file do not count without types.
    const auto& chains = rim.value().chains;
    const auto rims = static_cast<std::size_t>(
        std::count_if(chains.begin(), chains.end(), [&](const std::vector<Index>& chain) {
            return std::none_of(chain.begin(), chain.end(),
                                [&](Index p) { return isMarked(file, p); });
        }));
    if (rims == 0) return std::nullopt;
    auto points = pointsWhere(
        examined.size(), [&](Index p) { return rim.value().gap[p].known() && !isMarked(file, p); });
    return findingAt(std::move(points), Severity::Note,
                     "along " + counted(rims, "rim") +
                         " where the surface ends without a wall, and without types");
}

}  // namespace se
