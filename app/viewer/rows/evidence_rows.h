/// Rows of Inspect for a decision: values, thresholds and margins. Plain values, no ImGui.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/overview.h"
#include "spiraling_edge/points/point_name.h"
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

}  // namespace se::view
