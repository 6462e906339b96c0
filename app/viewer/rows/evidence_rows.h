/// Rows of Inspect for a decision: values, thresholds and margins. Plain values, no ImGui.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "run/overview.h"
#include "spiraling_edge/points/point_name.h"
#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/pivot_replay.h"

namespace se::view {

/// A value against its threshold, on a scale that ends at `largest`.
struct EvidenceGauge {
    double value = 0.0;
    double threshold = 0.0;
    double largest = 1.0;
};

struct EvidenceRow {
    std::string name;
    std::string value;
    std::optional<EvidenceGauge> gauge;  ///< Drawn below the value.
};

struct EvidenceInput {
    const Model& model;
    const DecisionState& picture;  ///< State at the event.
    const Event& event;
    const RunOverview* run = nullptr;  ///< Overview so far; for `done`.
    std::span<const PointName> names{};
};

/// The rows of the event's evidence, in order; the verdict is not among them.
std::vector<EvidenceRow> evidenceRows(const EvidenceInput& in);

/// The paper's section of a decision: that of its stage, except for stages with two sections. Empty
/// for rules beyond the paper.
std::string sectionOf(const Event& event);

/// "+x +z", the walls of a type (TypeBits).
std::string wallsText(std::uint8_t type);

// A decision of a ledger in words, for rows, tooltips and the clipboard.

/// "angle 120.9° against 211.4°, margin +1.6".
std::string readingText(const Reading& reading);
/// "angle 120.9° against 211.4°", or without the name of the quantity.
std::string comparisonText(const Reading& reading, bool named);
/// "+1.6", "-3.2e-05", "0".
std::string marginText(double margin);
/// Address, role, pivot, section, sentence and reading, in two lines at most.
std::string lineText(const LedgerLine& line);
/// The answer and all lines; the decisive one has a mark.
std::string ledgerText(const std::string& answer, std::span<const LedgerLine> lines,
                       std::size_t cause);

/// The terms that complete the last word of a line; all of them after a space, or if it is none.
std::vector<const QueryTerm*> termsFor(std::string_view line);
/// The line with its last word replaced by the beginning of a term: "stage=sphere mar" and
/// margin<X give "stage=sphere margin<".
std::string completed(std::string_view line, const QueryTerm& term);

}  // namespace se::view
