/// The part of the run that the RUN strip shows, and its shapes for the lanes of a part of the run:
/// limited by the number of pixels, not by the length of the run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "run/overview.h"
#include "spiraling_edge/run/pivot_replay.h"

namespace se::view {

/// The part of the run that the strip shows: pivots from() to to(), of 0 to last(). Both ends may
/// lie between two pivots.
class StripWindow {
  public:
    /// Minimum number of pivots that are shown.
    static constexpr double kLeast = 12.0;

    double from() const { return whole_ ? 0.0 : from_; }
    double to() const { return whole_ ? last_ : to_; }
    double last() const { return last_; }
    bool whole() const { return whole_; }

    /// The run has become longer, or is another one. A window on the whole stays so.
    void setLast(std::uint32_t last);
    void showAll() { whole_ = true; }
    /// Shows more (notches < 0) or less, so that the position at `share` of the width stays there.
    void zoomAt(double share, double notches);
    /// Moves by a share of the width.
    void pan(double shares);
    /// Moves until `pivot` is within.
    void reveal(std::uint32_t pivot);

    /// Position of a pivot, as a share of the width; outside of [0, 1] if it is not within.
    double shareOf(double pivot) const { return (pivot - from()) / (to() - from()); }
    double pivotAt(double share) const { return from() + share * (to() - from()); }

    friend bool operator==(const StripWindow&, const StripWindow&) = default;

  private:
    void put(double from, double length);

    bool whole_ = true;
    double from_ = 0.0;
    double to_ = 1.0;
    double last_ = 1.0;
};

/// A ring's time, from x to x in pixels.
struct LaneBar {
    std::uint32_t row = 0;
    float from = 0.0F;
    float to = 0.0F;
    bool active = false;  ///< False: on the stack.
};

/// A point where a lane begins or ends.
struct LaneSign {
    LaneChangeKind kind = LaneChangeKind::Seed;
    std::uint32_t pivot = 0;
    std::uint32_t row = 0;
    std::uint32_t otherRow = 0;  ///< Of a split or join.
    float x = 0.0F;
    Index ring = 0;  ///< The number of the ring that begins.
    /// There is room for its mark; otherwise only for the line of a split or join.
    bool alone = true;
};

struct LaneAlert {
    float x = 0.0F;
    std::uint32_t pivot = 0;
    AlertEvidence what{AlertKind::Hole, kNone};
};

struct LanePicture {
    std::vector<LaneBar> bars;
    std::vector<LaneSign> signs;
    std::vector<float> ringLength;  ///< Per pixel column, as a share of the longest; 0 if unknown.
    std::vector<LaneAlert> alerts;  ///< Alerts at distinguishable positions.
    std::uint32_t rows = 0;         ///< Rows in use.
    /// Lanes beyond those with a row of their own; they share the last row, without marks
    /// and without bars except the active one. 0: all have one.
    std::uint32_t gathered = 0;
    std::vector<std::uint32_t> crowd;  ///< Of those, the maximum at one time per pixel column.
};

struct LaneRoom {
    float width = 1.0F;
    std::uint32_t rows = 1;
    float signGap = 8.0F;  ///< Least distance of two marks in a row.
    friend bool operator==(const LaneRoom&, const LaneRoom&) = default;
};

LanePicture makeLanePicture(const RunOverview& run, const StripWindow& window,
                            const LaneRoom& room);

/// The alert closest to `x`, at most `within` pixels away; null if there is none.
const LaneAlert* alertNear(const LanePicture& picture, float x, float within);
/// A sentence about an alert, with its pivot.
std::string alertText(const LaneAlert& alert);

// The part of an edge ring that fits into the strip of the panel Rings. Plain arithmetic.

/// Positions in RingPath::points, in the direction of the ring; each at most once.
struct RingSlice {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t size = 0;  ///< Of the ring.

    std::size_t at(std::size_t i) const { return (first + i) % size; }
    bool whole() const { return count == size; }
};

/// The position of current work: the pivot if it is still on the ring, between first and last if it
/// is there more than once; otherwise where the ring continues; empty in a ring without the pivot.
std::optional<std::size_t> workPlace(const DecisionState& picture, const RingPath& ring);

/// As many points as fit, with `middle` in the middle, moved by `shift` points.
RingSlice sliceAbout(std::size_t size, std::size_t middle, long shift, std::size_t fits);

/// The ring with that id, otherwise the active one; null if there is none.
const RingPath* ringToShow(const DecisionState& picture, Index id);

// A watched number over the whole run, as columns of a small plot. Plain values.

/// The number within one column of pixels.
struct PlotColumn {
    double low = 0.0;
    double high = 0.0;
};

/// The least and the largest value in each of `columns` stretches of [0, last], `values` being the
/// known ones by pivot: no peak is lost, however many pivots share a column. Columns without
/// known values are left out at the end.
std::vector<PlotColumn> plotColumns(std::span<const double> values, std::size_t last,
                                    std::size_t columns);

/// The columns as last computed, and their inputs.
struct PaintedPlot {
    std::uint32_t generation = 0;
    std::size_t known = 0;
    std::size_t last = 0;
    std::vector<PlotColumn> columns;
    double low = 0.0;
    double high = 0.0;
};

/// Computes the plot again if something has changed.
void keepPlot(PaintedPlot& plot, std::uint32_t generation, std::span<const double> values,
              std::size_t last, std::size_t columns);

}  // namespace se::view
