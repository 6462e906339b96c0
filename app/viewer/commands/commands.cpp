#include "commands.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "alert_actions.h"
#include "ask_actions.h"
#include "break_commands.h"
#include "command_actions.h"
#include "panel_state/side_panels.h"
#include "run/strings.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

namespace {

using namespace actions;
using C = CommandContext;

constexpr bool kRepeats = true;

const std::string kSaveMeshHelp =
    "Save the final mesh as " + listText(meshFormats(), &MeshFormat::name, "or") + ".";
const std::string kSaveMeshSynonyms =
    "export write store triangles " + lowerCase(listText(meshFormats(), &MeshFormat::name, ""));

// Groups in the order of the menu bar.
const auto kCommands = std::to_array<Command>({
    {"file.open", "File", "Open...", "Ctrl+O", "Open a point file or a session.",
     [](C& c) { openBrowser(c, BrowserTask::Open); }, "load import read points scan"},
    {"file.new.shape", "File", "New from shape...", "Ctrl+N",
     "Spread new points over a shape, step by step.",
     [](C& c) { openGrowthPage(c, GrowthSource::Shape); }, "sample create generate particles"},
    {"file.new.volume", "File", "New from volume...", "Ctrl+Shift+N",
     "Spread new points over an isosurface of a volume, step by step.",
     [](C& c) { openGrowthPage(c, GrowthSource::Volume); },
     "sample create generate particles isosurface nrrd"},
    {"file.prepare", "File", "Prepare...", "Ctrl+Shift+R",
     "Choose what is derived from the points, and how.", openPrepare,
     "neighbors orient walls import options"},
    {"file.save", "File", "Save session", "Ctrl+S",
     "Save input, options, position, camera, layers, bookmarks and notes as a session file.",
     [](C& c) { c.ui.requests.saveSession = true; }, "store keep write project"},
    {"file.saveas", "File", "Save session as...", "Ctrl+Shift+S",
     "Save the session under another name.", saveAs, "store keep write project"},
    {"file.savemesh", "File", "Save mesh...", "Ctrl+E", kSaveMeshHelp, saveMesh, kSaveMeshSynonyms},
    {"file.copycommand", "File", "Copy command", "",
     "Copy the command line that makes this mesh: spiraling-edge run with all options.",
     copyCommand, "clipboard shell terminal script export"},
    {"file.savepoints", "File", "Save new points...", "", "Save the new points as PLY.", savePoints,
     "export write store ply"},
    {"file.restart", "File", "Reload and restart", "Ctrl+R",
     "Read the input again and go to the start.",
     [](C& c) { pause(c), c.ui.requests.reload = true; }, "reset refresh again"},
    {"file.screenshot", "File", "Save screenshot", "F12", "Save a picture of the window.",
     [](C& c) { c.ui.requests.screenshot = true; },
     "export record capture image snapshot png print"},
    {"file.quit", "File", "Quit", "Ctrl+Q", "Quit the program.",
     [](C& c) { c.ui.requests.quit = true; }, "exit close leave"},

    {"edit.undo", "Edit", "Undo", "Ctrl+Z",
     "Undo a change of layers, camera, selection, bookmarks, breakpoints, notes or looks.",
     [](C& c) { c.ui.requests.undo = true; }, "revert back", kRepeats},
    {"edit.redo", "Edit", "Redo", "Ctrl+Y Ctrl+Shift+Z", "Redo the last undone change.",
     [](C& c) { c.ui.requests.redo = true; }, "repeat again", kRepeats},

    {"edit.rules.reset", "Edit", "Reset all rules", "",
     "Reset all rules to the values of their set.", resetRules, "default settings"},
    {"edit.whatif.clear", "Edit", "Remove all what-ifs", "", "Run without what-ifs; rules stay.",
     clearWhatIfs, "undo fork reset"},

    {"run.play", "Run", "Play or pause", "Space P", "Play by the chosen unit, or pause.",
     playOrPause, "animate start stop record movie"},
    {"run.step", "Run", "One step forward", "O", "Go forward by one playback unit.",
     [](C& c) { stepByUnit(c, 1); }, "", kRepeats},
    {"run.step.back", "Run", "One step back", "Shift+O", "Go back by one playback unit.",
     [](C& c) { stepByUnit(c, -1); }, "", kRepeats},
    {"run.slower", "Run", "Slower", "-", "Play more slowly.", [](C& c) { c.playback.slower(); }, "",
     kRepeats},
    {"run.faster", "Run", "Faster", "=", "Play faster.", [](C& c) { c.playback.faster(); }, "",
     kRepeats},
    {"run.unit", "Run", "Change playback unit", "U",
     "Play by sub-steps, by pivots or from event to event.",
     [](C& c) { c.playback.setUnit(following(c.playback.unit())); }, "speed mode"},
    {"run.loop.start", "Run", "Loop from here", "A", "Set the start of the playback loop.",
     [](C& c) { setLoop(c, "start", &PlayLoop::setFrom); }, "repeat mark"},
    {"run.loop.end", "Run", "Loop to here", "B", "Set the end of the playback loop.",
     [](C& c) { setLoop(c, "end", &PlayLoop::setTo); }, "repeat mark"},
    {"run.loop.clear", "Run", "Clear loop", "Shift+A", "Remove both ends of the playback loop.",
     [](C& c) { c.playback.loop = {}; }},
    {"run.continue", "Run", "Run to the next breakpoint", "F5",
     "Continue to the next breakpoint; without one, to the end.", [](C& c) { continueBy(c, 1); },
     "go stop debug"},
    {"run.continue.back", "Run", "Back to the previous breakpoint", "Shift+F5",
     "Go back to the previous breakpoint; without one, to the start.",
     [](C& c) { continueBy(c, -1); }},
    {"run.break", "Run", "Breakpoint here", "F9",
     "Set or remove a breakpoint on the selection, or on this kind of decision.",
     toggleBreakpointHere, "stop halt pause debug toggle"},
    {"run.compare", "Run", "Compare with the other rules", "",
     "Compare with the robust rules or, if those are on, with the paper's.", compareUsual,
     "difference side versus"},
    {"run.compare.mesh", "Run", "Compare with a mesh...", "",
     "Compare with a mesh that another program made from the same points.", compareMesh,
     "difference side reference"},
    {"run.compare.swap", "Run", "Swap the compared runs", "", "Show the other run in all panels.",
     [](C& c) { askOfComparison(c, CompareAsk::Swap); }},
    {"run.compare.stop", "Run", "End comparison", "", "Close the other run or mesh.",
     [](C& c) { askOfComparison(c, CompareAsk::Stop); }},
    {"run.end", "Run", "Run to the end", "End", "Run to the end in the background.",
     [](C& c) { pause(c), c.session.moves().toEnd(); }, "finish complete whole mesh result"},
    {"run.start", "Run", "Back to the start", "Home", "Go to the start of the run.",
     [](C& c) { pause(c), c.session.moves().toStart(); }, "begin rewind reset first"},

    {"step.pivot.next", "Step", "Next pivot", "F10 .", "Go to the end of the next pivot.",
     [](C& c) { pause(c), c.session.moves().stepPivot(1); }, "", kRepeats},
    {"step.pivot.previous", "Step", "Previous pivot", "Shift+F10 ,",
     "Go to the end of the previous pivot.",
     [](C& c) { pause(c), c.session.moves().stepPivot(-1); }, "", kRepeats},
    {"step.event.next", "Step", "Next sub-step", "F11 Right", "Go forward by one decision.",
     [](C& c) { pause(c), c.session.moves().stepEvent(1); }, "", kRepeats},
    {"step.event.previous", "Step", "Previous sub-step", "Left", "Go back by one decision.",
     [](C& c) { pause(c), c.session.moves().stepEvent(-1); }, "", kRepeats},
    {"step.pivot.finish", "Step", "Finish this pivot", "Shift+F11",
     "Go to the last decision of this pivot.",
     [](C& c) { pause(c), c.session.moves().finishPivot(); }, "", kRepeats},
    {"step.mark.next", "Step", "Next split, join, seed, alert or bookmark", "Ctrl+Right",
     "Go to the next change of the rings, alert or bookmark.", [](C& c) { toMark(c, 1); }, "",
     kRepeats},
    {"step.mark.previous", "Step", "Previous split, join, seed, alert or bookmark", "Ctrl+Left",
     "Go to the previous one.", [](C& c) { toMark(c, -1); }, "", kRepeats},
    {"step.alert.next", "Step", "Next alert", "F8", "Go to the next alert, and frame it.",
     [](C& c) { nextAlert(c, 1); }, "error failure hole defect problem", kRepeats},
    {"step.alert.previous", "Step", "Previous alert", "Shift+F8", "Go to the previous alert.",
     [](C& c) { nextAlert(c, -1); }, "error failure hole defect problem", kRepeats},
    {"step.back", "Step", "Back", "Alt+Left", "Go back to where the last jump began.",
     [](C& c) { pause(c), c.session.moves().goBack(); }, "", kRepeats},
    {"step.forward", "Step", "Forward", "Alt+Right", "Undo going back.",
     [](C& c) { pause(c), c.session.moves().goForward(); }, "", kRepeats},
    {"step.before", "Step", "Before this decision (hold)", "`",
     "Show the state before this decision, while the key is held.",
     [](C& c) { c.ui.look.toggle(LookBack::Mode::Before, c.ui.clock); }},
    {"step.blink", "Step", "Blink before and after (hold)", "Shift+`",
     "Alternate the states before and after this decision while the keys are held.",
     [](C& c) { c.ui.look.toggle(LookBack::Mode::Blink, c.ui.clock); }},
    {"step.difference", "Step", "First difference", "D",
     "Go to the first decision in which the compared runs differ.",
     [](C& c) { askOfComparison(c, CompareAsk::FirstDifference); }},
    {"step.region.next", "Step", "Next region of difference", "Shift+D",
     "Show the next region where the compared meshes differ, largest first.",
     [](C& c) { askOfComparison(c, CompareAsk::NextRegion); }, "", kRepeats},
    {"step.region.previous", "Step", "Previous region of difference", "Ctrl+Shift+D",
     "Show the previous region of difference.",
     [](C& c) { askOfComparison(c, CompareAsk::PreviousRegion); }, "", kRepeats},
    {"step.birth", "Step", "Where the selection was made", "",
     "Go to the pivot that made the selected edge or triangle.", goToBirth},
    {"step.goto", "Step", "Go to...", "Ctrl+G", "Type 137, 137.sphere.3, +10, 50% or p812.",
     [](C& c) { c.ui.goTo.open(); }, "jump address find"},

    {"step.copy", "Step", "Copy position", "Ctrl+C", "Copy address and camera as text.",
     [](C& c) { c.ui.requests.copyPlace = true; }, "clipboard share link"},
    {"step.paste", "Step", "Go to copied position", "Ctrl+V",
     "Go to the address or position on the clipboard.",
     [](C& c) { c.ui.requests.pastePlace = true; }, "clipboard jump"},

    {"view.frame", "View", "Frame pivot or selection", "F",
     "Show the selection, or the pivot and its neighbors.", frameFocus, "zoom focus center"},
    {"view.pivot", "View", "Frame pivot", "", "Show the pivot and its neighbors.", framePivot},
    {"view.all", "View", "Frame all", "Shift+F", "Show everything; the direction stays.",
     [](C& c) { c.camera.frame(glm::vec3(0.0F), 1.0F); }, "zoom fit whole center"},
    {"view.home", "View", "Camera home", "Enter", "Show everything from the first direction.", home,
     "reset zoom fit"},
    {"view.front", "View", "Front", "1", "Look from the front.",
     [](C& c) { c.camera.set(ViewPreset::Front); }},
    {"view.back", "View", "Back", "", "Look from the back.",
     [](C& c) { c.camera.set(ViewPreset::Back); }},
    {"view.right", "View", "Right", "3", "Look from the right.",
     [](C& c) { c.camera.set(ViewPreset::Right); }},
    {"view.left", "View", "Left", "", "Look from the left.",
     [](C& c) { c.camera.set(ViewPreset::Left); }},
    {"view.top", "View", "Top", "7", "Look down.", [](C& c) { c.camera.set(ViewPreset::Top); },
     "above plan"},
    {"view.bottom", "View", "Bottom", "", "Look up.",
     [](C& c) { c.camera.set(ViewPreset::Bottom); }, "below under"},
    {"view.opposite", "View", "Opposite side", "9", "Look from the opposite side.", oppositeView},
    {"view.orthographic", "View", "Orthographic", "5",
     "Switch between orthographic and perspective view.",
     [](C& c) { c.camera.toggleOrthographic(); }, "perspective projection parallel"},
    {"view.up.auto", "View", "Up: automatic", "",
     "Guess the up axis, for this and all other files.", followUpAxis,
     "axis upright vertical orientation automatic rotate"},
    {"view.up.x", "View", "Up: x", "", "Make x the up axis, for this and all other files.",
     [](C& c) { chooseUp(c, UpAxis::X); }, "axis upright vertical orientation rotate"},
    {"view.up.y", "View", "Up: y", "", "Make y the up axis, for this and all other files.",
     [](C& c) { chooseUp(c, UpAxis::Y); }, "axis upright vertical orientation rotate"},
    {"view.up.z", "View", "Up: z", "", "Make z the up axis, for this and all other files.",
     [](C& c) { chooseUp(c, UpAxis::Z); }, "axis upright vertical orientation rotate"},
    {"view.fullscreen", "View", "Full screen", "Alt+Enter", "Switch full screen on or off.",
     [](C& c) { c.ui.requests.fullScreen = true; }, "maximize monitor"},
    {"view.theme", "View", "Dark or light", "T", "Switch between the dark and the light theme.",
     toggleTheme, "color mode appearance black white"},
    {"view.larger", "View", "Larger text", "Ctrl+=", "Enlarge text and panels, up to 3.",
     [](C& c) { scaleBy(c, 1); }, "zoom font scale bigger", kRepeats},
    {"view.smaller", "View", "Smaller text", "Ctrl+-", "Shrink text and panels, down to 0.75.",
     [](C& c) { scaleBy(c, -1); }, "zoom font scale", kRepeats},
    {"view.monitorscale", "View", "Text size of the monitor", "",
     "Reset text and panels to the scale of the monitor.",
     [](C& c) { c.ui.settings.uiScale = 0.0; }},
    {"view.layout.next", "View", "Next layout", "F2", "Debug, Learn, Present.",
     [](C& c) { applyLayoutPreset(c, following(c.ui.layoutPreset)); }},
    {"view.layout.debug", "View", "Layout Debug", "", "All panels.",
     [](C& c) { applyLayoutPreset(c, LayoutPreset::Debug); }, "panels arrange default"},
    {"view.layout.learn", "View", "Layout Learn", "",
     "The rule beside a large view, the decision in large type.",
     [](C& c) { applyLayoutPreset(c, LayoutPreset::Learn); }, "panels arrange teach paper"},
    {"view.layout.present", "View", "Layout Present", "", "Only view, caption and run.",
     [](C& c) { applyLayoutPreset(c, LayoutPreset::Present); }, "slides projector talk teach"},
    {"view.layout.compare", "View", "Layout Compare", "Ctrl+D",
     "Two runs, or a run and a mesh, side by side on one timeline; again to return.", toggleCompare,
     "difference side split versus"},
    {"view.mesh.flat", "View", "Mesh: flat", "", "Finished triangles flat gray.",
     [](C& c) { c.ui.settings.meshStyle = MeshStyle::Flat; }, "solid surface gray"},
    {"view.mesh.shaded", "View", "Mesh: smooth", "",
     "Finished triangles shaded as one smooth surface.",
     [](C& c) { c.ui.settings.meshStyle = MeshStyle::Shaded; }, "solid surface lit"},
    {"view.mesh.wire", "View", "Mesh: edges only", "", "Show only the edges of finished triangles.",
     [](C& c) { c.ui.settings.meshStyle = MeshStyle::Wire; }, "wireframe lines transparent"},
    {"view.mesh.birth", "View", "Mesh: by creation order", "",
     "Color finished triangles from the first to the last one made.",
     [](C& c) { c.ui.settings.meshStyle = MeshStyle::CreationOrder; }, "time age birth color"},
    {"view.mesh.component", "View", "Mesh: by component", "",
     "Color finished triangles by component.",
     [](C& c) { c.ui.settings.meshStyle = MeshStyle::Component; }, "parts pieces color"},
    {"view.mesh.next", "View", "Mesh: next style", "M", "Change how finished triangles look.",
     nextMeshStyle},
    {"view.points.status", "View", "Points: by status", "", "Color points by their status.",
     [](C& c) { c.ui.settings.pointTint = PointTint::Status; }},
    {"view.points.margin", "View", "Points: by least margin", "",
     "Color points by how close their tests came to going the other way.",
     [](C& c) { c.ui.settings.pointTint = PointTint::Margin; }},
    {"view.legend", "View", "Legend", "", "Show or hide the legend.",
     [](C& c) { c.ui.settings.legend = !c.ui.settings.legend; }, "symbols key meaning"},
    {"view.doctor", "View", "Doctor", "", "Open the panel with the problems of the input.",
     [](C& c) { openTab(c, kDoctorTab); }, "check repair problems input holes"},
    {"view.breakpoints", "View", "Breakpoints", "", "Open the panel with the breakpoints.",
     [](C& c) { openTab(c, kBreakpointsTab); }, "stops debug"},
    {"view.watch", "View", "Watch", "", "Open the panel with the watched expressions.",
     [](C& c) { openTab(c, kWatchTab); }, "plot graph variables numbers"},
    {"view.alerts", "View", "Alerts", "",
     "Open the panel with all failures of the run and their moments.",
     [](C& c) { openTab(c, kAlertsTab); }, "errors failures holes defects problems bugs wrong"},
    {"view.rules", "View", "Rules", "", "Open the panel with all rules as switches.",
     [](C& c) { openTab(c, kRulesTab); }, "options parameters settings switches"},
    {"view.whatif", "View", "What if", "",
     "Open the panel for overriding decisions: the run forks.",
     [](C& c) { openTab(c, kWhatIfTab); }, "fork override experiment change"},
    {"view.panel.next", "View", "Next panel", "Tab Ctrl+Tab",
     "Move the keyboard focus to the next panel: arrows choose a row, Enter goes there, Esc "
     "returns.",
     [](C& c) { c.ui.requests.walk = 1; }, "", kRepeats},
    {"view.panel.previous", "View", "Previous panel", "Shift+Tab Ctrl+Shift+Tab",
     "Move the keyboard focus to the previous panel.", [](C& c) { c.ui.requests.walk = -1; }, "",
     kRepeats},
    {"view.drawer", "View", "Fold the drawer", "Ctrl+J",
     "Show only the strip RUN, or PIVOT and STAGE as well.",
     [](C& c) { c.ui.navigation.toggleDrawer(); }, "strips timeline hide"},

    {"layer.normals", "Layers", "Normals", "N", "Pin normals near the pivot on or off.",
     [](C& c) { toggle(c, LayerId::Normals); }, "arrows show hide"},
    {"layer.labels", "Layers", "Labels", "L", "Pin labels on or off.",
     [](C& c) { toggle(c, LayerId::Labels); }, "names numbers text show hide"},
    {"layer.edges", "Layers", "Mesh edges", "E", "Pin edges of finished triangles on or off.",
     [](C& c) { toggle(c, LayerId::MeshEdges); }, "wireframe lines show hide"},
    {"layer.spheres", "Layers", "Spheres", "S", "Pin the circumsphere of a test on or off.",
     [](C& c) { toggle(c, LayerId::Spheres); }, "circumsphere circle show hide"},
    {"layer.links", "Layers", "Neighbor links", "G",
     "Pin the neighbor lists of pivot and selection on or off.",
     [](C& c) { toggle(c, LayerId::Links); }, "lists lines show hide"},
    {"layer.stack", "Layers", "Stacked rings", "K", "Pin the rings on the stack on or off.",
     [](C& c) { toggle(c, LayerId::StackedRings); }, "show hide"},

    {"ask.why", "Ask", "Why? Why not?", "W",
     "Explain in the panel Ledger why the selection is in the mesh, or why not.", askWhySelected,
     "explain reason cause history ledger"},
    {"ask.cause", "Ask", "Go to the cause", "", "Go to the decisive line of the ledger.", toCause},
    {"ask.line.next", "Ask", "Next line of the ledger", "]",
     "Go to the next decision in the ledger.", [](C& c) { toLedgerLine(c, 1); }, "", kRepeats},
    {"ask.line.previous", "Ask", "Previous line of the ledger", "[",
     "Go to the previous decision in the ledger.", [](C& c) { toLedgerLine(c, -1); }, "", kRepeats},

    {"ask.query", "Ask", "Find decisions...", "Ctrl+F",
     "Open the panel Query: for example stage=sphere kept margin<1e-4.", openQuery,
     "search filter"},
    {"ask.hit.next", "Ask", "Next decision found", "F3",
     "Go to the next decision that the query line found.", [](C& c) { toHit(c, 1); }, "", kRepeats},
    {"ask.hit.previous", "Ask", "Previous decision found", "Shift+F3",
     "Go to the previous one that the query line found.", [](C& c) { toHit(c, -1); }, "", kRepeats},
    {"ask.closest", "Ask", "Closest decisions", "",
     "List the decisions that came closest to going the other way.", openClosest,
     "margin near critical"},
    {"ask.charts", "Ask", "Charts", "", "Show the whole run as charts; each bar is a list.",
     [](C& c) { openTab(c, kChartsTab); }, "statistics histogram bars"},

    {"notes.bookmark", "Notes", "Bookmark here", "Ctrl+B",
     "Set or remove a bookmark at this decision.", toggleBookmarkHere,
     "mark favorite pin remember"},
    {"notes.go.1", "Notes", "Go to bookmark 1", "Ctrl+1", "Go to the first bookmark.",
     [](C& c) { toBookmark(c, 0); }},
    {"notes.go.2", "Notes", "Go to bookmark 2", "Ctrl+2", "Go to the second bookmark.",
     [](C& c) { toBookmark(c, 1); }},
    {"notes.go.3", "Notes", "Go to bookmark 3", "Ctrl+3", "Go to the third bookmark.",
     [](C& c) { toBookmark(c, 2); }},
    {"notes.go.4", "Notes", "Go to bookmark 4", "Ctrl+4", "Go to the fourth bookmark.",
     [](C& c) { toBookmark(c, 3); }},
    {"notes.go.5", "Notes", "Go to bookmark 5", "Ctrl+5", "Go to the fifth bookmark.",
     [](C& c) { toBookmark(c, 4); }},
    {"notes.go.6", "Notes", "Go to bookmark 6", "Ctrl+6", "Go to the sixth bookmark.",
     [](C& c) { toBookmark(c, 5); }},
    {"notes.go.7", "Notes", "Go to bookmark 7", "Ctrl+7", "Go to the seventh bookmark.",
     [](C& c) { toBookmark(c, 6); }},
    {"notes.go.8", "Notes", "Go to bookmark 8", "Ctrl+8", "Go to the eighth bookmark.",
     [](C& c) { toBookmark(c, 7); }},
    {"notes.go.9", "Notes", "Go to bookmark 9", "Ctrl+9", "Go to the ninth bookmark.",
     [](C& c) { toBookmark(c, 8); }},
    {"notes.go.10", "Notes", "Go to bookmark 10", "Ctrl+0", "Go to the tenth bookmark.",
     [](C& c) { toBookmark(c, 9); }},

    {"help.palette", "Help", "Find an action...", "Ctrl+P Ctrl+K",
     "Type words of an action, a panel or a scene, then press Enter.",
     [](C& c) { c.ui.palette.show(); }},
    {"help.keys", "Help", "Keys and mouse", "F1 ?", "Show this list.",
     [](C& c) { c.ui.cheatSheet = !c.ui.cheatSheet; }, "shortcuts keyboard help"},
    {"help.editkeys", "Help", "Change keys...", "", "Choose other keys for actions.",
     [](C& c) { c.ui.keyEditor = !c.ui.keyEditor; }, "shortcuts keyboard bindings"},
    {"help.leave", "Help", "Close popup, clear selection", "Esc",
     "Close a popup, leave a panel, clear the selection, leave Present, in this order; never "
     "quits.",
     escape},
});

}  // namespace

std::span<const Command> commands() { return kCommands; }

const Command* findCommand(std::string_view id) {
    const auto found = std::find_if(kCommands.begin(), kCommands.end(),
                                    [&](const Command& each) { return each.id == id; });
    return found == kCommands.end() ? nullptr : &*found;
}

std::string listActions() {
    std::string text;
    for (const Command& command : kCommands) {
        std::string line(command.id);
        line.resize(std::max<std::size_t>(line.size() + 1, 22), ' ');
        line += KeyMap().all(command);
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
