/// Saving the mesh and copying the command that makes it: connects the dialog, the threads and the
/// open run. Independent of window and OpenGL.
#pragma once

#include <string>

#include "context.h"
#include "jobs/mesh_export.h"
#include "session/session.h"
#include "ui_state.h"

namespace se::view {

class MeshSaving {
  public:
    explicit MeshSaving(CommandContext& context) : c_(context) {}

    /// Takes the results of the threads. True if there is something new to draw.
    bool poll();

    /// Saves the mesh once it is made; asks before a file is replaced.
    void save(const std::string& path);
    /// The answer yes or no to that question.
    void replace();
    void keep();
    /// Stops waiting for the mesh.
    void cancel();
    /// Copies the command line that makes the mesh; with an empty path for the usual file.
    void copyCommand(const std::string& path);

    /// Blocks until no work is in progress: for tests.
    void waitUntilDone();
    /// Work with a visible progress is going on.
    bool busy() const { return export_.busy(); }

  private:
    bool dialogOpen() const;
    void takeOutcome(const Result<SavedMesh>& outcome);
    void publish();
    void prepareMesh();
    bool canSave(const std::string& path);
    void write(const std::string& path);

    CommandContext& c_;
    MeshExport export_;
};

}  // namespace se::view
