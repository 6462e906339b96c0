/// Everything that a command may use.
#pragma once

namespace se::view {

class Camera;
class Playback;
class Session;
struct UiState;

struct CommandContext {
    Session& session;
    Playback& playback;
    Camera& camera;
    UiState& ui;
};

}  // namespace se::view
