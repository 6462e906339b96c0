#include "pivot_neighborhood.h"

#include <algorithm>

namespace se::view {

namespace {

class Collector {
  public:
    void add(Index point) {
        if (point == kNone) return;
        if (std::find(points_.begin(), points_.end(), point) == points_.end()) {
            points_.push_back(point);
        }
    }
    std::vector<Index> take() { return std::move(points_); }

    // Points that an event names beside its subject.
    void addOf(const ReciprocalEvidence& e) { add(e.pred), add(e.succ); }
    void addOf(const LimitEvidence& e) { add(e.from), add(e.to); }
    void addOf(const SphereEvidence& e) { add(e.s), add(e.t); }
    template <typename Other>
    void addOf(const Other&) {}

  private:
    std::vector<Index> points_;
};

}  // namespace

std::vector<Index> neighborhoodOf(const Picture& picture) {
    Collector all;
    for (const Index point : {picture.pivot, picture.start, picture.end, picture.first,
                              picture.last, picture.underTest, picture.nextPivot}) {
        all.add(point);
    }
    for (const CandidateMark& mark : picture.candidates) {
        if (mark.state == CandidateState::Kept) all.add(mark.point);
    }
    for (const Triangle& t : picture.newTriangles) {
        for (const Index corner : {t.a, t.b, t.c}) all.add(corner);
    }
    if (picture.event) {
        std::visit([&](const auto& e) { all.addOf(e); }, picture.event->evidence);
    }
    return all.take();
}

}  // namespace se::view
