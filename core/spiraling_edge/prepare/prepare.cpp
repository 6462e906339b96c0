/// The order of the derivations: usable points, strays, normals, their sides, types, lists, noise,
/// rims. Each piece is derived only if absent or requested, and timed.
#include "spiraling_edge/prepare/prepare.h"

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "spiraling_edge/base/stop_watch.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/given_normals.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/prepare/noise.h"
#include "spiraling_edge/prepare/normals.h"
#include "spiraling_edge/prepare/orientation.h"
#include "spiraling_edge/prepare/rim.h"
#include "spiraling_edge/prepare/strays.h"

namespace se {
namespace {

/// Turns one PointFile into one PointSet.
class Preparation {
  public:
    Preparation(const PointFile& file, const PrepareOptions& options, const Progress& progress)
        : file_(file), options_(options), progress_(progress) {}

    Result<Prepared> run() {
        if (Status status = checkColumns(file_); !status) return status.error();
        set_.position = file_.position;
        takeTypes();
        setAsideUnusable();
        if (Status status = checkSize(); !status) return status.error();
        if (Status status = takeStraysAside(); !status) return status.error();
        derives_ = options_.normals == NormalSource::Derived || lacksNormals(file_.normal, usable_);
        if (Status status = makeNormals(); !status) return status.error();
        Result<NeighborLists> lists = makeLists();
        if (!lists) return lists.error();
        if (options_.neighbors.symmetric) {
            lists = symmetricLists(set_.position, lists.value(), options_.neighbors.threads,
                                   upTo(0.5 * (1.0 + done_)));
        }
        if (!lists) return lists.error();
        set_.neighbors = std::move(lists.value());
        if (Status status = takeRim(); !status) return status.error();
        assert(validate(set_).ok());
        if (progress_) progress_(1.0);
        return std::move(prepared_);
    }

  private:
    /// Fails if most points lie where squares of distances are beyond the range of double, or are
    /// zero in it. A few are far from all others, and left over.
    Status checkSize() const {
        std::size_t present = 0;
        std::size_t tooFar = 0;
        std::size_t tooNear = 0;
        for (std::size_t p = 0; p < usable_.size(); ++p) {
            if (!usable_[p]) continue;
            const Vec3 x = glm::abs(set_.position[p]);
            ++present;
            const double greatest = std::max({x.x, x.y, x.z});
            tooFar += greatest > kGreatestCoordinate ? 1U : 0U;
            tooNear += greatest > 0.0 && greatest < kLeastCoordinate ? 1U : 0U;
        }
        if (2 * tooFar > present) {
            return Error{
                "coordinates are too large: beyond 1e152, squares of distances are no numbers of "
                "double precision; scale the points"};
        }
        if (2 * tooNear > present) {
            return Error{
                "coordinates are too small: below 1e-162, squares of distances are zero in double "
                "precision; scale the points (--scale-by 1e200,1e200,1e200)"};
        }
        return success();
    }

    void takeTypes() {
        StopWatch watch;
        if (options_.walls) {
            set_.type = wallTypes(file_.position, *options_.walls);
            report_.derived.types = true;
            report_.derived.typeSeconds = watch.lap();
            return;
        }
        set_.type.assign(file_.position.size(), kInterior);
        std::transform(file_.type.begin(), file_.type.end(), set_.type.begin(), withCornerBit);
    }

    /// Takes the rim points, found or given.
    Status takeRim() {
        if (!options_.rim) return takeGivenRim();
        StopWatch watch;
        DerivedPieces& derived = report_.derived;
        for (std::uint8_t& type : set_.type) {
            if (!isRimPoint(type)) continue;
            type = kInterior;
            derived.rim = true;
        }
        Result<Rim> rim = findRim(set_.position, set_.normal, set_.neighbors, set_.type,
                                  options_.neighbors.threads, upTo(1.0));
        if (!rim) return rim.error();
        derived.rimPoints = rim.value().points();
        derived.rim = derived.rim || derived.rimPoints > 0;
        derived.rimChains = rim.value().chains.size();
        if (derived.rimPoints > 0) set_.rim = std::move(rim.value().gap);
        for (Index p = 0; p < set_.rim.size(); ++p) {
            if (set_.rim[p].known()) set_.type[p] = kRimPoint;
        }
        derived.rimSeconds = watch.lap();
        return success();
    }

    Status takeGivenRim() {
        if (std::none_of(set_.type.begin(), set_.type.end(), isRimPoint)) return success();
        auto gaps = gapsOfRimPoints(set_.position, set_.normal, set_.neighbors, set_.type,
                                    options_.neighbors.threads, upTo(1.0));
        if (!gaps) return gaps.error();
        set_.rim = std::move(gaps.value());
        return success();
    }

    /// Sets aside points from which nothing can be derived, and those to leave out.
    void setAsideUnusable() {
        set_.aside.assign(set_.size(), Aside::No);
        usable_.assign(set_.size(), true);
        placed_ = placedPoints(set_.position, file_.farValues);
        for (Index p = 0; p < set_.size(); ++p) {
            if (placed_.aside[p] != Aside::No) setAside(p, placed_.aside[p]);
        }
        for (const Index p : options_.leaveOut) {
            assert(p < usable_.size());
            if (usable_[p]) setAside(p, Aside::LeftOut);
        }
    }
    /// Sets aside a point that was usable.
    void setAside(Index p, Aside reason) {
        usable_[p] = false;
        set_.aside[p] = reason;
        ++report_.aside[static_cast<std::size_t>(reason)];
    }

    /// Sets strays aside, by positions alone: no normal is derived from them.
    Status takeStraysAside() {
        if (!options_.setStraysAside) return success();
        Result<NeighborLists> nearest = findNearest(kNearestOfStrays, upTo(kStraysDone));
        if (!nearest) return nearest.error();
        const std::vector<bool> stray =
            strayPoints(set_.position, usable_, nearest.value(), options_.neighbors.threads);
        for (Index p = 0; p < set_.size(); ++p) {
            if (stray[p]) setAside(p, Aside::Stray);
        }
        if (report_.count(Aside::Stray) == 0) nearest_ = std::move(nearest.value());
        return success();
    }

    /// The normals of the file, of unit length, with those that have no direction completed.
    Status takeGivenNormals() {
        set_.normal = file_.normal;
        for (Index p = 0; p < set_.size(); ++p) {
            if (usable_[p] && !hasDirection(file_.normal[p])) ++report_.derived.completedNormals;
        }
        if (report_.derived.completedNormals > 0) {
            Result<std::vector<Vec3>> all =
                completeNormals(file_, usable_, options_.neighbors.threads, upTo(kNearestDone));
            if (!all) return all.error();
            set_.normal = std::move(all.value());
        }
        report_.averagedNormals = averageOverCopies(placed_, set_.normal);
        for (Index p = 0; p < set_.size(); ++p) {
            if (isFinite(set_.position[p]) && scaleToUnit(set_.normal[p]))
                ++report_.unscaledNormals;
        }
        setAsidePlaneless();
        report_.derived.completedNormals -= report_.count(Aside::NoNormal);
        return success();
    }

    Status makeNormals() {
        if (!derives_) {
            if (Status status = takeGivenNormals(); !status) return status;
            if (options_.normals == NormalSource::AsGiven) return success();
        }
        StopWatch watch;
        Result<NeighborLists> lists = listsForNormals();
        if (!lists) return lists.error();
        const OrderedPoints points(set_.position, std::move(lists.value()));
        DerivedPieces& derived = report_.derived;
        std::vector<Vec3> normal;
        if (derives_) {
            Result<std::vector<Vec3>> planes = estimateNormals(
                points.position(), points.lists(), options_.neighbors.threads, upTo(kPlanesDone));
            if (!planes) return planes.error();
            normal = std::move(planes.value());
            derived.normals = true;
            derived.normalSeconds = watch.lap();
        } else {
            normal = points.renumbered(normalsWithoutStrays());
        }
        const OrientationOptions sides{derives_ ? UnknownSide::ByVote : UnknownSide::AsMost,
                                       options_.scanner, file_.viewpoint,
                                       options_.neighbors.threads};
        const Result<OrientationReport> oriented =
            orientNormals(points, normal, sides, upTo(kNormalsDone));
        if (!oriented) return oriented.error();
        takeNormals(points.restored(std::move(normal)));
        if (derives_) setAsidePlaneless();
        const OrientationReport& turned = oriented.value();
        derived.orientation = true;
        derived.turnedNormals = derives_ ? 0 : turned.turned;
        derived.normalComponents = turned.components;
        derived.unknownSides = turned.unknownSides;
        derived.orientationSeconds = watch.lap();
        return success();
    }

    /// The normals, zero at strays, which are no components of the surface.
    std::vector<Vec3> normalsWithoutStrays() const {
        std::vector<Vec3> normal = set_.normal;
        for (Index p = 0; p < set_.size(); ++p) {
            if (set_.aside[p] == Aside::Stray) normal[p] = Vec3(0.0);
        }
        return normal;
    }
    /// Takes these normals; strays keep their own.
    void takeNormals(std::vector<Vec3> normal) {
        for (Index p = 0; p < set_.size() && !derives_; ++p) {
            if (set_.aside[p] == Aside::Stray) normal[p] = set_.normal[p];
        }
        set_.normal = std::move(normal);
    }

    /// The nearest points for planes, those of the search for strays where they are the same.
    Result<NeighborLists> listsForNormals() {
        if (derives_ && nearest_ && options_.planeNeighbors == kNearestOfStrays)
            return std::move(*std::exchange(nearest_, std::nullopt));
        return findNearest(options_.planeNeighbors, upTo(kNearestDone));
    }

    /// The `count` nearest points of each, with any normals.
    Result<NeighborLists> findNearest(std::size_t count, const Progress& progress) const {
        return nearestPoints(set_.position, usable_, count, options_.neighbors.threads, progress);
    }

    void setAsidePlaneless() {
        for (Index p = 0; p < set_.size(); ++p) {
            if (usable_[p] && set_.normal[p] == Vec3(0.0)) setAside(p, Aside::NoNormal);
        }
    }

    /// Progress of a part of the work, from the share done so far to `share` of the whole.
    Progress upTo(double share) {
        const double from = std::exchange(done_, share);
        if (!progress_) return {};
        return [this, from, share](double own) { return progress_(from + (share - from) * own); };
    }
    /// Checks for cancellation between parts of the work without progress.
    Status reportProgress() const {
        if (!progress_ || progress_(done_)) return success();
        return Error{"preparing the points was cancelled"};
    }

    Result<NeighborLists> makeLists() {
        const NeighborOptions& neighbors = options_.neighbors;
        if (file_.hasNeighbors() && !neighbors.recompute) return cleanLists();
        report_.neighborsComputed = true;
        StopWatch watch;
        const double listsDone =
            options_.setNoiseAside ? 0.5 * (listsShare() + done_) : listsShare();
        Result<NeighborLists> lists =
            findNeighbors(set_.position, set_.normal, usable_, neighbors, upTo(listsDone));
        if (lists && options_.setNoiseAside) lists = withoutNoise(std::move(lists));
        report_.derived.neighborSeconds = watch.lap();
        return lists;
    }

    /// The lists without the points that noise scatters over and under the others. If the noise
    /// remains, the points are no surface, or one that bends as much as it is noisy: all points
    /// stay.
    Result<NeighborLists> withoutNoise(Result<NeighborLists> all) {
        const auto noiseOf = [&](const Result<NeighborLists>& lists, Sheets sheets) {
            return noiseAlongNormals(set_.position, set_.normal, lists.value(), sheets,
                                     options_.neighbors.threads);
        };
        report_.noise = noiseOf(all, Sheets::Apart);
        // With fewer points than a patch takes, heights are the shape, as of a tetrahedron.
        const auto points = std::count(usable_.begin(), usable_.end(), true);
        if (report_.noise <= kNoisy || points <= static_cast<std::ptrdiff_t>(kNoisePatch))
            return all;
        const std::vector<bool> usable = usable_;
        const std::vector<Vec3> normal = set_.normal;
        if (Status status = thinOut(); !status) return status.error();
        Result<NeighborLists> lists = findNeighbors(set_.position, set_.normal, usable_,
                                                    options_.neighbors, upTo(listsShare()));
        if (!lists) return lists;
        // Of what is left one sheet is expected: front and back of a few points are none.
        if (noiseOf(lists, Sheets::One) > kNoisy) {
            usable_ = usable;
            set_.normal = normal;
            return all;
        }
        for (Index p = 0; p < set_.size(); ++p) {
            if (usable[p] && !usable_[p]) setAside(p, Aside::Noise);
        }
        return lists;
    }

    /// Sets points aside until none lies over another; the rest get the normals of their patches.
    Status thinOut() {
        NeighborOptions wide = options_.neighbors;
        wide.reach = KNearest{kNoisePatch};
        // By all rules the same points, as for the judge: normals of noise differ by any angle.
        wide.opposingCosine = kRightAngle;
        // The number of searches is not known: each takes a third of the remaining share.
        const auto search = [&] {
            return findNeighbors(set_.position, set_.normal, usable_, wide,
                                 upTo(done_ + (listsShare() - done_) / 3.0));
        };
        Result<NeighborLists> lists = search();
        if (!lists) return lists.error();
        const auto patches = noisePatches(set_.position, set_.normal, lists.value(), usable_,
                                          options_.neighbors.threads);
        if (Status status = reportProgress(); !status) return status;
        while (setNoiseAside(set_.position, patches, lists.value(), usable_) > 0) {
            lists = search();
            if (!lists) return lists.error();
        }
        for (Index p = 0; p < set_.size(); ++p) {
            if (usable_[p]) set_.normal[p] = patches[p].normal;
        }
        return reportProgress();
    }

    Result<NeighborLists> cleanLists() {
        const auto n = static_cast<Index>(set_.size());
        std::vector<std::size_t> agreeing(n, 0);
        for (Index p = 0; p < n; ++p) {
            for (const Index q : file_.neighbors[p]) {
                if (q >= n) {
                    return Error{"the neighbor list of point " + std::to_string(p) +
                                 " names point " + std::to_string(q) + ", but there are " +
                                 std::to_string(n) + " points; correct the list or leave it out"};
                }
                if (mayNeighbor(p, q) && !isLeftOut(p, q)) ++agreeing[p];
            }
        }
        NeighborLists lists;
        lists.offset.reserve(std::size_t{n} + 1);
        std::vector<Index> kept;
        for (Index p = 0; p < n; ++p) {
            kept.clear();
            for (const Index q : file_.neighbors[p]) {
                const bool areShort = agreeing[p] < kGoRound && agreeing[q] < kGoRound;
                if (mayNeighbor(p, q) && (areShort || !isLeftOut(p, q))) kept.push_back(q);
            }
            sortNearestFirst(set_.position, p, kept);
            lists.append(kept);
            report_.droppedListEntries += file_.neighbors[p].size() - kept.size();
        }
        return lists;
    }

    /// Points at distance zero are not usable, so they need no test of their own.
    bool mayNeighbor(Index p, Index q) const { return q != p && usable_[p] && usable_[q]; }
    bool isLeftOut(Index p, Index q) const {
        return options_.neighbors.dropOpposingNormals &&
               normalsOppose(set_.normal[p], set_.normal[q], options_.neighbors.opposingCosine);
    }

    /// Share of the whole work up to the lists: rims and symmetric lists follow.
    double listsShare() const {
        const bool rims =
            options_.rim || std::any_of(set_.type.begin(), set_.type.end(), isRimPoint);
        return (rims ? 0.65 : 1.0) * (options_.neighbors.symmetric ? 0.85 : 1.0);
    }

    /// Length of the lists that strayPoints() asks for.
    static constexpr std::size_t kNearestOfStrays = 12;
    /// Shares of the whole work when normals are derived.
    static constexpr double kStraysDone = 0.15;
    static constexpr double kNearestDone = 0.3;
    static constexpr double kPlanesDone = 0.35;
    static constexpr double kNormalsDone = 0.5;

    const PointFile& file_;
    const PrepareOptions& options_;
    const Progress& progress_;
    Prepared prepared_;
    PointSet& set_ = prepared_.points;
    PrepareReport& report_ = prepared_.report;
    PlacedPoints placed_;
    std::vector<bool> usable_;
    std::optional<NeighborLists> nearest_;  ///< Of all usable points, where no stray is among them.
    bool derives_ = false;                  ///< All normals are derived.
    double done_ = 0.0;                     ///< Share of the whole work.
};

}  // namespace

std::size_t PrepareReport::countAside() const {
    return std::accumulate(aside.begin(), aside.end(), std::size_t{0});
}

std::string unknownSidesText(std::size_t unknown, std::size_t parts) {
    std::string text = "which side faces out is unknown";
    if (parts > 1)
        text += " for " + std::to_string(unknown) + " of " + std::to_string(parts) + " parts";
    return text;
}

Result<Prepared> prepare(const PointFile& file, const PrepareOptions& options,
                         const Progress& progress) {
    if (const Status status = checkReach(options.neighbors); !status) return status.error();
    if (options.scanner && !isFinite(*options.scanner))
        return Error{"the position of the scanner must be three finite numbers"};
    return Preparation(file, options, progress).run();
}

void storeDerived(const PointSet& points, const PrepareReport& report, PointFile& file) {
    const DerivedPieces& derived = report.derived;
    if (derived.normals || derived.orientation || report.count(Aside::Noise) > 0)
        file.normal = points.normal;
    for (std::size_t p = 0; p < file.normal.size(); ++p) {
        if (derived.completedNormals > 0 && !hasDirection(file.normal[p]))
            file.normal[p] = points.normal[p];
    }
    if (derived.normals) file.normalType = file.positionType;
    if (derived.types || derived.rim) file.type = points.type;
}

PointFile fileOf(const PointSet& points) {
    PointFile file;
    file.position = points.position;
    file.normal = points.normal;
    file.positionType = file.normalType = ScalarType::Double;
    file.type = points.type;
    file.neighbors = points.neighbors;
    return file;
}

}  // namespace se
