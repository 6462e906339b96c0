/// State of the panel Lesson: the open lesson. Plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lesson_walk.h"

namespace se::view {

struct LessonPanel {
    LessonWalk walk;
    float captionEms = 0.0F;   ///< Height of the text in Present, in its largest type.
    bool countsHands = false;  ///< Of the question: the fields for hands are open.

    std::uint64_t nextPractice = 1;  ///< Seed of the next pivot to play.

    // Set by LessonPlayer.
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
