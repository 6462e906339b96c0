/// Delta debugging (Zeller and Hildebrandt 2002) over points: first the smallest ball around the
/// failure that fails, then pieces of half the points, a quarter and so on, far ones first, until
/// no single point can be removed. Each try is a run of the caller; about n log n tries in the
/// usual case, n squared at worst.
#include "spiraling_edge/why/reduce.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "spiraling_edge/doctor/doctor.h"

namespace se {
namespace {

class Reducer {
  public:
    using Fails = std::function<ReduceTry(const PointFile&)>;

    Reducer(const PointFile& file, const Fails& fails, std::uint64_t effort,
            const Progress& progress)
        : file_(file),
          fails_(fails),
          left_(effort),
          progress_(progress),
          pointCount_(file.position.size()) {}

    Result<Reduced> run(const Vec3& place) {
        kept_.resize(pointCount_);
        std::iota(kept_.begin(), kept_.end(), Index{0});
        if (!stillFails(kept_)) return Error{"The whole input does not fail so."};
        crop(place);
        // Points are ordered by distance, so that a piece is a connected part.
        sortByDistance(kept_, place);
        takeOutPieces();
        if (cancelled_) return Error{"Cancelled."};
        std::sort(kept_.begin(), kept_.end());
        return Reduced{subset(kept_), kept_, tries_, !exhausted_};
    }

  private:
    PointFile subset(const std::vector<Index>& points) const {
        std::vector<bool> isKept(pointCount_, false);
        for (const Index p : points) isKept[p] = true;
        std::vector<Index> others;
        for (Index p = 0; p < pointCount_; ++p) {
            if (!isKept[p]) others.push_back(p);
        }
        return applyFixes(file_, others).file;
    }
    bool stillFails(const std::vector<Index>& points) {
        if (over() || points.empty()) return false;
        // The first try is always made.
        exhausted_ = tries_ > 0 && left_ == 0;
        if (exhausted_) return false;
        ++tries_;
        const double share = 1.0 - std::log1p(static_cast<double>(kept_.size())) /
                                       std::log1p(static_cast<double>(pointCount_));
        cancelled_ = progress_ && !progress_(share);
        if (cancelled_) return false;
        const ReduceTry made = fails_(subset(points));
        left_ -= std::min(left_, made.work);
        return made.fails;
    }
    bool over() const { return cancelled_ || exhausted_; }
    void sortByDistance(std::vector<Index>& points, const Vec3& place) const {
        const auto distanceSq = [&](Index p) {
            const Vec3 d = file_.position[p] - place;
            return glm::dot(d, d);
        };
        std::stable_sort(points.begin(), points.end(),
                         [&](Index a, Index b) { return distanceSq(a) < distanceSq(b); });
    }

    /// Crops to the smallest ball, by factors of the fourth root of two, whose points fail alone.
    void crop(const Vec3& place) {
        constexpr double kGrowth = 1.189207115002721;
        std::vector<Index> byDistance = kept_;
        sortByDistance(byDistance, place);
        double count = 8.0;
        while (static_cast<std::size_t>(count) < byDistance.size() && !over()) {
            const std::vector<Index> ball(byDistance.begin(),
                                          byDistance.begin() + static_cast<std::ptrdiff_t>(count));
            if (stillFails(ball)) {
                kept_ = ball;
                return;
            }
            count *= kGrowth;
        }
    }

    /// Removes pieces of half the points, a quarter, ... down to single ones, until none can be
    /// removed.
    void takeOutPieces() {
        std::size_t size = std::max<std::size_t>(kept_.size() / 2, 1);
        for (;;) {
            bool changed = false;
            // From the far end: distant points first.
            for (std::size_t end = kept_.size(); end > 0 && !over();) {
                const std::size_t begin = end > size ? end - size : 0;
                std::vector<Index> rest = kept_;
                rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(begin),
                           rest.begin() + static_cast<std::ptrdiff_t>(end));
                if (stillFails(rest)) {
                    kept_ = std::move(rest);
                    changed = true;
                }
                end = begin;
            }
            if (over() || (size == 1 && !changed)) return;
            size = std::max<std::size_t>(size / 2, 1);
        }
    }

    const PointFile& file_;
    const Fails& fails_;
    std::uint64_t left_;  ///< Remaining effort.
    const Progress& progress_;
    std::size_t pointCount_;
    std::vector<Index> kept_;
    std::size_t tries_ = 0;
    bool cancelled_ = false;
    bool exhausted_ = false;
};

}  // namespace

Result<Reduced> reduceInput(const PointFile& file, const Vec3& place,
                            const std::function<ReduceTry(const PointFile&)>& fails,
                            std::uint64_t effort, const Progress& progress) {
    return Reducer(file, fails, effort, progress).run(place);
}

bool isBackToBack(const MeshFailure& failure, std::span<const Triangle> mesh) {
    if (failure.triangles.empty()) return false;
    const auto cornersOf = [](const Triangle& t) {
        std::array<Index, 3> corners{t.a, t.b, t.c};
        std::sort(corners.begin(), corners.end());
        return corners;
    };
    const auto corners = cornersOf(mesh[failure.triangles.front()]);
    std::size_t same = 0;
    for (const Triangle& each : mesh) {
        const auto other = cornersOf(each);
        if (other == corners) {
            ++same;
        } else if (std::find_first_of(other.begin(), other.end(), corners.begin(), corners.end()) !=
                   other.end()) {
            return false;
        }
    }
    return same > 1;
}

}  // namespace se
