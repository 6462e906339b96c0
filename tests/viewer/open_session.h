/// Small models for tests of the viewer.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>

#include "run/model.h"
#include "session/session.h"

namespace se::view::test {

/// A path for the files of this process alone: tests run in parallel. It does not exist yet.
inline std::filesystem::path ownPlace(const std::string& name) {
    return std::filesystem::temp_directory_path() /
           ("spiraling-edge-" + std::to_string(::getpid()) + "-" + name);
}

/// A new folder of this process alone, removed at the end with all in it.
class OwnFolder {
  public:
    OwnFolder() : path_(ownPlace("folder-" + std::to_string(made()++))) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~OwnFolder() { std::filesystem::remove_all(path_); }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    static int& made() {
        static int count = 0;
        return count;
    }
    std::filesystem::path path_;
};

/// As loadInput(), without the file.
inline Result<std::shared_ptr<const Model>> loadModel(const RunSpec& spec, LoadProgress& progress) {
    const Result<Loaded> loaded = loadInput(spec, progress);
    if (!loaded) return loaded.error();
    return loaded.value().model;
}

inline std::shared_ptr<const Model> sphereModel() {
    LoadProgress progress;
    const auto loaded = loadModel(RunSpec{"scene:sphere"}, progress);
    return loaded ? loaded.value() : nullptr;
}

/// A session that has opened a scene and is at its start.
struct OpenSession {
    Session session;

    explicit OpenSession(const char* source = "scene:sphere", const char* rules = "paper") {
        session.open(withSet({source}, rules));
        session.waitUntilDone();
    }
    /// Position of the cursor once all moves are done.
    std::string place() {
        session.waitUntilDone();
        return session.event() == nullptr ? "start" : toString(session.address());
    }
};

}  // namespace se::view::test
