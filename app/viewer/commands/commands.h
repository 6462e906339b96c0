/// All actions, in one table that feeds keys, menus, the cheat sheet and --list-actions.
#pragma once

#include <cstdint>
#include <string>

#include "input/key_map.h"

namespace se::view {

class Camera;
class CompareController;
class DocumentController;
class EditHistory;
class LessonController;
class MeshController;
class Playback;
class SamplingController;
class Session;
struct UiState;
enum class GrowthSource : std::uint8_t;

/// Everything that a command or panel may use: the open run, the state of the window, and what
/// acts on them.
struct CommandContext {
    Session& session;
    Playback& playback;
    Camera& camera;
    UiState& ui;
    DocumentController& document;
    EditHistory& history;
    LessonController& lesson;
    CompareController& compare;
    MeshController& mesh;
    SamplingController& sampling;

    /// The same for another run, or seen by another camera.
    CommandContext of(Session& run, Camera& seenBy) const {
        return {run, playback, seenBy, ui, document, history, lesson, compare, mesh, sampling};
    }
    CommandContext of(Session& run) const { return of(run, camera); }
};

/// One line per action: id, keys, help.
std::string listActions();

/// Moves by `count` playback units, at most to the end of the loop; back if it is
/// negative.
void playSteps(CommandContext& context, int count);

/// Runs a command, from a key, a menu or the list of actions.
void runCommand(const Command& command, CommandContext& context);

/// Opens the page with the last form, of a shape or of a volume.
void openGrowthPage(CommandContext& context, GrowthSource from);
/// Carries out the meaning of `command` on that page. False: it has its usual meaning.
bool runOnGrowthPage(const Command& command, CommandContext& context);

}  // namespace se::view
