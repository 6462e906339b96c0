/// The rows of Inspect, one function for each kind of evidence: those of evidence_tests.cpp, and
/// what they share with those of evidence_rows.cpp.
#pragma once

#include "evidence_rows.h"
#include "run/number_format.h"
#include "run/strings.h"
#include "scene/selection_measures.h"

namespace se::view {

/// Collects the rows of one event, one after the other.
class EvidenceRows {
  public:
    void row(std::string name, std::string value) {
        rows_.push_back({std::move(name), std::move(value), std::nullopt});
    }
    void row(std::string name, std::string value, const EvidenceGauge& gauge) {
        rows_.push_back({std::move(name), std::move(value), gauge});
    }
    /// An angle that must stay below a limit (or above it), and the margin.
    void angle(const std::string& name, double degrees, double limit, double largest = 360.0);
    /// A value whose sign decides; `scale` is a large value for comparison.
    void sign(const std::string& name, const std::string& value, double number, double scale);
    std::vector<EvidenceRow> take() { return std::move(rows_); }

  private:
    std::vector<EvidenceRow> rows_;
};

/// "12, 34", or the letters of a figure; "none" for no point.
std::string pointsText(const std::vector<Index>& list, std::span<const PointName> names);

// Where a ring begins, and at the walls.
void addRows(const SeedEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const StrandEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const PivotEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const SkipEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const InsertEvidence& e, const EvidenceInput& in, EvidenceRows& out);
// The tests of 6.1 to 6.4.
void addRows(const SortEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const LimitEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const DropEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const ReciprocalEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const HoleEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const SphereEvidence& e, const EvidenceInput& in, EvidenceRows& out);
void addRows(const TwoPointEvidence& e, const EvidenceInput& in, EvidenceRows& out);

}  // namespace se::view
