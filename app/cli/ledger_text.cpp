#include "ledger_text.h"

#include <fmt/format.h>

#include "mesh_text.h"

namespace se::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string readingText(const Reading& reading) {
    return fmt::format("{} {:.6g}{} against {:.6g}{}, margin {:+.2g}", reading.quantity,
                       reading.value, reading.unit.empty() ? "" : " deg", reading.threshold,
                       reading.unit.empty() ? "" : " deg", reading.margin);
}

std::string linesText(const std::vector<LedgerLine>& lines, std::size_t marked) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LedgerLine& line = lines[i];
        const std::string pivot = line.pivot == kNone ? "" : fmt::format("pivot {}", line.pivot);
        text += fmt::format("{} {:<18} {:<8} {:<12} {:<4} {}\n", i == marked ? '>' : ' ',
                            toString(line.event.address), roleName(line.role), pivot,
                            stageSection(line.event.address.stage), describe(line.event));
        if (line.reading) text += fmt::format("{:49}{}\n", "", readingText(*line.reading));
    }
    return text;
}

Json lineJson(const LedgerLine& line) {
    Json json;
    json["address"] = toString(line.event.address);
    json["role"] = roleName(line.role);
    json["pivot"] = line.pivot == kNone ? Json() : Json(line.pivot);
    json["section"] = stageSection(line.event.address.stage);
    json["text"] = describe(line.event);
    if (line.reading) {
        json["quantity"] = line.reading->quantity;
        json["value"] = line.reading->value;
        json["threshold"] = line.reading->threshold;
        json["margin"] = line.reading->margin;
    }
    return json;
}

std::string dumped(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string ledgerText(const Ledger& ledger) {
    return ledger.answer + "\n\n" + linesText(ledger.lines, ledger.cause);
}

std::string ledgerJson(const std::string& input, const Ledger& ledger) {
    Json json;
    json["input"] = input;
    json["subject"] =
        std::vector<Index>(ledger.subject.points().begin(), ledger.subject.points().end());
    json["present"] = ledger.present;
    json["answer"] = ledger.answer;
    json["cause"] = toString(ledger.lines[ledger.cause].event.address);
    json["lines"] = Json::array();
    for (const LedgerLine& line : ledger.lines) json["lines"].push_back(lineJson(line));
    return dumped(json);
}

std::string callsText(const ClosestCalls& calls) {
    std::string text;
    for (const ClosestCall& call : calls.calls) {
        const Vec3& by = call.nudge.by;
        text += fmt::format("{:<18} {}\n{:19}{}; moving {} by ({:.3g}, {:.3g}, {:.3g}) turns it\n",
                            toString(call.event.address), describe(call.event), "",
                            readingText(call.reading), call.nudge.point, by.x, by.y, by.z);
    }
    return text;
}

std::string callsJson(const std::string& input, const ClosestCalls& calls) {
    Json json;
    json["input"] = input;
    json["closest"] = Json::array();
    for (const ClosestCall& call : calls.calls) {
        Json row = lineJson({call.event, call.pivot, LineRole::Fact, call.reading});
        row["role"] =
            roleName(outcomeOf(call.event) == Outcome::Taken ? LineRole::Taken : LineRole::Refused);
        const Vec3& by = call.nudge.by;
        row["nudge"] = {{"point", call.nudge.point}, {"by", {by.x, by.y, by.z}}};
        json["closest"].push_back(row);
    }
    return dumped(json);
}

std::string foundText(const FoundDecisions& found) {
    const std::string more = found.total > found.lines.size()
                                 ? fmt::format(", the first {} of them:", found.lines.size())
                                 : "";
    return fmt::format("{}{}\n", counted(found.total, "decision"), more) +
           linesText(found.lines, found.lines.size());
}

std::string foundJson(const std::string& input, const FoundDecisions& found) {
    Json json;
    json["input"] = input;
    json["total"] = found.total;
    json["lines"] = Json::array();
    for (const LedgerLine& each : found.lines) json["lines"].push_back(lineJson(each));
    return dumped(json);
}

std::string momentsText(const MeshFailure& failure, const FailureMoments& moments) {
    const auto row = [](const char* name, const LedgerLine& line) {
        std::string text = fmt::format("  {:<16} {:<18} {}\n", name, toString(line.event.address),
                                       describe(line.event));
        if (line.reading) text += fmt::format("{:37}{}\n", "", readingText(*line.reading));
        return text;
    };
    return describe(failure) + "\n" + row("created", moments.created) +
           row("unavoidable", moments.unavoidable) + row("first touched", moments.touched);
}

std::string momentsJson(const std::string& input, const MeshFailure& failure,
                        const FailureMoments& moments) {
    Json json;
    json["input"] = input;
    json["class"] = failure.kind->name;
    json["points"] = failure.points;
    json["triangles"] = failure.triangles;
    json["created"] = lineJson(moments.created);
    json["unavoidable"] = lineJson(moments.unavoidable);
    json["first_touched"] = lineJson(moments.touched);
    return dumped(json);
}

}  // namespace se::cli
