/// State of the panel Lesson: the open lesson, and the user's requests about it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "session/lesson_walk.h"

namespace se::view {

/// Request of a frame, carried out at its end.
enum class LessonAsk : std::uint8_t {
    None,
    Next,      ///< The next step; in Present an open question is answered first.
    Previous,  ///< The step before.
    Return,    ///< To the position of the step.
    Play,      ///< From the position of the step to its end.
    Answer,    ///< Grade what is given.
    Show,      ///< Show the right answer.
    Close,
};

struct LessonPanel {
    LessonWalk walk;
    LessonAsk ask = LessonAsk::None;
    std::optional<std::size_t> toStep;  ///< To a step, from 0; with `ask` None.
    std::string open;                   ///< The source of a lesson to open; empty: none.
    std::string follow;                 ///< The address of a link that was clicked; empty: none.
    std::string saveResult;             ///< The file to save the answers in; empty: none.
    std::string saveLesson;             ///< The file to save bookmarks in, as a lesson.
    float captionEms = 0.0F;            ///< Height of the text in Present, in its largest type.
    bool countsHands = false;           ///< Of the question: the fields for hands are open.

    std::uint64_t nextPractice = 1;  ///< Seed of the next pivot to play.

    // Set by LessonController.
    bool opening = false;   ///< A lesson is being read and run.
    double share = 0.0;     ///< Of that, in [0, 1].
    std::string complaint;  ///< Why a lesson could not be opened; empty: no problem.
    bool away = false;      ///< The run is at another position, or has other settings.

    /// Hands of a room are counted for the open question: clicks mark nothing.
    bool countsRoom() const {
        return countsHands && walk.question() != nullptr && !walk.question()->options.empty();
    }
    /// A question is open: all decisions after it are hidden.
    bool hides() const { return walk.isOpen() && walk.asks() && !away; }
};

}  // namespace se::view
