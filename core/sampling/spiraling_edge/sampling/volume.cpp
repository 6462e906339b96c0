/// Trilinear interpolation of samples on a grid. The reader of volumes is in nrrd.cpp.
#include "spiraling_edge/sampling/volume.h"

#include <algorithm>
#include <cassert>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/lists.h"

namespace se {

namespace fs = std::filesystem;

std::span<const std::string_view> volumeExtensions() {
    static constexpr std::array<std::string_view, 2> kExtensions{".nrrd", ".nhdr"};
    return kExtensions;
}

bool isVolumePath(const fs::path& path) {
    return isAmong(lowerExtension(path), volumeExtensions());
}

Vec3 Volume::high() const {
    const Vec3 steps(static_cast<double>(size[0] - 1), static_cast<double>(size[1] - 1),
                     static_cast<double>(size[2] - 1));
    return origin + steps * spacing;
}

namespace {

/// The eight samples around a place, x fastest, and its position between them, in 0 .. 1.
struct Cell {
    std::array<double, 8> corner{};
    Vec3 t{0.0};
};

Cell cellAround(const Volume& volume, const Vec3& x) {
    const Vec3 steps = (x - volume.origin) / volume.spacing;
    std::array<std::size_t, 3> first{};
    Cell cell;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        const auto last = static_cast<double>(volume.size[i] - 1);
        const double at = std::clamp(steps[axis], 0.0, last);
        first[i] = static_cast<std::size_t>(std::min(at, last - 1.0));
        cell.t[axis] = at - static_cast<double>(first[i]);
    }
    const std::size_t row = volume.size[0];
    const std::size_t layer = row * volume.size[1];
    const float* from = &volume.value[first[2] * layer + first[1] * row + first[0]];
    for (std::size_t i = 0; i < 8; ++i)
        cell.corner[i] = from[(i & 1U) + (i >> 1U & 1U) * row + (i >> 2U) * layer];
    return cell;
}

double mix(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

double Volume::valueAt(const Vec3& x) const {
    const Cell cell = cellAround(*this, x);
    const auto& c = cell.corner;
    const Vec3& t = cell.t;
    return mix(mix(mix(c[0], c[1], t.x), mix(c[2], c[3], t.x), t.y),
               mix(mix(c[4], c[5], t.x), mix(c[6], c[7], t.x), t.y), t.z);
}

Vec3 Volume::gradientAt(const Vec3& x) const {
    constexpr double kReach = 0.5;
    const Vec3 last = high();
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 before = x;
        Vec3 after = x;
        before[axis] = std::max(x[axis] - kReach * spacing[axis], origin[axis]);
        after[axis] = std::min(x[axis] + kReach * spacing[axis], last[axis]);
        gradient[axis] = (valueAt(after) - valueAt(before)) / (after[axis] - before[axis]);
    }
    return gradient;
}

Field fieldOf(const std::shared_ptr<const Volume>& volume, double isovalue) {
    assert(volume->size[0] >= 2 && volume->size[1] >= 2 && volume->size[2] >= 2);
    Field field;
    field.value = [volume](const Vec3& x) { return volume->valueAt(x); };
    field.gradient = [volume](const Vec3& x) { return volume->gradientAt(x); };
    field.low = volume->origin;
    field.high = volume->high();
    field.isovalue = isovalue;
    for (std::size_t axis = 0; axis < 3; ++axis)
        field.cells[static_cast<int>(axis)] = static_cast<int>(volume->size[axis]) - 1;
    return field;
}

}  // namespace se
