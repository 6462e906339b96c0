// Each line is parsed by itself, so that a fault has its line, and memory is that of the pivots.
// A pivot is run phase by phase; what a stage leaves is read off the State after its phase, so that
// a trace needs no log.
#include "setrace.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/text_scan.h"
#include "teach/file_bytes.h"
#include "teach/json_text.h"

namespace se::teach {
namespace {

using TraceJson = nlohmann::ordered_json;

constexpr std::array kTraceStages{
    TraceStageRow{TraceStage::Sort, "sort", "sort", Phase::Sort, Stage::Sort, &TracePivot::sort},
    TraceStageRow{TraceStage::Limits, "limits", "limits", Phase::Convex, Stage::Convex,
                  &TracePivot::limits},
    TraceStageRow{TraceStage::Reciprocal, "reciprocal", "reciprocal", Phase::Reciprocal,
                  Stage::Reciprocal, &TracePivot::reciprocal},
    TraceStageRow{TraceStage::Hole, "hole", "hole", Phase::Hole, Stage::Hole, &TracePivot::hole},
    TraceStageRow{TraceStage::Sphere, "sphere", "sphere", Phase::Sphere, Stage::Sphere,
                  &TracePivot::sphere},
    TraceStageRow{TraceStage::Emit, "emit", "fan", Phase::Emit, Stage::Guard, &TracePivot::fan},
    TraceStageRow{TraceStage::Ring, "ring", "ring", Phase::Advance, Stage::Advance,
                  &TracePivot::ring},
};
static_assert(isInOrder(kTraceStages) && kTraceStages.size() == kTraceStageCount);

// ---- writing ------------------------------------------------------------------------------------

TraceJson jsonOfSteps(const std::vector<RingStep>& steps) {
    TraceJson list = TraceJson::array();
    for (const RingStep& step : steps) list.push_back({step.from, step.to});
    return list;
}

// ---- reading ------------------------------------------------------------------------------------

/// Expectation that the fan of a pivot does not meet; empty if it meets all.
std::string faultOfFan(const TracePivot& pivot) {
    const std::vector<Index>& fan = *pivot.fan;
    if (fan.empty()) return {};
    if (fan.front() != pivot.first || fan.back() != pivot.last) {
        return "points from first, " + std::to_string(pivot.first) + ", to last, " +
               std::to_string(pivot.last);
    }
    if (fan.size() < 2) return "two points or more, or [] for none";
    if (std::find(fan.begin(), fan.end(), pivot.p) != fan.end())
        return "no p, which every triangle has anyway";
    if (std::adjacent_find(fan.begin(), fan.end()) != fan.end()) return "no point twice in a row";
    return {};
}

/// The pivot of a line; `number`: from 1. Throws an Error.
TracePivot pivotOfLine(const JsonEntry& line, std::size_t points, std::size_t number) {
    TracePivot pivot;
    pivot.p = line.at("p").point(points);
    pivot.first = line.at("first").point(points);
    pivot.last = line.at("last").point(points);
    if (pivot.p == pivot.first || pivot.p == pivot.last)
        line.at("p").fail("a pivot other than first and last");
    if (line.has("start")) pivot.start = line.at("start").point(points);
    if (line.has("end")) pivot.end = line.at("end").point(points);
    if (line.has("next"))
        pivot.next = line.at("next").json().is_null() ? kNone : line.at("next").point(points);
    for (const TraceStageRow& row : kTraceStages) {
        if (line.has(row.field))
            pivot.*row.points = line.at(row.field).points("a list of points", points);
    }
    if (line.has("ends")) pivot.ends = line.at("ends").truth();
    const std::string expected = pivot.fan ? faultOfFan(pivot) : "";
    if (!expected.empty()) {
        line.at("fan").fail(expected + ", at pivot " + std::to_string(number) + " (point " +
                            std::to_string(pivot.p) + ")");
    }
    return pivot;
}

Error traceError(const std::string& name, std::size_t line, const std::string& what) {
    return io::errorAt(name, io::lineText(line), what);
}

/// The object of a line. Fails if it is none.
Result<nlohmann::json> objectOfLine(const io::LineReader& lines, const std::string& name) {
    if (const std::string fault = jsonLimitFault(lines.line(), lines.number()); !fault.empty())
        return Error{name + ": " + fault};
    nlohmann::json json = nlohmann::json::parse(lines.line(), nullptr, false);
    if (json.is_object()) return json;
    const bool cut = json.is_discarded() && lines.rest().empty();
    return traceError(name, lines.number(),
                      std::string("expected one JSON object, got ") + inQuotes(lines.line()) +
                          (cut ? "; the last line may be cut off" : ""));
}

/// The header. Throws an Error unless it is one.
Trace traceOfHeader(const JsonEntry& head) {
    if (!head.has("setrace"))
        head.fail("the header {\"setrace\": 1, \"points\": N, \"hash\": ...}");
    if (head.at("setrace").json() != 1) head.at("setrace").fail("version 1");
    Trace trace;
    const nlohmann::json& points = head.at("points").json();
    if (!points.is_number_unsigned() || points == 0 || points >= kNone)
        head.at("points").fail("the number of points of the input");
    trace.points = points.get<std::size_t>();
    if (head.has("hash")) trace.hash = head.at("hash").text();
    return trace;
}

/// Success if a pivot that another one follows has the stages up to `upto`, and does not end the
/// trace.
Status requireWhole(const TracePivot& pivot, TraceStage upto, const std::string& name) {
    if (pivot.ends) {
        return traceError(name, pivot.line,
                          "ends: expected in the last line only, another pivot follows");
    }
    if (hasStage(pivot, upto)) return success();
    return traceError(
        name, pivot.line,
        std::string(rowOf(upto).field) + ": expected a list of points, it is missing");
}

void addOpenSteps(const EdgeRings& rings, Index ring, std::vector<RingStep>& open) {
    for (const Index entry : rings.entriesOf(ring)) {
        if (rings.open(entry)) open.push_back({rings.point(entry), rings.point(rings.next(entry))});
    }
}

/// The rings after a pivot.
void recordRings(const State& state, TracePivot& pivot) {
    const EdgeRings& rings = state.rings;
    pivot.ring.emplace();
    pivot.next = kNone;
    if (rings.active() != kNone) {
        pivot.ring = ringFrom(rings, state.pivot.pivot);
        pivot.next = pivot.ring->front();
        addOpenSteps(rings, rings.active(), pivot.open);
    }
    for (const Index ring : rings.stack()) {
        pivot.stack.push_back(ringFrom(rings, rings.head(ring)));
        addOpenSteps(rings, ring, pivot.open);
    }
}

/// Records what the phase that just ran has left.
void recordStage(Phase phase, const State& state, TracePivot& pivot) {
    for (const TraceStageRow& row : traceStages()) {
        if (row.phase != phase || row.id >= TraceStage::Emit) continue;
        std::vector<Index>& points = (pivot.*row.points).emplace();
        for (const Candidate& each : state.pivot.candidates) points.push_back(each.point);
    }
    if (phase != Phase::Convex) return;
    pivot.start = state.rings.point(state.pivot.start);
    pivot.end = state.rings.point(state.pivot.end);
}

[[maybe_unused]] bool isBetweenPivots(Phase phase) {
    return phase == Phase::Seed || phase == Phase::Pivot || phase == Phase::Fill ||
           phase == Phase::Finished || isRepair(phase);
}

/// The pivot at the phase that begins it.
TracePivot beginningOf(const State& state) {
    TracePivot pivot;
    const Index entry = state.pivot.pivot;
    pivot.p = state.rings.point(entry);
    pivot.first = state.rings.point(state.rings.prev(entry));
    pivot.last = state.rings.point(state.rings.next(entry));
    pivot.fan.emplace();
    return pivot;
}

}  // namespace

bool hasStage(const TracePivot& pivot, TraceStage stage) {
    if (pivot.*rowOf(stage).points) return true;
    return stage != TraceStage::Ring && pivot.fan && pivot.fan->empty();
}

std::span<const TraceStageRow> traceStages() { return kTraceStages; }

const TraceStageRow& rowOf(TraceStage stage) {
    return kTraceStages[static_cast<std::size_t>(stage)];
}

std::string pointsHash(const PointSet& points) {
    ByteHash hash;
    for (const Vec3& x : points.position) {
        for (int i = 0; i < 3; ++i) hash.add(x[i]);
    }
    return hash.text();
}

std::string traceHeader(const PointSet& points) {
    const TraceJson json{{"setrace", 1}, {"points", points.size()}, {"hash", pointsHash(points)}};
    return json.dump() + '\n';
}

std::string traceLine(const TracePivot& pivot) {
    TraceJson json{{"p", pivot.p}, {"first", pivot.first}, {"last", pivot.last}};
    for (const TraceStageRow& row : kTraceStages) {
        const TracedPoints& points = pivot.*row.points;
        if (points) json[std::string(row.field)] = *points;
        if (row.id != TraceStage::Limits) continue;
        if (pivot.start) json["start"] = *pivot.start;
        if (pivot.end) json["end"] = *pivot.end;
    }
    if (pivot.next) json["next"] = *pivot.next == kNone ? TraceJson() : TraceJson(*pivot.next);
    if (pivot.ends) json["ends"] = true;
    if (!pivot.stack.empty()) json["stack"] = pivot.stack;
    if (!pivot.open.empty()) json["open"] = jsonOfSteps(pivot.open);
    if (!pivot.done.empty()) json["done"] = pivot.done;
    return json.dump() + '\n';
}

Result<Trace> readTrace(std::string_view text, const std::string& name, TraceStage upto) {
    if (const std::size_t line = lineOfBadByte(text); line > 0)
        return traceError(name, line, "not UTF-8; a trace is a text file");
    io::LineReader lines(text);
    std::optional<Trace> trace;
    while (lines.nextContent()) {
        const Result<nlohmann::json> json = objectOfLine(lines, name);
        if (!json) return json.error();
        if (trace && !trace->pivots.empty()) {
            const Status whole = requireWhole(trace->pivots.back(), upto, name);
            if (!whole) return whole.error();
        }
        try {
            const JsonEntry entry(json.value(), name + ": " + io::lineText(lines.number()));
            if (!trace) {
                trace = traceOfHeader(entry);
                continue;
            }
            trace->pivots.push_back(pivotOfLine(entry, trace->points, trace->pivots.size() + 1));
            trace->pivots.back().line = lines.number();
        } catch (const Error& fault) {
            return fault;
        }
    }
    if (!trace) return Error{name + ": the file is empty"};
    return *std::move(trace);
}

Result<Trace> readTraceFile(const std::string& path, TraceStage upto) {
    const Result<std::string> bytes =
        readBytes(path, {kMaxTraceBytes, "write the traces of fewer pivots, without `ring`"});
    if (!bytes) return bytes.error();
    return readTrace(bytes.value(), path, upto);
}

Status requireTraceOf(const Trace& trace, const PointSet& points, const std::string& name) {
    if (trace.points != points.size()) {
        return traceError(name, 1,
                          "points: the input has " + std::to_string(points.size()) +
                              " points, the trace is of " + std::to_string(trace.points));
    }
    if (!trace.hash.empty() && trace.hash != pointsHash(points)) {
        return traceError(name, 1,
                          "hash: the input has " + pointsHash(points) +
                              "; the trace is of other points, or of another order");
    }
    return success();
}

std::vector<Index> ringFrom(const EdgeRings& rings, Index entry) {
    std::vector<Index> points;
    for (const Index each : RingEntries(rings, entry, rings.length(rings.ringOf(entry))))
        points.push_back(rings.point(each));
    return points;
}

TraceStep stepTraced(Stepper& stepper, TraceDetail detail) {
    assert(isBetweenPivots(stepper.state().phase));
    TraceStep step;
    const std::size_t doneBefore = stepper.state().done.size();
    while (true) {
        const Phase phase = stepper.state().phase;
        if (!stepper.advance()) return step;
        const State& state = stepper.state();
        if (isRepair(phase)) {
            step.ran = true;
            return step;
        }
        if (phase == Phase::Pivot || phase == Phase::Fill) step.pivot = beginningOf(state);
        if (!step.pivot) continue;
        if (phase == Phase::Emit) step.pivot->fan = state.pivot.spokes;
        if (detail == TraceDetail::Stages) recordStage(phase, state, *step.pivot);
        if (phase != Phase::Advance) continue;
        step.ran = true;
        if (detail == TraceDetail::Fans) return step;
        recordRings(state, *step.pivot);
        step.pivot->done.assign(state.done.begin() + static_cast<std::ptrdiff_t>(doneBefore),
                                state.done.end());
        return step;
    }
}

}  // namespace se::teach
