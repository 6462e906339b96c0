/// Practice: a pivot drawn from a seed, which the user plays move by move. Plain data, for the
/// command line and for a window:
///
///     const PracticeTask task = practiceTask(seed);
///     // show task.points, task.ring, task.p, task.first, task.last; collect moves in the order of
///     // moveTable(); after each try:
///     const PracticeGrade grade = gradePractice(task, moves);
///
/// A window that shows the run itself opens task.points under task.params and goes to task.address;
/// nothing after that may be shown while the task is open.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "play_moves.h"
#include "result.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/points/shared_points.h"
#include "spiraling_edge/stepper/params.h"

namespace se::teach {

/// Least margin (Reading::margin) of every decision of the pivot that is played: about the share of
/// its distance by which a point would have to move to change a decision.
inline constexpr double kPracticeMargin = 1e-3;

/// One task.
struct PracticeTask {
    std::uint64_t seed = 0;
    SharedPoints points;   ///< Coordinates are whole thousandths, so that they print exactly.
    Params params = {};    ///< The set `paper`.
    Address address = {};  ///< Of the event that begins the pivot: "5.pivot.1".
    Index p = kNone, first = kNone, last = kNone;
    std::vector<Index> ring = {};                ///< The active edge ring before it, from p on.
    std::vector<std::vector<Index>> stack = {};  ///< The other rings, bottom first.
    std::vector<Index> done = {};  ///< DONE points; what is on no ring and not DONE is UNUSED.
    std::vector<RunMove> solution = {};  ///< The moves of the run, with their decisions.
    std::vector<Event> events = {};      ///< All decisions of the pivot.
};

/// Source of the points of a task in a lesson: "practice:7".
inline constexpr std::string_view kPracticePrefix = "practice:";
/// The seed in such a source; nothing if it is none.
std::optional<std::uint64_t> practiceSeed(std::string_view source);

/// The names of its points: p, first and last.
std::vector<PointName> practiceNames(const PracticeTask& task);

/// The points of the task of a seed as a file with neighbor lists.
PointFile practiceFile(std::uint64_t seed);
/// The task of a seed as the text of a lesson with one question of kind `play`.
std::string practiceLesson(std::uint64_t seed);

/// The task of a seed. Deterministic; different seeds give different points.
PracticeTask practiceTask(std::uint64_t seed);

/// The result of one try.
struct PracticeGrade {
    bool right = false;
    std::size_t rightMoves = 0;  ///< Before the first wrong one.
    /// Of the first wrong decision; empty if all are right.
    std::string section;   ///< "6.3"
    std::string stage;     ///< "sphere"
    std::string address;   ///< "5.sphere.2"
    std::string sentence;  ///< The decision of the run in words, with the names of the task.
};
/// Compares the moves of a user with the solution; any number of tries.
PracticeGrade gradePractice(const PracticeTask& task, const std::vector<PlayMove>& moves);

/// An answer as a result for `lesson results`, which sums up tasks of all seeds in one row. It does
/// not know of tries before it.
LessonResult practiceResult(const std::vector<PlayMove>& moves, const PracticeGrade& grade,
                            const PracticeTask& task);

/// Reads moves, one a line; blank lines and what follows # are passed over. Fails with the name of
/// the file and the line, also if a point does not exist.
Result<std::vector<PlayMove>> readMoves(std::string_view text, const std::string& file,
                                        const PracticeTask& task);

}  // namespace se::teach
