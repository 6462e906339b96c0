#include <algorithm>

#include "spiraling_edge/doctor/checks.h"
#include "spiraling_edge/prepare/rim.h"

namespace se {
namespace {

/// The normals of the points, with flipped ones corrected.
std::vector<Vec3> sidesOfPoints(const ExaminedFile& examined) {
    std::vector<Vec3> side(examined.size(), Vec3(0.0));
    for (Index p = 0; p < examined.size(); ++p) {
        if (examined.hasSide(p)) side[p] = examined.side(p);
    }
    return side;
}

bool isMarked(const PointFile& file, Index p) {
    return file.hasTypes() && isRimPoint(file.type[p]);
}

}  // namespace

std::optional<Finding> findOpenBorder(const ExaminedFile& examined) {
    const PointFile& file = examined.file;
    if (!file.hasNormals()) return std::nullopt;
    const std::vector<Vec3> side = sidesOfPoints(examined);
    std::vector<bool> usable(examined.size());
    for (Index p = 0; p < examined.size(); ++p) usable[p] = examined.hasSide(p);
    const Result<NeighborLists> lists = findNeighbors(file.position, side, usable, {});
    if (!lists) return std::nullopt;
    const Result<Rim> rim = findRim(file.position, side, lists.value(), file.type);
    if (!rim) return std::nullopt;
    // Rim points in the file do not count without types.
    const auto& chains = rim.value().chains;
    const auto rims = static_cast<std::size_t>(
        std::count_if(chains.begin(), chains.end(), [&](const std::vector<Index>& chain) {
            return std::none_of(chain.begin(), chain.end(),
                                [&](Index p) { return isMarked(file, p); });
        }));
    if (rims == 0) return std::nullopt;
    std::vector<Index> points;
    for (Index p = 0; p < examined.size(); ++p) {
        if (rim.value().gap[p].known() && !isMarked(file, p)) points.push_back(p);
    }
    const std::string text = countText(points.size(), "point") + " along " +
                             countText(rims, "rim") +
                             " where the surface ends without a wall, and without types";
    return findingAt(std::move(points), Severity::Note, text);
}

}  // namespace se
