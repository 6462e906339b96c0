#include "rows/pivot_dial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "open_session.h"
#include "scene/palette.h"

using namespace se;
using namespace se::view;

namespace {

const DialTick* tickOf(const Dial& dial, Index point) {
    const auto found = std::find_if(dial.ticks.begin(), dial.ticks.end(),
                                    [&](const DialTick& t) { return t.point == point; });
    return found == dial.ticks.end() ? nullptr : &*found;
}

const DialArc* arcOf(const Dial& dial, DialArc::Kind kind) {
    const auto found = std::find_if(dial.arcs.begin(), dial.arcs.end(),
                                    [&](const DialArc& a) { return a.kind == kind; });
    return found == dial.arcs.end() ? nullptr : &*found;
}

/// Calls `look` with every event of the first pivots of a scene and its dial.
template <typename Look>
void forEachDial(const char* scene, Look&& look) {
    LoadProgress progress;
    const auto model = test::loadModel(RunSpec{scene}, progress);
    REQUIRE(model.ok());
    Timeline timeline(model.value()->points, model.value()->params);
    for (std::uint32_t pivot = 1; pivot <= 120; ++pivot) {
        const auto record = timeline.record(pivot);
        for (std::size_t i = 0; i < record->events.size(); ++i) {
            const DecisionState picture = PivotReplay(record).after(i);
            const Event& event = record->events[i];
            CAPTURE(toString(event.address));
            look(picture, event, makeDial(model.value()->points, model.value()->params, picture));
        }
    }
}

}  // namespace

TEST_CASE("Dial: ticks are at the angles of the decisions") {
    for (const char* scene : {"scene:sphere", "scene:linked-tori", "scene:sheet"}) {
        CAPTURE(scene);
        int compared = 0;
        forEachDial(scene, [&](const DecisionState& picture, const Event& event, const Dial& dial) {
            const auto* sort = std::get_if<SortEvidence>(&event.evidence);
            if (sort == nullptr || sort->verdict == Verdict::OnRingEnd) return;
            const DialTick* tick = tickOf(dial, sort->point);
            REQUIRE(tick != nullptr);
            CHECK(tick->degrees == doctest::Approx(sort->degrees));
            CHECK(tick->underTest == (picture.underTest == sort->point));
            ++compared;
        });
        CHECK(compared > 300);
    }
}

TEST_CASE("Dial: rejected neighbors have a reason, kept ones do not") {
    forEachDial("scene:torus", [](const DecisionState& picture, const Event&, const Dial& dial) {
        for (const CandidateMark& mark : picture.candidates) {
            const DialTick* tick = tickOf(dial, mark.point);
            REQUIRE(tick != nullptr);
            if (tick->role != DialRole::Candidate && tick->role != DialRole::Rejected) continue;
            const bool rejected = mark.state == CandidateState::Rejected;
            CHECK((tick->role == DialRole::Rejected) == rejected);
            CHECK(tick->note.empty() != rejected);
        }
    });
}

TEST_CASE("Dial: the range runs from start to end, and the gap of a sphere test from t to s") {
    int gaps = 0;
    forEachDial(
        "scene:torus", [&](const DecisionState& picture, const Event& event, const Dial& dial) {
            if (picture.pivot == kNone) {
                CHECK(dial.empty());
                return;
            }
            const DialArc* range = arcOf(dial, DialArc::Kind::Range);
            REQUIRE(range != nullptr);
            CHECK(range->from == picture.startDegrees);
            for (const DialTick& tick : dial.ticks) {
                CHECK(tick.reach >= 0.0F);
                CHECK(tick.reach <= 1.0F);
                CHECK(std::abs(tick.height) <= 1.0F);
            }
            const auto* sphere = std::get_if<SphereEvidence>(&event.evidence);
            if (sphere == nullptr) return;
            const bool wide = sphere->gapDegrees > 120.0;
            const DialArc* gap = arcOf(dial, wide ? DialArc::Kind::TooWide : DialArc::Kind::Gap);
            REQUIRE(gap != nullptr);
            CHECK(gap->to - gap->from == doctest::Approx(sphere->gapDegrees));
            for (const Index point : {sphere->q, sphere->t, sphere->s})
                CHECK(tickOf(dial, point)->named);
            CHECK(labelOf(*tickOf(dial, sphere->q), {}) == std::to_string(sphere->q));
            ++gaps;
        });
    CHECK(gaps > 50);
}

TEST_CASE("Dial: the limits that angles are compared with are marked, and refusals named") {
    int spheres = 0;
    int refusals = 0;
    forEachDial("scene:coarse-torus", [&](const DecisionState&, const Event& event,
                                          const Dial& dial) {
        if (const auto* sphere = std::get_if<SphereEvidence>(&event.evidence)) {
            const bool wide = sphere->gapDegrees > 120.0;
            const DialArc* gap = arcOf(dial, wide ? DialArc::Kind::TooWide : DialArc::Kind::Gap);
            REQUIRE(gap != nullptr);
            REQUIRE(dial.marks.size() == 1);
            CHECK(dial.marks[0].degrees == doctest::Approx(gap->from + 120.0));
            ++spheres;
        }
        if (std::holds_alternative<TwoPointEvidence>(event.evidence)) {
            REQUIRE(dial.marks.size() == 1);
            CHECK(dial.marks[0].degrees == 180.0);
        }
        if (std::holds_alternative<HoleEvidence>(event.evidence)) CHECK(dial.chord.has_value());
        if (outcomeOf(event) != Outcome::Refused || dial.empty()) return;
        CHECK(dial.caption.find(verdictText(*verdictOf(event))) != std::string::npos);
        ++refusals;
    });
    CHECK(spheres > 50);
    CHECK(refusals > 50);
}

TEST_CASE("Dial: kept candidates have a rank by angle") {
    forEachDial("scene:torus", [](const DecisionState&, const Event&, const Dial& dial) {
        std::vector<const DialTick*> ranked;
        for (const DialTick& tick : dial.ticks) {
            CHECK((tick.rank > 0) == (tick.role == DialRole::Candidate));
            if (tick.rank > 0) ranked.push_back(&tick);
        }
        std::sort(ranked.begin(), ranked.end(),
                  [](const DialTick* a, const DialTick* b) { return a->rank < b->rank; });
        for (std::size_t i = 1; i < ranked.size(); ++i) {
            CHECK(ranked[i - 1]->degrees <= ranked[i]->degrees);
        }
    });
}

TEST_CASE("Dial: a third point has a slot before and after the pivot, one of them filled") {
    int slots = 0;
    forEachDial("scene:figure-14", [&](const DecisionState&, const Event& event, const Dial& dial) {
        const auto* insert = std::get_if<InsertEvidence>(&event.evidence);
        if (insert == nullptr) return;
        REQUIRE(dial.slots.size() == 2);
        CHECK(dial.slots[0].filled == (insert->verdict == Verdict::Before));
        CHECK(dial.slots[1].filled == (insert->verdict == Verdict::After));
        ++slots;
    });
    CHECK(slots > 0);
}

TEST_CASE("Dial: the second disc shows the pivot as seen from the tested point") {
    int discs = 0;
    forEachDial("scene:small-sheet",
                [&](const DecisionState&, const Event& event, const Dial& dial) {
                    const auto* test = std::get_if<ReciprocalEvidence>(&event.evidence);
                    CHECK(dial.reciprocal.has_value() == (test != nullptr));
                    if (test == nullptr) return;
                    CHECK(dial.reciprocal->e == test->point);
                    CHECK(dial.reciprocal->kept == (test->verdict == Verdict::Kept));
                    CHECK(dial.reciprocal->kept ==
                          (dial.reciprocal->pivotDegrees > 0.0 &&
                           dial.reciprocal->pivotDegrees < dial.reciprocal->limitDegrees));
                    // The free sector begins at the point before e: elast in Figure 6.
                    CHECK(dial.reciprocal->lastDegrees() == 0.0);
                    CHECK(dial.reciprocal->firstDegrees() == test->limitDegrees);
                    ++discs;
                });
    CHECK(discs > 0);
}

TEST_CASE("Dial: the caption of a limit has no question, and no reason twice") {
    int moved = 0;
    forEachDial("scene:figure-8", [&](const DecisionState&, const Event& event, const Dial& dial) {
        const auto* limit = std::get_if<LimitEvidence>(&event.evidence);
        if (limit == nullptr) return;
        CHECK(dial.caption.find('?') == std::string::npos);
        const bool moves = limit->verdict == Verdict::Moved;
        CHECK((dial.caption.find("moved from") != std::string::npos) == moves);
        CHECK((dial.caption.find("stays") != std::string::npos) != moves);
        moved += moves ? 1 : 0;
    });
    CHECK(moved > 0);
    int convex = 0;
    forEachDial("scene:small-torus",
                [&](const DecisionState&, const Event& event, const Dial& dial) {
                    const auto* drop = std::get_if<DropEvidence>(&event.evidence);
                    if (drop == nullptr || drop->verdict != Verdict::BeyondConvex) return;
                    const std::size_t first = dial.caption.find("after");
                    REQUIRE(first != std::string::npos);
                    CHECK(dial.caption.find("after", first + 1) == std::string::npos);
                    ++convex;
                });
    CHECK(convex > 0);
}

TEST_CASE("Dial: the new start and end of Figure 4 are not crossed out") {
    int limits = 0;
    forEachDial("scene:figure-8", [&](const DecisionState& picture, const Event& event,
                                      const Dial& dial) {
        const auto* drop = std::get_if<DropEvidence>(&event.evidence);
        if (drop == nullptr || !drop->isLimit()) return;
        const bool start = drop->side == Side::Start;
        CHECK(drop->point == (start ? picture.start : picture.end));
        CHECK(std::none_of(
            picture.candidates.begin(), picture.candidates.end(), [&](const CandidateMark& each) {
                return each.point == drop->point && each.state == CandidateState::Rejected;
            }));
        CHECK(outcomeOf(event) != Outcome::Refused);
        CHECK(outcomeColor(paletteOf(Theme::Dark), event) == paletteOf(Theme::Dark).test);
        const auto tick = std::find_if(dial.ticks.begin(), dial.ticks.end(),
                                       [&](const DialTick& t) { return t.point == drop->point; });
        REQUIRE(tick != dial.ticks.end());
        CHECK(tick->role == (start ? DialRole::Start : DialRole::End));
        CHECK(tick->note.empty());
        CHECK(dial.caption.starts_with(start ? "now start" : "now end"));
        ++limits;
    });
    CHECK(limits >= 2);
}
