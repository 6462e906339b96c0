/// Follows failures through a second run. Events are passed only to the failures at their points,
/// and the number of events per point, counted in the first run, decides beforehand how many
/// failures can be followed within the work limit.
#include "spiraling_edge/why/failure_moments.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/why/inspected_run.h"
#include "spiraling_edge/why/moment_finder.h"
#include "spiraling_edge/why/origin_decisions.h"

namespace se {
namespace {

/// Calls `visit` with the points that an event in the pivot of `pivot` is about; it may name one of
/// them twice.
template <typename Visit>
void forEachPointOf(const Event& event, Index pivot, const Visit& visit) {
    const auto visitAll = [&](std::initializer_list<Index> points) {
        for (const Index p : points)
            if (p != kNone) visit(p);
    };
    visitAll({testedPoint(event), pivot});
    if (const auto* seed = as<SeedEvidence>(event)) visitAll({seed->first, seed->second});
    if (const auto* flip = as<FlipEvidence>(event)) visitAll({flip->x, flip->y});
    if (const auto* hole = as<CloseHoleEvidence>(event)) visitAll({hole->first, hole->second});
    if (const auto* remesh = as<RemeshEvidence>(event))
        visitAll({remesh->faulty.a, remesh->faulty.b, remesh->faulty.c});
    if (const auto* sphere = as<SphereEvidence>(event)) visitAll({sphere->t, sphere->s});
    if (const auto* emit = as<EmitEvidence>(event))
        visitAll({emit->corners.a, emit->corners.b, emit->corners.c});
}

/// The finders of several failures, called only with events at their points.
class Finders {
  public:
    Finders(const PointSet& points, const Params& params, const std::vector<Triangle>& mesh,
            std::span<const MeshFailure> failures)
        : input_{points, params, mesh, moves_, tests_},
          failures_(failures),
          at_(points.size()),
          asked_(failures.size(), 0) {
        finders_.reserve(failures.size());
        for (std::size_t i = 0; i < failures.size(); ++i) {
            finders_.emplace_back(input_, failures[i]);
            for (const Index p : finders_[i].watched()) at_[p].push_back(i);
        }
    }

    void add(const SweptPivot& pivot) {
        moves_.clear();
        for (const Event& event : pivot.events) {
            ++event_;
            concerned_.clear();
            const auto* limit = as<LimitEvidence>(event);
            if (limit != nullptr && limit->moves())
                moves_.push_back(lineOf(event, {input_.points, input_.params, pivot.point}));
            gather(event, pivot.point);
            const auto freed = rings_.add(event);
            if (concerned_.empty() && !freed) continue;
            const auto line = sharedLine(event, pivot.point);
            addTest(*line, tests_);
            for (const std::size_t i : concerned_) finders_[i].add(line);
            if (freed) addFreed(*freed, pivot.point);
        }
    }

    const std::vector<MomentFinder>& all() const { return finders_; }

  private:
    SharedLine sharedLine(const Event& event, Index pivot) const {
        return std::make_shared<const LedgerLine>(
            lineOf(event, {input_.points, input_.params, pivot}));
    }
    void gather(const Event& event, Index pivot) {
        forEachPointOf(event, pivot, [&](Index p) {
            for (const std::size_t i : at_[p]) {
                if (asked_[i] != event_) concerned_.push_back(i);
                asked_[i] = event_;
            }
        });
    }
    void addFreed(const FreedRing& ring, Index pivot) {
        for (const std::size_t i : at_[ring.points.front()]) {
            if (failures_[i].kind->find != nullptr || failures_[i].points != ring.points) continue;
            finders_[i].addFreed(sharedLine(ring.event, pivot));
        }
    }

    std::vector<LedgerLine> moves_;
    std::vector<LedgerLine> tests_;
    FinderInput input_;
    std::span<const MeshFailure> failures_;
    std::vector<std::vector<std::size_t>> at_;  ///< Per point: the failures there.
    std::vector<std::uint64_t> asked_;          ///< Per failure: the last event passed to it.
    std::uint64_t event_ = 0;
    std::vector<MomentFinder> finders_;
    std::vector<std::size_t> concerned_;
    FreedRings rings_;
};

/// Positions in run.failures of those that can be followed within the work `left`, ascending;
/// lowers the numbers listed in run.totals to them. The work of following a failure is the number
/// of events of the run at its points, `eventsAt` each point. The first ones of each class are
/// taken: all firsts, then all seconds, until the next of its class exceeds the work. Requires
/// failures in the order of their classes.
std::vector<std::size_t> affordableOf(const PointSet& points, const Params& params,
                                      const std::vector<std::uint64_t>& eventsAt,
                                      std::uint64_t left, InspectedRun& run) {
    assert(std::is_sorted(run.failures.begin(), run.failures.end(), isOfEarlierClass));
    const std::vector<LedgerLine> none;
    const FinderInput input{points, params, run.mesh, none, none};
    std::vector<std::uint64_t> work;
    work.reserve(run.failures.size());
    std::uint64_t all = 0;
    for (const MeshFailure& each : run.failures) {
        const MomentFinder finder(input, each);
        work.push_back(0);
        for (const Index p : finder.watched()) work.back() += eventsAt[p];
        all += work.back();
    }
    std::vector<std::size_t> chosen(run.failures.size());
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    if (all <= left) return chosen;
    std::vector<std::size_t> first;  // of each class
    std::size_t before = 0;
    for (const ClassTotal& each : run.totals) {
        first.push_back(before);
        before += each.listed;
    }
    std::vector<std::size_t> kept(run.totals.size(), 0);
    for (bool more = true; more;) {
        more = false;
        for (std::size_t c = 0; c < kept.size(); ++c) {
            ClassTotal& total = run.totals[c];
            if (kept[c] == total.listed) continue;
            const std::uint64_t next = work[first[c] + kept[c]];
            if (kept[c] > 0 && next > left) {
                total.listed = kept[c];
                continue;
            }
            left -= std::min(left, next);
            ++kept[c];
            more = true;
        }
    }
    chosen.clear();
    for (std::size_t c = 0; c < kept.size(); ++c) {
        for (std::size_t i = 0; i < kept[c]; ++i) chosen.push_back(first[c] + i);
    }
    return chosen;
}

/// The moments that the finders have found. Triangles that fill a gap between three points are
/// traced back to the decision that made the last of their edges. Nothing if cancelled.
std::optional<std::vector<std::optional<FailureMoments>>> tracedBack(
    const PointSet& points, const Params& params, const std::vector<MomentFinder>& finders,
    const Progress& progress) {
    std::vector<std::optional<FailureMoments>> found;
    found.reserve(finders.size());
    std::vector<Index> alone;
    for (const MomentFinder& each : finders) {
        found.push_back(each.found());
        if (each.alone() != kNone) alone.push_back(each.alone());
    }
    if (alone.empty()) return found;
    const auto origins = originDecisions(points, params, alone, progress);
    if (!origins) return {};
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto origin = origins->find(finders[i].alone());
        if (found[i] && origin != origins->end()) found[i]->decided = origin->second;
    }
    return found;
}

/// The moments of all `failures` in one pass through the run; nothing for a failure that is not one
/// of this run. Fails if cancelled. O(run + events about their points).
Result<std::vector<std::optional<FailureMoments>>> momentsOfAll(
    const PointSet& points, const Params& params, std::span<const MeshFailure> failures,
    const std::vector<Triangle>& mesh, const Progress& progress) {
    if (failures.empty()) return std::vector<std::optional<FailureMoments>>{};
    Finders finders(points, params, mesh, failures);
    const auto end = sweep(
        points, params, [&](const SweptPivot& pivot) { finders.add(pivot); },
        partOf(progress, 0.0, 0.6));
    if (!end) return Error{"Cancelled."};
    auto found = tracedBack(points, params, finders.all(), partOf(progress, 0.6, 1.0));
    if (!found) return Error{"Cancelled."};
    return std::move(*found);
}

bool wasStopped(const InspectedRun& run) {
    return run.totalOf(*findFailureClass("triangle_cap")).total > 0;
}

/// Places and verdict of `found.all`, which come from `run`.
void judge(const PointSet& points, InspectedRun& run, RunFailureSearch& found) {
    found.places = faultPlaces(points, found.all, run.meanEdge);
    run.failures = std::move(found.all);
    found.verdict = verdictOn(points, run.mesh, run, found.places);
    found.verdict.stopped = wasStopped(run);
    found.all = std::move(run.failures);
}

/// The failures of an inspected run, with the moments of those that can be followed.
Result<RunFailureSearch> searchIn(const PointSet& points, const Params& params,
                                  const RunCounts& counts, InspectedRun& run,
                                  const Progress& progress) {
    const std::vector<std::size_t> chosen =
        affordableOf(points, params, counts.eventsAt(), counts.affordable(), run);
    std::vector<MeshFailure> followed;
    followed.reserve(chosen.size());
    for (const std::size_t i : chosen) followed.push_back(run.failures[i]);
    const auto moments =
        momentsOfAll(points, params, followed, run.mesh, partOf(progress, 0.2, 1.0));
    if (!moments) return moments.error();
    const bool stopped = wasStopped(run);
    RunFailureSearch found;
    found.failures.reserve(chosen.size());
    found.all.reserve(run.failures.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < run.failures.size(); ++i) {
        MeshFailure& failure = run.failures[i];
        const bool isFollowed = next < chosen.size() && chosen[next] == i;
        const std::optional<FailureMoments>* its = isFollowed ? &moments.value()[next++] : nullptr;
        if (its != nullptr && !*its) {
            ClassTotal& total = run.totals[rankOf(*failure.kind)];
            --total.listed;
            if (stopped) {
                // Not a failure of this run: not counted.
                --total.total;
                continue;
            }
        } else if (its != nullptr) {
            std::vector<Triangle> corners;
            corners.reserve(failure.triangles.size());
            for (const Index number : failure.triangles) corners.push_back(run.mesh[number]);
            found.failures.push_back({failure, found.all.size(), std::move(corners), **its});
        }
        found.all.push_back(std::move(failure));
    }
    judge(points, run, found);
    return found;
}

}  // namespace

void RunCounts::add(const SweptPivot& pivot) {
    events_ += pivot.events.size();
    for (const Event& event : pivot.events)
        forEachPointOf(event, pivot.point, [&](Index p) { ++eventsAt_[p]; });
    leftOver_.add(points_, pivot.events);
}

Result<RunFailureSearch> searchFailures(const PointSet& points, const Params& params,
                                        const Progress& progress) {
    RunCounts counts(points);
    std::optional<State> end = sweep(
        points, params, [&](const SweptPivot& pivot) { counts.add(pivot); },
        partOf(progress, 0.0, 0.4));
    if (!end) return Error{"Cancelled."};
    return searchFailures(points, params, counts, takeMesh(std::move(*end)),
                          partOf(progress, 0.4, 1.0));
}

Result<RunFailureSearch> searchFailures(const PointSet& points, const Params& params,
                                        const RunCounts& counts, std::vector<Triangle> mesh,
                                        const Progress& progress) {
    InspectedRun run = inspectEnd(points, std::move(mesh), counts.leftOver());
    return searchIn(points, params, counts, run, progress);
}

RunFailureSearch failuresAtEnd(const PointSet& points, const RunCounts& counts,
                               std::vector<Triangle> mesh) {
    InspectedRun run = inspectEnd(points, std::move(mesh), counts.leftOver());
    if (wasStopped(run)) {
        // What the run did not reach is no failure of it.
        const FailureClass& lost = *findFailureClass("lost_points");
        run.totals[rankOf(lost)].total -= std::erase_if(run.failures, [&](const MeshFailure& each) {
            return each.kind == &lost && counts.eventsAt()[each.points.front()] == 0;
        });
    }
    for (ClassTotal& each : run.totals) each.listed = 0;
    RunFailureSearch found;
    found.all = std::move(run.failures);
    judge(points, run, found);
    return found;
}

Result<std::vector<RunFailure>> failuresOfRun(const PointSet& points, const Params& params,
                                              const Progress& progress) {
    Result<RunFailureSearch> found = searchFailures(points, params, progress);
    if (!found) return found.error();
    return std::move(found.value().failures);
}

}  // namespace se
