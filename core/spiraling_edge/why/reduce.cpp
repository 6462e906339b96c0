/// Delta debugging (Zeller and Hildebrandt 2002) over points: first the smallest ball around the
/// failure that fails, then pieces of half the points, a quarter and so on, far ones first, until
/// no single point can be removed. Each try is a run of the caller; about n log n tries in the
/// usual case, n squared at worst.
#include "spiraling_edge/why/reduce.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/reconstruct.h"

namespace se {
namespace {

/// Work of a run and of the inspection of its mesh, in tests. Each point is read and prepared; in
/// each pivot every listed point may be tested against every other.
std::uint64_t workOf(const PointSet& points, const State& end, const MeshInspection& found) {
    constexpr std::uint64_t kPerPoint = 200;
    const std::uint64_t count = std::max<std::uint64_t>(points.size(), 1);
    const std::uint64_t listed = points.neighbors.ids.size() / count + 1;
    return kPerPoint * count + end.counters.pivots * listed * listed + found.work;
}

/// Positions of a failure's points, sorted: they identify a hole across runs.
std::vector<Vec3> placesOf(const PointSet& points, const MeshFailure& failure) {
    std::vector<Vec3> places;
    places.reserve(failure.points.size());
    for (const Index p : failure.points) places.push_back(points.position[p]);
    std::sort(places.begin(), places.end(), [](const Vec3& a, const Vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    return places;
}

}  // namespace

Reduction::Reduction(PointFile file, const Vec3& place, ReduceTest fails, std::uint64_t effort)
    : file_(std::move(file)),
      fails_(std::move(fails)),
      left_(effort),
      kept_(file_.position.size()) {
    std::iota(kept_.begin(), kept_.end(), Index{0});
    const auto distanceSq = [&](Index p) {
        const Vec3 d = file_.position[p] - place;
        return glm::dot(d, d);
    };
    std::stable_sort(kept_.begin(), kept_.end(),
                     [&](Index a, Index b) { return distanceSq(a) < distanceSq(b); });
}

bool Reduction::advance() {
    switch (step_) {
        case Step::Whole:
            tryWhole();
            break;
        case Step::Ball:
            tryBall();
            break;
        case Step::Pieces:
            tryPiece();
            break;
        case Step::Done:
            break;
    }
    if (exhausted_) step_ = Step::Done;
    return step_ != Step::Done;
}

double Reduction::share() const {
    if (file_.position.empty()) return 1.0;
    return 1.0 - std::log1p(static_cast<double>(kept_.size())) /
                     std::log1p(static_cast<double>(file_.position.size()));
}

Result<Reduced> Reduction::result() const {
    if (!failed_) return Error{"The whole input does not fail so."};
    std::vector<Index> kept = kept_;
    std::sort(kept.begin(), kept.end());
    PointFile points = subset(kept);
    return Reduced{std::move(points), std::move(kept), tries_, !exhausted_};
}

PointFile Reduction::subset(const std::vector<Index>& points) const {
    std::vector<bool> isKept(file_.position.size(), false);
    for (const Index p : points) isKept[p] = true;
    std::vector<Index> others;
    for (Index p = 0; p < isKept.size(); ++p) {
        if (!isKept[p]) others.push_back(p);
    }
    return applyFixes(file_, others).file;
}

bool Reduction::stillFails(const std::vector<Index>& points) {
    if (points.empty()) return false;
    // The first try is always made.
    exhausted_ = tries_ > 0 && left_ == 0;
    if (exhausted_) return false;
    ++tries_;
    const ReduceTry made = fails_(subset(points));
    left_ -= std::min(left_, made.work);
    return made.fails;
}

void Reduction::tryWhole() {
    failed_ = stillFails(kept_);
    step_ = failed_ ? Step::Ball : Step::Done;
}

/// The smallest ball, by factors of the fourth root of two, whose points fail alone.
void Reduction::tryBall() {
    constexpr double kGrowth = 1.189207115002721;
    const auto count = static_cast<std::size_t>(ball_);
    const bool all = count >= kept_.size();
    if (!all) {
        std::vector<Index> ball(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(count));
        if (!stillFails(ball)) {
            ball_ *= kGrowth;
            return;
        }
        kept_ = std::move(ball);
    }
    step_ = Step::Pieces;
    piece_ = std::max<std::size_t>(kept_.size() / 2, 1);
    end_ = kept_.size();
}

/// A piece of half the points, a quarter, ... down to single ones, from the far end, until none can
/// be removed.
void Reduction::tryPiece() {
    const std::size_t begin = end_ > piece_ ? end_ - piece_ : 0;
    std::vector<Index> rest = kept_;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(begin),
               rest.begin() + static_cast<std::ptrdiff_t>(end_));
    if (stillFails(rest)) {
        kept_ = std::move(rest);
        changed_ = true;
    }
    end_ = begin;
    if (end_ > 0) return;
    if (piece_ == 1 && !changed_) step_ = Step::Done;
    piece_ = std::max<std::size_t>(piece_ / 2, 1);
    end_ = kept_.size();
    changed_ = false;
}

Result<Reduced> reduceInput(const PointFile& file, const Vec3& place, const ReduceTest& fails,
                            std::uint64_t effort, const Progress& progress) {
    Reduction reduction(file, place, fails, effort);
    do {
        if (progress && !progress(reduction.share())) return Error{"Cancelled."};
    } while (reduction.advance());
    return reduction.result();
}

ReduceTest failsAlike(const RunSpec& spec, const Params& params, const PointSet& points,
                      const MeshFailure& failure, std::span<const Triangle> mesh) {
    const bool backToBack = isBackToBack(failure, mesh);
    return [spec, params, backToBack, kind = failure.kind, loop = isLoop(failure),
            places = placesOf(points, failure)](const PointFile& file) -> ReduceTry {
        const ReduceTry impossible{false, file.position.size()};
        const Result<PrepareOptions> options = prepareOptionsOf(spec, params, file);
        if (!options) return impossible;
        const Result<Prepared> prepared = prepare(file, options.value());
        if (!prepared) return impossible;
        const PointSet& left = prepared.value().points;
        const State end = reconstruct(left, params).state;
        const MeshInspection found = inspectWithTotals(left, end.mesh());
        const std::vector<MeshFailure>& all = found.failures;
        const bool still = std::any_of(all.begin(), all.end(), [&](const MeshFailure& each) {
            return each.kind == kind && backToBack == isBackToBack(each, end.mesh()) &&
                   (!loop || placesOf(left, each) == places);
        });
        return {still, workOf(left, end, found)};
    };
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
