#include "evidence_rows.h"

#include <algorithm>
#include <cmath>

#include "evidence_parts.h"

namespace se::view {

void EvidenceRows::angle(const std::string& name, double degrees, double limit, double largest) {
    row(name, degreesText(degrees) + ", limit " + degreesText(limit), {degrees, limit, largest});
    row("margin",
        degreesText(std::abs(limit - degrees)) + (degrees > limit ? " over" : " under") + " it");
}

void EvidenceRows::sign(const std::string& name, const std::string& value, double number,
                        double scale) {
    // Zero in the middle.
    const double reach = std::max(std::abs(number), std::abs(scale));
    row(name, value, {number + reach, reach, 2.0 * reach});
}

std::string pointsText(const std::vector<Index>& list) {
    std::string text;
    for (const Index p : list) {
        text += (text.empty() ? "" : ", ") + (p == kNone ? std::string("none") : std::to_string(p));
    }
    return text;
}

std::string countText(std::size_t count, const std::string& word) {
    return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

std::string wallsText(std::uint8_t type) {
    constexpr const char* kFaces[] = {"+x",           "+y", "+z", "\xE2\x88\x92x", "\xE2\x88\x92y",
                                      "\xE2\x88\x92z"};
    std::string text;
    for (unsigned i = 0; i < 6; ++i) {
        if ((type >> i & 1U) != 0) text += (text.empty() ? "" : " ") + std::string(kFaces[i]);
    }
    return text.empty() ? (isRimPoint(type) ? "none, a rim" : "none") : text;
}

std::vector<EvidenceRow> evidenceRows(const EvidenceInput& in) {
    EvidenceRows rows;
    std::visit([&](const auto& evidence) { addRows(evidence, in, rows); }, in.event.evidence);
    return rows.take();
}

std::string sectionOf(const Event& event) {
    const auto* insert = std::get_if<InsertEvidence>(&event.evidence);
    return insert != nullptr && insert->corner ? "7.2"
                                               : std::string(stageSection(event.address.stage));
}

}  // namespace se::view
