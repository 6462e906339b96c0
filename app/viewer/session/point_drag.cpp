// One job at a time: a position that arrives while the pivot of another is made waits for it, and
// replaces one that waits already. The search for the turn, which follows, is given up for it.
#include "point_drag.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "session.h"
#include "spiraling_edge/run/reading.h"

namespace se::view {

namespace {

/// Pivots that are made within this time are shown in the same frame.
constexpr std::chrono::milliseconds kSameFrame{12};
/// The turn is searched up to this multiple of the way so far, and over this many spacings.
constexpr double kFarther = 1.5;
constexpr double kLeastSearched = 2.0;

/// The test at the cursor, otherwise the tests of the point at that stage.
PointDecisions decisionsAt(const Session& session, Index point) {
    const Event* event = session.event();
    if (event == nullptr) return {Stage::Pivot, point};
    const Index subject = testedPoint(*event);
    return {event->address.stage, subject != kNone ? subject : point};
}

/// The end of the way along which the turn is searched.
Vec3 farEnd(const Model& model, const Vec3& from, const Vec3& to) {
    const double way = glm::distance(from, to);
    if (way == 0.0) return from;
    const double spacing = static_cast<double>(model.spacing) / model.scale;
    return from + (std::max(kFarther * way, kLeastSearched * spacing) / way) * (to - from);
}

}  // namespace

bool PointDrag::possible(Index point) const {
    if (!session_.ready() || session_.moves().busy() || session_.showsBefore()) return false;
    if (active()) return false;
    return point < session_.model().points.size() && session_.record().pivot > 0 &&
           session_.picture().pivot != kNone && !session_.picture().repaired;
}

void PointDrag::begin(Index point) {
    assert(possible(point));
    held_ = true;
    point_ = point;
    decisions_ = decisionsAt(session_, point);
    model_ = std::make_shared<Model>(session_.shown());
    from_ = to_ = model_->points.position[point];
    open_ = session_.record_;
    openCursor_ = session_.cursor_;
    ++revision_;
    ++session_.revision_;
}

void PointDrag::moveTo(const Vec3& to) {
    assert(held_);
    if (to == to_) return;
    to_ = to;
    turn_.reset();
    model_->points.position[point_] = to;
    model_->place[point_] = model_->toView(to);
    ++revision_;
    ++session_.revision_;
    waits_ = true;
    poll();
    if (!job_.waitFor(kSameFrame)) return;
    poll();
}

/// Makes the pivot for the present position, then searches the turn on the way there.
void PointDrag::start() {
    waits_ = recordTaken_ = false;
    const auto run = session_.sharedModel();
    const Vec3 end = farEnd(*model_, from_, to_);
    job_.start([run, end, known = pivot_, number = open_->pivot, point = point_, from = from_,
                to = to_, decisions = decisions_](BackgroundJob<Made>::Results& results) {
        const auto keepGoing = [&results] { return results.report(0.5); };
        std::shared_ptr<const MovedPivot> pivot = known;
        if (!pivot) {
            auto made = MovedPivot::make(run->points, run->params, number, keepGoing);
            if (!made) return;
            pivot = std::make_shared<const MovedPivot>(std::move(*made));
        }
        results.add({pivot, pivot->record(point, to), {}, false});
        if (!results.report(0.5)) return;
        const auto share = pivot->turn(point, from, end, decisions, keepGoing);
        if (share) {
            results.add({pivot, nullptr, from + *share * (end - from), true});
        } else {
            results.add({pivot, nullptr, {}, true});
        }
    });
}

/// The event of the present record that is about the same decision.
void PointDrag::showAtSameStep() {
    SamePosition same;
    same.kind = SamePosition::Kind::Same;
    same.pivot = open_->pivot;
    const bool any = openCursor_ < open_->events.size();
    same.from = {any ? open_->events[openCursor_].address : Address{open_->pivot, Stage::Pivot, 0},
                 any ? subjectOf(open_->events[openCursor_]) : kNone, false};
    session_.setCursor(sameStep(*session_.record_, same));
}

bool PointDrag::take() {
    if (!job_.busy()) return false;
    const bool ended = job_.ended();
    std::vector<Made> fresh = job_.take();
    for (Made& each : fresh) {
        pivot_ = each.pivot;
        if (each.complete && !waits_) turn_ = each.turn;
        if (!each.record) continue;
        recordTaken_ = true;
        session_.record_ = std::move(each.record);
        showAtSameStep();
    }
    if (ended) job_.close();
    return !fresh.empty();
}

bool PointDrag::poll() {
    if (!active()) return false;
    const bool any = take();
    if (waits_ && recordTaken_) job_.cancel();
    if (waits_ && !job_.busy()) start();
    return any;
}

void PointDrag::waitUntilDone() {
    while (active() && busy()) {
        job_.waitUntilDone();
        poll();
    }
}

WhatIf PointDrag::release() {
    assert(held_);
    held_ = false;
    return {WhatIfKind::Move, open_->pivot, Stage::Pivot, point_, to_, {}};
}

void PointDrag::takeBack() {
    if (!active()) return;
    session_.record_ = open_;
    const std::size_t cursor = openCursor_;
    forget();
    session_.setCursor(cursor);
}

void PointDrag::forget() {
    job_.cancel();
    held_ = false;
    waits_ = false;
    model_ = nullptr;
    open_ = nullptr;
    pivot_ = nullptr;
    turn_.reset();
}

}  // namespace se::view
