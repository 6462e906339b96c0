/// Small models for tests of the viewer.
#pragma once

#include <memory>

#include "model.h"
#include "session.h"

namespace se::view::test {

inline std::shared_ptr<const Model> sphereModel() {
    LoadProgress progress;
    const auto loaded = loadModel({"scene:sphere", {}, "paper"}, progress);
    return loaded ? loaded.value() : nullptr;
}

/// A session that has opened a scene and stands at its start.
struct OpenSession {
    Session session;

    explicit OpenSession(const char* source = "scene:sphere") {
        session.open({source, {}, "paper"});
        session.settle();
    }
    /// Where the cursor stands once all moves are done.
    std::string place() {
        session.settle();
        return session.event() == nullptr ? "start" : toString(session.address());
    }
};

}  // namespace se::view::test
