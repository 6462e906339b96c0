#include "neighborhood.h"

#include <algorithm>
#include <initializer_list>

#include "spiraling_edge/base/overloaded.h"

namespace se::view {

std::vector<Index> neighborhoodOf(const DecisionState& picture) {
    std::vector<Index> all;
    const auto add = [&](std::initializer_list<Index> points) {
        for (const Index point : points) {
            const bool known = std::find(all.begin(), all.end(), point) != all.end();
            if (point != kNone && !known) all.push_back(point);
        }
    };
    add({picture.pivot, picture.start, picture.end, picture.first, picture.last, picture.underTest,
         picture.nextPivot});
    for (const CandidateMark& mark : picture.candidates) {
        if (mark.state == CandidateState::Kept) add({mark.point});
    }
    for (const Triangle& t : picture.newTriangles) add({t.a, t.b, t.c});
    if (!picture.event) return all;
    // Points that an event names beside its subject.
    std::visit(Overloaded{
                   [&](const ReciprocalEvidence& e) {
                       add({e.pred, e.succ});
                   },
                   [&](const LimitEvidence& e) {
                       add({e.from, e.to});
                   },
                   [&](const SphereEvidence& e) {
                       add({e.s, e.t});
                   },
                   [](const auto&) {},
               },
               picture.event->evidence);
    return all;
}

bool isMeasured(const LimitEvidence& e) {
    return e.verdict != Verdict::OtherLimit && e.verdict != Verdict::NotAnEdge &&
           e.verdict != Verdict::NotListed;
}

}  // namespace se::view
