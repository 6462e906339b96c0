/// Least squares by the normal equations, with lengths in units of the patch, so that six digits of
/// the heights remain; Gaussian elimination with + - * / alone. O(points of the patch).
#include "spiraling_edge/doctor/surface_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "spiraling_edge/prepare/normals.h"

namespace se {
namespace {

constexpr std::size_t kFitCoefficients = 6;
constexpr std::size_t kLeastFitted = kFitCoefficients + 3;

/// 1, x, y, x^2, x y, y^2 of a point, and its height.
using FitRow = std::array<double, kFitCoefficients + 1>;
using Equations = std::array<FitRow, kFitCoefficients>;

/// Axes of a patch: its normal and two in its plane, about its first point.
struct PatchFrame {
    Vec3 origin;
    Vec3 x;
    Vec3 y;
    Vec3 normal;
    double length = 1.0;

    FitRow rowOf(const Vec3& place) const {
        const Vec3 offset = (place - origin) / length;
        const double u = glm::dot(offset, x);
        const double v = glm::dot(offset, y);
        return {1.0, u, v, u * u, u * v, v * v, glm::dot(offset, normal)};
    }
};

std::optional<PatchFrame> frameOf(std::span<const Vec3> position, std::span<const Index> patch) {
    PatchFrame frame;
    frame.normal = planeNormalAt(position, patch.front(), patch.subspan(1));
    if (frame.normal == Vec3(0.0)) return std::nullopt;
    frame.origin = position[patch.front()];
    const Vec3 axis = std::abs(frame.normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    frame.x = glm::cross(frame.normal, axis);
    frame.x /= std::sqrt(glm::dot(frame.x, frame.x));
    frame.y = glm::cross(frame.normal, frame.x);
    double reachSq = 0.0;
    for (const Index q : patch) {
        const Vec3 offset = position[q] - frame.origin;
        reachSq = std::max(reachSq, glm::dot(offset, offset));
    }
    frame.length = std::sqrt(reachSq);
    return frame;
}

/// Solves the equations in place, so that the last column holds the solution. False if they are
/// singular.
bool solve(Equations& equations) {
    constexpr double kSingular = 1e-9;
    for (std::size_t i = 0; i < kFitCoefficients; ++i) {
        std::size_t pivot = i;
        for (std::size_t r = i + 1; r < kFitCoefficients; ++r) {
            if (std::abs(equations[r][i]) > std::abs(equations[pivot][i])) pivot = r;
        }
        if (!(std::abs(equations[pivot][i]) > kSingular)) return false;
        std::swap(equations[i], equations[pivot]);
        for (std::size_t r = 0; r < kFitCoefficients; ++r) {
            if (r == i) continue;
            const double factor = equations[r][i] / equations[i][i];
            for (std::size_t c = i; c <= kFitCoefficients; ++c)
                equations[r][c] -= factor * equations[i][c];
        }
    }
    for (std::size_t i = 0; i < kFitCoefficients; ++i)
        equations[i][kFitCoefficients] /= equations[i][i];
    return true;
}

Equations equationsOf(std::span<const FitRow> rows) {
    Equations equations{};
    for (const FitRow& row : rows) {
        for (std::size_t i = 0; i < kFitCoefficients; ++i) {
            for (std::size_t j = i; j <= kFitCoefficients; ++j) equations[i][j] += row[i] * row[j];
        }
    }
    // They are symmetric.
    for (std::size_t i = 1; i < kFitCoefficients; ++i) {
        for (std::size_t j = 0; j < i; ++j) equations[i][j] = equations[j][i];
    }
    return equations;
}

/// Heights over the surface that fits the rows best; false if they do not determine it.
bool heightsOver(std::span<const FitRow> rows, std::vector<double>& heights) {
    Equations equations = equationsOf(rows);
    if (!solve(equations)) return false;
    heights.clear();
    for (const FitRow& row : rows) {
        double height = row[kFitCoefficients];
        for (std::size_t i = 0; i < kFitCoefficients; ++i)
            height -= equations[i][kFitCoefficients] * row[i];
        heights.push_back(height);
    }
    return true;
}

/// The heaps of the heights over a surface that is fitted to both as one. Requires heights over
/// the rows, which move.
TwoHeaps heapsOver(std::vector<FitRow>& rows, std::vector<double>& heights) {
    constexpr int kRounds = 3;  // Then the heaps stay.
    std::vector<double> sorted = heights;
    TwoHeaps heaps = twoHeapsOf(sorted);
    for (int round = 0; round < kRounds && heaps.share > 0.0; ++round) {
        std::vector<FitRow> joined = rows;
        for (std::size_t i = 0; i < rows.size(); ++i)
            joined[i][kFitCoefficients] -= heights[i] >= heaps.cut ? heaps.apart : 0.0;
        std::vector<double> over;
        if (!heightsOver(joined, over)) break;
        for (std::size_t i = 0; i < rows.size(); ++i)
            heights[i] = over[i] + rows[i][kFitCoefficients] - joined[i][kFitCoefficients];
        sorted = heights;
        heaps = twoHeapsOf(sorted);
    }
    return heaps;
}

/// A patch with the quadric that fits it best.
struct FittedPatch {
    double length = 1.0;  ///< Of PatchFrame, the unit of rows and heights.
    std::vector<FitRow> rows;
    std::vector<double> heights;

    /// The points less the coefficients.
    double freedom() const {
        return static_cast<double>(rows.size()) - static_cast<double>(kFitCoefficients);
    }
    double deviation() const {
        double squares = 0.0;
        for (const double height : heights) squares += height * height;
        return length * std::sqrt(squares / freedom());
    }
};

std::optional<FittedPatch> fitQuadric(std::span<const Vec3> position,
                                      std::span<const Index> patch) {
    if (patch.size() < kLeastFitted) return std::nullopt;
    const std::optional<PatchFrame> frame = frameOf(position, patch);
    if (!frame) return std::nullopt;
    FittedPatch fitted{frame->length, {}, {}};
    fitted.rows.reserve(patch.size());
    for (const Index q : patch) fitted.rows.push_back(frame->rowOf(position[q]));
    if (!heightsOver(fitted.rows, fitted.heights)) return std::nullopt;
    return fitted;
}

}  // namespace

std::optional<double> deviationFromQuadric(std::span<const Vec3> position,
                                           std::span<const Index> patch) {
    const std::optional<FittedPatch> fitted = fitQuadric(position, patch);
    return fitted ? std::optional(fitted->deviation()) : std::nullopt;
}

std::optional<FitHeights> heapsOverQuadric(std::span<const Vec3> position,
                                           std::span<const Index> patch) {
    std::optional<FittedPatch> fitted = fitQuadric(position, patch);
    if (!fitted) return std::nullopt;
    const double deviation = fitted->deviation();
    TwoHeaps heaps = heapsOver(fitted->rows, fitted->heights);
    const auto count = static_cast<double>(patch.size());
    heaps.apart *= fitted->length;
    heaps.within *= fitted->length * std::sqrt(count / fitted->freedom());
    return FitHeights{deviation, heaps};
}

}  // namespace se
