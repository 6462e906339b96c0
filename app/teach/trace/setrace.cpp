// Each line is parsed by itself, so that a fault has its line, and memory is that of the pivots.
#include "setrace.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/text_scan.h"
#include "teach/file_bytes.h"
#include "teach/find_named.h"
#include "teach/json_text.h"

namespace se::teach {
namespace {

using TraceJson = nlohmann::ordered_json;

constexpr std::array kTraceStages{
    TraceStageRow{TraceStage::Sort, "sort", "sort", "6.1", Stage::Sort, &TracePivot::sort},
    TraceStageRow{TraceStage::Limits, "limits", "limits", "6.1", Stage::Convex,
                  &TracePivot::limits},
    TraceStageRow{TraceStage::Reciprocal, "reciprocal", "reciprocal", "6.1", Stage::Reciprocal,
                  &TracePivot::reciprocal},
    TraceStageRow{TraceStage::Hole, "hole", "hole", "6.2", Stage::Hole, &TracePivot::hole},
    TraceStageRow{TraceStage::Sphere, "sphere", "sphere", "6.3", Stage::Sphere,
                  &TracePivot::sphere},
    TraceStageRow{TraceStage::Emit, "emit", "fan", "6.4", Stage::Guard, &TracePivot::fan},
    TraceStageRow{TraceStage::Ring, "ring", "ring", "6.5", Stage::Advance, &TracePivot::ring},
};
static_assert(isInOrder(kTraceStages) && kTraceStages.size() == kTraceStageCount);

/// A point that may be missing.
struct TracePointField {
    std::string_view name;
    std::optional<Index> TracePivot::*point;
};
constexpr std::array kTracePointFields{TracePointField{"start", &TracePivot::start},
                                       TracePointField{"end", &TracePivot::end}};

// ---- writing ------------------------------------------------------------------------------------

TraceJson jsonOfSteps(const std::vector<RingStep>& steps) {
    TraceJson list = TraceJson::array();
    for (const RingStep& step : steps) list.push_back({step.from, step.to});
    return list;
}

// ---- reading ------------------------------------------------------------------------------------

/// The fields of one line. After the first fault, which is kept, nothing more is read.
class TraceLineReader {
  public:
    /// `number`: of the pivot, from 1.
    TraceLineReader(const TraceJson& json, std::size_t points, std::size_t number)
        : json_(json), points_(points), number_(number) {}

    const std::string& fault() const { return fault_; }

    TracePivot pivot() {
        TracePivot pivot;
        pivot.p = point("p");
        pivot.first = point("first");
        pivot.last = point("last");
        if (fault_.empty() && (pivot.p == pivot.first || pivot.p == pivot.last))
            complain("p", "a pivot other than first and last");
        for (const TracePointField& each : kTracePointFields) {
            if (json_.contains(each.name)) pivot.*each.point = point(each.name);
        }
        if (json_.contains("next")) pivot.next = nextPivot();
        for (const TraceStageRow& row : kTraceStages) {
            if (json_.contains(row.field)) pivot.*row.points = list(row.field);
        }
        if (json_.contains("ends")) pivot.ends = truth("ends");
        if (fault_.empty() && pivot.fan) checkFan(pivot);
        return pivot;
    }

  private:
    void complain(std::string_view field, const std::string& expected) {
        if (fault_.empty()) fault_ = '"' + std::string(field) + "\": expected " + expected;
    }
    std::string numbers() const {
        return "the number of a point, from 0 to " + std::to_string(points_ - 1);
    }
    bool isPoint(const TraceJson& value) const {
        return value.is_number_unsigned() && value.get<std::uint64_t>() < points_;
    }
    Index point(std::string_view field) {
        const auto found = json_.find(field);
        if (found == json_.end()) complain(field, numbers() + ", it is missing");
        if (found == json_.end()) return kNone;
        if (isPoint(*found)) return found->get<Index>();
        complain(field, numbers() + ", got " + shortText(*found));
        return kNone;
    }
    bool truth(std::string_view field) {
        const TraceJson& value = json_.at(std::string(field));
        if (!value.is_boolean()) complain(field, "true or false, got " + shortText(value));
        return value == true;
    }
    Index nextPivot() { return json_.at("next").is_null() ? kNone : point("next"); }
    std::vector<Index> list(std::string_view field) {
        const TraceJson& values = json_.at(std::string(field));
        std::vector<Index> points;
        if (!values.is_array()) complain(field, "a list of points, got " + shortText(values));
        if (!values.is_array()) return points;
        points.reserve(values.size());
        for (const TraceJson& each : values) {
            if (!isPoint(each)) {
                complain(field, numbers() + ", got " + shortText(each));
                return points;
            }
            points.push_back(each.get<Index>());
        }
        return points;
    }
    void checkFan(const TracePivot& pivot) {
        const std::string expected = faultOfFan(pivot);
        if (expected.empty()) return;
        complain("fan", expected + ", got " + shortText(json_.at("fan")) + " at pivot " +
                            std::to_string(number_) + " (point " + std::to_string(pivot.p) + ")");
    }
    /// The sentence on what the fan should be; empty if it is that.
    static std::string faultOfFan(const TracePivot& pivot) {
        const std::vector<Index>& fan = *pivot.fan;
        if (fan.empty()) return {};
        if (fan.front() != pivot.first || fan.back() != pivot.last) {
            return "points from first, " + std::to_string(pivot.first) + ", to last, " +
                   std::to_string(pivot.last);
        }
        if (fan.size() < 2) return "two points or more, or [] for none";
        if (std::find(fan.begin(), fan.end(), pivot.p) != fan.end())
            return "no p, which every triangle has anyway";
        if (std::adjacent_find(fan.begin(), fan.end()) != fan.end())
            return "no point twice in a row";
        return {};
    }
    static std::string shortText(const TraceJson& value) { return '"' + jsonExcerpt(value) + '"'; }

    const TraceJson& json_;
    std::size_t points_;
    std::size_t number_;
    std::string fault_;
};

Error traceError(const std::string& name, std::size_t line, const std::string& what) {
    return io::errorAt(name, io::lineText(line), what);
}

/// The object of a line. Fails if it is none.
Result<TraceJson> objectOfLine(const io::LineReader& lines, const std::string& name) {
    if (const std::string fault = jsonLimitFault(lines.line(), lines.number()); !fault.empty())
        return Error{name + ": " + fault};
    TraceJson json = TraceJson::parse(lines.line(), nullptr, false);
    if (json.is_object()) return json;
    const bool cut = json.is_discarded() && lines.rest().empty();
    return traceError(name, lines.number(),
                      std::string("expected one JSON object, got ") + inQuotes(lines.line()) +
                          (cut ? "; the last line may be cut off" : ""));
}

/// The header. Fails unless it is one.
Result<Trace> readTraceHeader(const TraceJson& json, std::size_t line, const std::string& name) {
    const auto version = json.find("setrace");
    if (version == json.end()) {
        return traceError(name, line,
                          "expected the header {\"setrace\": 1, \"points\": N, \"hash\": ...}");
    }
    if (*version != 1) return traceError(name, line, "\"setrace\": expected version 1");
    Trace trace;
    const auto points = json.find("points");
    if (points == json.end() || !points->is_number_unsigned() ||
        points->get<std::uint64_t>() == 0 || points->get<std::uint64_t>() >= kNone)
        return traceError(name, line, "\"points\": expected the number of points of the input");
    trace.points = points->get<std::size_t>();
    const auto hash = json.find("hash");
    if (hash == json.end()) return trace;
    if (!hash->is_string())
        return traceError(name, line, "\"hash\": expected a text such as \"fnv1a64:...\"");
    trace.hash = hash->get<std::string>();
    return trace;
}

/// Success if a pivot that another one follows has the stages up to `upto`, and does not end the
/// trace.
Status requireWhole(const TracePivot& pivot, TraceStage upto, const std::string& name) {
    if (pivot.ends) {
        return traceError(name, pivot.line,
                          "\"ends\": expected in the last line only, another pivot follows");
    }
    if (hasStage(pivot, upto)) return success();
    return traceError(
        name, pivot.line,
        '"' + std::string(rowOf(upto).field) + "\": expected a list of points, it is missing");
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

std::optional<TraceStage> traceStageFromName(std::string_view name) {
    const TraceStageRow* row = findNamed(kTraceStages, name);
    return row != nullptr ? std::optional(row->id) : std::nullopt;
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
        for (const TracePointField& each : kTracePointFields) {
            if (pivot.*each.point) json[std::string(each.name)] = *(pivot.*each.point);
        }
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
    if (!lines.nextContent()) return Error{name + ": the file is empty"};
    const Result<TraceJson> head = objectOfLine(lines, name);
    if (!head) return head.error();
    Result<Trace> header = readTraceHeader(head.value(), lines.number(), name);
    if (!header) return header;
    Trace trace = std::move(header.value());
    while (lines.nextContent()) {
        const Result<TraceJson> json = objectOfLine(lines, name);
        if (!json) return json.error();
        if (!trace.pivots.empty()) {
            const Status whole = requireWhole(trace.pivots.back(), upto, name);
            if (!whole) return whole.error();
        }
        TraceLineReader reader(json.value(), trace.points, trace.pivots.size() + 1);
        trace.pivots.push_back(reader.pivot());
        if (!reader.fault().empty()) return traceError(name, lines.number(), reader.fault());
        trace.pivots.back().line = lines.number();
    }
    return trace;
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
                          "\"points\": the input has " + std::to_string(points.size()) +
                              " points, the trace is of " + std::to_string(trace.points));
    }
    if (!trace.hash.empty() && trace.hash != pointsHash(points)) {
        return traceError(name, 1,
                          "\"hash\": the input has " + pointsHash(points) +
                              "; the trace is of other points, or of another order");
    }
    return success();
}

}  // namespace se::teach
