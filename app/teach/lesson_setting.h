/// The setting of a step: input, rules, names and position in force there, with all that it takes
/// over from the lesson and from earlier steps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lesson.h"
#include "spiraling_edge/points/point_name.h"

namespace se::teach {

/// Input, rules and position at a step.
struct StepSetting {
    std::string input;  ///< As in the lesson: scene:ID, or a path relative to its folder.
    SpecChange run;     ///< Options and rules, as they are written.
    std::vector<NamedPoint> names;  ///< Those of the lesson, or of the figure.
    std::string view;  ///< By name; empty: viewDirection() has that of the figure, if there is one.
    std::string at;    ///< Position: that of the question while it is open. "0": the start.
    std::string answerPlace;  ///< Position when the question is answered; empty: end of the pivot.
};

/// The setting of step number `step`, from 0. Requires such a step.
StepSetting settingOf(const Lesson& lesson, std::size_t step);

/// The spec of its run. Fails if there is no such set or rule, or a what-if is malformed.
Result<RunSpec> runSpec(const StepSetting& setting);

/// The direction to look from, from the points to the eye; nothing if the lesson leaves it open.
std::optional<Vec3> viewDirection(const StepSetting& setting);

/// Names for describe(); they refer to `names`.
std::vector<PointName> pointNames(const std::vector<NamedPoint>& names);

/// The point of a name, or of a number as text; kNone if it is neither.
Index pointOf(std::string_view word, const std::vector<NamedPoint>& names);

/// "99: there are 50 points, from 0"; `word` names the point that is absent.
std::string absentPointText(const std::string& word, std::size_t count);

/// The names of points, or their numbers.
std::vector<std::string> namesOf(const std::vector<Index>& points,
                                 const std::vector<NamedPoint>& names);
/// "q, 31"; "none" for an empty list.
std::string pointsText(const std::vector<Index>& points, const std::vector<NamedPoint>& names);

}  // namespace se::teach
