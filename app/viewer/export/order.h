/// The order of an export: what the command line and the dialog choose. Plain values.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/open_lesson.h"
#include "run/model.h"
#include "session/playback.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

/// Greatest width and height of what is drawn, and number of its pixels: a gigabyte.
inline constexpr int kMostPixels = 32768;
inline constexpr double kMostArea = 16384.0 * 16384.0;

/// Frames per second of an animation.
inline constexpr double kLeastPerSecond = 0.1;
inline constexpr double kMostPerSecond = 60.0;

/// A part of a run, from one position to another, both included.
struct FrameRange {
    std::string from;
    std::string to;
    PlayUnit unit = PlayUnit::SubStep;  ///< From frame to frame; of Pivot the end of each.
};
/// The range of all decisions of the pivot of an address. Fails if it is no address.
Result<FrameRange> rangeAround(const std::string& address);

/// What is exported, and where to.
struct ExportOrder {
    std::filesystem::path path;
    std::optional<FrameRange> range;  ///< Empty: the position of the cursor alone.
    SharedLesson lesson;              ///< Null: a run.
    std::vector<std::size_t> steps;   ///< Of the lesson, from 1; empty: all.
    std::string stepsText;            ///< As typed, before the lesson is read.
    double perSecond = 2.0;           ///< Frames of an animation.
    bool captions = true;
    bool dial = false;     ///< The dial of the pivot, beside the view.
    bool program = false;  ///< The program itself as a page, which begins there; no frames.
    std::string viewer;    ///< Address of the program, for links of a page; empty: no links.

    /// More than one frame is possible.
    bool several() const { return range.has_value() || lesson != nullptr; }
};

/// Fails with a sentence unless pages can link to a program at that address.
Status checkViewerAddress(const std::string& address);

/// Reads "1280x800"; empty unless both sides are within the limits of a picture.
std::optional<glm::ivec2> pictureSize(const std::string& text);

/// Reads "2,4-6": numbers from 1 to `count`, ascending. Fails with a sentence.
Result<std::vector<std::size_t>> stepsFromText(std::string_view text, std::size_t count);

// The frames of a range of a run, and the points that one camera has to hold for all of them.

/// Greatest number of frames of a range.
inline constexpr std::size_t kMaxFrames = 10'000;

/// The frames of a range, in the order of the run.
struct FramePlan {
    std::vector<std::string> places;  ///< Addresses; empty: the start of the run.
    std::vector<Index> points;        ///< Points of the decisions, ascending.
    std::vector<Index> pivots;        ///< Ascending.
};

/// Runs the input of `model` as far as the range goes. Fails with a sentence if a position is not
/// in the run, if the second lies before the first, or if there are no frames or too many.
Result<FramePlan> planFrames(const Model& model, const FrameRange& range);

}  // namespace se::view
