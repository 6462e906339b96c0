/// Planes by principal components: the 3 x 3 scatter matrix is diagonalized by Jacobi rotations,
/// with + - * / and sqrt alone. O(list entries).
#include "spiraling_edge/prepare/normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/prepare/orientation.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// Turns axes a and b so that m[a][b] becomes zero (Jacobi); the columns of `axes` turn along.
void rotate(Matrix& m, Matrix& axes, std::size_t a, std::size_t b) {
    if (m[a][b] == 0.0) return;
    const double half = (m[b][b] - m[a][a]) / (2.0 * m[a][b]);
    const double tangent =
        (half >= 0.0 ? 1.0 : -1.0) / (std::abs(half) + std::sqrt(half * half + 1.0));
    const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0);
    const double sine = tangent * cosine;
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = m[i][a];
        const double y = m[i][b];
        m[i][a] = cosine * x - sine * y;
        m[i][b] = sine * x + cosine * y;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = m[a][i];
        const double y = m[b][i];
        m[a][i] = cosine * x - sine * y;
        m[b][i] = sine * x + cosine * y;
        const double u = axes[i][a];
        const double v = axes[i][b];
        axes[i][a] = cosine * u - sine * v;
        axes[i][b] = sine * u + cosine * v;
    }
    m[a][b] = m[b][a] = 0.0;
}

/// True if what is left off the diagonal is too small to turn the axes: mostly so after three
/// sweeps.
bool isDiagonal(const Matrix& m) {
    constexpr double kNegligible = 1e-32;  // Of the trace: far below the rounding of an axis.
    const double offDiagonal = std::abs(m[0][1]) + std::abs(m[0][2]) + std::abs(m[1][2]);
    return offDiagonal <= kNegligible * (m[0][0] + m[1][1] + m[2][2]);
}

/// Scatter matrix of the offsets about their mean; p itself counts with offset zero.
Matrix scatter(std::span<const Vec3> position, Index p, std::span<const Index> list) {
    Vec3 mean(0.0);
    for (const Index q : list) mean += position[q] - position[p];
    mean /= static_cast<double>(list.size() + 1);
    Matrix m{};
    const auto add = [&](const Vec3& d) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += d[i] * d[j];
            }
        }
    };
    add(-mean);
    for (const Index q : list) add(position[q] - position[p] - mean);
    return m;
}

/// Direction of least scatter, zero if the next one scatters no more than rounding does; and the
/// scatter along each axis.
PlaneFit planeOf(Matrix m) {
    Matrix axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr int kSweeps = 8;
    for (int sweep = 0; sweep < kSweeps && !isDiagonal(m); ++sweep) {
        rotate(m, axes, 0, 1);
        rotate(m, axes, 0, 2);
        rotate(m, axes, 1, 2);
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return m[a][a] < m[b][b] || (m[a][a] == m[b][b] && a < b);
    });
    const double middle = m[order[1]][order[1]];
    const double largest = m[order[2]][order[2]];
    PlaneFit plane;
    plane.variance = {std::max(m[order[0]][order[0]], 0.0), middle, largest};
    constexpr double kInLine = 1e-12;  // Squares of lengths.
    if (!(middle > kInLine * largest)) return plane;
    const std::size_t least = order[0];
    const Vec3 n(axes[0][least], axes[1][least], axes[2][least]);
    plane.normal = n / std::sqrt(glm::dot(n, n));
    return plane;
}

}  // namespace

PlaneFit planeAt(std::span<const Vec3> position, Index p, std::span<const Index> list) {
    if (list.size() < 2) return {};
    PlaneFit plane = planeOf(scatter(position, p, list));
    for (double& each : plane.variance) each /= static_cast<double>(list.size() + 1);
    return plane;
}

Result<std::vector<Vec3>> estimateNormals(std::span<const Vec3> position,
                                          const NeighborLists& neighbors, unsigned threads,
                                          const Progress& progress) {
    constexpr std::size_t kPlanesPerThread = 1024;
    std::vector<Vec3> normal(position.size(), Vec3(0.0));
    const auto estimate = [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        normal[p] = planeNormalAt(position, p, neighbors[p]);
    };
    if (!forEachWithProgress(normal.size(), threads, kPlanesPerThread, progress, estimate))
        return Error{"the work on normals was cancelled"};
    return normal;
}

bool lacksNormals(std::span<const Vec3> normal, const std::vector<bool>& usable) {
    if (normal.empty()) return true;
    std::size_t directed = 0;
    std::size_t all = 0;
    for (std::size_t p = 0; p < usable.size(); ++p) {
        if (!usable[p]) continue;
        ++all;
        directed += hasDirection(normal[p]) ? 1U : 0U;
    }
    return 2 * directed < all;
}

namespace {

/// Sets missing normals by those of neighbors.
class NormalCompletion {
  public:
    NormalCompletion(std::span<const Vec3> position, const NeighborLists& lists,
                     std::vector<Vec3>& normal)
        : position_(position), lists_(lists), normal_(normal), plane_(normal.size(), Vec3(0.0)) {}

    /// `missing`: the points whose normals are to be set, which are zero.
    void run(const std::vector<Index>& missing) {
        for (const Index p : missing) {
            plane_[p] = planeNormalAt(position_, p, lists_[p]);
            queue_.push_back(p);
        }
        // Each is looked at again once a neighbor has got its normal.
        for (std::size_t i = 0; i < queue_.size(); ++i) {
            if (!set(queue_[i])) continue;
            for (const Index q : lists_[queue_[i]]) {
                if (plane_[q] != Vec3(0.0)) queue_.push_back(q);
            }
        }
    }
    /// The planes of the points of parts in which no point has a normal; zero at all others.
    std::vector<Vec3> takeRest() { return std::move(plane_); }

  private:
    /// True if p has got its normal now.
    bool set(Index p) {
        double side = 0.0;
        for (const Index q : lists_[p]) {
            Vec3 other = normal_[q];
            if (!hasDirection(other)) continue;
            scaleToUnit(other);
            side += glm::dot(plane_[p], other);
        }
        if (side == 0.0) return false;
        normal_[p] = side < 0.0 ? -plane_[p] : plane_[p];
        plane_[p] = Vec3(0.0);
        return true;
    }

    std::span<const Vec3> position_;
    const NeighborLists& lists_;
    std::vector<Vec3>& normal_;
    std::vector<Vec3> plane_;  ///< Zero once used.
    std::vector<Index> queue_;
};

}  // namespace

Result<std::vector<Vec3>> completeNormals(const PointFile& file, const std::vector<bool>& usable,
                                          unsigned threads, const Progress& progress) {
    std::vector<Vec3> normal = file.normal;
    std::vector<Index> missing;
    for (Index p = 0; p < normal.size(); ++p) {
        if (!usable[p] || hasDirection(normal[p])) continue;
        normal[p] = Vec3(0.0);
        missing.push_back(p);
    }
    if (missing.empty()) return normal;
    const Result<NeighborLists> lists =
        nearestPoints(file.position, usable, KNearest{}.k, threads, progress);
    if (!lists) return lists.error();
    NormalCompletion completion(file.position, lists.value(), normal);
    completion.run(missing);
    std::vector<Vec3> rest = completion.takeRest();
    const OrientationOptions outward{UnknownSide::ByVote, {}, {}, threads};
    const Result<OrientationReport> turned =
        orientNormals(file.position, lists.value(), rest, outward);
    if (!turned) return turned.error();
    for (const Index p : missing) {
        if (normal[p] == Vec3(0.0)) normal[p] = rest[p];
        if (file.normalType == ScalarType::Float) normal[p] = Vec3(glm::vec3(normal[p]));
    }
    return normal;
}

}  // namespace se
