// The terms of a query line.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/replay/decision_scan.h"
#include "spiraling_edge/replay/pivot_tally.h"

namespace se {
namespace {

using Condition = DecisionCondition;
using Read = Result<Condition>;

/// An empty condition: the word is of another form.
Read otherForm() { return Condition(); }

/// The rest of the word after `prefix`; empty if the word does not begin with it.
std::optional<std::string_view> afterPrefix(std::string_view word, std::string_view prefix) {
    if (!word.starts_with(prefix)) return {};
    return word.substr(prefix.size());
}

template <typename Number>
std::optional<Number> numberIn(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return number;
}

Error notA(std::string_view word, std::string_view what) {
    return Error{"\"" + std::string(word) + "\": expected " + std::string(what) + "."};
}

/// A text in the form of a query line: "inside-sphere" for "inside sphere".
std::string hyphened(std::string_view text) {
    std::string word(text);
    std::replace(word.begin(), word.end(), ' ', '-');
    std::erase(word, ',');
    return word;
}

Read readStage(std::string_view word) {
    const auto name = afterPrefix(word, "stage=");
    if (!name) return otherForm();
    const auto stage = stageFromName(*name);
    if (!stage) return notA(word, "the name of a stage, such as sphere");
    return Condition([s = *stage](const Decision& d) { return d.event.address.stage == s; });
}

Read readSection(std::string_view word) {
    const auto section = afterPrefix(word, "section=");
    if (!section) return otherForm();
    const std::span<const StageRow> stages = stageTable();
    const bool known = !section->empty() &&
                       std::any_of(stages.begin(), stages.end(),
                                   [&](const StageRow& row) { return row.section == *section; });
    if (!known) return notA(word, "a section with a stage of its own, such as 6.3");
    return Condition([s = std::string(*section)](const Decision& d) {
        return stageSection(d.event.address.stage) == s;
    });
}

Read readOutcome(std::string_view word) {
    if (word != "kept" && word != "refused") return otherForm();
    if (word == "kept") {
        return Condition([](const Decision& d) { return outcomeOf(d.event) == Outcome::Taken; });
    }
    return Condition([](const Decision& d) { return isAgainst(outcomeOf(d.event)); });
}

Read readVerdict(std::string_view word) {
    const auto name = afterPrefix(word, "verdict=");
    if (!name) return otherForm();
    const auto table = verdictTable();
    if (std::none_of(table.begin(), table.end(),
                     [&](const VerdictRow& row) { return hyphened(row.text) == *name; }))
        return notA(word, "the words of a verdict with hyphens, such as inside-sphere");
    return Condition([n = std::string(*name)](const Decision& d) {
        return std::visit(
            [&](const auto& e) {
                if constexpr (requires { e.verdict; }) return hyphened(verdictText(e.verdict)) == n;
                return false;
            },
            d.event.evidence);
    });
}

Read readPoint(std::string_view word) {
    const auto text = afterPrefix(word, "point=");
    if (!text) return otherForm();
    const auto point = numberIn<Index>(*text);
    if (!point) return notA(word, "the number of a point, such as point=812");
    return Condition([p = *point](const Decision& d) { return testedPoint(d.event) == p; });
}

Read readPivot(std::string_view word) {
    const auto text = afterPrefix(word, "pivot=");
    if (!text) return otherForm();
    const auto point = numberIn<Index>(*text);
    if (!point) return notA(word, "the number of the point, such as pivot=812");
    return Condition([p = *point](const Decision& d) { return d.pivot == p; });
}

/// "7" or "3..7", both ends included.
struct Range {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    bool has(std::uint32_t number) const { return number >= from && number <= to; }
};
std::optional<Range> rangeIn(std::string_view text) {
    const std::size_t dots = text.find("..");
    const auto from = numberIn<std::uint32_t>(text.substr(0, dots));
    const auto to =
        dots == std::string_view::npos ? from : numberIn<std::uint32_t>(text.substr(dots + 2));
    if (!from || !to) return {};
    return Range{*from, *to};
}

Read readAt(std::string_view word) {
    const auto text = afterPrefix(word, "at=");
    if (!text) return otherForm();
    const auto range = rangeIn(*text);
    if (!range) return notA(word, "pivot numbers, such as at=137 or at=100..200");
    return Condition([r = *range](const Decision& d) { return r.has(d.event.address.pivot); });
}

/// A number of the pivot as a whole, one or from A to B.
Read readTally(std::string_view word, std::string_view prefix, std::uint32_t PivotTally::*number) {
    const auto text = afterPrefix(word, prefix);
    if (!text) return otherForm();
    const auto range = rangeIn(*text);
    if (!range) {
        const std::string name(prefix);
        return notA(word, "a number or two, such as " + name + "5 or " + name + "10..19");
    }
    return Condition(
        [r = *range, number](const Decision& d) { return r.has(tallyOf(d.events).*number); });
}
Read readRing(std::string_view word) { return readTally(word, "ring=", &PivotTally::ringLength); }
Read readCandidates(std::string_view word) {
    return readTally(word, "candidates=", &PivotTally::candidates);
}
Read readTests(std::string_view word) { return readTally(word, "tests=", &PivotTally::tests); }

/// `name<X` and `name>X` for a number of the reading.
Read readCompared(std::string_view word, std::string_view name,
                  double (*numberOf)(const Reading&)) {
    const auto text = afterPrefix(word, name);
    if (!text || text->empty() || (text->front() != '<' && text->front() != '>'))
        return otherForm();
    const auto limit = numberIn<double>(text->substr(1));
    if (!limit) return notA(word, "a number after < or >, such as " + std::string(name) + "<1e-4");
    const bool below = text->front() == '<';
    return Condition([below, limit = *limit, numberOf](const Decision& d) {
        if (!d.reading) return false;
        const double number = numberOf(*d.reading);
        return below ? number < limit : number > limit;
    });
}
Read readMargin(std::string_view word) {
    return readCompared(word, "margin", [](const Reading& r) { return std::abs(r.margin); });
}
Read readValue(std::string_view word) {
    return readCompared(word, "value", [](const Reading& r) { return r.value; });
}

/// One point after `prefix`, and the condition on it.
Read readPointTerm(std::string_view word, std::string_view prefix,
                   bool (*holds)(const Decision&, Index)) {
    const auto text = afterPrefix(word, prefix);
    if (!text) return otherForm();
    const auto point = numberIn<Index>(*text);
    if (!point) return notA(word, "the number of a point, such as " + std::string(prefix) + "812");
    return Condition([p = *point, holds](const Decision& d) { return holds(d, p); });
}

/// True if the point gets its first entry on a ring (§4): by a seed, as a third point of §7, or in
/// a fan.
bool becomesUsed(const Decision& d, Index p) {
    if (const auto* seed = std::get_if<SeedEvidence>(&d.event.evidence))
        return p == kNone || seed->first == p || seed->second == p;
    if (const auto* insert = std::get_if<InsertEvidence>(&d.event.evidence))
        return insert->third != kNone && (p == kNone || insert->third == p);
    const auto* ring = std::get_if<RingEvidence>(&d.event.evidence);
    return ring != nullptr && ring->inserted && ring->status == 1 &&
           (p == kNone || ring->point == p);
}
Read readUsed(std::string_view word) {
    if (word == "used") return Condition([](const Decision& d) { return becomesUsed(d, kNone); });
    return readPointTerm(word, "used=", becomesUsed);
}

/// True if its last entry leaves the rings (§6.5, §7), or it cannot begin a ring (§4).
bool becomesDone(const Decision& d, Index p) {
    if (const auto* strand = std::get_if<StrandEvidence>(&d.event.evidence))
        return p == kNone || strand->point == p;
    const auto* ring = std::get_if<RingEvidence>(&d.event.evidence);
    return ring != nullptr && ring->status < 0 && (p == kNone || ring->point == p);
}
Read readDone(std::string_view word) {
    if (word == "done") return Condition([](const Decision& d) { return becomesDone(d, kNone); });
    return readPointTerm(word, "done=", becomesDone);
}
Read readStranded(std::string_view word) {
    if (word == "stranded") {
        return Condition([](const Decision& d) {
            return std::holds_alternative<StrandEvidence>(d.event.evidence);
        });
    }
    return readPointTerm(word, "stranded=", [](const Decision& d, Index p) {
        const auto* strand = std::get_if<StrandEvidence>(&d.event.evidence);
        return strand != nullptr && strand->point == p;
    });
}

/// A new side of the mesh is a step of the ring (§6.5): the side of a triangle across from its
/// pivot, or the two steps of a seed.
Read readEdge(std::string_view word) {
    const auto text = afterPrefix(word, "edge=");
    if (!text) return otherForm();
    const std::size_t comma = text->find(',');
    const auto a = numberIn<Index>(text->substr(0, comma));
    const auto b =
        comma == std::string_view::npos ? std::nullopt : numberIn<Index>(text->substr(comma + 1));
    if (!a || !b) return notA(word, "two points, such as edge=812,640");
    return Condition([a = *a, b = *b](const Decision& d) {
        const auto both = [&](Index x, Index y) {
            return (x == a && y == b) || (x == b && y == a);
        };
        if (const auto* seed = std::get_if<SeedEvidence>(&d.event.evidence))
            return both(seed->first, seed->second);
        const auto* emit = std::get_if<EmitEvidence>(&d.event.evidence);
        return emit != nullptr && both(emit->corners.b, emit->corners.c);
    });
}

Read readCloses(std::string_view word) {
    if (word != "closes") return otherForm();
    return Condition([](const Decision& d) {
        return std::holds_alternative<CloseEvidence>(d.event.evidence) ||
               std::holds_alternative<FreeEvidence>(d.event.evidence);
    });
}
Read readComponent(std::string_view word) {
    if (word != "component") return otherForm();
    return Condition([](const Decision& d) {
        return std::holds_alternative<ComponentEvidence>(d.event.evidence);
    });
}
Read readAlert(std::string_view word) {
    if (word != "alert") return otherForm();
    return Condition(
        [](const Decision& d) { return std::holds_alternative<AlertEvidence>(d.event.evidence); });
}

/// A class of failures, as a bit of Decision::failures; all of them without a name.
Read readFailure(std::string_view word) {
    if (word == "failure") return Condition([](const Decision& d) { return d.failures != 0; });
    const auto name = afterPrefix(word, "failure=");
    if (!name) return otherForm();
    const FailureClass* kind = findFailureClass(*name);
    if (kind == nullptr || !appearsInRun(*kind)) {
        std::string names;
        for (const FailureClass& each : failureClasses())
            if (appearsInRun(each)) names += (names.empty() ? "" : ", ") + std::string(each.name);
        if (kind != nullptr)
            return Error{"\"" + std::string(word) +
                         "\": that is known only when the run has ended; during a run there are " +
                         names + "."};
        return notA(word, "a class of failures that appears during a run: " + names);
    }
    const std::uint32_t bit = failureBit(*kind);
    return Condition([bit](const Decision& d) { return (d.failures & bit) != 0; });
}

Read readLeastAngle(std::string_view word) {
    const auto text = afterPrefix(word, "angle<");
    if (!text) return otherForm();
    const auto degrees = numberIn<double>(*text);
    if (!degrees) return notA(word, "degrees, such as angle<5");
    const double cosine = std::cos(*degrees * 3.14159265358979323846 / 180.0);
    return Condition([cosine](const Decision& d) {
        const auto* emit = std::get_if<EmitEvidence>(&d.event.evidence);
        return emit != nullptr && leastAngleCosine(d.points, emit->corners) > cosine;
    });
}

/// Limit of a range, so that a typing error does not fill the memory.
constexpr Index kMaxInRange = 10'000'000;

Read readAmong(std::string_view word) {
    auto text = afterPrefix(word, "among=");
    if (!text) return otherForm();
    std::vector<Index> points;
    while (!text->empty()) {
        const std::size_t comma = std::min(text->find(','), text->size());
        const std::string_view part = text->substr(0, comma);
        const std::size_t dots = part.find("..");
        const auto from = numberIn<Index>(part.substr(0, dots));
        const auto to =
            dots == std::string_view::npos ? from : numberIn<Index>(part.substr(dots + 2));
        if (!from || !to || *to < *from || *to - *from >= kMaxInRange)
            return notA(word, "points, such as among=3,4,5 or among=3..5");
        for (Index p = *from; p <= *to; ++p) points.push_back(p);
        text->remove_prefix(std::min(comma + 1, text->size()));
    }
    std::sort(points.begin(), points.end());
    return Condition([points = std::move(points)](const Decision& d) {
        return std::binary_search(points.begin(), points.end(), testedPoint(d.event)) ||
               std::binary_search(points.begin(), points.end(), d.pivot);
    });
}

constexpr QueryTerm kTerms[] = {
    {"stage=NAME", "Of this stage: sort, sphere, ring ...", readStage},
    {"section=6.3", "Of this section of the paper.", readSection},
    {"kept", "A test that took its point.", readOutcome},
    {"refused", "A test that refused its point.", readOutcome},
    {"verdict=NAME", "Ended so: inside-sphere, gap-too-wide ...", readVerdict},
    {"point=N", "About this point.", readPoint},
    {"pivot=N", "While this point was the pivot.", readPivot},
    {"at=A..B", "At these pivots, counted from 1.", readAt},
    {"ring=A..B", "At pivots on a ring of A to B points.", readRing},
    {"candidates=A..B", "At pivots with A to B candidates (6.1).", readCandidates},
    {"tests=A..B", "At pivots with A to B tests.", readTests},
    {"margin<X", "A margin of less than X on either side; or margin>X.", readMargin},
    {"value<X", "The measured number, in its own unit; or value>X.", readValue},
    {"used=N", "The point becomes USED; any point without =N.", readUsed},
    {"done=N", "The point becomes DONE; any point without =N.", readDone},
    {"stranded", "A point that cannot begin a ring; or stranded=N.", readStranded},
    {"edge=N,M", "The edge becomes a step of the ring.", readEdge},
    {"closes", "A ring is closed or freed.", readCloses},
    {"component", "A component is complete.", readComponent},
    {"alert", "An alert: a ring freed with points in it, a lost seed, a stopped run.", readAlert},
    {"failure=CLASS", "A failure of the mesh appears; of any class without =CLASS.", readFailure,
     true},
    {"angle<X", "A triangle with a least angle below X degrees.", readLeastAngle},
    {"among=N,M..", "About one of these points, or while one was the pivot.", readAmong},
};

}  // namespace

std::span<const QueryTerm> queryTerms() { return kTerms; }

}  // namespace se
