#include "mesh_saving.h"

#include <filesystem>
#include <utility>

#include "document.h"
#include "session/mesh_command.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

constexpr const char* kNoTriangle = "This run makes no triangles: there is no mesh to save.";

}  // namespace

bool MeshSaving::dialogOpen() const {
    return c_.ui.fileBrowser && c_.ui.browser == BrowserTask::SaveMesh && c_.session.ready();
}

bool MeshSaving::poll() {
    const bool news = export_.poll();
    if (auto outcome = export_.takeOutcome()) takeOutcome(*outcome);
    if (dialogOpen()) {
        prepareMesh();
    } else {
        export_.discard();
        c_.ui.mesh.question.clear();
    }
    publish();
    return news;
}

void MeshSaving::publish() {
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

void MeshSaving::takeOutcome(const Result<SavedMesh>& outcome) {
    MeshForm& form = c_.ui.mesh;
    if (!outcome) {
        form.complaint = outcome.error().message;
        // The dialog may have been closed.
        return c_.session.messages().say(form.complaint);
    }
    const SavedMesh& saved = outcome.value();
    form.savedPath = saved.target.path;
    form.savedSource = c_.session.input().spec().source;
    // The settings of the run are in a file now, with its mesh.
    c_.document.keepSettings();
    if (dialogOpen()) c_.ui.fileBrowser = false;
    c_.session.messages().say(savedText(saved));
}

/// Prepares the mesh of the open run. While a file is written, another run may have been opened.
void MeshSaving::prepareMesh() {
    if (export_.writing()) return;
    export_.make(c_.session.sharedModel(), c_.session.input().file(), c_.session.runEnd());
    if (!export_.saving() || !c_.session.isMade() || c_.session.runEnd()) return;
    export_.cancel();
    c_.ui.mesh.complaint = "The run did not come to its end: there is no mesh to save.";
}

bool MeshSaving::canSave(const std::string& path) {
    MeshForm& form = c_.ui.mesh;
    if (path.empty() || !c_.session.ready() || export_.saving()) return false;
    form.clearLines();
    if (!form.size || form.size->triangles > 0) return true;
    form.complaint = kNoTriangle;
    return false;
}

void MeshSaving::save(const std::string& path) {
    // The key that asks must not answer the question in the same frame.
    c_.ui.betweenFrames([this, path] {
        MeshForm& form = c_.ui.mesh;
        if (!canSave(path)) return;
        std::error_code error;
        if (!fs::exists(path, error)) return write(path);
        form.question = path;
        form.justAsked = true;
    });
}

void MeshSaving::replace() {
    const std::string path = std::exchange(c_.ui.mesh.question, {});
    if (canSave(path)) write(path);
}

void MeshSaving::keep() {
    c_.ui.mesh.clearLines();
    c_.ui.mesh.question.clear();
}

void MeshSaving::write(const std::string& path) {
    const MeshForm& form = c_.ui.mesh;
    prepareMesh();
    export_.save({path, form.usedOnly, form.faultFields});
    publish();
}

void MeshSaving::cancel() {
    export_.cancel();
    c_.ui.mesh.clearLines();
    c_.ui.mesh.complaint = "Cancelled: nothing was saved.";
}

void MeshSaving::copyCommand(const std::string& path) {
    MeshForm& form = c_.ui.mesh;
    form.clearLines();
    const bool known =
        form.savedSource == c_.session.input().spec().source && !form.savedPath.empty();
    const std::string usual =
        known ? form.savedPath : meshStem(c_.session) + std::string(form.chosen().extension);
    const MeshCommand command =
        meshCommand(c_.session, {path.empty() ? usual : path, form.usedOnly, form.faultFields});
    if (command.text.empty()) {
        form.complaint = command.note;
        return c_.session.messages().say(command.note);
    }
    c_.ui.clipboard.copy(command.text);
    form.note = "Copied the command." + (command.note.empty() ? "" : " " + command.note);
    c_.session.messages().say(form.note);
}

void MeshSaving::waitUntilDone() {
    export_.waitUntilDone();
    poll();
}

}  // namespace se::view
