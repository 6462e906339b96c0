// Decisions of the rules beyond the paper are in the ledgers of their points.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/why/ledger.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// A rule and the test for its decision.
struct Sign {
    std::string_view rule;
    std::function<bool(const Event&)> is;
};

template <typename E>
bool has(const Event& event, Verdict verdict) {
    const auto* e = std::get_if<E>(&event.evidence);
    if constexpr (requires { e->verdict; }) return e != nullptr && e->verdict == verdict;
    return false;
}
std::function<bool(const Event&)> objects(std::initializer_list<Verdict> verdicts) {
    return [all = std::vector<Verdict>(verdicts)](const Event& event) {
        return std::any_of(all.begin(), all.end(),
                           [&](Verdict v) { return has<GuardEvidence>(event, v); });
    };
}
template <typename E>
std::function<bool(const Event&)> of() {
    return [](const Event& event) { return std::holds_alternative<E>(event.evidence); };
}

/// Rules that only change the numbers of other tests, tangent and stepback, have no event; those of
/// shelve are about a ring.
std::vector<Sign> signs() {
    return {
        {"unblocked", [](const Event& e) { return has<LimitEvidence>(e, Verdict::Blocked); }},
        {"wallsdone",
         [](const Event& e) { return has<ReciprocalEvidence>(e, Verdict::WallComplete); }},
        {"bothwalls",
         [](const Event& e) { return has<InsertEvidence>(e, Verdict::OtherSideOpen); }},
        {"guard", objects({Verdict::EdgeTaken, Verdict::EntryMissed})},
        {"gap", objects({Verdict::WideGap})},
        {"nopillow", objects({Verdict::Pillow})},
        {"nocross", objects({Verdict::Crosses})},
        {"nofold", objects({Verdict::AgainstNormal, Verdict::FoldsOver})},
        {"nomeet", objects({Verdict::Meets})},
        {"nolayer", objects({Verdict::Covers})},
        {"rim", objects({Verdict::OverRim})},
        {"delay", objects({Verdict::Steep})},
        {"fill", of<FillEvidence>()},
        {"reinsert", of<ReinsertEvidence>()},
        {"droppatches", of<DropPatchEvidence>()},
        {"closeholes", of<CloseHoleEvidence>()},
        {"flip", of<FlipEvidence>()},
        {"remesh", of<RemeshEvidence>()},
    };
}

/// The subject of a likely query.
Subject likelySubject(const Event& event) {
    if (const auto* flip = std::get_if<FlipEvidence>(&event.evidence))
        return Subject::edge(flip->x, flip->y);
    if (const auto* hole = std::get_if<CloseHoleEvidence>(&event.evidence))
        return Subject::point(hole->first);
    if (const auto* remesh = std::get_if<RemeshEvidence>(&event.evidence))
        return Subject::point(remesh->faulty.a);
    if (const auto* fill = std::get_if<FillEvidence>(&event.evidence))
        return Subject::point(fill->pivot);
    if (const auto* insert = std::get_if<InsertEvidence>(&event.evidence))
        return Subject::point(insert->pivot);
    const auto* guard = std::get_if<GuardEvidence>(&event.evidence);
    if (guard != nullptr && guard->dropped == kNone) return Subject::point(guard->a);
    return Subject::point(testedPoint(event));
}

std::vector<PointSet> inputs() {
    std::vector<PointSet> all;
    for (const FailureScene& each : failureScenes()) all.push_back(prepared(each.scene.build()));
    for (const Scene& each : scenes()) all.push_back(prepared(each.build()));
    for (std::uint64_t seed = 1; seed <= 60; ++seed) all.push_back(randomPoints(seed));
    return all;
}

/// The first decision of the rule in one of the runs.
struct Found {
    const PointSet* points = nullptr;
    Event event;
};
Found firstDecision(const std::vector<PointSet>& all, const Params& params, const Sign& sign) {
    Found found;
    for (const PointSet& points : all) {
        (void)sweep(points, params, [&](const SweptPivot& pivot) {
            if (found.points != nullptr) return;
            const auto event = std::find_if(pivot.events.begin(), pivot.events.end(), sign.is);
            if (event != pivot.events.end()) found = {&points, *event};
        });
        if (found.points != nullptr) break;
    }
    return found;
}

}  // namespace

TEST_CASE("robust: what each rule decides is a line of the ledger of what it is about" *
          doctest::test_suite("long")) {
    const std::vector<PointSet> all = inputs();
    for (const Sign& sign : signs()) {
        CAPTURE(sign.rule);
        const auto rows = ruleSwitches();
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const RuleSetting& each) {
            return each.name == sign.rule;
        });
        REQUIRE(row != rows.end());
        Params params = paper();
        row->turnOn(params);
        Found found = firstDecision(all, params, sign);
        if (found.points == nullptr) {
            // Some take effect only together with the others.
            params = *paramsByName("robust");
            found = firstDecision(all, params, sign);
        }
        // Some are rare.
        std::vector<PointSet> more;
        for (std::uint64_t seed = 61; found.points == nullptr && seed <= 2000; ++seed) {
            more = {randomPoints(seed)};
            found = firstDecision(more, params, sign);
        }
        REQUIRE(found.points != nullptr);
        const std::string address = toString(found.event.address);
        CAPTURE(address);
        const auto ledger = why(*found.points, params, likelySubject(found.event));
        REQUIRE(ledger.ok());
        const auto& lines = ledger.value().lines;
        CHECK(std::any_of(lines.begin(), lines.end(), [&](const LedgerLine& line) {
            return toString(line.event.address) == address;
        }));
    }
}

TEST_CASE("robust: every rule of the set has such a line, or only changes numbers") {
    const Params robust = *paramsByName("robust");
    const Params plain = paper();
    const std::vector<Sign> known = signs();
    for (const RuleSetting& each : ruleSwitches()) {
        if (!each.isOn(robust) || each.isOn(plain)) continue;
        CAPTURE(each.name);
        const bool has = std::any_of(known.begin(), known.end(),
                                     [&](const Sign& sign) { return sign.rule == each.name; });
        CHECK((has || each.name == "tangent" || each.name == "stepback" || each.name == "shelve"));
    }
}
