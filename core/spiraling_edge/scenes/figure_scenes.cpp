/// Small inputs that each show one figure of the paper. tests/core/scenes/scenes_test.cpp checks
/// the pivots named in the table of scenes.
#include "spiraling_edge/scenes/figure_scenes.h"

#include <algorithm>

#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/scenes/surface_scenes.h"

namespace se {
namespace {

/// Adds lists of the k nearest points, so that the figure does not depend on options.
PointFile withLists(PointFile file, std::size_t k) {
    const std::vector<bool> usable(file.position.size(), true);
    auto lists = findNeighbors(file.position, file.normal, usable, {KNearest{k}});
    if (lists.ok()) file.neighbors = std::move(lists.value());
    return file;
}

template <typename T>
void moveToBack(std::vector<T>& values, std::size_t count) {
    std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count), values.end());
}

/// A small sheet whose run begins at an interior point.
PointFile smallSheet(const ImplicitSurface& sheet, std::uint64_t seed, std::size_t k) {
    constexpr std::size_t kPerSide = 5;
    constexpr std::size_t kRim = 4 * (kPerSide + 1);
    PointFile file = sampleSheet(sheet, kPerSide, 26, seed);
    moveToBack(file.position, kRim);
    moveToBack(file.normal, kRim);
    moveToBack(file.type, kRim);
    return withLists(std::move(file), k);
}

PointFile smallTorus(std::uint64_t seed, std::size_t k) {
    return withLists(sampleClosed(torus(), 160, 0.3375, seed), k);
}

/// The points of Figure 2 around point 1, in the order of their numbers; spacing 1.
constexpr double kFigure2[][2] = {
    {0.0, 0.0},                                     // 1
    {0.94, 0.0},    {0.52, 0.88},  {-0.5, 0.9},     // 2 to 4
    {-1.0, 0.02},   {-0.49, -0.9}, {0.52, -0.88},   // 5 to 7
    {1.56, -0.88},  {1.92, 0.1},   {1.34, 1.26},    // 8 to 10, around 2
    {0.06, 1.8},                                    // 11, around 3
    {-1.0, 1.74},   {-1.62, 0.92},                  // 12, 13, around 4
    {-1.96, 0.2},   {-1.9, -0.62}, {-1.34, -1.36},  // 14 to 16, around 5
    {-0.46, -1.86}, {0.5, -1.84},                   // 17, 18
};

}  // namespace

PointFile figure2() {
    constexpr int kRows = 4;
    constexpr double kRowHeight = 0.9;
    constexpr double kHalfWidth = 4.0;
    constexpr double kHalfHeight = kRows * kRowHeight;
    PointFile file;
    file.positionType = ScalarType::Double;
    const auto add = [&](double x, double y) {
        unsigned faces = 0;
        if (x == kHalfWidth) faces |= kPositiveX;
        if (y == kHalfHeight) faces |= kPositiveY;
        if (x == -kHalfWidth) faces |= kNegativeX;
        if (y == -kHalfHeight) faces |= kNegativeY;
        file.position.emplace_back(x, y, 0.0);
        file.normal.emplace_back(0.0, 0.0, 1.0);
        file.type.push_back(withCornerBit(static_cast<std::uint8_t>(faces)));
    };
    for (const auto& p : kFigure2) add(p[0], p[1]);
    for (int row = -kRows; row <= kRows; ++row) {
        // Eight or seven steps from wall to wall: rows are shifted against each other.
        const int steps = row % 2 == 0 ? 8 : 7;
        const double y = row * kRowHeight;
        for (int i = 0; i <= steps; ++i) {
            const double x = i == steps ? kHalfWidth : -kHalfWidth + i * (2.0 * kHalfWidth) / steps;
            const bool taken =
                std::any_of(std::begin(kFigure2), std::end(kFigure2), [&](const auto& p) {
                    const double dx = x - p[0];
                    const double dy = y - p[1];
                    return dx * dx + dy * dy < 0.55;
                });
            if (!taken) add(x, y);
        }
    }
    return file;
}

PointFile figure4() { return smallSheet(flatSheet(), 1, 10); }
PointFile figure5() { return smallTorus(1, 10); }
PointFile figure6() { return smallSheet(wavySheet(), 122, 12); }
PointFile figure7() { return smallTorus(1, 14); }
PointFile figure9() { return smallTorus(11, 10); }
PointFile figure12() { return smallTorus(5, 10); }

PointFile figure14() {
    PointFile file = sampleSheet(flatSheet(), 5, 26, 1);
    // Rim points come in groups of four, from the corners on: this begins on the wall y = -1.
    moveToBack(file.position, 8);
    moveToBack(file.normal, 8);
    moveToBack(file.type, 8);
    return withLists(std::move(file), 10);
}

}  // namespace se
