#include "mesh_saving.h"

#include <fmt/format.h>

#include <cassert>
#include <filesystem>
#include <utility>

#include "document.h"
#include "run/packed_file.h"
#include "run/strings.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/sampling/volume.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/spec_fields.h"

namespace se::view {

// The viewer and the command line use the same library, so a mesh can be reproduced byte for byte
// by `spiraling-edge run` with the options of the open input. Sampled points and the doctor's
// repairs are not options of `run`: they become commands before it, joined by &&, with files
// beside the mesh. tests/viewer/session/mesh_command_test.cpp compares the bytes.

namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "spiraling-edge";

std::string stemOf(const std::string& source, std::size_t points) {
    if (isScene(source)) return source.substr(kScenePrefix.size());
    if (isStandardInput(source)) return "points";
    if (isPacked(source)) return fs::path(packedName(source)).stem().string();
    if (!isSample(source)) return fs::path(source).stem().string();
    const Result<SampleSpec> spec = sampleFromSource(source);
    return spec ? sampleStem(spec.value(), points) : "sample";
}

/// A file in the folder of the mesh.
std::string besideMesh(const MeshTarget& target, const std::string& name) {
    return (fs::path(target.path).parent_path() / name).string();
}

/// The input of `run`, and the commands that write it.
struct Steps {
    std::string before;  ///< Ends where the next command may begin.
    std::string input;
    std::string note;
    std::string piece{};  ///< Options that read the piece of the input.

    void addNote(const char* words, const std::string& file) {
        note += fmt::format("{}{}{}.", note.empty() ? "" : " ", words, file);
    }
};

Steps stepsToSource(const std::string& source, const MeshTarget& target) {
    if (source.empty()) return {{}, sceneSource(scenes().front().id), {}};
    if (isScene(source)) return {{}, source, {}};
    if (isStandardInput(source)) {
        return {{},
                {},
                "These points came from standard input. Save them to a file, open it, and "
                "copy again."};
    }
    if (isPacked(source)) {
        return {
            {}, {}, "These points came in a link. Save them to a file, open it, and copy again."};
    }
    // The terminal may be in another folder.
    if (!isSample(source)) return {{}, wholePath(source), {}};
    Result<SampleSpec> spec = sampleFromSource(source);
    if (!spec) return {{}, {}, spec.error().message};
    SampleSpec& made = spec.value();
    if (isVolumePath(made.surface)) made.surface = wholePath(made.surface);
    const std::string points = besideMesh(target, sampleStem(made, made.count) + ".ply");
    const std::string command = sampleCommand(made, points);
    if (command.empty()) {
        return {{},
                {},
                "The sampler was stopped early, which the command line cannot do. Save the points "
                "by File > Save new points..., open that file, and copy again."};
    }
    return {command + " && ", points, "First the points are written to " + points + "."};
}

/// The input and its piece as words.
std::string inputOf(const Steps& steps) { return shellPath(steps.input) + steps.piece; }

/// The doctor's commands for the fixes that repair or drop points. Exit code 1 only means that
/// findings are left; the next command must not run after any other failure.
void addDoctor(const RunSpec& spec, const MeshTarget& target, Steps& steps) {
    const std::string stem = stemOf(spec.source.empty() ? steps.input : spec.source, 0);
    int files = 0;
    for (const std::string& name : spec.fixes) {
        const DoctorCheck* check = findDoctorCheck(name);
        if (check == nullptr) continue;
        const bool drops = check->fix == Fix::Drop;
        // One command repairs everything that any of these checks finds.
        if (!drops && (check->fix != Fix::Repair || files > 0)) continue;
        ++files;
        std::string repaired = besideMesh(
            target,
            fmt::format("{}-fixed{}.ply", stem, files > 1 ? fmt::format("-{}", files) : ""));
        steps.before +=
            fmt::format("{{ {} doctor {} -q --fix {}{}; [ $? -le 1 ]; }} && ", kProgram,
                        inputOf(steps), shellPath(repaired), drops ? " --drop " + name : "");
        steps.input = std::move(repaired);
        steps.piece.clear();
    }
    if (files > 0) steps.addNote("First the points are repaired in ", steps.input);
}

/// The command that writes a given start, and the option that reads it.
std::string addStart(const RunSpec& spec, const MeshTarget& target, Steps& steps) {
    if (spec.start.empty()) return {};
    const std::string stem = stemOf(spec.source.empty() ? steps.input : spec.source, 0);
    const std::string file = besideMesh(target, stem + ".start.json");
    steps.before +=
        "printf '%s\\n' " + shellQuoted(startJson(spec.start)) + " > " + shellPath(file) + " && ";
    steps.addNote("First the start is written to ", file);
    return " --start " + shellPath(file);
}

}  // namespace

MeshCommand meshCommand(const RunSpec& spec, const MeshTarget& target) {
    if (!spec.leftOut.empty()) {
        return {{},
                "There is no command for points left out in the view. Save the session, which "
                "keeps them, or bring them back in the panel Doctor."};
    }
    if (isPractice(spec.source)) {
        return {"spiraling-edge-viewer " + shellQuoted(spec.source),
                "It opens the pivot to practice, whose points have no file."};
    }
    Steps steps = stepsToSource(spec.source, target);
    if (steps.input.empty()) return {{}, steps.note};
    steps.piece = optionsText(spec, {SpecGroup::Reading});
    addDoctor(spec, target, steps);
    const std::string start = addStart(spec, target, steps);
    MeshCommand command{steps.before + kProgram + " run " + inputOf(steps), steps.note};
    command.text += start + optionsText(withFixesAsOptions(spec),
                                        {SpecGroup::Rules, SpecGroup::Lists, SpecGroup::Derived});
    if (target.usedOnly) command.text += " --used-points";
    if (target.writesFaultFields()) command.text += " --fault-fields";
    command.text += " -o " + shellPath(target.path);
    const NamedFile input{"", steps.input};
    const NamedFile output{"-o", target.path};
    if (!requireKept({&input, 1}, {&output, 1})) command.text += " " + std::string(kForceOption);
    return command;
}

MeshCommand meshCommand(const Session& session, const MeshTarget& target) {
    assert(session.ready());
    const RunSpec& spec = session.input().spec();
    for (std::size_t i = 0; i < spec.whatIf.size(); ++i) {
        if (session.input().whatIfProblem(i).empty()) continue;
        return {{},
                "The command line refuses the what-if \"" + lineOf(spec.whatIf[i]) +
                    "\": " + session.input().whatIfProblem(i) +
                    " Remove it in the panel What if, and copy again."};
    }
    return meshCommand(spec, target);
}

std::string inputStem(const Session& session) {
    assert(session.ready());
    const std::string& source = session.input().spec().source.empty()
                                    ? session.model().name
                                    : session.input().spec().source;
    return stemOf(source, session.model().points.size());
}

std::string meshStem(const Session& session) { return inputStem(session) + "-mesh"; }

bool MeshSaving::dialogOpen() const {
    return c_.ui.fileBrowser && c_.ui.browser == BrowserTask::SaveMesh && c_.session.ready();
}

bool MeshSaving::poll() {
    bool news = mesh_.poll();
    if (news) startWriting();
    if (file_.poll()) {
        news = true;
        file_.answer() != nullptr ? takeSaved(*file_.answer()) : fail(file_.complaint());
        file_.cancel();
    }
    if (dialogOpen())
        prepareMesh();
    else
        discard();
    c_.ui.mesh.saving = saving();
    return news;
}

/// Discards the mesh, and a pending write. A write in progress completes.
void MeshSaving::discard() {
    order_.reset();
    model_.reset();
    begun_ = false;
    mesh_.cancel();
}

/// Starts the pending write if the mesh is ready. If there will be no mesh, reports the reason.
void MeshSaving::startWriting() {
    if (!order_) return;
    if (!mesh_.complaint().empty()) {
        order_.reset();
        return fail(mesh_.complaint());
    }
    if (mesh() == nullptr) return;
    file_.start([model = model_, mesh = *mesh(), target = *std::exchange(order_, std::nullopt)](
                    const Progress&) { return saveMesh(*model, mesh, target); });
}

void MeshSaving::fail(const std::string& why) {
    c_.ui.mesh.complaint = why;
    // The dialog may have been closed.
    c_.session.messages().say(why);
}

void MeshSaving::takeSaved(const SavedMesh& saved) {
    MeshForm& form = c_.ui.mesh;
    form.savedPath = saved.target.path;
    form.savedSource = c_.session.input().spec().source;
    // The settings of the run are in a file now, with its mesh.
    c_.document.keepSettings();
    if (dialogOpen()) c_.ui.fileBrowser = false;
    c_.session.messages().say(savedText(saved));
}

/// Prepares the mesh of the open run once there is its end, unless it is ready or in progress; the
/// mesh of another run is discarded. While a file is written, another run may have been opened.
void MeshSaving::prepareMesh() {
    if (writing()) return;
    const Session& session = c_.session;
    if (session.sharedModel() != model_) {
        discard();
        model_ = session.sharedModel();
    }
    const std::shared_ptr<const RunEnd> end = session.runEnd();
    if (!end && order_ && session.isMade()) {
        order_.reset();
        c_.ui.mesh.complaint = "The run did not come to its end: there is no mesh to save.";
    }
    if (!end || std::exchange(begun_, true)) return;
    mesh_.start(
        [model = model_, input = session.input().file(),
         end](const Progress&) -> Result<FinishedMesh> { return finishMesh(*model, *input, end); });
}

bool MeshSaving::canSave(const std::string& path) {
    MeshForm& form = c_.ui.mesh;
    if (path.empty() || !c_.session.ready() || saving()) return false;
    form.clearLines();
    if (mesh() == nullptr || !mesh()->triangles->empty()) return true;
    form.complaint = "This run makes no triangles: there is no mesh to save.";
    return false;
}

void MeshSaving::save(const std::string& path) {
    MeshForm& form = c_.ui.mesh;
    if (!canSave(path)) return;
    prepareMesh();
    if (saving()) return;
    order_ = MeshTarget{path, form.usedOnly, form.faultFields};
    startWriting();
    form.saving = saving();
}

void MeshSaving::cancel() {
    order_.reset();
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
    mesh_.waitUntilDone();
    poll();
    file_.waitUntilDone();
    poll();
}

}  // namespace se::view
