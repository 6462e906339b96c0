/// One run with a heap of the best: of every test with a number the least margin is kept per point,
/// and the moves that would invert the best decisions are computed only for those that enter the
/// heap. O(run).
#include "spiraling_edge/explain/nearest_decisions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spiraling_edge/explain/flipping_move.h"
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

    NearestDecisions take() {
        std::sort_heap(heap_.begin(), heap_.end(), better);
        NearestDecisions result{{}, std::move(least_)};
        for (const Entry& entry : heap_) result.decisions.push_back(entry.decision);
        return result;
    }

  private:
    struct Entry {
        NearestDecision decision;
        std::uint64_t number;  ///< In the order of the run.
    };
    static bool better(const Entry& a, const Entry& b) {
        const double x = std::abs(a.decision.reading.margin);
        const double y = std::abs(b.decision.reading.margin);
        return x < y || (x == y && a.number < b.number);
    }

    void consider(const NearestDecision& decision, Index first, Index last) {
        Entry entry{decision, number_++};
        if (heap_.size() == count_ && (count_ == 0 || !better(entry, heap_.front()))) return;
        const FlippingMoveContext context{points_, params_, entry.decision.pivot, first, last};
        const auto move = flippingMoveOf(entry.decision.event, context);
        if (!move) return;
        entry.decision.move = *move;
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

Result<NearestDecisions> nearestDecisions(const PointSet& points, const Params& params,
                                          std::size_t count, const Progress& progress) {
    Shortlist list(points, params, count);
    const auto end = scanRun(
        points, params, [&](const ScannedPivot& pivot) { list.add(pivot); }, progress);
    if (!end) return Error{"Cancelled."};
    return list.take();
}

}  // namespace se
