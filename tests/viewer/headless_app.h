/// A program without a window, for tests of opening, saving and leaving.
#pragma once

#include "controllers/document.h"
#include "open_session.h"
#include "session/playback.h"

namespace se::view::test {

/// Has a folder of its own that is removed after the test.
struct HeadlessApp {
    Session session;
    Playback playback;
    Camera camera;
    UiState ui;
    CommandContext context{session, playback, camera, ui};
    DocumentController document{context};
    std::filesystem::path folder;

    explicit HeadlessApp(const std::string& name) : folder(ownPlace(name)) {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    ~HeadlessApp() { std::filesystem::remove_all(folder); }
    HeadlessApp(const HeadlessApp&) = delete;
    HeadlessApp& operator=(const HeadlessApp&) = delete;

    void waitUntilDone() {
        session.waitUntilDone();
        document.poll();
        session.waitUntilDone();
    }
};

}  // namespace se::view::test
