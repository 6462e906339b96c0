/// A program without a window, for tests of its actions.
#pragma once

#include "compare/compared_runs.h"
#include "document/document.h"
#include "document/edit_history.h"
#include "document/mesh_saving.h"
#include "document/new_points.h"
#include "lesson/lesson_player.h"
#include "open_session.h"
#include "session/playback.h"

namespace se::view::test {

/// All that acts on a session.
struct AroundSession {
    Playback playback;
    Camera camera;
    UiState ui;
    CommandContext context;
    Document document{context};
    EditHistory history{context};
    LessonPlayer lesson{context};
    ComparedRuns compare{context};
    MeshSaving mesh{context};
    NewPoints sampling{context};

    explicit AroundSession(Session& session)
        : context{session, playback, camera,  ui,   document,
                  history, lesson,   compare, mesh, sampling} {}
    AroundSession(const AroundSession&) = delete;
    AroundSession& operator=(const AroundSession&) = delete;
};

struct OwnSession {
    Session session;
};

/// Has a folder of its own that is removed after the test.
struct HeadlessApp : OwnSession, AroundSession {
    std::filesystem::path folder;

    explicit HeadlessApp(const std::string& name)
        : AroundSession(OwnSession::session), folder(ownPlace(name)) {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    ~HeadlessApp() { std::filesystem::remove_all(folder); }
    HeadlessApp(const HeadlessApp&) = delete;
    HeadlessApp& operator=(const HeadlessApp&) = delete;

    /// Opens another input; what is unsaved is discarded.
    void openInstead(const std::string& source) {
        document.open(source);
        document.answer(LeaveAnswer::Discard);
        waitUntilDone();
    }
    void waitUntilDone() {
        session.waitUntilDone();
        document.poll();
        session.waitUntilDone();
    }
};

}  // namespace se::view::test
