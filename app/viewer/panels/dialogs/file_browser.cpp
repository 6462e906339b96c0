// The file dialog: folders and files, the line of the name, and the options of what is saved.
#include <algorithm>
#include <filesystem>
#include <vector>

#include "compare/compared_runs.h"
#include "document/actions.h"
#include "document/document.h"
#include "document/mesh_saving.h"
#include "document/new_points.h"
#include "document/ui_state.h"
#include "export/formats.h"
#include "input/key_routing.h"
#include "lesson/lesson_player.h"
#include "lesson/lesson_walk.h"
#include "panel_state/file_browser_state.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/packed_file.h"
#include "session/session.h"
#include "session/session_file.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::view {

namespace {

/// Position of the fields after their names, in em.
constexpr float kFieldColumn = 4.5F;
constexpr float kAddressEms = 9.0F;
constexpr float kSpeedEms = 3.5F;

/// A choice, beside the previous one if there is room. True if it was chosen.
bool drawChoice(const PanelContext& context, const std::string& label, bool on,
                const std::string& where, const std::string& tip, bool first) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width =
        ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize(label.c_str()).x;
    if (!first) {
        ImGui::SameLine(0.0F, context.em);
        if (ImGui::GetContentRegionAvail().x < width) {
            ImGui::NewLine();
            ImGui::SetCursorPosX(kFieldColumn * context.em);
        }
    }
    const bool chosen = ImGui::RadioButton(label.c_str(), on);
    nameItem(context, where, tip);
    return chosen;
}

std::string leftOutText(const MeshFormat& format) {
    return std::string(format.title) + ". " +
           (format.leavesOut.empty() ? "Keeps everything."
                                     : "Leaves out: " + std::string(format.leavesOut) + ".");
}

/// The formats of a table, as "mesh PLY" or "export gif" of `where`.
template <typename Form, typename Formats, typename Label, typename Tip>
void drawFormats(const PanelContext& context, Form& form, const Formats& formats, std::string& name,
                 const std::string& where, Label labelOf, Tip tipOf) {
    form.followName(name);
    fieldName(context, "Format", kFieldColumn);
    for (std::size_t i = 0; i < formats.size(); ++i) {
        const std::string label(labelOf(formats[i]));
        if (drawChoice(context, label, form.format == i, where + label,
                       std::string(tipOf(formats[i])), i == 0))
            form.choose(i, name);
    }
}

void drawPoints(const PanelContext& context) {
    MeshForm& form = context.state<MeshForm>();
    fieldName(context, "Points", kFieldColumn);
    if (drawChoice(context, "All, in the order of the input", !form.usedOnly, "mesh all points",
                   "Also points in no triangle", true))
        form.usedOnly = false;
    if (drawChoice(context, "Used points only", form.usedOnly, "mesh used points",
                   "Without points in no triangle (--used-points)", false))
        form.usedOnly = true;
}

/// Columns of faults, for formats that hold columns.
void drawFields(const PanelContext& context) {
    MeshForm& form = context.state<MeshForm>();
    const bool possible = keepsColumns(form.chosen());
    fieldName(context, "Fields", kFieldColumn);
    ImGui::BeginDisabled(!possible);
    bool on = form.faultFields && possible;
    if (ImGui::Checkbox("Faults and distances of points", &on)) form.faultFields = on;
    nameItem(context, "mesh fault fields",
             possible
                 ? "Scalar fields se_fault and se_distance, as CloudCompare shows them "
                   "(--fault-fields)"
                 : "Only in " + listText(meshFormats(), &MeshFormat::name, "and", keepsColumns));
    ImGui::EndDisabled();
}

/// Size of the mesh, and the state of the run.
void drawSize(const PanelContext& context) {
    const FinishedMesh* mesh = context.commands.mesh.mesh();
    if (mesh == nullptr) {
        ImGui::ProgressBar(static_cast<float>(context.session().madeShare()), {-1.0F, 0.0F},
                           "running to the end");
        return;
    }
    if (mesh->triangles->empty())
        return wrappedText("This run makes no triangles: there is no mesh to save.");
    const std::size_t all = mesh->points->position.size();
    const std::size_t written = context.state<MeshForm>().usedOnly ? mesh->usedPoints : all;
    std::string text = sizeText(mesh->triangles->size(), written, all);
    text += ": the mesh at the end of the run.";
    if (mesh->capped) text += " The run was stopped by the rule cap: the mesh is incomplete.";
    wrappedText(text);
}

void drawCopy(const PanelContext& context, const std::string& path) {
    const MeshForm& form = context.state<MeshForm>();
    if (textButton(context, "Copy command", "mesh copy command",
                   "The command line that writes the same file, for a terminal"))
        context.commands.mesh.copyCommand(path);
    if (form.note.empty()) return;
    ImGui::SameLine();
    dimText(form.note);
}

void drawWork(const PanelContext& context) {
    const bool writing = context.commands.mesh.writing();
    const float button = 5.5F * context.em;
    ImGui::ProgressBar(writing ? 1.0F : static_cast<float>(context.session().madeShare()),
                       {ImGui::GetContentRegionAvail().x - button, 0.0F},
                       writing ? "writing" : "running to the end");
    ImGui::SameLine();
    ImGui::BeginDisabled(writing);
    if (textButton(context, "Cancel", "mesh cancel", {}, -1.0F)) context.commands.mesh.cancel();
    ImGui::EndDisabled();
}

/// The place of the captions of a format.
std::string captionsTip(const ExportFormat& format) {
    if (format.captioned) return "The sentence of each decision, below the view";
    if (format.content == FrameContent::BothThemes) return "The sentence below each drawing";
    return "The sentences, in a text file beside the pictures";
}

/// A field of the export, by the name of its item, with a hint while it is empty.
void drawField(const PanelContext& context, const std::string& name, const std::string& tip,
               const char* hint, std::string& text, float ems = kAddressEms) {
    ImGui::SetNextItemWidth(ems * context.em);
    textField(("##" + name).c_str(), hint, text);
    nameItem(context, name, tip);
}

void drawRange(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    fieldName(context, "From", kFieldColumn);
    drawField(context, "export from", "First frame: 9, 9.sphere.1 or 50%", "9.sphere.1", form.from);
    ImGui::SameLine();
    ImGui::TextDisabled("to");
    ImGui::SameLine();
    drawField(context, "export to", "Last frame; of a pivot, its last decision", "9.emit.4",
              form.to);
    fieldName(context, "Each", kFieldColumn);
    for (const PlayUnit unit : {PlayUnit::SubStep, PlayUnit::Pivot, PlayUnit::Event}) {
        const std::string name(unitName(unit));
        if (drawChoice(context, name, form.unit == unit, "export " + name,
                       unit == PlayUnit::Event ? "Seed, split, join or alert" : "",
                       unit == PlayUnit::SubStep))
            form.unit = unit;
    }
}

void drawFrameOptions(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    const bool lesson = context.state<LessonPanel>().walk.isOpen();
    if (!lesson && form.frames == ExportFrames::Lesson) form.frames = ExportFrames::Picture;
    fieldName(context, "Frames", kFieldColumn);
    const auto offer = [&](ExportFrames frames, const char* label, const char* where) {
        if (drawChoice(context, label, form.frames == frames, where, "",
                       frames == ExportFrames::Picture))
            form.frames = frames;
    };
    offer(ExportFrames::Picture, "This picture", "export picture");
    offer(ExportFrames::Pivot, "This pivot", "export this pivot");
    offer(ExportFrames::Range, "A range", "export range");
    if (lesson) offer(ExportFrames::Lesson, "The lesson", "export lesson");
    if (form.frames == ExportFrames::Range) drawRange(context);
    if (form.frames != ExportFrames::Lesson) return;
    fieldName(context, "Steps", kFieldColumn);
    drawField(context, "export steps", "Numbers of steps, such as 2,4-6; none: all", "all",
              form.steps);
}

void drawLookOptions(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    fieldName(context, "Size", kFieldColumn);
    drawField(context, "export size", "Width and height in pixels", "1280x800", form.size);
    if (form.hasSpeed()) {
        ImGui::SameLine(0.0F, context.em);
        drawField(context, "export speed", "Frames per second", "2", form.perSecond, kSpeedEms);
        ImGui::SameLine();
        ImGui::TextDisabled("per second");
    }
    if (!form.hasCaptions()) return;
    ImGui::SameLine(0.0F, context.em);
    ImGui::Checkbox("Captions", &form.captions);
    nameItem(context, "export captions", captionsTip(form.chosen()));
}

void drawProgress(const PanelContext& context) {
    ExportForm& form = context.state<ExportForm>();
    const std::string text = form.total == 0 ? "opening"
                                             : "frame " + std::to_string(form.made) + " of " +
                                                   std::to_string(form.total);
    const double share =
        form.total == 0 ? 0.0 : static_cast<double>(form.made) / static_cast<double>(form.total);
    if (progressAndStop(context, share, text.c_str(), "export cancel", 5.5F)) form.working = false;
}

/// The browser is saving a mesh or an export, and waits for a thread: input is disabled.
bool saveDialogWaits(const PanelContext& context) {
    const BrowserTask task = context.ui().browser;
    return (task == BrowserTask::SaveMesh && context.state<MeshForm>().saving) ||
           (task == BrowserTask::Export && context.state<ExportForm>().working);
}

/// Draws the fields below the line with the name; a format may change the extension in `name`.
void drawMeshFields(const PanelContext& context, std::string& name, const std::string& path) {
    MeshForm& form = context.state<MeshForm>();
    complain(context, form.complaint);
    if (form.saving) return drawWork(context);
    drawFormats(
        context, form, meshFormats(), name, "mesh ",
        [](const MeshFormat& each) { return each.name; }, leftOutText);
    ImGui::SetCursorPosX(kFieldColumn * context.em);
    dimText(leftOutText(form.chosen()));
    drawPoints(context);
    drawFields(context);
    drawSize(context);
    drawCopy(context, path);
    ImGui::Separator();
}

void drawExportFields(const PanelContext& context, std::string& name) {
    ExportForm& form = context.state<ExportForm>();
    complain(context, form.complaint);
    if (form.working) return drawProgress(context);
    drawFormats(
        context, form, exportFormats(), name, "export ",
        [](const ExportFormat& each) { return each.extension.substr(1); },
        [](const ExportFormat& each) { return each.title; });
    drawFrameOptions(context);
    drawLookOptions(context);
    ImGui::Separator();
}

namespace fs = std::filesystem;

/// Frames in which the line gets the keyboard focus and its text is selected: Dear ImGui needs two.
constexpr int kSettling = 3;

void openSource(const PanelContext& context, const std::string& source) {
    context.ui().fileBrowser = false;
    actions::openFor(context.commands, context.ui().browser, source);
}

void save(CommandContext& c, const std::string& path) {
    switch (c.ui.browser) {
        case BrowserTask::SaveSession:
            return c.document.saveAs(path);
        case BrowserTask::SavePoints:
            return c.sampling.save(path);
        case BrowserTask::SaveResult:
            return c.lesson.saveResult(path);
        case BrowserTask::SaveLesson:
            return c.lesson.saveLesson(path);
        case BrowserTask::SaveMesh:
            return c.mesh.save(path);
        case BrowserTask::Export:
            c.ui.exported.path = path;
            c.ui.exported.working = true;
            return;
        default:
            return;
    }
}

/// The file of a typed name, with the extension of the chosen format or of the purpose.
fs::path fileOf(const PanelContext& context, const std::string& typed) {
    const BrowserTask task = context.ui().browser;
    if (task == BrowserTask::SaveMesh) return context.state<MeshForm>().withFormat(typed);
    if (task == BrowserTask::Export) return context.state<ExportForm>().withFormat(typed);
    return withExtension(typed, rowOf(task).extension);
}

/// An existing file is replaced only at the second request.
void saveTo(const PanelContext& context, FileBrowsing& state, const std::string& typed) {
    const BrowserTask task = context.ui().browser;
    const fs::path path = fileOf(context, typed);
    std::error_code error;
    const bool own = task == BrowserTask::SaveSession && path == context.ui().sessionPath;
    const bool series =
        task == BrowserTask::Export && context.state<ExportForm>().frames != ExportFrames::Picture;
    std::vector<fs::path> replaced = series ? seriesFilesAt(path) : std::vector{path};
    std::erase_if(replaced, [&](const fs::path& each) { return !fs::exists(each, error); });
    if (!own && !replaced.empty() && state.overwrite != path) {
        state.overwrite = path;
        context.state<MeshForm>().clearLines();
        state.error =
            replaceText(replaced.front().string(), context.session().input().spec().source) +
            " Save again to do so.";
        return;
    }
    state.overwrite.clear();
    state.error.clear();
    save(context.commands, path.string());
    // A mesh and an export show their progress here.
    const bool shows = task == BrowserTask::SaveMesh || task == BrowserTask::Export;
    if (!shows) context.ui().fileBrowser = false;
}

/// File name without extension for the sampled points of the page, or of the open input.
std::string stemOfMade(const PanelContext& context) {
    const GrowthPicture* picture = context.commands.sampling.growth().picture();
    if (context.state<GrowthPage>().open)
        return sampleStem(context.commands.sampling.growth().spec(),
                          picture != nullptr ? picture->points->position.size() : 0);
    const Session& session = context.session();
    const Result<SampleSpec> spec = sampleFromSource(session.input().spec().source);
    return spec && session.ready() ? sampleStem(spec.value(), session.model().points.size()) : "";
}

/// File of the last saved mesh of this input; empty: none yet.
fs::path savedMesh(const PanelContext& context) {
    const MeshForm& form = context.state<MeshForm>();
    const bool mesh = context.ui().browser == BrowserTask::SaveMesh;
    return mesh && form.savedSource == context.session().input().spec().source ? form.savedPath
                                                                               : "";
}

/// Name of the open lesson without extension.
std::string lessonStem(const PanelContext& context) {
    const LessonWalk& walk = context.state<LessonPanel>().walk;
    if (!walk.isOpen()) return "lesson";
    if (!isLessonFile(walk.source())) {
        std::string name = walk.source();
        std::replace(name.begin(), name.end(), ':', '-');
        return name;
    }
    const std::string name = fs::path(walk.source()).filename().string();
    return name.substr(0, name.size() - teach::kLessonExtension.size());
}

/// The input and the position, "torus-9-sphere-2.png".
std::string exportName(const PanelContext& context) {
    const Session& session = context.session();
    std::string place = session.event() != nullptr ? toString(session.address()) : "start";
    std::replace(place.begin(), place.end(), '.', '-');
    return context.state<ExportForm>().withFormat(inputStem(session) + "-" + place);
}

/// The proposed name: that of the session, otherwise that of the input.
std::string proposedName(const PanelContext& context) {
    if (context.ui().browser == BrowserTask::SavePoints) return stemOfMade(context) + ".ply";
    if (context.ui().browser == BrowserTask::SaveMesh) {
        const fs::path saved = savedMesh(context);
        return saved.empty() ? context.state<MeshForm>().withFormat(meshStem(context.session()))
                             : saved.filename().string();
    }
    if (context.ui().browser == BrowserTask::SaveResult)
        return lessonStem(context) + std::string(teach::kResultExtension);
    const bool lesson = context.ui().browser == BrowserTask::SaveLesson;
    if (context.ui().browser == BrowserTask::Export) return exportName(context);
    const std::string& session = context.ui().sessionPath;
    if (!session.empty() && !lesson) return fs::path(session).filename().string();
    if (!context.session().ready()) return {};
    const std::string extension(lesson ? teach::kLessonExtension : kSessionExtension);
    if (const std::string made = stemOfMade(context); !made.empty()) return made + extension;
    std::string name = context.session().model().name;
    if (isScene(name)) name = name.substr(kScenePrefix.size());
    return fs::path(name).stem().string() + extension;
}

/// The folder of the last export or mesh, of the open file, otherwise the working directory,
/// otherwise home.
fs::path firstFolder(const PanelContext& context) {
    std::error_code error;
    const UiState& ui = context.ui();
    const std::string& source = context.session().input().spec().source;
    const bool file = isFilePath(source);
    const bool exports = ui.browser == BrowserTask::Export;
    const fs::path saved = exports ? fs::path(ui.exported.path) : savedMesh(context);
    const fs::path near = !saved.empty()            ? saved
                          : !ui.sessionPath.empty() ? fs::path(ui.sessionPath)
                          : file                    ? fs::path(source)
                                                    : fs::path();
    if (near.empty()) return fs::current_path(error);
    return fs::path(wholePath(near.string())).parent_path();
}

void drawScenes(const PanelContext& context) {
    heading(context, "Scenes");
    if (ImGui::BeginChild("##scenes", {0, 0}, false)) {
        for (const Scene& scene : scenes()) {
            const std::string title =
                fitted(std::string(scene.title), ImGui::GetContentRegionAvail().x);
            if (ImGui::Selectable((title + "##" + std::string(scene.id)).c_str())) {
                openSource(context, sceneSource(scene.id));
            }
            tooltip(sceneSource(scene.id) + "\n" + std::string(scene.watch));
        }
    }
    ImGui::EndChild();
}

/// The input line, with its button.
void drawPathLine(const PanelContext& context, FileBrowsing& state) {
    const BrowserTaskRow& task = rowOf(context.ui().browser);
    const bool exports = context.ui().browser == BrowserTask::Export;
    const bool waits = saveDialogWaits(context);
    ImGui::BeginDisabled(waits);
    ImGui::SetNextItemWidth(-5.0F * context.em);
    // A click beside the line must not take the keyboard focus away.
    // Nor must a page that opens together with the browser and takes the focus.
    if (!waits && (state.settling > 0 || state.refocus)) ImGui::SetKeyboardFocusHere();
    // The proposed name is selected, also if the field was typed into before.
    const int select = state.settling > 0 ? ImGuiInputTextFlags_AutoSelectAll : 0;
    const bool entered = textField("##path", task.hint.c_str(), state.path,
                                   ImGuiInputTextFlags_EnterReturnsTrue | select);
    if (ImGui::IsItemActive()) context.state<TypingWait>().takesKeys();
    ImGui::SameLine();
    const bool pressed = ImGui::Button(exports      ? "Export"
                                       : task.saves ? "Save"
                                                    : "Open",
                                       {-1.0F, 0.0F});
    if (exports) nameItem(context, "export go");
    ImGui::EndDisabled();
    // Enter takes the keyboard focus from the line: if the name is refused, the next one is typed
    // there.
    if (entered) state.settling = kSettling;
    if ((pressed || entered) && !waits) {
        const std::string source = typedSource(state.folder, state.path);
        std::error_code error;
        if (source.empty()) {
            state.error = "Enter a name.";
        } else if (fs::is_directory(source, error)) {
            state.readFolder(source);
        } else if (task.saves) {
            saveTo(context, state, source);
        } else {
            openSource(context, source);
        }
    }
    complain(context, state.error);
}

/// Files of the reader's machine: the program does not see them before they are chosen.
void drawHostFiles(const PanelContext& context) {
    heading(context, "Files", "");
    if (ImGui::Button("Choose a file...")) context.ui().hostFiles.pick();
    dimText("Or drop one anywhere on the window. It stays on this machine.");
}

void drawFiles(const PanelContext& context, FileBrowsing& state) {
    if (context.ui().hostFiles.apart() && !rowOf(context.ui().browser).saves)
        return drawHostFiles(context);
    const float room = std::max(6.0F * context.em, ImGui::GetContentRegionAvail().x * 0.75F);
    heading(context, "Files", fittedName(state.folder.string(), room));
    drawPathLine(context, state);
    if (context.ui().browser == BrowserTask::SaveMesh && context.session().ready()) {
        const std::string path = typedSource(state.folder, state.path);
        drawMeshFields(context, state.path,
                       path.empty() ? path : context.state<MeshForm>().withFormat(path));
    }
    if (context.ui().browser == BrowserTask::Export) drawExportFields(context, state.path);
    if (context.ui().hostFiles.apart()) return dimText("The file goes to your downloads.");
    ImGui::BeginDisabled(saveDialogWaits(context));
    if (ImGui::BeginChild("##files", {0, 0}, false)) {
        if (ImGui::Selectable("..")) state.readFolder(fs::path(state.folder).parent_path());
        const std::vector<BrowserEntry> entries = state.entries;
        for (const BrowserEntry& entry : entries) {
            const std::string shown = entry.folder ? entry.name + "/" : entry.name;
            if (!ImGui::Selectable(shown.c_str())) continue;
            const fs::path path = state.folder / entry.name;
            if (entry.folder) {
                state.readFolder(path);
            } else if (rowOf(state.task).saves) {
                state.path = entry.name;
            } else {
                openSource(context, path.string());
            }
        }
        if (entries.empty()) ImGui::TextDisabled("%s", rowOf(state.task).nothing.c_str());
    }
    ImGui::EndChild();
    ImGui::EndDisabled();
}

void drawOpen(const PanelContext& context, FileBrowsing& state) {
    // The lists in it scroll, not the window.
    if (!ImGui::BeginTable("##open", 2, ImGuiTableFlags_BordersInnerV)) return;
    ImGui::TableSetupColumn("scenes", ImGuiTableColumnFlags_WidthStretch, 0.42F);
    ImGui::TableSetupColumn("files", ImGuiTableColumnFlags_WidthStretch, 0.58F);
    ImGui::TableNextColumn();
    drawScenes(context);
    ImGui::TableNextColumn();
    drawFiles(context, state);
    ImGui::EndTable();
}

/// Prepares the browser each time it opens, since files may have changed.
void prepare(const PanelContext& context, FileBrowsing& state) {
    state.task = context.ui().browser;
    if (state.folder.empty() || rowOf(state.task).saves) state.folder = firstFolder(context);
    state.readFolder(fs::path(state.folder));
    state.path = rowOf(state.task).saves ? proposedName(context) : std::string{};
    state.settling = kSettling;
    state.overwrite.clear();
}

}  // namespace

void drawFileBrowser(const PanelContext& context) {
    bool& open = context.ui().fileBrowser;
    FileBrowsing& state = context.state<FileBrowsing>();
    if (!open) {
        state.shown = false;
        return;
    }
    if (!state.shown || state.task != context.ui().browser) prepare(context, state);
    placeDialog(context, {48.0F, 32.0F});
    if (beginDialog((rowOf(state.task).title + "###browser").c_str(), &open,
                    ImGuiWindowFlags_NoScrollbar))
        state.task == BrowserTask::Open ? drawOpen(context, state) : drawFiles(context, state);
    state.shown = true;
    // After a question the input line has the keyboard focus again.
    state.settling = saveDialogWaits(context) ? 2 : std::max(0, state.settling - 1);
    // Unless the click was into another text field.
    state.refocus = ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive();
    ImGui::End();
}

}  // namespace se::view
