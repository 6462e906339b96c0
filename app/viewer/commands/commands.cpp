#include "commands.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "alert_actions.h"
#include "ask_actions.h"
#include "break_commands.h"
#include "command_actions.h"
#include "compare_commands.h"
#include "growth_commands.h"
#include "panel_state/side_panels.h"
#include "run/strings.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/io/format_lists.h"

namespace se::view {

namespace {

using namespace actions;
using C = CommandContext;

const std::string kSaveMeshHelp =
    "Save the final mesh as " + listText(meshFormats(), &MeshFormat::name, "or") + ".";
const std::string kSaveMeshSynonyms =
    "export write store triangles " + lowerCase(listText(meshFormats(), &MeshFormat::name, ""));

// Groups in the order of the menu bar.
const auto kCommands = std::to_array<Command>({
    {"file.open", "File", "Open...", "Ctrl+O", "Open a point file or a session.", false,
     openBrowser, "load import read points scan"},
    {"file.new.shape", "File", "New from shape...", "Ctrl+N",
     "Spread new points over a shape, step by step.", false,
     [](C& c) { openGrowthPage(c, GrowthSource::Shape); }, "sample create generate particles"},
    {"file.new.volume", "File", "New from volume...", "Ctrl+Shift+N",
     "Spread new points over an isosurface of a volume, step by step.", false,
     [](C& c) { openGrowthPage(c, GrowthSource::Volume); },
     "sample create generate particles isosurface nrrd"},
    {"file.prepare", "File", "Prepare...", "Ctrl+Shift+R",
     "Choose what is derived from the points, and how.", false, openPrepare,
     "neighbors orient walls import options"},
    {"file.save", "File", "Save session", "Ctrl+S",
     "Save input, options, position, camera, layers, bookmarks and notes as a session file.", false,
     [](C& c) { c.ui.requests.saveSession = true; }, "store keep write project"},
    {"file.saveas", "File", "Save session as...", "Ctrl+Shift+S",
     "Save the session under another name.", false, saveAs, "store keep write project"},
    {"file.savemesh", "File", "Save mesh...", "Ctrl+E", kSaveMeshHelp, false, saveMesh,
     kSaveMeshSynonyms},
    {"file.copycommand", "File", "Copy command", "",
     "Copy the command line that makes this mesh: spiraling-edge run with all options.", false,
     copyCommand, "clipboard shell terminal script export"},
    {"file.savepoints", "File", "Save new points...", "", "Save the new points as PLY.", false,
     savePoints, "export write store ply"},
    {"file.restart", "File", "Reload and restart", "Ctrl+R",
     "Read the input again and go to the start.", false, restart, "reset refresh again"},
    {"file.screenshot", "File", "Save screenshot", "F12", "Save a picture of the window.", false,
     [](C& c) { c.ui.requests.screenshot = true; },
     "export record capture image snapshot png print"},
    {"file.quit", "File", "Quit", "Ctrl+Q", "Quit the program.", false,
     [](C& c) { c.ui.requests.quit = true; }, "exit close leave"},

    {"edit.undo", "Edit", "Undo", "Ctrl+Z",
     "Undo a change of layers, camera, selection, bookmarks, breakpoints, notes or looks.", true,
     [](C& c) { c.ui.requests.undo = true; }, "revert back"},
    {"edit.redo", "Edit", "Redo", "Ctrl+Y Ctrl+Shift+Z", "Redo the last undone change.", true,
     [](C& c) { c.ui.requests.redo = true; }, "repeat again"},

    {"edit.rules.reset", "Edit", "Reset all rules", "",
     "Reset all rules to the values of their set.", false, resetRules, "default settings"},
    {"edit.whatif.clear", "Edit", "Remove all what-ifs", "", "Run without what-ifs; rules stay.",
     false, clearWhatIfs, "undo fork reset"},

    {"run.play", "Run", "Play or pause", "Space P", "Play by the chosen unit, or pause.", false,
     playOrPause, "animate start stop record movie"},
    {"run.step", "Run", "One step forward", "O", "Go forward by one playback unit.", true,
     [](C& c) { stepByUnit(c, 1); }},
    {"run.step.back", "Run", "One step back", "Shift+O", "Go back by one playback unit.", true,
     [](C& c) { stepByUnit(c, -1); }},
    {"run.slower", "Run", "Slower", "-", "Play more slowly.", true,
     [](C& c) { c.playback.slower(); }},
    {"run.faster", "Run", "Faster", "=", "Play faster.", true, [](C& c) { c.playback.faster(); }},
    {"run.unit", "Run", "Change playback unit", "U",
     "Play by sub-steps, by pivots or from event to event.", false, toggleUnit, "speed mode"},
    {"run.loop.start", "Run", "Loop from here", "A", "Set the start of the playback loop.", false,
     setLoopStart, "repeat mark"},
    {"run.loop.end", "Run", "Loop to here", "B", "Set the end of the playback loop.", false,
     setLoopEnd, "repeat mark"},
    {"run.loop.clear", "Run", "Clear loop", "Shift+A", "Remove both ends of the playback loop.",
     false, [](C& c) { c.playback.loop = {}; }},
    {"run.continue", "Run", "Run to the next breakpoint", "F5",
     "Continue to the next breakpoint; without one, to the end.", false, continueRun<1>,
     "go stop debug"},
    {"run.continue.back", "Run", "Back to the previous breakpoint", "Shift+F5",
     "Go back to the previous breakpoint; without one, to the start.", false, continueRun<-1>},
    {"run.break", "Run", "Breakpoint here", "F9",
     "Set or remove a breakpoint on the selection, or on this kind of decision.", false,
     toggleBreakpointHere, "stop halt pause debug toggle"},
    {"run.compare", "Run", "Compare with the other rules", "",
     "Compare with the robust rules or, if those are on, with the paper's.", false, compareUsual,
     "difference side versus"},
    {"run.compare.mesh", "Run", "Compare with a mesh...", "",
     "Compare with a mesh that another program made from the same points.", false, compareMesh,
     "difference side reference"},
    {"run.compare.swap", "Run", "Swap the compared runs", "", "Show the other run in all panels.",
     false, askCompare<CompareAsk::Swap>},
    {"run.compare.stop", "Run", "End comparison", "", "Close the other run or mesh.", false,
     askCompare<CompareAsk::Stop>},
    {"run.end", "Run", "Run to the end", "End", "Run to the end in the background.", false, toEnd,
     "finish complete whole mesh result"},
    {"run.start", "Run", "Back to the start", "Home", "Go to the start of the run.", false, toStart,
     "begin rewind reset first"},

    {"step.pivot.next", "Step", "Next pivot", "F10 .", "Go to the end of the next pivot.", true,
     [](C& c) { pause(c), c.session.moves().stepPivot(1); }},
    {"step.pivot.previous", "Step", "Previous pivot", "Shift+F10 ,",
     "Go to the end of the previous pivot.", true,
     [](C& c) { pause(c), c.session.moves().stepPivot(-1); }},
    {"step.event.next", "Step", "Next sub-step", "F11 Right", "Go forward by one decision.", true,
     [](C& c) { pause(c), c.session.moves().stepEvent(1); }},
    {"step.event.previous", "Step", "Previous sub-step", "Left", "Go back by one decision.", true,
     [](C& c) { pause(c), c.session.moves().stepEvent(-1); }},
    {"step.pivot.finish", "Step", "Finish this pivot", "Shift+F11",
     "Go to the last decision of this pivot.", true,
     [](C& c) { pause(c), c.session.moves().finishPivot(); }},
    {"step.mark.next", "Step", "Next split, join, seed, alert or bookmark", "Ctrl+Right",
     "Go to the next change of the rings, alert or bookmark.", true, [](C& c) { toMark(c, 1); }},
    {"step.mark.previous", "Step", "Previous split, join, seed, alert or bookmark", "Ctrl+Left",
     "Go to the previous one.", true, [](C& c) { toMark(c, -1); }},
    {"step.alert.next", "Step", "Next alert", "F8", "Go to the next alert, and frame it.", true,
     [](C& c) { nextAlert(c, 1); }, "error failure hole defect problem"},
    {"step.alert.previous", "Step", "Previous alert", "Shift+F8", "Go to the previous alert.", true,
     [](C& c) { nextAlert(c, -1); }, "error failure hole defect problem"},
    {"step.back", "Step", "Back", "Alt+Left", "Go back to where the last jump began.", true,
     [](C& c) { pause(c), c.session.moves().goBack(); }},
    {"step.forward", "Step", "Forward", "Alt+Right", "Undo going back.", true,
     [](C& c) { pause(c), c.session.moves().goForward(); }},
    {"step.before", "Step", "Before this decision (hold)", "`",
     "Show the state before this decision, while the key is held.", false,
     [](C& c) { c.ui.look.toggle(LookBack::Mode::Before, c.ui.clock); }},
    {"step.blink", "Step", "Blink before and after (hold)", "Shift+`",
     "Alternate the states before and after this decision while the keys are held.", false,
     [](C& c) { c.ui.look.toggle(LookBack::Mode::Blink, c.ui.clock); }},
    {"step.difference", "Step", "First difference", "D",
     "Go to the first decision in which the compared runs differ.", false,
     askCompare<CompareAsk::FirstDifference>},
    {"step.region.next", "Step", "Next region of difference", "Shift+D",
     "Show the next region where the compared meshes differ, largest first.", true,
     askCompare<CompareAsk::NextRegion>},
    {"step.region.previous", "Step", "Previous region of difference", "Ctrl+Shift+D",
     "Show the previous region of difference.", true, askCompare<CompareAsk::PreviousRegion>},
    {"step.birth", "Step", "Where the selection was made", "",
     "Go to the pivot that made the selected edge or triangle.", false, goToBirth},
    {"step.goto", "Step", "Go to...", "Ctrl+G", "Type 137, 137.sphere.3, +10, 50% or p812.", false,
     [](C& c) { c.ui.goTo.open(); }, "jump address find"},

    {"step.copy", "Step", "Copy position", "Ctrl+C", "Copy address and camera as text.", false,
     [](C& c) { c.ui.requests.copyPlace = true; }, "clipboard share link"},
    {"step.paste", "Step", "Go to copied position", "Ctrl+V",
     "Go to the address or position on the clipboard.", false,
     [](C& c) { c.ui.requests.pastePlace = true; }, "clipboard jump"},

    {"view.frame", "View", "Frame pivot or selection", "F",
     "Show the selection, or the pivot and its neighbors.", false, frameFocus, "zoom focus center"},
    {"view.pivot", "View", "Frame pivot", "", "Show the pivot and its neighbors.", false,
     framePivot},
    {"view.all", "View", "Frame all", "Shift+F", "Show everything; the direction stays.", false,
     [](C& c) { c.camera.frame(glm::vec3(0.0F), 1.0F); }, "zoom fit whole center"},
    {"view.home", "View", "Camera home", "Enter", "Show everything from the first direction.",
     false, home, "reset zoom fit"},
    {"view.front", "View", "Front", "1", "Look from the front.", false, setView<ViewPreset::Front>},
    {"view.back", "View", "Back", "", "Look from the back.", false, setView<ViewPreset::Back>},
    {"view.right", "View", "Right", "3", "Look from the right.", false, setView<ViewPreset::Right>},
    {"view.left", "View", "Left", "", "Look from the left.", false, setView<ViewPreset::Left>},
    {"view.top", "View", "Top", "7", "Look down.", false, setView<ViewPreset::Top>, "above plan"},
    {"view.bottom", "View", "Bottom", "", "Look up.", false, setView<ViewPreset::Bottom>,
     "below under"},
    {"view.opposite", "View", "Opposite side", "9", "Look from the opposite side.", false,
     oppositeView},
    {"view.orthographic", "View", "Orthographic", "5",
     "Switch between orthographic and perspective view.", false,
     [](C& c) { c.camera.toggleOrthographic(); }, "perspective projection parallel"},
    {"view.up.auto", "View", "Up: automatic", "",
     "Guess the up axis, for this and all other files.", false, followUpAxis,
     "axis upright vertical orientation automatic rotate"},
    {"view.up.x", "View", "Up: x", "", "Make x the up axis, for this and all other files.", false,
     setUp<UpAxis::X>, "axis upright vertical orientation rotate"},
    {"view.up.y", "View", "Up: y", "", "Make y the up axis, for this and all other files.", false,
     setUp<UpAxis::Y>, "axis upright vertical orientation rotate"},
    {"view.up.z", "View", "Up: z", "", "Make z the up axis, for this and all other files.", false,
     setUp<UpAxis::Z>, "axis upright vertical orientation rotate"},
    {"view.fullscreen", "View", "Full screen", "Alt+Enter", "Switch full screen on or off.", false,
     [](C& c) { c.ui.requests.fullScreen = true; }, "maximize monitor"},
    {"view.theme", "View", "Dark or light", "T", "Switch between the dark and the light theme.",
     false, toggleTheme, "color mode appearance black white"},
    {"view.larger", "View", "Larger text", "Ctrl+=", "Enlarge text and panels, up to 3.", true,
     changeScale<1>, "zoom font scale bigger"},
    {"view.smaller", "View", "Smaller text", "Ctrl+-", "Shrink text and panels, down to 0.75.",
     true, changeScale<-1>, "zoom font scale"},
    {"view.monitorscale", "View", "Text size of the monitor", "",
     "Reset text and panels to the scale of the monitor.", false,
     [](C& c) { c.ui.settings.uiScale = 0.0; }},
    {"view.layout.next", "View", "Next layout", "F2", "Debug, Learn, Present.", false,
     [](C& c) { applyLayoutPreset(c, following(c.ui.layoutPreset)); }},
    {"view.layout.debug", "View", "Layout Debug", "", "All panels.", false,
     setLayoutPreset<LayoutPreset::Debug>, "panels arrange default"},
    {"view.layout.learn", "View", "Layout Learn", "",
     "The rule beside a large view, the decision in large type.", false,
     setLayoutPreset<LayoutPreset::Learn>, "panels arrange teach paper"},
    {"view.layout.present", "View", "Layout Present", "", "Only view, caption and run.", false,
     setLayoutPreset<LayoutPreset::Present>, "slides projector talk teach"},
    {"view.layout.compare", "View", "Layout Compare", "Ctrl+D",
     "Two runs, or a run and a mesh, side by side on one timeline; again to return.", false,
     toggleCompare, "difference side split versus"},
    {"view.mesh.flat", "View", "Mesh: flat", "", "Finished triangles flat gray.", false,
     setMeshStyle<MeshStyle::Flat>, "solid surface gray"},
    {"view.mesh.shaded", "View", "Mesh: smooth", "",
     "Finished triangles shaded as one smooth surface.", false, setMeshStyle<MeshStyle::Shaded>,
     "solid surface lit"},
    {"view.mesh.wire", "View", "Mesh: edges only", "", "Show only the edges of finished triangles.",
     false, setMeshStyle<MeshStyle::Wire>, "wireframe lines transparent"},
    {"view.mesh.birth", "View", "Mesh: by creation order", "",
     "Color finished triangles from the first to the last one made.", false,
     setMeshStyle<MeshStyle::CreationOrder>, "time age birth color"},
    {"view.mesh.component", "View", "Mesh: by component", "",
     "Color finished triangles by component.", false, setMeshStyle<MeshStyle::Component>,
     "parts pieces color"},
    {"view.mesh.next", "View", "Mesh: next style", "M", "Change how finished triangles look.",
     false, nextMeshStyle},
    {"view.points.status", "View", "Points: by status", "", "Color points by their status.", false,
     setPointTint<PointTint::Status>},
    {"view.points.margin", "View", "Points: by least margin", "",
     "Color points by how close their tests came to going the other way.", false,
     setPointTint<PointTint::Margin>},
    {"view.legend", "View", "Legend", "", "Show or hide the legend.", false,
     [](C& c) { c.ui.settings.legend = !c.ui.settings.legend; }, "symbols key meaning"},
    {"view.doctor", "View", "Doctor", "", "Open the panel with the problems of the input.", false,
     [](C& c) { openTab(c, kDoctorTab); }, "check repair problems input holes"},
    {"view.breakpoints", "View", "Breakpoints", "", "Open the panel with the breakpoints.", false,
     [](C& c) { openTab(c, kBreakpointsTab); }, "stops debug"},
    {"view.watch", "View", "Watch", "", "Open the panel with the watched expressions.", false,
     [](C& c) { openTab(c, kWatchTab); }, "plot graph variables numbers"},
    {"view.alerts", "View", "Alerts", "",
     "Open the panel with all failures of the run and their moments.", false,
     [](C& c) { openTab(c, kAlertsTab); }, "errors failures holes defects problems bugs wrong"},
    {"view.rules", "View", "Rules", "", "Open the panel with all rules as switches.", false,
     [](C& c) { openTab(c, kRulesTab); }, "options parameters settings switches"},
    {"view.whatif", "View", "What if", "",
     "Open the panel for overriding decisions: the run forks.", false,
     [](C& c) { openTab(c, kWhatIfTab); }, "fork override experiment change"},
    {"view.panel.next", "View", "Next panel", "Tab Ctrl+Tab",
     "Move the keyboard focus to the next panel: arrows choose a row, Enter goes there, Esc "
     "returns.",
     true, [](C& c) { c.ui.requests.walk = 1; }},
    {"view.panel.previous", "View", "Previous panel", "Shift+Tab Ctrl+Shift+Tab",
     "Move the keyboard focus to the previous panel.", true, [](C& c) { c.ui.requests.walk = -1; }},
    {"view.drawer", "View", "Fold the drawer", "Ctrl+J",
     "Show only the strip RUN, or PIVOT and STAGE as well.", false,
     [](C& c) { c.ui.navigation.toggleDrawer(); }, "strips timeline hide"},

    {"layer.normals", "Layers", "Normals", "N", "Pin normals near the pivot on or off.", false,
     toggle<LayerId::Normals>, "arrows show hide"},
    {"layer.labels", "Layers", "Labels", "L", "Pin labels on or off.", false,
     toggle<LayerId::Labels>, "names numbers text show hide"},
    {"layer.edges", "Layers", "Mesh edges", "E", "Pin edges of finished triangles on or off.",
     false, toggle<LayerId::MeshEdges>, "wireframe lines show hide"},
    {"layer.spheres", "Layers", "Spheres", "S", "Pin the circumsphere of a test on or off.", false,
     toggle<LayerId::Spheres>, "circumsphere circle show hide"},
    {"layer.links", "Layers", "Neighbor links", "G",
     "Pin the neighbor lists of pivot and selection on or off.", false, toggle<LayerId::Links>,
     "lists lines show hide"},
    {"layer.stack", "Layers", "Stacked rings", "K", "Pin the rings on the stack on or off.", false,
     toggle<LayerId::StackedRings>, "show hide"},

    {"ask.why", "Ask", "Why? Why not?", "W",
     "Explain in the panel Ledger why the selection is in the mesh, or why not.", false,
     askWhySelected, "explain reason cause history ledger"},
    {"ask.cause", "Ask", "Go to the cause", "", "Go to the decisive line of the ledger.", false,
     toCause},
    {"ask.line.next", "Ask", "Next line of the ledger", "]",
     "Go to the next decision in the ledger.", true, [](C& c) { toLedgerLine(c, 1); }},
    {"ask.line.previous", "Ask", "Previous line of the ledger", "[",
     "Go to the previous decision in the ledger.", true, [](C& c) { toLedgerLine(c, -1); }},

    {"ask.query", "Ask", "Find decisions...", "Ctrl+F",
     "Open the panel Query: for example stage=sphere kept margin<1e-4.", false, openQuery,
     "search filter"},
    {"ask.hit.next", "Ask", "Next decision found", "F3",
     "Go to the next decision that the query line found.", true, [](C& c) { toHit(c, 1); }},
    {"ask.hit.previous", "Ask", "Previous decision found", "Shift+F3",
     "Go to the previous one that the query line found.", true, [](C& c) { toHit(c, -1); }},
    {"ask.closest", "Ask", "Closest decisions", "",
     "List the decisions that came closest to going the other way.", false, openClosest,
     "margin near critical"},
    {"ask.charts", "Ask", "Charts", "", "Show the whole run as charts; each bar is a list.", false,
     openCharts, "statistics histogram bars"},

    {"notes.bookmark", "Notes", "Bookmark here", "Ctrl+B",
     "Set or remove a bookmark at this decision.", false, toggleBookmarkHere,
     "mark favorite pin remember"},
    {"notes.go.1", "Notes", "Go to bookmark 1", "Ctrl+1", "Go to the first bookmark.", false,
     goToBookmark<0>},
    {"notes.go.2", "Notes", "Go to bookmark 2", "Ctrl+2", "Go to the second bookmark.", false,
     goToBookmark<1>},
    {"notes.go.3", "Notes", "Go to bookmark 3", "Ctrl+3", "Go to the third bookmark.", false,
     goToBookmark<2>},
    {"notes.go.4", "Notes", "Go to bookmark 4", "Ctrl+4", "Go to the fourth bookmark.", false,
     goToBookmark<3>},
    {"notes.go.5", "Notes", "Go to bookmark 5", "Ctrl+5", "Go to the fifth bookmark.", false,
     goToBookmark<4>},
    {"notes.go.6", "Notes", "Go to bookmark 6", "Ctrl+6", "Go to the sixth bookmark.", false,
     goToBookmark<5>},
    {"notes.go.7", "Notes", "Go to bookmark 7", "Ctrl+7", "Go to the seventh bookmark.", false,
     goToBookmark<6>},
    {"notes.go.8", "Notes", "Go to bookmark 8", "Ctrl+8", "Go to the eighth bookmark.", false,
     goToBookmark<7>},
    {"notes.go.9", "Notes", "Go to bookmark 9", "Ctrl+9", "Go to the ninth bookmark.", false,
     goToBookmark<8>},
    {"notes.go.10", "Notes", "Go to bookmark 10", "Ctrl+0", "Go to the tenth bookmark.", false,
     goToBookmark<9>},

    {"help.palette", "Help", "Find an action...", "Ctrl+P Ctrl+K",
     "Type words of an action, a panel or a scene, then press Enter.", false,
     [](C& c) { c.ui.palette.show(); }},
    {"help.keys", "Help", "Keys and mouse", "F1 ?", "Show this list.", false,
     [](C& c) { c.ui.cheatSheet = !c.ui.cheatSheet; }, "shortcuts keyboard help"},
    {"help.editkeys", "Help", "Change keys...", "", "Choose other keys for actions.", false,
     [](C& c) { c.ui.keyEditor = !c.ui.keyEditor; }, "shortcuts keyboard bindings"},
    {"help.leave", "Help", "Close popup, clear selection", "Esc",
     "Close a popup, leave a panel, clear the selection, leave Present, in this order; never "
     "quits.",
     false, escape},
});

}  // namespace

std::span<const Command> commands() { return kCommands; }

const Command* findCommand(std::string_view id) {
    const auto found = std::find_if(kCommands.begin(), kCommands.end(),
                                    [&](const Command& each) { return each.id == id; });
    return found == kCommands.end() ? nullptr : &*found;
}

const Command* commandForKey(const KeyChord& chord) {
    for (const Command& command : kCommands) {
        for (const std::string_view word : wordsOf(command.keys)) {
            if (keyFromString(word) == chord) return &command;
        }
    }
    return nullptr;
}

std::string firstKey(const Command& command) {
    const auto words = wordsOf(command.keys);
    return words.empty() ? std::string{} : std::string(words.front());
}

std::string allKeys(const Command& command) {
    std::string text;
    for (const std::string_view word : wordsOf(command.keys)) {
        text += (text.empty() ? "" : ", ") + std::string(word);
    }
    return text;
}

std::string listActions() {
    std::string text;
    for (const Command& command : kCommands) {
        std::string line(command.id);
        line.resize(std::max<std::size_t>(line.size() + 1, 22), ' ');
        line += allKeys(command);
        line.resize(std::max<std::size_t>(line.size() + 1, 40), ' ');
        text += line + std::string(command.help) + "\n";
    }
    return text;
}

void runCommand(const Command& command, CommandContext& context) {
    if (context.ui.growth.open && runOnGrowthPage(command, context)) return;
    command.run(context);
}

}  // namespace se::view
