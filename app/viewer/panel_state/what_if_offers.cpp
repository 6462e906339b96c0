// The override that a verdict allows is its row's inverse (verdict_table.h); here it gets the point
// and the words. Verdicts without an inverse get a sentence on what to change instead.
#include "what_if_offers.h"

#include <algorithm>
#include <optional>

#include "run/strings.h"
#include "session/session.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se::view {

namespace {

std::string pointText(Index p) { return "point " + std::to_string(p); }

bool saysWhatIf(const Event& event) {
    const std::optional<Verdict> verdict = verdictOf(event);
    return verdict && isWhatIf(*verdict);
}

/// True if the triangle of this pivot is an ear closed by fill: there is no fan to test.
bool isEar(const Session& session) {
    const std::vector<Event>& events = session.record().events;
    return std::any_of(events.begin(), events.end(),
                       [](const Event& each) { return each.address.stage == Stage::Fill; });
}

}  // namespace

std::vector<WhatIfOffer> offersAt(const Event& event, Index pivot) {
    const std::optional<Verdict> verdict = verdictOf(event);
    if (!verdict) return {};
    const Stage stage = event.address.stage;
    const auto offer = [&](WhatIfKind kind, Index point, std::string label) {
        const WhatIf what{kind, event.address.pivot, stage, point, Vec3(0.0), {}};
        return std::vector<WhatIfOffer>{{what, std::move(label)}};
    };
    if (const auto* sort = std::get_if<SortEvidence>(&event.evidence)) {
        if (*verdict == Verdict::SameAngle)
            return offer(WhatIfKind::Drop, sort->rival,
                         "Drop " + pointText(sort->rival) + ", so that " + pointText(sort->point) +
                             " stays");
        if (*verdict != Verdict::Kept) return {};
        return offer(WhatIfKind::Drop, sort->point, "Drop " + pointText(sort->point));
    }
    const std::optional<WhatIfKind> inverse = rowOf(*verdict).inverse;
    if (!inverse) return {};
    const bool keep = *inverse == WhatIfKind::Keep;
    const Index tested = se::testedPoint(event);
    switch (stage) {
        case Stage::Limits:
            return offer(*inverse, tested,
                         (keep ? "Advance to " : "Do not advance to ") + pointText(tested));
        case Stage::Convex:
        case Stage::Reciprocal:
        case Stage::Hole:
        case Stage::Sphere:
            return offer(*inverse, tested, (keep ? "Keep " : "Drop ") + pointText(tested));
        case Stage::TwoPoint:
            return offer(*inverse, pivot, keep ? "Make the triangle" : "Make no triangle");
        case Stage::Guard:
            // The rules on fans dropped a point, or the whole fan.
            if (tested == kNone)
                return offer(WhatIfKind::Keep, pivot, "Make these triangles anyway");
            return offer(WhatIfKind::Keep, tested, "Keep " + pointText(tested));
        default:
            return {};
    }
}

std::vector<WhatIfOffer> offersHere(const Session& session) {
    const Event* event = session.event();
    if (event == nullptr) return {};
    const Index pivot = session.picture().pivot;
    std::vector<WhatIfOffer> offers = offersAt(*event, pivot);
    const Stage stage = event->address.stage;
    if ((stage == Stage::Emit || stage == Stage::Guard) && pivot != kNone && !isEar(session) &&
        !saysWhatIf(*event)) {
        offers.push_back(
            {{WhatIfKind::Drop, event->address.pivot, Stage::Guard, pivot, Vec3(0.0), {}},
             "Make no triangle at this pivot"});
    }
    return offers;
}

std::string noOfferText(const Event& event) {
    if (const std::optional<Verdict> verdict = verdictOf(event)) {
        const std::string reason = reasonAgainst(*verdict, se::testedPoint(event));
        if (!reason.empty()) return "This cannot be overridden. " + reason;
    }
    const Stage stage = event.address.stage;
    const auto isOneOf = [stage](std::initializer_list<Stage> stages) {
        return isAmong(stage, stages);
    };
    if (isOneOf({Stage::Pivot, Stage::Advance}))
        return "Select a point of a ring to continue at another one; the tests of this pivot come "
               "next.";
    if (isOneOf({Stage::Insert, Stage::Skip}))
        return "Boundary points follow the walls of section 7: turn walls, thirdpoint or corners "
               "off in Rules, or move the point.";
    if (isOneOf({Stage::Fill, Stage::DropPatch, Stage::Reinsert, Stage::CloseHole, Stage::Flip,
                 Stage::Remesh}))
        return "Not decided by a test: turn " + std::string(stageName(stage)) + " off in Rules.";
    if (isOneOf({Stage::Seed, Stage::Strand, Stage::Emit, Stage::Ring, Stage::Split, Stage::Join,
                 Stage::Done, Stage::Finished}))
        return "No choice was made here: it follows from the tests before it. Override one of "
               "those.";
    return "No test here can be overridden.";
}

std::vector<WhatIfOffer> offersAbout(const Session& session, Index point) {
    std::vector<WhatIfOffer> found;
    for (const Event& event : session.record().events) {
        if (saysWhatIf(event)) continue;
        for (WhatIfOffer& each : offersAt(event, session.picture().pivot)) {
            if (each.what.point != point || each.what.stage == Stage::TwoPoint) continue;
            const bool known = std::any_of(found.begin(), found.end(), [&](const WhatIfOffer& one) {
                return one.what == each.what;
            });
            if (known) continue;
            each.label += " at " + std::string(stageName(event.address.stage));
            found.push_back(std::move(each));
        }
    }
    if (session.record().pivot > 0) {
        found.push_back(
            {{WhatIfKind::Pivot, session.record().pivot, Stage::Advance, point, Vec3(0.0), {}},
             "Continue there after this pivot"});
    }
    return found;
}

void WhatIfForm::take(const Session& session, Index wanted) {
    const bool drags = session.drag().active() && session.drag().point() == wanted;
    const bool ended = std::exchange(dragged, drags) && !drags;
    if (wanted == point && generation == session.generation() && !drags && !ended) return;
    point = wanted;
    generation = session.generation();
    const PointSet& points = session.shown().points;
    if (wanted >= points.size()) return;
    for (int i = 0; i < 3; ++i) to[static_cast<std::size_t>(i)] = exact(points.position[wanted][i]);
    list = joinedNumbers(points.neighbors[wanted], " ");
}

Result<WhatIf> WhatIfForm::move(std::uint32_t pivot) const {
    const auto what = whatIfFromText(std::to_string(pivot) + " move " + std::to_string(point) +
                                     " " + to[0] + " " + to[1] + " " + to[2]);
    if (!what) return Error{"Expected three numbers, in the units of the input."};
    return what;
}

Result<WhatIf> WhatIfForm::neighbors(std::uint32_t pivot) const {
    const auto what =
        whatIfFromText(std::to_string(pivot) + " list " + std::to_string(point) + " " + list);
    if (!what) return Error{"Expected point numbers separated by spaces."};
    return what;
}

std::uint32_t forkPivot(const Session& session) { return std::max(1U, session.record().pivot); }

RunSpec withWhatIf(const RunSpec& rules, const WhatIf& what) {
    RunSpec made = rules;
    const auto decides = [](WhatIfKind kind) {
        return kind == WhatIfKind::Keep || kind == WhatIfKind::Drop;
    };
    std::erase_if(made.whatIf, [&](const WhatIf& each) {
        const bool place = each.pivot == what.pivot && each.stage == what.stage;
        const bool kind = each.kind == what.kind || (decides(each.kind) && decides(what.kind));
        return place && kind && (each.point == what.point || what.kind == WhatIfKind::Pivot);
    });
    made.whatIf.push_back(what);
    return made;
}

}  // namespace se::view
