#include "line_text.h"

#include "run/number_format.h"
#include "run/strings.h"
#include "spiraling_edge/replay/event_text.h"

namespace se::view {

namespace {

std::string valueText(const Reading& reading, double value) {
    return reading.unit.empty() ? numberText(value) : degreesText(value);
}

}  // namespace

std::string marginText(double margin) { return margin == 0.0 ? "0" : formatted("%+.2g", margin); }

std::string comparisonText(const Reading& reading, bool named) {
    return (named ? std::string(reading.quantity) + " " : std::string{}) +
           valueText(reading, reading.value) + " against " + valueText(reading, reading.threshold);
}

std::string readingText(const Reading& reading) {
    return comparisonText(reading, true) + ", margin " + marginText(reading.margin);
}

std::string lineText(const LedgerLine& line) {
    const std::string_view section = stageSection(line.event.address.stage);
    std::string text = toString(line.event.address) + "  " + std::string(roleName(line.role)) +
                       (line.pivot == kNone ? "" : "  pivot " + std::to_string(line.pivot)) +
                       (section.empty() ? "" : "  " + std::string(section)) + "  " +
                       describe(line.event);
    if (line.reading) text += "\n    " + readingText(*line.reading);
    return text;
}

std::string ledgerText(const std::string& answer, std::span<const LedgerLine> lines,
                       std::size_t cause) {
    std::string text = answer + "\n\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += (i == cause ? "> " : "  ") + lineText(lines[i]) + "\n";
    return text;
}

}  // namespace se::view
