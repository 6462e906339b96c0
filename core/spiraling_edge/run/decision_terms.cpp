/// The terms of a query line: one function for each, which reads its value, if the word is of its
/// form, and makes a condition on a decision of it; and one row of the table for each.
#include <algorithm>
#include <cmath>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/event.h"

namespace se {
namespace {

using Condition = DecisionCondition;
using Read = Result<Condition>;

Error notA(std::string_view word, std::string_view what) {
    return Error{inQuotes(word) + ": expected " + std::string(what) + "."};
}

/// A term of a prefix and a value, such as point=812: `valueIn` reads the value, if it is one, and
/// `holds` compares a decision with it. An empty condition: the word is of another form.
template <typename ValueIn, typename Holds>
Read readTerm(std::string_view word, std::string_view prefix, const ValueIn& valueIn,
              std::string_view expected, const Holds& holds) {
    if (!word.starts_with(prefix)) return Condition();
    const auto value = valueIn(word.substr(prefix.size()));
    if (!value) return notA(word, expected);
    return Condition([value = *value, holds](const Decision& d) { return holds(d, value); });
}

/// A term without a value.
template <typename Holds>
Read readWord(std::string_view word, std::string_view term, const Holds& holds) {
    return word == term ? Condition(holds) : Condition();
}

Read readStage(std::string_view word) {
    return readTerm(word, "stage=", stageFromName, "the name of a stage, such as sphere",
                    [](const Decision& d, Stage s) { return d.event.address.stage == s; });
}

/// The section, if it has a stage of its own.
std::optional<std::string> sectionIn(std::string_view text) {
    const std::span<const StageRow> stages = stageTable();
    const bool known =
        !text.empty() && std::any_of(stages.begin(), stages.end(),
                                     [&](const StageRow& row) { return row.section == text; });
    return known ? std::optional(std::string(text)) : std::nullopt;
}
Read readSection(std::string_view word) {
    return readTerm(word, "section=", sectionIn, "a section with a stage of its own, such as 6.3",
                    [](const Decision& d, const std::string& section) {
                        return stageSection(d.event.address.stage) == section;
                    });
}

Read readKept(std::string_view word) {
    return readWord(word, "kept",
                    [](const Decision& d) { return outcomeOf(d.event) == Outcome::Taken; });
}
Read readRefused(std::string_view word) {
    return readWord(word, "refused",
                    [](const Decision& d) { return isAgainst(outcomeOf(d.event)); });
}

/// The verdict of a text with hyphens: "inside-sphere" for "inside sphere".
std::optional<Verdict> verdictIn(std::string_view text) {
    for (const VerdictRow& row : verdictTable()) {
        std::string word(row.text);
        std::replace(word.begin(), word.end(), ' ', '-');
        std::erase(word, ',');
        if (word == text) return row.id;
    }
    return {};
}
Read readVerdict(std::string_view word) {
    return readTerm(word, "verdict=", verdictIn,
                    "the words of a verdict with hyphens, such as inside-sphere",
                    [](const Decision& d, Verdict v) { return verdictOf(d.event) == v; });
}

Read readPoint(std::string_view word) {
    return readTerm(word, "point=", numberIn<Index>, "the number of a point, such as point=812",
                    [](const Decision& d, Index p) { return testedPoint(d.event) == p; });
}
Read readPivot(std::string_view word) {
    return readTerm(word, "pivot=", numberIn<Index>, "the number of the point, such as pivot=812",
                    [](const Decision& d, Index p) { return d.pivot == p; });
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
    return readTerm(word, "at=", rangeIn, "pivot numbers, such as at=137 or at=100..200",
                    [](const Decision& d, const Range& r) { return r.has(d.event.address.pivot); });
}

/// A number of the pivot as a whole, one or from A to B.
Read readTally(std::string_view word, const std::string& prefix,
               std::uint32_t PivotTally::*number) {
    return readTerm(
        word, prefix, rangeIn, "a number or two, such as " + prefix + "5 or " + prefix + "10..19",
        [number](const Decision& d, const Range& r) { return r.has(tallyOf(d.events).*number); });
}
Read readRing(std::string_view word) { return readTally(word, "ring=", &PivotTally::ringLength); }
Read readCandidates(std::string_view word) {
    return readTally(word, "candidates=", &PivotTally::candidates);
}
Read readTests(std::string_view word) { return readTally(word, "tests=", &PivotTally::tests); }

/// `name<X` and `name>X` for a number of the reading.
Read readCompared(std::string_view word, const std::string& name,
                  double (*numberOf)(const Reading&)) {
    const std::string expected = "a number after < or >, such as " + name + "<1e-4";
    const bool above = word.starts_with(name + ">");
    return readTerm(word, name + (above ? ">" : "<"), numberIn<double>, expected,
                    [above, numberOf](const Decision& d, double limit) {
                        if (!d.reading) return false;
                        const double number = numberOf(*d.reading);
                        return above ? number > limit : number < limit;
                    });
}
Read readMargin(std::string_view word) {
    return readCompared(word, "margin", [](const Reading& r) { return std::abs(r.margin); });
}
Read readValue(std::string_view word) {
    return readCompared(word, "value", [](const Reading& r) { return r.value; });
}

/// `name` alone, for any point, or `name=812`; `holds` gets kNone for any point.
Read readPointTerm(std::string_view word, const std::string& name,
                   bool (*holds)(const Decision&, Index)) {
    if (word == name) return Condition([holds](const Decision& d) { return holds(d, kNone); });
    return readTerm(word, name + "=", numberIn<Index>,
                    "the number of a point, such as " + name + "=812", holds);
}
bool meets(Index wanted, Index point) { return wanted == kNone || wanted == point; }

/// True if the point gets its first entry on a ring (§4): by a seed, as a third point of §7, or in
/// a fan.
bool becomesUsed(const Decision& d, Index p) {
    if (const auto* seed = as<SeedEvidence>(d.event))
        return meets(p, seed->first) || meets(p, seed->second);
    if (const auto* insert = as<InsertEvidence>(d.event))
        return insert->third != kNone && meets(p, insert->third);
    const auto* ring = as<RingEvidence>(d.event);
    return ring != nullptr && ring->inserted && ring->status == 1 && meets(p, ring->point);
}
bool becomesStranded(const Decision& d, Index p) {
    const auto* strand = as<StrandEvidence>(d.event);
    return strand != nullptr && meets(p, strand->point);
}
/// True if its last entry leaves the rings (§6.5, §7), or it cannot begin a ring (§4).
bool becomesDone(const Decision& d, Index p) {
    const auto* ring = as<RingEvidence>(d.event);
    return becomesStranded(d, p) || (ring != nullptr && ring->status < 0 && meets(p, ring->point));
}
Read readUsed(std::string_view word) { return readPointTerm(word, "used", becomesUsed); }
Read readDone(std::string_view word) { return readPointTerm(word, "done", becomesDone); }
Read readStranded(std::string_view word) {
    return readPointTerm(word, "stranded", becomesStranded);
}

/// The two ends of an edge: "812,640".
std::optional<std::pair<Index, Index>> edgeIn(std::string_view text) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto a = numberIn<Index>(text.substr(0, comma));
    const auto b = numberIn<Index>(text.substr(std::min(comma + 1, text.size())));
    return a && b ? std::optional(std::pair(*a, *b)) : std::nullopt;
}
/// A new side of the mesh is a step of the ring (§6.5): the side of a triangle across from its
/// pivot, or the two steps of a seed.
bool makesEdge(const Decision& d, const std::pair<Index, Index>& edge) {
    const auto both = [&](Index x, Index y) {
        return edge == std::pair(x, y) || edge == std::pair(y, x);
    };
    if (const auto* seed = as<SeedEvidence>(d.event)) return both(seed->first, seed->second);
    const auto* emit = as<EmitEvidence>(d.event);
    return emit != nullptr && both(emit->corners.b, emit->corners.c);
}
Read readEdge(std::string_view word) {
    return readTerm(word, "edge=", edgeIn, "two points, such as edge=812,640", makesEdge);
}

Read readCloses(std::string_view word) {
    return readWord(word, "closes", [](const Decision& d) {
        return isA<CloseEvidence>(d.event) || isA<FreeEvidence>(d.event);
    });
}
Read readComponent(std::string_view word) {
    return readWord(word, "component",
                    [](const Decision& d) { return isA<ComponentEvidence>(d.event); });
}
Read readAlert(std::string_view word) {
    return readWord(word, "alert", [](const Decision& d) { return isA<AlertEvidence>(d.event); });
}

/// A class of failures, as a bit of Decision::failures; all of them without a name.
Read readFailure(std::string_view word) {
    if (word == "failure") return Condition([](const Decision& d) { return d.failures != 0; });
    constexpr std::string_view kPrefix = "failure=";
    if (!word.starts_with(kPrefix)) return Condition();
    const FailureClass* kind = findFailureClass(word.substr(kPrefix.size()));
    if (kind != nullptr && appearsInRun(*kind))
        return Condition(
            [bit = failureBit(*kind)](const Decision& d) { return (d.failures & bit) != 0; });
    std::string names;
    for (const FailureClass& each : failureClasses())
        if (appearsInRun(each)) names += (names.empty() ? "" : ", ") + std::string(each.name);
    if (kind == nullptr)
        return notA(word, "a class of failures that appears during a run: " + names);
    return Error{inQuotes(word) +
                 ": that is known only when the run has ended; during a run there are " + names +
                 "."};
}

std::optional<double> cosineIn(std::string_view text) {
    const auto degrees = numberIn<double>(text);
    if (!degrees) return {};
    return std::cos(*degrees * 3.14159265358979323846 / 180.0);
}
Read readLeastAngle(std::string_view word) {
    return readTerm(
        word, "angle<", cosineIn, "degrees, such as angle<5", [](const Decision& d, double cosine) {
            const auto* emit = as<EmitEvidence>(d.event);
            return emit != nullptr && leastAngleCosine(d.points, emit->corners) > cosine;
        });
}

/// Limit of a range, so that a typing error does not fill the memory.
constexpr Index kMaxInRange = 10'000'000;

/// The points of "3,4,5" or "3..5", ascending.
std::optional<std::vector<Index>> pointsIn(std::string_view text) {
    std::vector<Index> points;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const auto range = rangeIn(text.substr(0, comma));
        if (!range || range->to < range->from || range->to - range->from >= kMaxInRange) return {};
        for (Index p = range->from; p <= range->to; ++p) points.push_back(p);
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    std::sort(points.begin(), points.end());
    return points;
}
Read readAmong(std::string_view word) {
    return readTerm(word, "among=", pointsIn, "points, such as among=3,4,5 or among=3..5",
                    [](const Decision& d, const std::vector<Index>& points) {
                        const auto has = [&](Index p) {
                            return std::binary_search(points.begin(), points.end(), p);
                        };
                        return has(testedPoint(d.event)) || has(d.pivot);
                    });
}

constexpr QueryTerm kTerms[] = {
    {"stage=NAME", "Of this stage: sort, sphere, ring ...", readStage},
    {"section=6.3", "Of this section of the paper.", readSection},
    {"kept", "A test that took its point.", readKept},
    {"refused", "A test that refused its point.", readRefused},
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
