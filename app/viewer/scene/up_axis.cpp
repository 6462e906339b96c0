// File formats do not record which way is up. Three clues are tried in order of reliability: a
// flat side on which the object rests (at one end of the box far more points with outward normals
// than at any other end), the thin axis of a plate, and the convention of the format. O(points).
#include "up_axis.h"

#include <algorithm>
#include <array>

#include "run/model.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/points/wall_types.h"

namespace se::view {

namespace {

constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};

/// Points this close to an end of the box, as a share of its side, may lie on a flat side there.
constexpr double kEndShare = 0.02;
/// Cosine between the normal of such a point and the axis.
constexpr double kFacing = 0.9;
/// A flat side has at least this share of all points, and kFlatFactor times the points of any other
/// end.
constexpr double kFlatShare = 0.02;
constexpr double kFlatFactor = 2.0;
/// A plate is at most this thin against its width, and at least this wide against its length.
constexpr double kThin = 0.4;
constexpr double kWide = 0.7;

constexpr int kAxes = 3;

/// Number of points that lie flat at the low and the high end of each axis.
std::array<std::size_t, 2 * kAxes> flatPoints(const PointSet& points, const WallBox& box) {
    std::array<std::size_t, 2 * kAxes> counts{};
    const Vec3 margin = kEndShare * (box.high - box.low);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points.position[i];
        const Vec3& n = points.normal[i];
        for (int axis = 0; axis < kAxes; ++axis) {
            const auto end = 2 * static_cast<std::size_t>(axis);
            if (p[axis] < box.low[axis] + margin[axis] && n[axis] < -kFacing) ++counts[end];
            if (p[axis] > box.high[axis] - margin[axis] && n[axis] > kFacing) ++counts[end + 1];
        }
    }
    return counts;
}

/// The axis with an end that has far more flat points than all other ends.
std::optional<UpAxis> axisOfFlatSide(const PointSet& points, const WallBox& box) {
    auto counts = flatPoints(points, box);
    const auto most = std::max_element(counts.begin(), counts.end());
    const auto axis = static_cast<UpAxis>((most - counts.begin()) / 2);
    const auto count = static_cast<double>(*most);
    *most = 0;
    const auto next = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
    if (count == 0.0 || count < kFlatShare * static_cast<double>(points.size()) ||
        count < kFlatFactor * next)
        return std::nullopt;
    return axis;
}

/// The thin axis of a plate.
std::optional<UpAxis> axisOfPlate(const WallBox& box) {
    const Vec3 sides = box.high - box.low;
    std::array<int, kAxes> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return sides[a] < sides[b]; });
    const double thin = sides[order[0]];
    const double wide = sides[order[1]];
    const double longest = sides[order[2]];
    const bool plate = longest > 0.0 && thin <= kThin * wide && wide >= kWide * longest;
    if (!plate) return std::nullopt;
    return static_cast<UpAxis>(order[0]);
}

/// True if the extension is that of a format for meshes; false for one for points alone.
bool isForMeshes(const std::filesystem::path& path) {
    const PointFormat* points = pointFormatOf(path);
    if (points != nullptr) return points->faces;
    return path.has_extension() && meshFormatOf(path) != nullptr;
}

}  // namespace

std::string_view upAxisName(UpAxis axis) { return kNames[static_cast<std::size_t>(axis)]; }

std::optional<UpAxis> upAxisFromName(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<UpAxis>(found - kNames.begin());
}

UpAxis guessUpAxis(const PointSet& points, std::string_view source) {
    const bool made = isScene(source) || isSample(source) || isPractice(source);
    if (made || std::any_of(points.type.begin(), points.type.end(), isOnWall)) return UpAxis::Z;
    const WallBox box = boxAround(points.position);
    if (const auto axis = axisOfFlatSide(points, box)) return *axis;
    if (const auto axis = axisOfPlate(box)) return *axis;
    return isForMeshes(source) ? UpAxis::Y : UpAxis::Z;
}

}  // namespace se::view
