/// One run with a heap of the best: of every test with a number the least margin is kept per point,
/// and the moves that would invert the best decisions are computed only for those that enter the
/// heap. O(run).
#include "spiraling_edge/explain/closest_calls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spiraling_edge/explain/nudge.h"
#include "spiraling_edge/replay/scan_run.h"

namespace se {
namespace {

/// The best calls so far, as a heap whose top is the worst of them.
class Shortlist {
  public:
    Shortlist(const PointSet& points, const Params& params, std::size_t count)
        : points_(points),
          params_(params),
          count_(count),
          least_(points.size(), std::numeric_limits<double>::infinity()) {}

    void add(const ScannedPivot& pivot) {
        Index first = kNone;
        Index last = kNone;
        for (const Event& event : pivot.events) {
            if (const auto* p = std::get_if<PivotEvidence>(&event.evidence)) {
                first = p->first;
                last = p->last;
            }
            const auto reading = readingOf(event, {points_, params_, pivot.point});
            if (!reading) continue;
            if (const Index p = testedPoint(event); p != kNone)
                least_[p] = std::min(least_[p], std::abs(reading->margin));
            consider({event, pivot.point, *reading, {}}, first, last);
        }
    }

    ClosestCalls take() {
        std::sort_heap(heap_.begin(), heap_.end(), better);
        ClosestCalls result{{}, std::move(least_)};
        for (const Entry& entry : heap_) result.calls.push_back(entry.call);
        return result;
    }

  private:
    struct Entry {
        ClosestCall call;
        std::uint64_t number;  ///< In the order of the run.
    };
    static bool better(const Entry& a, const Entry& b) {
        const double x = std::abs(a.call.reading.margin);
        const double y = std::abs(b.call.reading.margin);
        return x < y || (x == y && a.number < b.number);
    }

    void consider(const ClosestCall& call, Index first, Index last) {
        Entry entry{call, number_++};
        if (heap_.size() == count_ && (count_ == 0 || !better(entry, heap_.front()))) return;
        const NudgeContext context{points_, params_, entry.call.pivot, first, last};
        const auto nudge = nudgeOf(entry.call.event, context);
        if (!nudge) return;
        entry.call.nudge = *nudge;
        if (heap_.size() == count_) {
            std::pop_heap(heap_.begin(), heap_.end(), better);
            heap_.pop_back();
        }
        heap_.push_back(entry);
        std::push_heap(heap_.begin(), heap_.end(), better);
    }

    const PointSet& points_;
    const Params& params_;
    std::size_t count_;
    std::vector<double> least_;
    std::vector<Entry> heap_;
    std::uint64_t number_ = 0;
};

}  // namespace

Result<ClosestCalls> closestCalls(const PointSet& points, const Params& params, std::size_t count,
                                  const Progress& progress) {
    Shortlist list(points, params, count);
    const auto end = scanRun(
        points, params, [&](const ScannedPivot& pivot) { list.add(pivot); }, progress);
    if (!end) return Error{"Cancelled."};
    return list.take();
}

}  // namespace se
