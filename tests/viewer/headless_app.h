/// A program without a window, for tests of opening, saving and leaving.
#pragma once

#include "controllers/document.h"
#include "open_session.h"

namespace se::view::test {

/// Has a folder of its own that is removed after the test.
struct Desk {
    Session session;
    Playback playback;
    Camera camera;
    UiState ui;
    CommandContext context{session, playback, camera, ui};
    Filing filing{context};
    std::filesystem::path folder;

    explicit Desk(const std::string& name) : folder(ownPlace(name)) {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    ~Desk() { std::filesystem::remove_all(folder); }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    void settle() {
        session.settle();
        filing.poll();
        session.settle();
    }
};

}  // namespace se::view::test
