/// Saving the mesh and copying the command that makes it: ties the dialog, the threads and what is
/// open. Knows neither window nor OpenGL.
#pragma once

#include <string>

#include "panel_state/ui_state.h"
#include "session/mesh_export.h"
#include "session/session.h"

namespace se::view {

class MeshSaving {
  public:
    explicit MeshSaving(CommandContext& context) : c_(context) {}

    /// Takes over what the threads have done. True if there is something new to draw.
    bool poll();
    /// Carries out what dialog and commands asked for in a frame.
    void carryOut();
    /// Blocks until nothing is under way: for tests.
    void settle();
    /// Something is under way whose progress is shown.
    bool busy() const { return export_.busy(); }

  private:
    bool dialogOpen() const;
    void takeOutcome(const Result<SavedMesh>& outcome);
    void publish();
    void answer(MeshAsk ask);
    void save(const std::string& path, bool replace);
    void copyCommand(const std::string& path);

    CommandContext& c_;
    MeshExport export_;
};

}  // namespace se::view
