/// A lesson as plain data, as it stands in its file: steps with text, position and question; and
/// the setting of a step: input, rules, names and position in force there, with all that it takes
/// over from the lesson and from earlier steps. Read by lesson_read.h; checked against the run by
/// lesson_check.h.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/types.h"
#include "spiraling_edge/points/point_name.h"
#include "spiraling_edge/spec/spec_fields.h"

namespace se::teach {

/// Extension of a lesson's file.
inline constexpr std::string_view kLessonExtension = ".lesson.md";

/// Kind of a fault: a file that cannot be used, or one that contradicts its run.
enum class FaultSort : std::uint8_t {
    Malformed,  ///< Syntax, a missing input, an address that the run has not.
    Disagrees,  ///< An answer, an outcome or a comparison is not that of the run.
};

/// A fault of a lesson: where, what, and what to do.
struct LessonFault {
    std::size_t line = 0;  ///< Of the file, from 1; 0: the whole file.
    std::string key;       ///< Of a block; may be empty.
    std::string message;
    FaultSort sort = FaultSort::Malformed;
    friend bool operator==(const LessonFault&, const LessonFault&) = default;
};

/// "name:14: at: pivot 9 has 4 decisions of sphere, not 5".
std::string faultText(const LessonFault& fault, std::string_view name);

/// Lines of the keys of one block.
struct KeyLines {
    std::size_t block = 0;  ///< Line of the fence.
    std::vector<std::pair<std::string, std::size_t>> keys;

    /// Line of a key; that of the block if the key was not given.
    std::size_t of(std::string_view key) const;
};

/// Names of the units that are played by.
inline constexpr std::array<std::string_view, 3> kPlayUnits = {"sub-step", "pivot", "event"};

/// Playback from the position of a step to its `until`.
struct PlaySpeed {
    std::string unit;  ///< One of kPlayUnits.
    double perSecond = 0.0;
};

/// A link in the text to a decision: `[so](se:9.sphere.3)`.
struct LessonLink {
    std::size_t line = 0;
    std::string address;
};

/// A statement of a step's text, and what makes it true.
struct LessonFact {
    std::size_t line = 0;
    std::string words;                ///< As they stand in the text or the title of the step.
    std::vector<std::string> claims;  ///< "lost_points: 3", "B at=9 stage=emit: 5".
};

/// A question. Its words are the text of its step.
struct Question {
    KeyLines lines;
    std::string kind;    ///< One of questionKinds().
    std::string at;      ///< Nothing after this is known while it is open; empty: that of the step.
    std::string until;   ///< Shown when it is answered; empty: the end of the pivot.
    std::string answer;  ///< One of runAnswers(); empty: it is typed.
    std::vector<std::string> typed;     ///< The typed answer: points, a number or an option.
    std::vector<std::string> options;   ///< Answers A to D, to choose from; a room raises hands.
    std::vector<std::string> verdicts;  ///< For each option the outcome for which it is right.
    double within = 0.0;                ///< Greatest error of a number.
    std::string why;                    ///< Address of the decision that gives the reason.
    bool unchecked = false;             ///< The typed answer does not follow from the run.
};

/// One step: a heading, text, a position in a run, and at most one question.
struct LessonStep {
    std::size_t line = 0;  ///< Of its heading.
    std::string title;
    std::string text;  ///< Markdown, without the blocks; textBlocks() in lesson_text.h splits it.
    std::vector<LessonLink> links;
    KeyLines lines;
    double minutes = 1.0;
    std::string input;             ///< Another input from here on; empty: none.
    std::vector<PointName> names;  ///< Of that input.
    std::string at;                ///< Empty: as the step before.
    std::string until;
    std::string expect;  ///< Outcome of the decision at `at`, as outcomeText().
    /// Set, single rules and what-ifs of this step alone, as they are written.
    SpecChange rules;
    std::vector<std::string> compare;    ///< Words in which another run differs, as of --with.
    std::vector<std::string> select;     ///< One point, or two or three of an edge or triangle.
    std::string camera;                  ///< JSON as Ctrl+C copies it.
    std::string view;                    ///< One of lessonViews().
    std::string frame;                   ///< "all" or "pivot".
    std::vector<std::string> pin, hide;  ///< Of kLayerNames.
    std::optional<PlaySpeed> play;
    std::vector<LessonFact> facts;
    std::optional<Question> question;
};

/// A whole lesson.
struct Lesson {
    std::string name;   ///< Of the file, for messages.
    std::string title;  ///< The first heading.
    std::string text;   ///< Before the first step.
    std::string hash;   ///< "fnv1a64:..." of all bytes of the file.
    KeyLines lines;
    std::string input;
    SpecChange options;  ///< Neighbor lists of the input.
    SpecChange rules;    ///< As those of a step.
    std::vector<PointName> names;
    std::string view;
    std::string layout;
    std::string author, license;
    std::vector<LessonStep> steps;

    /// Length: that of its steps together.
    double minutes() const;
    std::size_t questions() const;
};

/// Names of the layers of the viewer's picture, in its drawing order.
inline constexpr std::array<std::string_view, 31> kLayerNames = {
    "points",    "aside",   "triangles", "edges",   "ring",    "stack",    "sector",
    "neighbors", "seed",    "walls",     "angles",  "limits",  "convex",   "reciprocal",
    "hole",      "spheres", "twopoint",  "fan",     "change",  "exchange", "advance",
    "component", "guard",   "fill",      "mending", "normals", "links",    "labels",
    "selection", "marked",  "alerts"};

/// A direction to look from, by name.
struct LessonView {
    std::string_view name;
    Vec3 toEye;  ///< From the points to the eye.
};
/// All views: "front", "back", "left", "right", "top", "bottom".
const std::vector<LessonView>& lessonViews();

/// Input, rules and position at a step.
struct StepSetting {
    std::string input;  ///< As in the lesson: scene:ID, or a path relative to its folder.
    SpecChange run;     ///< Options and rules, as they are written.
    std::vector<PointName> names;  ///< Those of the lesson, or of the figure.
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

/// The point of a name, or of a number as text; kNone if it is neither.
Index pointOf(std::string_view word, const std::vector<PointName>& names);

/// "99: there are 50 points, from 0"; `word` names the point that is absent.
std::string absentPointText(const std::string& word, std::size_t count);

/// The names of points, or their numbers.
std::vector<std::string> namesOf(const std::vector<Index>& points,
                                 const std::vector<PointName>& names);
/// "q, 31"; "none" for an empty list.
std::string pointsText(const std::vector<Index>& points, const std::vector<PointName>& names);

}  // namespace se::teach
