/// Saving the mesh and copying the command that makes it: connects the dialog, the threads and the
/// open run. Independent of window and OpenGL.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "context.h"
#include "jobs/background_job.h"
#include "jobs/mesh_export.h"
#include "run/model.h"
#include "session/session.h"
#include "ui_state.h"

namespace se::view {

// The command line that makes the mesh which the viewer saves.

class Session;

/// A command line for a POSIX shell, or the reason why there is none.
struct MeshCommand {
    std::string text;  ///< One line, words quoted where a shell needs it; empty: there is none.
    std::string note;  ///< A sentence: steps of the line before the run, or why there is none.
};

/// The line for an input whose what-ifs all have an effect; intermediate files are written to the
/// folder of the mesh.
MeshCommand meshCommand(const RunSpec& spec, const MeshTarget& target);
/// The line for the open input. Requires session.ready().
MeshCommand meshCommand(const Session& session, const MeshTarget& target);

/// The name of the input as the beginning of a file's name, "torus". Requires session.ready().
std::string inputStem(const Session& session);
/// A file name without folder and extension for the mesh of the open input: "torus-mesh". Requires
/// session.ready().
std::string meshStem(const Session& session);

class MeshSaving {
  public:
    explicit MeshSaving(CommandContext& context) : c_(context) {}

    /// Takes the results of the threads. True if there is something new to draw.
    bool poll();

    /// Saves the mesh once it is made; replaces a file. Ignored while another file waits or is
    /// written.
    void save(const std::string& path);
    /// Stops waiting for the mesh; too late once the file is being written.
    void cancel();
    /// Copies the command line that makes the mesh; with an empty path for the usual file.
    void copyCommand(const std::string& path);

    /// Blocks until no work is in progress: for tests.
    void waitUntilDone();
    /// Work with a visible progress is going on.
    bool busy() const { return mesh_.busy() || saving(); }
    /// A file is being written.
    bool writing() const { return file_.busy(); }
    /// The mesh that would be written; null until the run has ended.
    const FinishedMesh* mesh() const { return mesh_.answer(); }

  private:
    /// A file waits for the mesh, or is being written.
    bool saving() const { return order_.has_value() || writing(); }
    bool dialogOpen() const;
    void prepareMesh();
    void discard();
    bool canSave(const std::string& path);
    void startWriting();
    void takeSaved(const SavedMesh& saved);
    void fail(const std::string& why);

    CommandContext& c_;
    std::shared_ptr<const Model> model_;  ///< Model of the mesh; null: none.
    bool begun_ = false;                  ///< The mesh of model_ is ready or in progress.
    BackgroundQuery<FinishedMesh> mesh_;
    BackgroundQuery<SavedMesh> file_;
    std::optional<MeshTarget> order_;  ///< Waits for the mesh.
};

}  // namespace se::view
