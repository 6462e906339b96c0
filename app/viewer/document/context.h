/// The parts of the program that actions and panels act on.
#pragma once

namespace se::view {

class Camera;
class ComparedRuns;
class Document;
class EditHistory;
class LessonPlayer;
class MeshSaving;
class Playback;
class NewPoints;
class Session;
struct UiState;

/// Everything that a command or panel may use: the open run, the state of the window, and what
/// acts on them.
struct CommandContext {
    Session& session;
    Playback& playback;
    Camera& camera;
    UiState& ui;
    Document& document;
    EditHistory& history;
    LessonPlayer& lesson;
    ComparedRuns& compare;
    MeshSaving& mesh;
    NewPoints& sampling;

    /// This context with another run, or with another camera.
    CommandContext of(Session& run, Camera& seenBy) const {
        return {run, playback, seenBy, ui, document, history, lesson, compare, mesh, sampling};
    }
    CommandContext of(Session& run) const { return of(run, camera); }
};

}  // namespace se::view
