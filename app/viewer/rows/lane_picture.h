/// What the RUN strip draws for the lanes of a part of the run: so much as there are pixels for,
/// however long the run is.
#pragma once

#include <string>
#include <vector>

#include "run/overview.h"
#include "strip_window.h"

namespace se::view {

/// A ring's time, from x to x in pixels.
struct LaneBar {
    std::uint32_t row = 0;
    float from = 0.0F;
    float to = 0.0F;
    bool active = false;  ///< Else it waits on the stack.
};

/// A place where a lane begins or ends.
struct LaneSign {
    LaneChangeKind kind = LaneChangeKind::Seed;
    std::uint32_t pivot = 0;
    std::uint32_t row = 0;
    std::uint32_t otherRow = 0;  ///< Of a split or join.
    float x = 0.0F;
    bool alone = true;  ///< There is room for its sign; else only for the line of a split or join.
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
    std::vector<LaneAlert> alerts;  ///< Those that can be told apart.
    std::uint32_t rows = 0;         ///< That are in use.
    /// Lanes beyond those that have a row of their own; they share the last row, without signs
    /// and without bars but for the active one. 0: all have one.
    std::uint32_t gathered = 0;
    std::vector<std::uint32_t> crowd;  ///< Of those, most at a time per pixel column.
};

struct LaneRoom {
    float width = 1.0F;
    std::uint32_t rows = 1;
    float signGap = 8.0F;  ///< Least distance of two signs in a row.
    friend bool operator==(const LaneRoom&, const LaneRoom&) = default;
};

LanePicture makeLanePicture(const RunOverview& run, const StripWindow& window,
                            const LaneRoom& room);

/// The alert nearest to `x`, at most `within` pixels away; null if there is none.
const LaneAlert* alertNear(const LanePicture& picture, float x, float within);
/// What is wrong, as a sentence, and at which pivot.
std::string alertText(const LaneAlert& alert);

}  // namespace se::view
