/// Commands of the open lesson, and the commands that are off while its question is open.
#pragma once

#include "document/context.h"
#include "input/key_map.h"

namespace se::view {

/// Whether a command shows nothing of what follows the cursor in the run: camera, layers, looks,
/// moves, which end at the question, and what leaves it.
bool isAllowedDuringQuestion(const Command& command);

/// Answers the open question by a key: a letter chooses its option, Enter is the button Answer.
/// True if the key was for the question; not in Present, where B is black.
bool answerByKey(const KeyChord& chord, CommandContext& context);

namespace actions {

/// Opens the lesson that shows the six stages on a torus.
void openTour(CommandContext& c);
/// Opens the next pivot to play: that after the open one, or after the last one.
void openPractice(CommandContext& c);
/// To the position of the step, with its settings.
void returnToLessonStep(CommandContext& c);
void closeLesson(CommandContext& c);
/// Opens the file dialog for the answers given so far.
void saveResult(CommandContext& c);
/// Opens the file dialog for the bookmarks, as the steps of a lesson.
void saveLesson(CommandContext& c);

}  // namespace actions

}  // namespace se::view
