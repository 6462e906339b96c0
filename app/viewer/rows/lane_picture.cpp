// One pass over the lane changes of the run, O(changes), that emits shapes only as far as pixels
// can show them: bars of a row that touch are merged, and marks closer than their size are
// dropped. Rows that do not fit are summed into the last one, as a maximum per pixel column.

#include "lane_picture.h"

#include <algorithm>
#include <cmath>

#include "spiraling_edge/run/event_text.h"

namespace se::view {

namespace {

/// Factor of a notch of the wheel.
constexpr double kPerNotch = 1.25;
/// Bars of a row that are this close are merged.
constexpr float kJoinWithin = 0.75F;

class LanePainter {
  public:
    LanePainter(const RunOverview& run, const StripWindow& window, const LaneRoom& room)
        : run_(run), window_(window), room_(room) {
        const std::uint32_t rows = std::max(1U, room.rows);
        out_.rows = std::clamp(run.lanes, 1U, rows);
        if (run.lanes > rows) {
            out_.gathered = run.lanes - (rows - 1);
            out_.crowd.resize(static_cast<std::size_t>(std::max(1.0F, room.width)));
        }
        open_.resize(run.lanes);
        lastBar_.resize(std::size_t{2} * out_.rows, kNoBar);
        lastSign_.resize(out_.rows, -room.signGap);
        lastLine_.resize(out_.rows, -2.0F);
    }

    LanePicture paint() {
        for (const LaneChange& change : run_.laneChanges) {
            gather(change);
            take(change);
        }
        passColumns(room_.width);
        const auto end = static_cast<double>(run_.lastPivot);
        for (std::uint32_t lane = 0; lane < open_.size(); ++lane) endPiece(lane, end);
        return std::move(out_);
    }

  private:
    static constexpr std::size_t kNoBar = ~std::size_t{0};
    struct Open {
        bool live = false;
        bool active = false;
        double since = 0.0;
    };

    std::uint32_t rowOf(std::uint32_t lane) const { return std::min(lane, out_.rows - 1); }
    float xOf(double pivot) const {
        return static_cast<float>(window_.shareOf(pivot)) * room_.width;
    }

    void take(const LaneChange& change) {
        if (change.lane >= open_.size()) return;
        // A pivot fills the pixels from the end of the previous one to its own end.
        const double at = change.pivot;
        Open& lane = open_[change.lane];
        if (change.kind == LaneChangeKind::Seed) {
            lane = {true, true, at - 1.0};
        } else if (change.kind == LaneChangeKind::Split) {
            lane = {true, false, at};
        } else if (change.kind == LaneChangeKind::Activated) {
            endPiece(change.lane, at);
            lane = {true, true, at};
        } else {
            endPiece(change.lane, at);
        }
        sign(change);
    }

    /// Whether the lane shares the last row with others.
    bool isGathered(std::uint32_t lane) const { return out_.gathered > 0 && lane + 1 >= out_.rows; }

    /// Draws the current number of shared lanes, up to x.
    void passColumns(float x) {
        if (out_.crowd.empty() || x < 0.0F || beyond_) return;
        beyond_ = x >= room_.width;
        const auto last = static_cast<float>(out_.crowd.size() - 1);
        const auto to = static_cast<std::size_t>(std::clamp(x, 0.0F, last));
        for (std::size_t c = std::min(column_, to); c <= to; ++c)
            out_.crowd[c] = std::max(out_.crowd[c], crowd_);
        column_ = to;
    }

    void gather(const LaneChange& change) {
        if (!isGathered(change.lane) || change.kind == LaneChangeKind::Activated) return;
        passColumns(xOf(change.pivot));
        if (beginsLane(change.kind)) {
            ++crowd_;
        } else if (crowd_ > 0) {
            --crowd_;
        }
    }

    void endPiece(std::uint32_t number, double at) {
        Open& lane = open_[number];
        // Among lanes in the shared row the active one can be drawn: there is one at a time.
        const bool hasBar = lane.active || !isGathered(number);
        if (lane.live && hasBar) bar(rowOf(number), lane.active, lane.since, at);
        lane.live = false;
    }

    void bar(std::uint32_t row, bool active, double since, double until) {
        const float from = std::max(0.0F, xOf(since));
        const float to = std::min(room_.width, xOf(until));
        if (to < 0.0F || from > room_.width) return;
        std::size_t& last = lastBar_[2 * row + (active ? 1U : 0U)];
        if (last != kNoBar && from <= out_.bars[last].to + kJoinWithin) {
            out_.bars[last].to = std::max(out_.bars[last].to, to);
            return;
        }
        last = out_.bars.size();
        out_.bars.push_back({row, from, to, active});
    }

    void sign(const LaneChange& change) {
        if (change.kind == LaneChangeKind::Activated || isGathered(change.lane)) return;
        const double at = change.kind == LaneChangeKind::Seed ? change.pivot - 1.0 : change.pivot;
        const float x = xOf(at);
        if (x < 0.0F || x > room_.width) return;
        LaneSign sign{change.kind, change.pivot, rowOf(change.lane), rowOf(change.lane), x,
                      change.ring, true};
        const bool links =
            change.kind == LaneChangeKind::Split || change.kind == LaneChangeKind::Join;
        if (links) sign.otherRow = rowOf(change.other);
        sign.alone = x >= lastSign_[sign.row] + room_.signGap;
        const bool lineFits = links && x >= lastLine_[sign.row] + 2.0F;
        if (!sign.alone && !lineFits) return;
        if (sign.alone) lastSign_[sign.row] = x;
        if (links) lastLine_[sign.row] = x;
        out_.signs.push_back(sign);
    }

    const RunOverview& run_;
    const StripWindow& window_;
    const LaneRoom& room_;
    LanePicture out_;
    std::vector<Open> open_;
    std::vector<std::size_t> lastBar_;  // two per row: stacked, active
    std::vector<float> lastSign_;
    std::vector<float> lastLine_;
    std::uint32_t crowd_ = 0;  // shared lanes now
    std::size_t column_ = 0;   // known up to here
    bool beyond_ = false;      // all columns are
};

/// The longest ring at each pixel column.
std::vector<float> ringLengths(const RunOverview& run, const StripWindow& window, float width) {
    const auto columns = static_cast<std::size_t>(std::max(1.0F, width));
    std::vector<float> lengths(columns, 0.0F);
    if (run.longestRing == 0) return lengths;
    const auto pivotOf = [&](std::size_t column) {
        const double share = static_cast<double>(column) / static_cast<double>(columns);
        return static_cast<std::size_t>(std::max(0.0, window.pivotAt(share)));
    };
    for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t from = pivotOf(c);
        const std::size_t to = std::min(std::max(from + 1, pivotOf(c + 1)), run.ringLength.size());
        std::uint32_t longest = 0;
        for (std::size_t i = from; i < to; ++i) longest = std::max(longest, run.ringLength[i]);
        lengths[c] = static_cast<float>(longest) / static_cast<float>(run.longestRing);
    }
    return lengths;
}

std::vector<LaneAlert> alertPlaces(const RunOverview& run, const StripWindow& window, float width) {
    std::vector<LaneAlert> places;
    for (const RunMark& mark : run.marks) {
        if (mark.kind != MarkKind::Alert) continue;
        const float x = static_cast<float>(window.shareOf(mark.pivot)) * width;
        const bool within = x >= 0.0F && x <= width;
        if (within && (places.empty() || x >= places.back().x + 2.0F)) {
            places.push_back({x, mark.pivot, mark.alert});
        }
    }
    return places;
}

}  // namespace

void StripWindow::put(double from, double length) {
    if (length >= last_) {
        whole_ = true;
        return;
    }
    whole_ = false;
    from_ = std::clamp(from, 0.0, last_ - length);
    to_ = from_ + length;
}

void StripWindow::setLast(std::uint32_t last) {
    last_ = std::max(1.0, static_cast<double>(last));
    if (!whole_) put(from_, to_ - from_);
}

void StripWindow::zoomAt(double share, double notches) {
    const double fixed = pivotAt(share);
    const double length = std::max(kLeast, (to() - from()) * std::pow(kPerNotch, -notches));
    if (length < to() - from() || notches < 0.0) put(fixed - share * length, length);
}

void StripWindow::pan(double shares) {
    if (whole_) return;
    put(from_ + shares * (to_ - from_), to_ - from_);
}

void StripWindow::reveal(std::uint32_t pivot) {
    const double at = pivot;
    if (whole_ || (at >= from_ && at <= to_)) return;
    const double length = to_ - from_;
    put(at < from_ ? at - 0.1 * length : at - 0.9 * length, length);
}

LanePicture makeLanePicture(const RunOverview& run, const StripWindow& window,
                            const LaneRoom& room) {
    LanePicture picture = LanePainter(run, window, room).paint();
    picture.ringLength = ringLengths(run, window, room.width);
    picture.alerts = alertPlaces(run, window, room.width);
    return picture;
}

const LaneAlert* alertNear(const LanePicture& picture, float x, float within) {
    const LaneAlert* nearest = nullptr;
    for (const LaneAlert& alert : picture.alerts) {
        const float distance = std::abs(alert.x - x);
        if (distance > within) continue;
        within = distance;
        nearest = &alert;
    }
    return nearest;
}

std::string alertText(const LaneAlert& alert) {
    const Event event{{alert.pivot, Stage::Done, 1}, alert.what};
    return describe(event) + " (pivot " + std::to_string(alert.pivot) + ")";
}

std::optional<std::size_t> workPlace(const DecisionState& picture, const RingPath& ring) {
    const std::size_t size = ring.points.size();
    std::optional<std::size_t> pivot;
    std::optional<std::size_t> next;
    std::optional<std::size_t> end;
    for (std::size_t i = 0; i < size; ++i) {
        const Index point = ring.points[i];
        if (point == picture.pivot && picture.pivot != kNone) {
            const bool between = ring.points[(i + size - 1) % size] == picture.first &&
                                 ring.points[(i + 1) % size] == picture.last;
            if (between || !pivot) pivot = i;
            if (between) break;
        }
        if (point == picture.nextPivot && picture.nextPivot != kNone && !next) next = i;
        if (point == picture.end && picture.end != kNone && !end) end = i;
    }
    return pivot ? pivot : next ? next : end;
}

RingSlice sliceAbout(std::size_t size, std::size_t middle, long shift, std::size_t fits) {
    if (size == 0) return {};
    const std::size_t count = std::min(size, std::max<std::size_t>(1, fits));
    const auto n = static_cast<long>(size);
    const long first = static_cast<long>(middle) + shift - static_cast<long>(count / 2);
    return {static_cast<std::size_t>(((first % n) + n) % n), count, size};
}

const RingPath* ringToShow(const DecisionState& picture, Index id) {
    const RingPath* active = nullptr;
    for (const RingPath& ring : picture.rings) {
        if (id != kNone && ring.id == id) return &ring;
        if (ring.active) active = &ring;
    }
    return active;
}

// Each column of pixels shows the least and the largest value of its pivots instead of a sample,
// so that a peak of a single pivot stays visible in a long run. O(pivots), computed again only
// when more of the run is known or the width changes.

std::vector<PlotColumn> plotColumns(std::span<const double> values, std::size_t last,
                                    std::size_t columns) {
    std::vector<PlotColumn> plot;
    const std::size_t all = last + 1;
    for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t from = i * all / columns;
        const std::size_t to = std::max(from + 1, (i + 1) * all / columns);
        if (from >= values.size()) break;
        const auto part = values.subspan(from, std::min(to, values.size()) - from);
        const auto [low, high] = std::minmax_element(part.begin(), part.end());
        plot.push_back({*low, *high});
    }
    return plot;
}

void keepPlot(PaintedPlot& plot, std::uint32_t generation, std::span<const double> values,
              std::size_t last, std::size_t columns) {
    const bool same = plot.generation == generation && plot.known == values.size() &&
                      plot.last == last && plot.columns.size() <= columns &&
                      plot.columns.size() + 1 >= columns;
    if (same) return;
    plot = {generation, values.size(), last, plotColumns(values, last, columns), 0.0, 0.0};
    if (values.empty()) return;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    plot.low = *low;
    plot.high = *high;
}

}  // namespace se::view
