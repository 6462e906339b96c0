/// The part of the run that the RUN strip shows. Plain arithmetic.
#pragma once

#include <cstdint>

namespace se::view {

/// Pivots from() to to(), of `last` in all; both may lie between two pivots.
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

}  // namespace se::view
