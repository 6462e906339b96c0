/// Every sentence of the log, recomputed from points and state: its numbers, comparison and reason.
/// Each form of a sentence is a row of a table (pivot_forms.cpp, ring_forms.cpp, repair_forms.cpp).
#include <doctest/doctest.h>

#include <cstdlib>
#include <map>
#include <sstream>

#include "core/run/sentences/claim.h"
#include "spiraling_edge/run/event_text.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/shared_data.h"

namespace se::test::sentences {
namespace {

/// The first claim of a sentence that does not hold; empty if all do.
std::string firstFalse(const Witness& witness, const Event& event, const std::string& text) {
    const auto verdict = verdictOf(event);
    for (const auto& forms : {pivotForms(), ringForms(), repairForms()}) {
        for (const SentenceForm& form : forms) {
            if (form.stage != event.address.stage || (form.verdict && form.verdict != verdict))
                continue;
            auto parts = partsOf(text, form.form);
            if (!parts) continue;
            Claim claim(witness, std::move(*parts));
            claim.verdict = form.verdict;
            form.check(claim);
            if (!claim.wrong.empty()) return claim.wrong;
            return claim.verdict == verdict ? "" : "the verdict";
        }
    }
    return "no form";
}

/// The sentences of runs, by stage and verdict; those that are false, by claim.
struct Tally {
    std::map<std::pair<Stage, std::optional<Verdict>>, std::size_t> checked;
    std::map<std::string, std::vector<std::string>> wrong;

    std::size_t count() const {
        std::size_t all = 0;
        for (const auto& [key, sentences] : checked) all += sentences;
        return all;
    }
    std::size_t countWrong() const {
        std::size_t all = 0;
        for (const auto& [claim, sentences] : wrong) all += sentences.size();
        return all;
    }
    void add(const Event& event, const std::string& text, const std::string& claim) {
        ++checked[{event.address.stage, verdictOf(event)}];
        if (claim.empty()) return;
        wrong[std::string(stageName(event.address.stage)) + ": " + claim].push_back(
            toString(event.address) + ": " + text);
    }
};

/// Makes a decision, or the words for it, false; returns false for those that it leaves alone.
using Corruption = bool (*)(Event& event, std::string& text);

/// Runs to the end and checks the sentences: all, or those that `corrupt` makes false.
void check(const PointSet& points, const Params& params, Tally& tally,
           Corruption corrupt = nullptr) {
    EventLog log;
    Stepper stepper(points, params, &log);
    Witness witness(points, params, stepper.state());
    for (;;) {
        log.clear();
        witness.beforePhase();
        if (!stepper.advance()) return;
        for (const Event& event : log.events()) {
            Event said = event;
            std::string text = describe(said);
            if (corrupt == nullptr || corrupt(said, text))
                tally.add(said, text, firstFalse(witness, said, text));
            witness.follow(event);
        }
        witness.afterPhase();
    }
}

/// Calls visit(points, params) for points by each rule set.
template <typename Visit>
void underAllRules(const PointFile& file, const GivenStart& start, const Visit& visit) {
    for (const std::string_view set : paramSetNames()) {
        Params params = *paramsByName(set);
        params.start = start;
        const PointSet points = prepared(file, {KNearest{}, params.dropOpposingNormals});
        visit(points, params);
        if (set != "paper") continue;
        params.paper.turn = TurnRule::Clockwise;
        visit(points, params);
    }
}

/// The count by stage and verdict; in full if SPIRALING_EDGE_SENTENCES is set.
std::string tableOf(const Tally& tally) {
    std::ostringstream table;
    table << tally.count() << " sentences";
    if (std::getenv("SPIRALING_EDGE_SENTENCES") == nullptr) return table.str();
    for (const auto& [key, count] : tally.checked)
        table << "\n| " << stageName(key.first) << " | "
              << (key.second ? verdictText(*key.second) : "") << " | " << count << " |";
    return table.str();
}

/// Verdicts that no run here reaches.
struct Unreached {
    Verdict verdict;
    std::string_view reason;
};
constexpr std::array<Unreached, 2> kUnreached{{
    {Verdict::WhatIfKept, "of a what-if, which no rule set has: it overrides the numbers"},
    {Verdict::WhatIfDropped, "of a what-if, which no rule set has: it overrides the numbers"},
}};

}  // namespace

TEST_CASE("sentences: each follows from points and state, and each verdict occurs") {
    Tally tally;
    const auto visit = [&](const PointSet& points, const Params& params) {
        check(points, params, tally);
    };
    for (const Scene& scene : scenes()) underAllRules(scene.build(), startOfScene(scene.id), visit);
    for (const FailureScene& each : failureScenes())
        underAllRules(each.scene.build(), startOfScene(each.scene.id), visit);
    for (std::uint64_t seed = 1; seed <= 41; seed += kSanitized ? 8 : 1) {
        const PointSet points = randomPoints(seed <= 40 ? seed : 164);  // 164: a hole is closed.
        for (const std::string_view set : paramSetNames()) visit(points, *paramsByName(set));
        // In `robust`, other rules come before these.
        Params guarded;
        guarded.robust.guard = guarded.robust.noPillow = true;
        visit(points, guarded);
        Params unmoved;
        unmoved.paper.limits = false;
        visit(points, unmoved);
        Params turned = *paramsByName("robust");
        turned.paper.turn = TurnRule::Clockwise;
        visit(points, turned);
    }
    for (const char* name : {"points/nefertiti.ply", "points/fin90.ply", "points/brain_piece.ply",
                             "points/table1_hyperboloid.ply", "cases/tunnel_no_normals.ply",
                             "cases/twin_points_0.05.ply", "cases/hard_edged_cube.obj"}) {
        if (kSanitized) break;
        if (const auto file = sharedPoints(name)) underAllRules(*file, {}, visit);
    }
    MESSAGE(tableOf(tally));
    for (const auto& [claim, sentences] : tally.wrong)
        CHECK_MESSAGE(sentences.empty(), claim, ", ", sentences.size(), ": ", sentences.front());
    if (kSanitized) return;  // Fewer runs do not reach all of them.
    for (const StageRow& stage : stageTable()) {
        const auto occurs = [&](const auto& each) { return each.first.first == stage.id; };
        CHECK_MESSAGE(std::any_of(tally.checked.begin(), tally.checked.end(), occurs), stage.name);
    }
    for (std::size_t i = 0; i < kVerdictCount; ++i) {
        const auto verdict = static_cast<Verdict>(i);
        const auto occurs = [&](const auto& each) { return each.first.second == verdict; };
        const bool isReached = std::any_of(tally.checked.begin(), tally.checked.end(), occurs);
        const bool isNamed = std::any_of(kUnreached.begin(), kUnreached.end(), [&](const auto& u) {
            return u.verdict == verdict && !u.reason.empty();
        });
        CHECK_MESSAGE(isReached != isNamed, verdictText(verdict));
    }
}

namespace {

template <typename Kind>
Kind* evidenceOf(Event& event) {
    return std::get_if<Kind>(&event.evidence);
}
bool replace(std::string& text, std::string_view words, std::string_view others) {
    const std::size_t at = text.find(words);
    if (at == std::string::npos) return false;
    text.replace(at, words.size(), others);
    return true;
}
/// Changes the evidence and puts it into words again.
template <typename Kind, typename Change>
bool alter(Event& event, std::string& text, const Change& change) {
    Kind* evidence = evidenceOf<Kind>(event);
    if (evidence == nullptr || !change(*evidence)) return false;
    text = describe(event);
    return true;
}

struct WrongReason {
    std::string_view name;
    Corruption corrupt;
};
constexpr auto kWrongReasons = std::to_array<WrongReason>({
    {"inside for outside the sphere",
     [](Event& event, std::string& text) {
         return isA<SphereEvidence>(event) &&
                (replace(text, " inside ", " outside ") || replace(text, " outside ", " inside "));
     }},
    {"the angle from last instead of first",
     [](Event& event, std::string& text) {
         return alter<SortEvidence>(event, text, [](SortEvidence& e) {
             const double other = e.endDegrees - e.degrees;
             const bool changes = e.verdict == Verdict::Kept && std::abs(other - e.degrees) > 0.2;
             e.degrees = other;
             return changes;
         });
     }},
    {"nearer for the farther of two at the same angle",
     [](Event& event, std::string& text) {
         return alter<SortEvidence>(event, text, [](SortEvidence& e) {
             e.farther = -e.farther;
             return e.verdict == Verdict::SameAngle && e.farther != 0.0;
         });
     }},
    {"another point on the ring sees the pivot",
     [](Event& event, std::string& text) {
         return alter<ReciprocalEvidence>(event, text, [](ReciprocalEvidence& e) {
             std::swap(e.point, e.succ);
             return true;
         });
     }},
    {"a convex end is blocked",
     [](Event& event, std::string& text) {
         return alter<LimitEvidence>(event, text, [](LimitEvidence& e) {
             const bool changes = e.verdict == Verdict::NotConcave;
             e.verdict = Verdict::Blocked;
             e.blocker = e.from;
             return changes;
         });
     }},
    {"another wall",
     [](Event& event, std::string& text) {
         return alter<SkipEvidence>(event, text, [](SkipEvidence& e) {
             e.type = static_cast<std::uint8_t>(e.type ^ kPositiveZ);
             return isOnWall(e.type);
         });
     }},
    {"a steep triangle folds over",
     [](Event& event, std::string& text) {
         return alter<GuardEvidence>(event, text, [](GuardEvidence& e) {
             const bool changes = e.verdict == Verdict::Steep;
             e.verdict = Verdict::FoldsOver;
             return changes;
         });
     }},
});

}  // namespace

TEST_CASE("sentences: planted wrong reasons are found") {
    for (const WrongReason& wrong : kWrongReasons) {
        CAPTURE(wrong.name);
        Tally tally;
        for (const char* id : {"sheet", "grid", "small-torus"}) {
            underAllRules(findScene(id)->build(), {},
                          [&](const PointSet& points, const Params& params) {
                              check(points, params, tally, wrong.corrupt);
                          });
        }
        MESSAGE(wrong.name, ": ", tally.count(), " planted, ", tally.countWrong(), " found");
        CHECK(tally.count() > 0);
        CHECK(tally.countWrong() == tally.count());
    }
}

}  // namespace se::test::sentences
