#include "mesh_saving.h"

#include <filesystem>
#include <utility>

#include "session/mesh_command.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

constexpr const char* kNoTriangle = "This run makes no triangles: there is no mesh to save.";

}  // namespace

bool MeshController::dialogOpen() const {
    return c_.ui.fileBrowser && c_.ui.browser == BrowserTask::SaveMesh && c_.session.ready();
}

bool MeshController::poll() {
    const bool news = export_.poll();
    if (auto outcome = export_.takeOutcome()) takeOutcome(*outcome);
    publish();
    return news;
}

void MeshController::publish() {
    MeshForm& form = c_.ui.mesh;
    form.saving = export_.saving();
    form.writing = export_.writing();
    form.share = c_.session.ready() ? c_.session.madeShare() : 0.0;
    form.size.reset();
    if (const FinishedMesh* mesh = export_.mesh()) {
        form.size = MeshSize{mesh->triangles->size(), mesh->points->position.size(),
                             mesh->usedPoints, mesh->capped};
    }
}

void MeshController::takeOutcome(const Result<SavedMesh>& outcome) {
    MeshForm& form = c_.ui.mesh;
    if (!outcome) {
        form.complaint = outcome.error().message;
        // The dialog may have been closed.
        return c_.session.messages().say(form.complaint);
    }
    const SavedMesh& saved = outcome.value();
    form.savedPath = saved.target.path;
    form.savedSource = c_.session.input().spec().source;
    form.justSaved = true;
    if (dialogOpen()) c_.ui.fileBrowser = false;
    c_.session.messages().say(savedText(saved));
}

void MeshController::carryOut() {
    const MeshAsk ask = std::exchange(c_.ui.mesh.ask, MeshAsk::None);
    if (dialogOpen()) prepareMesh();
    if (ask != MeshAsk::None && c_.session.ready()) answer(ask);
    if (!dialogOpen()) {
        export_.discard();
        c_.ui.mesh.question.clear();
    }
    publish();
}

/// Prepares the mesh of the open run. While a file is written, another run may have been opened.
void MeshController::prepareMesh() {
    if (export_.writing()) return;
    export_.make(c_.session.sharedModel(), c_.session.input().file(), c_.session.runEnd());
    if (!export_.saving() || !c_.session.isMade() || c_.session.runEnd()) return;
    export_.cancel();
    c_.ui.mesh.complaint = "The run did not come to its end: there is no mesh to save.";
}

void MeshController::answer(MeshAsk ask) {
    MeshForm& form = c_.ui.mesh;
    form.complaint.clear();
    form.note.clear();
    const std::string asked = std::exchange(form.question, {});
    if (ask == MeshAsk::Save) save(form.path, false);
    if (ask == MeshAsk::Replace) save(asked, true);
    if (ask == MeshAsk::CopyCommand) copyCommand(form.path);
    if (ask != MeshAsk::Cancel) return;
    export_.cancel();
    form.complaint = "Cancelled: nothing was saved.";
}

void MeshController::save(const std::string& path, bool replace) {
    MeshForm& form = c_.ui.mesh;
    if (path.empty() || export_.saving()) return;
    if (form.size && form.size->triangles == 0) {
        form.complaint = kNoTriangle;
        return;
    }
    std::error_code error;
    if (!replace && fs::exists(path, error)) {
        form.question = path;
        form.justAsked = true;
        return;
    }
    export_.save({path, form.usedOnly, form.faultFields});
}

void MeshController::copyCommand(const std::string& path) {
    MeshForm& form = c_.ui.mesh;
    const bool known =
        form.savedSource == c_.session.input().spec().source && !form.savedPath.empty();
    const std::string usual =
        known ? form.savedPath
              : meshStem(c_.session) + std::string(meshFormats()[form.format].extension);
    const MeshCommand command =
        meshCommand(c_.session, {path.empty() ? usual : path, form.usedOnly, form.faultFields});
    if (command.text.empty()) {
        form.complaint = command.note;
        return c_.session.messages().say(command.note);
    }
    form.copied = c_.ui.requests.copyText = command.text;
    form.note = "Copied the command." + (command.note.empty() ? "" : " " + command.note);
    c_.session.messages().say(form.note);
}

void MeshController::waitUntilDone() {
    export_.waitUntilDone();
    poll();
}

}  // namespace se::view
