#include "commands.h"

#include <algorithm>
#include <array>

#include "compare/compared_runs.h"
#include "compare/comparison.h"
#include "document/actions.h"
#include "document/alert_actions.h"
#include "document/ask_actions.h"
#include "document/document.h"
#include "document/edit_history.h"
#include "document/link_actions.h"
#include "document/new_points.h"
#include "document/piece_actions.h"
#include "document/ui_state.h"
#include "jobs/open_lesson.h"
#include "lesson/lesson_player.h"
#include "panel_state/column.h"
#include "panel_state/side_panels.h"
#include "run/model.h"
#include "run/strings.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::view {

namespace {

using namespace actions;
using C = CommandContext;

constexpr bool kRepeats = true;

void togglePage(C& c, HelpPage page) { c.ui.help = c.ui.help == page ? HelpPage::None : page; }

/// Goes to the bookmark at a position of their list, from 0.
template <std::size_t Place>
void goMark(C& c) {
    const Bookmarks& all = c.ui.bookmarks;
    if (Place < all.size()) return jumpingMoves(c).goTo(all[Place].address);
    c.session.messages().say("There is no bookmark " + std::to_string(Place + 1) + ".");
}

const std::string kSaveMeshHelp =
    "Save the final mesh as " + listText(meshFormats(), &MeshFormat::name, "or") + ".";
const std::string kSaveMeshSynonyms =
    "export write store triangles " + lowerCase(listText(meshFormats(), &MeshFormat::name, ""));

// Groups in the order of the menu bar.
const auto kCommands = std::to_array<Command>({
    {"file.open", "File", "Open...", "Ctrl+O", "Open a point file or a session.",
     [](C& c) { openBrowser(c, BrowserTask::Open); }, "load import read points scan"},
    {"file.new.shape", "File", "New from shape...", "Ctrl+N Alt+N",
     "Spread new points over a shape, step by step.",
     [](C& c) { c.sampling.openPage(GrowthSource::Shape); }, "sample create generate particles"},
    {"file.new.volume", "File", "New from volume...", "Ctrl+Shift+N Alt+Shift+N",
     "Spread new points over an isosurface of a volume, step by step.",
     [](C& c) { c.sampling.openPage(GrowthSource::Volume); },
     "sample create generate particles isosurface nrrd"},
    {"file.prepare", "File", "Prepare...", "Ctrl+Shift+R Alt+Shift+R",
     "Choose what is derived from the points, and how.", openPrepare,
     "neighbors orient walls import options"},
    {"file.save", "File", "Save session", "Ctrl+S",
     "Save input, options, position, camera, layers and notes as a session file.",
     [](C& c) { c.document.save(); }, "store keep write project"},
    {"file.saveas", "File", "Save session as...", "Ctrl+Shift+S",
     "Save the session under another name.",
     [](C& c) { openBrowser(c, BrowserTask::SaveSession); }, "store keep write project"},
    {"file.savemesh", "File", "Save mesh...", "Ctrl+E", kSaveMeshHelp, saveMesh, kSaveMeshSynonyms},
    {"file.copycommand", "File", "Copy command", "",
     "Copy the command line that makes this mesh: spiraling-edge run with all options.",
     copyCommand, "clipboard shell terminal script export"},
    {"file.savelesson", "File", "Save as lesson...", "",
     "Save the bookmarks, with their notes and cameras, as the steps of a lesson.",
     [](C& c) { openBrowser(c, BrowserTask::SaveLesson); }, "write teach export course"},
    {"file.saveresult", "File", "Save result...", "",
     "Save the answers to the questions of the open lesson.",
     [](C& c) { openBrowser(c, BrowserTask::SaveResult); }, "lesson answers grade student class"},
    {"file.export", "File", "Export...", "Ctrl+Shift+E",
     "Write frames as a picture, a page or an animation.",
     [](C& c) { pause(c), c.ui.exported.open(), openBrowser(c, BrowserTask::Export); },
     "picture svg gif mp4 video html page png frames write"},
    {"file.savepoints", "File", "Save new points...", "", "Save the new points as PLY.", savePoints,
     "export write store ply"},
    {"file.restart", "File", "Reload and restart", "Ctrl+R Alt+R",
     "Read the input again and go to the start.", [](C& c) { pause(c), c.document.reload(); },
     "reset refresh again"},
    {"file.screenshot", "File", "Save screenshot", "F12 Alt+P", "Save a picture of the window.",
     [](C& c) { c.ui.takesPicture = true; }, "export record capture image snapshot png print"},
    {"file.quit", "File", "Quit", "Ctrl+Q", "Quit the program.", [](C& c) { c.document.quit(); },
     "exit close leave"},

    {"edit.undo", "Edit", "Undo", "Ctrl+Z",
     "Undo a change of points, layers, camera, selection, annotations or looks.",
     [](C& c) { c.history.undo(); }, "revert back", kRepeats},
    {"edit.redo", "Edit", "Redo", "Ctrl+Y Ctrl+Shift+Z", "Redo the last undone change.",
     [](C& c) { c.history.redo(); }, "repeat again", kRepeats},

    {"edit.piece", "Edit", "Keep or leave out points...", "X",
     "Draw a box or a lasso around points: run with these alone, or without them.", togglePieceTool,
     "crop cut select lasso box region piece part scan remove delete outliers"},

    {"edit.rules.reset", "Edit", "Reset all rules", "",
     "Reset all rules to the values of their set.", resetRules, "default settings"},
    {"edit.whatif.clear", "Edit", "Remove all what-ifs", "", "Run without what-ifs; rules stay.",
     [](C& c) { c.document.rerun(trueRunOf(c.session.input().rules())); }, "undo fork reset"},

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
     "Compare with the robust rules or, if those are on, with the paper's.",
     [](C& c) { enterCompare(c), c.compare.beginUsual(); },
     "difference side versus"},
    {"run.compare.mesh", "Run", "Compare with a mesh or trace...", "",
     "Compare with a mesh, or a trace, that another program made from the same points.",
     [](C& c) { enterCompare(c), openBrowser(c, BrowserTask::Mesh); }, "difference side reference"},
    {"run.compare.swap", "Run", "Swap the compared runs", "", "Show the other run in all panels.",
     [](C& c) { pause(c), c.compare.swap(); }},
    {"run.compare.stop", "Run", "End comparison", "", "Close the other run, mesh or trace.",
     [](C& c) { pause(c), c.compare.stop(); }},
    {"run.end", "Run", "Run to the end", "End", "Run to the end in the background.",
     [](C& c) { pause(c), c.session.moves().toEnd(); }, "finish complete whole mesh result"},
    {"run.start", "Run", "Back to the start", "Home",
     "Go to the start of the run; in Present also F5, if no lesson is open.",
     [](C& c) { pause(c), c.session.moves().toStart(); }, "begin rewind reset first", !kRepeats,
     "F5"},

    {"step.pivot.next", "Step", "Next pivot", "F10 .", "Go to the end of the next pivot.",
     [](C& c) { step(c), c.session.moves().stepPivot(1); }, "", kRepeats},
    {"step.pivot.previous", "Step", "Previous pivot", "Shift+F10 ,",
     "Go to the end of the previous pivot.", [](C& c) { step(c), c.session.moves().stepPivot(-1); },
     "", kRepeats},
    {"step.event.next", "Step", "Next sub-step", "F11 Right",
     "Go forward by one decision; in Present also PgDn.",
     [](C& c) { step(c), c.session.moves().stepEvent(1); }, "", kRepeats, "PageDown"},
    {"step.event.previous", "Step", "Previous sub-step", "Left",
     "Go back by one decision; in Present also PgUp.",
     [](C& c) { step(c), c.session.moves().stepEvent(-1); }, "", kRepeats, "PageUp"},
    {"step.pivot.finish", "Step", "Finish this pivot", "Shift+F11",
     "Go to the last decision of this pivot.",
     [](C& c) { step(c), c.session.moves().finishPivot(); }, "", kRepeats},
    {"step.mark.next", "Step", "Next split, join, seed, alert or bookmark", "Ctrl+Right",
     "Go to the next change of the rings, alert or bookmark.", [](C& c) { toMark(c, 1); }, "",
     kRepeats},
    {"step.mark.previous", "Step", "Previous split, join, seed, alert or bookmark", "Ctrl+Left",
     "Go to the previous one.", [](C& c) { toMark(c, -1); }, "", kRepeats},
    {"step.alert.next", "Step", "Next place with faults", "F8",
     "Show the next place with faults on the finished mesh, the most severe first.",
     [](C& c) { nextPlace(c, 1); }, "error failure hole defect problem alert worst", kRepeats},
    {"step.alert.previous", "Step", "Previous place with faults", "Shift+F8",
     "Show the previous place with faults.", [](C& c) { nextPlace(c, -1); },
     "error failure hole defect problem alert", kRepeats},
    {"lesson.next", "Step", "Next step of the lesson", "PageDown",
     "Show the next step of the open lesson; in Present the answer to an open question first.",
     [](C& c) { c.lesson.next(); }, "teach course slide forward", kRepeats},
    {"lesson.previous", "Step", "Previous step of the lesson", "PageUp",
     "Show the step of the lesson before.", [](C& c) { c.lesson.previous(); },
     "teach course slide back", kRepeats},
    {"lesson.return", "Step", "Back to the step of the lesson", "",
     "Return to position, rules and view of the step; in Present also F5.",
     [](C& c) { c.lesson.returnToStep(); }, "teach course"},
    {"lesson.close", "Step", "Close the lesson", "", "Close the lesson; the run stays open.",
     [](C& c) { c.lesson.close(); }, "teach course end leave"},
    {"step.back", "Step", "Back", "Alt+Left", "Go back to where the last jump began.",
     [](C& c) { jumpingMoves(c).goBack(); }, "", kRepeats},
    {"step.forward", "Step", "Forward", "Alt+Right", "Undo going back.",
     [](C& c) { jumpingMoves(c).goForward(); }, "", kRepeats},
    {"step.before", "Step", "Before this decision (hold)", "`",
     "Show the state before this decision, while the key is held.",
     [](C& c) { c.ui.look.toggle(LookBack::Mode::Before, c.ui.clock); }},
    {"step.blink", "Step", "Blink before and after (hold)", "Shift+`",
     "Alternate the states before and after this decision while the keys are held.",
     [](C& c) { c.ui.look.toggle(LookBack::Mode::Blink, c.ui.clock); }},
    {"step.difference", "Step", "First difference", "D",
     "Go to the first decision in which the compared runs differ.",
     [](C& c) { pause(c), c.compare.toFirstDifference(); }},
    {"step.region.next", "Step", "Next region of difference", "Shift+D",
     "Show the next region where the compared meshes differ, largest first.",
     [](C& c) { pause(c), c.compare.toNextRegion(); }, "", kRepeats},
    {"step.region.previous", "Step", "Previous region of difference", "Ctrl+Shift+D",
     "Show the previous region of difference.",
     [](C& c) { pause(c), c.compare.toPreviousRegion(); }, "", kRepeats},
    {"step.birth", "Step", "Where the selection was made", "",
     "Go to the pivot that made the selected edge or triangle.", goToCreation},
    {"step.goto", "Step", "Go to...", "Ctrl+G", "Type 137, 137.sphere.3, +10, 50% or p812.",
     openGoTo, "jump address find"},

    {"step.copy", "Step", "Copy link", "Ctrl+C",
     "Copy a link to what is shown: input, options, address and camera.", copyLink,
     "clipboard share position url"},
    {"step.copyframe", "Step", "Copy link as a frame", "",
     "Copy HTML for a page of your own, which shows this place in a frame.", copyFrame,
     "clipboard share iframe embed html page moodle"},
    {"step.copyfailure", "Step", "Copy link to this failure", "",
     "Copy a link with the fewest points that still end in the alert that is shown.",
     copyFailureLink, "clipboard share reduce minimal case bug report"},
    {"step.paste", "Step", "Go to copied link", "Ctrl+V",
     "Follow the link, or go to the address, on the clipboard.",
     [](C& c) { follow(c, c.ui.clipboard.text()); },
     "clipboard jump position"},

    {"view.frame", "View", "Frame pivot or selection", "F",
     "Show the selection, or the decision from the side that shows it best.", frameSmoothly,
     "zoom focus center"},
    {"view.follow", "View", "Follow the decision", "Shift+V",
     "Move the camera to the view of each decision; on in lessons and Present.", toggleFollow,
     "camera automatic move track"},
    {"view.swing", "View", "Swing the view", "V", "Swing by 20 degrees and back, to show depth.",
     [](C& c) { c.ui.cameraMove.swing(c.camera); }, "parallax rotate depth camera rock"},
    {"view.all", "View", "Frame all", "Shift+F", "Show everything; the direction stays.", frameAll,
     "zoom fit whole center"},
    {"view.home", "View", "Camera home", "Enter", "Show everything, its broad side to the eye.",
     home, "reset zoom fit"},
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
     [](C& c) { c.ui.fullScreen = !c.ui.fullScreen; }, "maximize monitor"},
    {"view.theme", "View", "Dark or light", "T", "Switch between the dark and the light theme.",
     toggleTheme, "color mode appearance black white"},
    {"view.larger", "View", "Larger text", "Ctrl+= Ctrl+Plus", "Enlarge text and panels, up to 3.",
     [](C& c) { scaleBy(c, 1); }, "zoom font scale bigger", kRepeats},
    {"view.smaller", "View", "Smaller text", "Ctrl+-", "Shrink text and panels, down to 0.75.",
     [](C& c) { scaleBy(c, -1); }, "zoom font scale", kRepeats},
    {"view.layout.next", "View", "Next layout", "F2", "Debug, Present.",
     [](C& c) { applyLayoutPreset(c, following(c.ui.layoutPreset)); }},
    {"view.layout.debug", "View", "Layout Debug", "", "View, column and strip.",
     [](C& c) { applyLayoutPreset(c, LayoutPreset::Debug); }, "panels arrange default"},
    {"view.layout.present", "View", "Layout Present", "", "Only view, caption and run.",
     [](C& c) { applyLayoutPreset(c, LayoutPreset::Present); }, "slides projector talk teach",
     !kRepeats, "Shift+F5"},
    {"view.black", "View", "Black screen", "",
     "In Present, where the keys are B and the period: all black, until a key is pressed.",
     [](C& c) { blankScreen(c, BlankScreen::Black); }, "slides projector hide", !kRepeats, "B ."},
    {"view.white", "View", "White screen", "",
     "In Present, where the key is W: all white, until a key is pressed.",
     [](C& c) { blankScreen(c, BlankScreen::White); }, "slides projector hide", !kRepeats, "W"},
    {"view.spotlight", "View", "Spotlight", "",
     "In Present, where the key is L: dim all but the neighborhood of the pivot, or stop.",
     [](C& c) { c.ui.spotlight = !c.ui.spotlight; }, "slides projector highlight focus teach",
     !kRepeats, "L"},
    {"view.layout.compare", "View", "Layout Compare", "Ctrl+D",
     "Two runs, or a run and a mesh, side by side on one timeline; again to return.",
     [](C& c) {
         const bool on = c.ui.layoutPreset == LayoutPreset::Compare;
         applyLayoutPreset(c, on ? LayoutPreset::Debug : LayoutPreset::Compare);
     },
     "difference side split versus"},
    {"view.mesh.faults", "View", "Mesh: faults", "",
     "Finished triangles flat gray; at the end of the run, faults are colored.",
     [](C& c) { c.ui.settings.meshStyle = MeshStyle::Faults; }, "errors holes defects problems"},
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
    {"view.names", "View", "Letters of figures", "",
     "In a figure of the paper: its letters, or the numbers of points.",
     [](C& c) { c.ui.settings.names = !c.ui.settings.names; }, "names numbers points"},
    {"view.legend", "View", "Legend", "", "Show or hide the legend.",
     [](C& c) {
         bool& legend = c.ui.phone ? c.ui.navigation.phoneLegend : c.ui.settings.legend;
         legend = !legend;
     },
     "symbols key meaning"},
    {"view.doctor", "View", "Doctor", "", "Open the panel with the problems of the input.",
     [](C& c) { openPart(c, kDoctorPart); }, "check repair problems input holes"},
    {"view.breakpoints", "View", "Breakpoints", "", "Open the panel with the breakpoints.",
     [](C& c) { openPart(c, kBreakpointsPart); }, "stops debug"},
    {"view.watch", "View", "Watch", "", "Open the panel with the watched expressions.",
     [](C& c) { openPart(c, kWatchPart); }, "plot graph variables numbers"},
    {"view.alerts", "View", "Alerts", "",
     "Open the panel with all failures of the run and their moments.",
     [](C& c) { openPart(c, kAlertsPart); }, "errors failures holes defects problems bugs wrong"},
    {"view.rules", "View", "Rules", "", "Open the panel with all rules as switches.",
     [](C& c) { openPart(c, kRulesPart); }, "options parameters settings switches"},
    {"view.whatif", "View", "What if", "",
     "Open the panel for overriding decisions: the run forks.",
     [](C& c) { openPart(c, kWhatIfPart); }, "fork override experiment change"},
    {"view.section", "View", "Section", "",
     "Open the panel with the profile along the normal of the pivot.",
     [](C& c) { openPart(c, kSectionPart); }, "cut slice profile layers sheets"},
    {"view.section.turn", "View", "Turn the section", "R",
     "Turn the plane of the section about the normal by 15 degrees.",
     [](C& c) { turnSection(c, 1); }, "rotate plane cut", kRepeats},
    {"view.panel.next", "View", "Next panel", "Tab Ctrl+Tab",
     "Focus the next panel: arrows choose a row, Enter goes there, Esc returns.",
     [](C& c) { walkPanels(c, 1); }, "", kRepeats},
    {"view.panel.previous", "View", "Previous panel", "Shift+Tab Ctrl+Shift+Tab",
     "Move the keyboard focus to the previous panel.", [](C& c) { walkPanels(c, -1); }, "",
     kRepeats},
    {"view.column", "View", "Fold the panels", "Ctrl+Shift+J Alt+J",
     "Show only the rail of the tasks, or their panels as well.", foldColumn,
     "column side hide wide"},
    {"view.strips", "View", "Fold the strips", "Ctrl+J",
     "Show only the first row below the view, or the lanes and the decisions of the stage as well.",
     [](C& c) { c.ui.navigation.toggleStrips(); }, "drawer timeline lanes hide"},

    {"view.layers", "View", "Layers", "", "Show what the view draws, and when.",
     [](C& c) { c.ui.navigation.opensLayers = true; }, "pins switches visible"},
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
     "Say in the panel Why what put the selection into the mesh, or kept it out.", askWhySelected,
     "explain reason cause history ledger"},
    {"ask.cause", "Ask", "Go to the cause", "", "Go to the decisive line of the answer.", toCause},
    {"ask.line.next", "Ask", "Next line of the answer", "]",
     "Go to the next decision in the answer.", [](C& c) { toLedgerLine(c, 1); }, "", kRepeats},
    {"ask.line.previous", "Ask", "Previous line of the answer", "[",
     "Go to the previous decision in the answer.", [](C& c) { toLedgerLine(c, -1); }, "", kRepeats},

    {"ask.query", "Ask", "Find decisions...", "Ctrl+F",
     "Open the panel Query: for example stage=sphere kept margin<1e-4.", openQuery,
     "search filter"},
    {"ask.hit.next", "Ask", "Next decision found", "F3",
     "Go to the next decision that the query line found.", [](C& c) { toHit(c, 1); }, "", kRepeats},
    {"ask.hit.previous", "Ask", "Previous decision found", "Shift+F3",
     "Go to the previous one that the query line found.", [](C& c) { toHit(c, -1); }, "", kRepeats},
    {"ask.closest", "Ask", "Closest decisions", "",
     "List the decisions that came closest to going the other way.",
     [](C& c) { openPart(c, kQueryPart), c.ui.query.shown = QueryList::Closest; },
     "margin near critical"},
    {"ask.charts", "Ask", "Charts", "", "Show the whole run as charts; each bar is a list.",
     [](C& c) { openPart(c, kChartsPart); }, "statistics histogram bars counts counters numbers"},

    {"notes.bookmark", "Notes", "Bookmark here", "Ctrl+B",
     "Set or remove a bookmark at this decision.", toggleBookmarkHere,
     "mark favorite pin remember"},
    {"notes.show", "Notes", "Notes", "", "Show the bookmarks and your own text.",
     [](C& c) { c.ui.navigation.opensNotes = true; }, "annotations comments bookmarks"},
    {"notes.go.1", "Notes", "Go to bookmark 1", "Ctrl+1", "Go to the first bookmark.", goMark<0>},
    {"notes.go.2", "Notes", "Go to bookmark 2", "Ctrl+2", "Go to the second bookmark.", goMark<1>},
    {"notes.go.3", "Notes", "Go to bookmark 3", "Ctrl+3", "Go to the third bookmark.", goMark<2>},
    {"notes.go.4", "Notes", "Go to bookmark 4", "Ctrl+4", "Go to the fourth bookmark.", goMark<3>},
    {"notes.go.5", "Notes", "Go to bookmark 5", "Ctrl+5", "Go to the fifth bookmark.", goMark<4>},
    {"notes.go.6", "Notes", "Go to bookmark 6", "Ctrl+6", "Go to the sixth bookmark.", goMark<5>},
    {"notes.go.7", "Notes", "Go to bookmark 7", "Ctrl+7", "Go to the seventh bookmark.", goMark<6>},
    {"notes.go.8", "Notes", "Go to bookmark 8", "Ctrl+8", "Go to the eighth bookmark.", goMark<7>},
    {"notes.go.9", "Notes", "Go to bookmark 9", "Ctrl+9", "Go to the ninth bookmark.", goMark<8>},
    {"notes.go.10", "Notes", "Go to bookmark 10", "Ctrl+0", "Go to the tenth bookmark.", goMark<9>},

    {"help.guide", "Help", "Guide", "", "What the window shows, and how to move through a run.",
     [](C& c) { c.ui.help = HelpPage::Guide; }, "manual documentation introduction"},
    {"help.tour", "Help", "Tour", "", "The six stages on a torus, in ninety seconds.", openTour,
     "introduction lesson start tutorial teach"},
    {"help.practice", "Help", "Practice a pivot", "",
     "Play a pivot of a small run yourself, move by move: another one each time.", openPractice,
     "lesson exercise task teach play quiz"},
    {"help.palette", "Help", "Find an action...", "Ctrl+P Ctrl+K",
     "Type words of an action, a panel or a scene, then press Enter.",
     openPalette},
    {"help.keys", "Help", "Keys and mouse", "F1 ?", "Show this list.",
     [](C& c) { togglePage(c, HelpPage::Keys); }, "shortcuts keyboard help"},
    {"help.editkeys", "Help", "Change keys...", "", "Choose other keys for actions.",
     [](C& c) { togglePage(c, HelpPage::ChangeKeys); }, "shortcuts keyboard bindings"},
    {"help.about", "Help", "About", "", "Version, paper and license.",
     [](C& c) { c.ui.help = HelpPage::About; }, "version license"},
    {"help.leave", "Help", "Close popup, clear selection", "Esc",
     "Close a popup, leave a panel, clear the selection, leave Present; never quits.", escape},
});

/// A condition of the commands whose ids begin with `id`.
struct Need {
    std::string_view id;
    bool (*holds)(const CommandContext& context);
    std::string_view reason;       ///< Why they cannot act without it.
    std::string_view except = {};  ///< The command that needs nothing; empty: none.
};

bool isOpen(const CommandContext& c) { return c.session.ready(); }
bool isBeforeEnd(const CommandContext& c) { return !c.session.atEnd(); }
bool isAfterStart(const CommandContext& c) { return !c.session.atStart(); }
bool hasWhatIfs(const CommandContext& c) { return !c.session.input().spec().whatIf.empty(); }
bool hasChangedRules(const CommandContext& c) { return !c.session.input().spec().choices.empty(); }
bool hasLesson(const CommandContext& c) { return c.ui.lesson.walk.isOpen(); }
bool hasAnswers(const CommandContext& c) { return c.ui.lesson.walk.hasAnswers(); }
bool hasBookmarks(const CommandContext& c) { return !c.ui.bookmarks.empty(); }
bool hasSelectedEdge(const CommandContext& c) {
    return c.session.selection().corners().size() >= 2;
}
bool presents(const CommandContext& c) { return c.ui.layoutPreset == LayoutPreset::Present; }
bool canUndo(const CommandContext& c) { return c.history.undoDepth() > 0; }
bool canRedo(const CommandContext& c) { return c.history.redoDepth() > 0; }
bool isChecked(const CommandContext& c) { return c.session.alerts().done(); }
bool hasPlaces(const CommandContext& c) { return !c.session.alerts().places().empty(); }
bool showsAlert(const CommandContext& c) { return c.session.alerts().shown() != nullptr; }
bool hasWindow(const CommandContext& c) { return c.ui.pageAddress.empty(); }
bool compares(const CommandContext& c) {
    return c.ui.compare.now != nullptr && c.ui.compare.now->chosen();
}

constexpr std::string_view kNothing = "Nothing is open.";
constexpr std::string_view kFinished = "The run is finished.";
constexpr std::string_view kNotCompared = "No comparison: press Ctrl+D, then choose the other run.";
constexpr std::string_view kBlanksInPresent = "The screen is blanked in the layout Present (F2).";

/// Needs of commands that are refused where these do not hold.
constexpr auto kCommandNeeds = std::to_array<Need>({
    {"edit.", isOpen, kNothing},
    {"run.", isOpen, kNothing},
    {"step.", isOpen, kNothing, "step.paste"},
    {"ask.", isOpen, kNothing},
    {"notes.", isOpen, kNothing},
    {"file.savemesh", isOpen, "There is no run to save the mesh of."},
    {"file.save", isOpen, kNothing},
    {"file.savelesson", hasBookmarks,
     "Set bookmarks first (Ctrl+B): each becomes a step of the lesson."},
    {"file.saveresult", hasLesson, kNoLesson},
    {"file.saveresult", hasAnswers, "No question of this lesson has been answered yet."},
    {"file.export", isOpen, "There is nothing open to export."},
    {"file.prepare", isOpen, kNothing},
    {"file.copycommand", isOpen, kNothing},
    {"file.restart", isOpen, kNothing},
    {"file.quit", hasWindow, "Close the page instead."},
    {"view.frame", isOpen, kNothing},
    {"view.follow", isOpen, kNothing},
    {"step.copyfailure", showsAlert, kNoAlertShown},
    {"edit.rules.reset", hasChangedRules, kNoChangedRules},
    {"edit.whatif.clear", hasWhatIfs, kNoWhatIfs},
    {"run.compare.stop", compares, "Nothing is compared."},
    {"run.compare.swap", compares, "Nothing is compared."},
    {"step.difference", compares, kNotCompared},
    {"step.region.", compares, kNotCompared},
    {"step.birth", hasSelectedEdge, "Select an edge or a triangle first."},
    {"lesson.", hasLesson, kNoLesson},
    {"view.black", presents, kBlanksInPresent},
    {"view.white", presents, kBlanksInPresent},
    {"view.spotlight", presents, "The spotlight belongs to the layout Present (F2)."},
});

/// Needs of commands that are gray where these do not hold, but are carried out anyway: their
/// messages may say more, and undoing ends a change that is still open.
constexpr auto kMoveNeeds = std::to_array<Need>({
    {"run.play", isBeforeEnd, kFinished},
    {"run.end", isBeforeEnd, kFinished},
    {"step.event.next", isBeforeEnd, kFinished},
    {"step.pivot.next", isBeforeEnd, kFinished},
    {"run.start", isAfterStart, "This is the start of the run."},
    {"step.alert.", isChecked, "The mesh is not checked yet."},
    {"step.alert.", hasPlaces, "There is no place with faults."},
    {"edit.undo", canUndo, "There is nothing to undo."},
    {"edit.redo", canRedo, "There is nothing to redo."},
});

/// The reason of the first need that does not hold; empty if all do.
std::string_view reasonAmong(std::span<const Need> needs, const Command& command,
                             const CommandContext& context) {
    const Need* missing = rowWhere(needs, [&](const Need& need) {
        return command.id.starts_with(need.id) && command.id != need.except && !need.holds(context);
    });
    return missing != nullptr ? missing->reason : std::string_view{};
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

const Command* findCommand(std::string_view id) {
    return rowWhere(kCommands, [&](const Command& each) { return each.id == id; });
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

std::string_view whyUnavailable(const Command& command, const CommandContext& context) {
    const std::string_view reason = reasonAmong(kCommandNeeds, command, context);
    return reason.empty() ? reasonAmong(kMoveNeeds, command, context) : reason;
}

// Commands of the growing points: the groups about the run, which does not exist yet, are replaced.

namespace {

struct Meaning {
    std::string_view id;
    void (NewPoints::*act)();
};

constexpr auto kMeanings = std::to_array<Meaning>({
    {"run.play", &NewPoints::playOrPause},
    {"run.step", &NewPoints::step},
    {"run.slower", &NewPoints::slower},
    {"run.faster", &NewPoints::faster},
    {"step.event.next", &NewPoints::step},
    {"step.pivot.next", &NewPoints::step},
    {"run.end", &NewPoints::finish},
    {"run.continue", &NewPoints::finish},
    {"run.continue.back", &NewPoints::start},
    {"run.start", &NewPoints::start},
    {"file.restart", &NewPoints::start},
    {"view.home", &NewPoints::home},
    {"view.all", &NewPoints::home},
    {"view.frame", &NewPoints::home},
});

/// Beginnings of the ids of commands about the run, which does not exist yet.
constexpr std::array<std::string_view, 15> kAside = {
    "run.",         "step.",       "lesson.",     "layer.",           "notes.",
    "edit.",        "view.mesh.",  "view.doctor", "view.breakpoints", "view.watch",
    "view.layout.", "view.strips", "view.column", "view.legend",      "file.prepare"};

/// Carries out the meaning of `command` on the page with new points. False: it has its usual
/// meaning.
bool runOnGrowthPage(const Command& command, CommandContext& context) {
    const auto is = [&](const Meaning& each) { return each.id == command.id; };
    if (const Meaning* meaning = rowWhere(kMeanings, is)) {
        (context.sampling.*meaning->act)();
        return true;
    }
    if (command.id == "file.save" || command.id == "file.saveas" ||
        command.id == "file.savepoints") {
        savePoints(context);
        return true;
    }
    if (command.id == "file.savemesh" || command.id == "file.copycommand" ||
        command.id == "file.export") {
        context.ui.growth.complaint = "There is no mesh yet: choose Use these points first.";
        return true;
    }
    return std::any_of(kAside.begin(), kAside.end(),
                       [&](std::string_view id) { return command.id.starts_with(id); });
}

PaletteEntry entryOf(const Scene& scene, std::string_view synonyms) {
    return {PaletteEntry::Kind::Scene, scene.title, "Scene", synonyms, scene.id, scene.watch};
}

/// Whether a word of the text begins with `start`. Words consist of letters and digits.
bool hasWordStart(std::string_view text, std::string_view start) {
    const auto isInner = [](char sign) {
        return (sign >= 'a' && sign <= 'z') || (sign >= '0' && sign <= '9');
    };
    for (std::size_t at = text.find(start); at != std::string_view::npos;
         at = text.find(start, at + 1)) {
        if (at == 0 || !isInner(text[at - 1])) return true;
    }
    return false;
}

bool hasAll(const std::string& text, std::span<const std::string> words) {
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return hasWordStart(text, word); });
}

/// Quality of a match, the best first.
enum class Fit : std::uint8_t { Named, Title, Synonyms, Elsewhere, None };

Fit fitOf(const PaletteEntry& entry, std::string_view filter, std::span<const std::string> words) {
    std::string text = lowerCase(entry.title);
    if (text == filter) return Fit::Named;
    if (hasAll(text, words)) return Fit::Title;
    text.append(" ").append(entry.synonyms);
    if (hasAll(text, words)) return Fit::Synonyms;
    text.append(" ").append(lowerCase(entry.note));
    text.append(" ").append(entry.id).append(" ").append(lowerCase(entry.help));
    return hasAll(text, words) ? Fit::Elsewhere : Fit::None;
}

}  // namespace

void runCommand(const Command& command, CommandContext& context) {
    if (context.ui.growth.open && runOnGrowthPage(command, context)) return;
    if (context.ui.lesson.hides() && !isAllowedDuringQuestion(command))
        return context.session.messages().say("Answer the question first, or show its answer.");
    if (const auto reason = reasonAmong(kCommandNeeds, command, context); !reason.empty())
        return context.session.messages().say(std::string(reason));
    command.run(context);
}

std::vector<PaletteEntry> paletteEntries() {
    std::vector<PaletteEntry> entries;
    for (const Command& each : commands())
        entries.push_back({PaletteEntry::Kind::Action, each.title, each.group, each.synonyms,
                           each.id, each.help});
    for (const PartRow& part : partRows()) {
        const auto is = [&](const Command& each) { return each.title == part.title; };
        if (rowWhere(kCommands, is) == nullptr)
            entries.push_back({PaletteEntry::Kind::Panel, part.title, "Panel", part.synonyms,
                               part.title, "Show this panel."});
    }
    for (const LessonEntry& each : lessonEntries())
        entries.push_back({PaletteEntry::Kind::Lesson, each.title, "Lesson", "teach course open",
                           each.source, each.text});
    for (const Scene& scene : scenes()) entries.push_back(entryOf(scene, "example open"));
    for (const Figure& each : figures()) {
        if (each.sample.empty()) continue;
        entries.push_back(entryOf(each.scene, "example open sample"));
        entries.back().id = each.sample;
    }
    for (const FailureScene& each : failureScenes())
        entries.push_back(entryOf(each.scene, "example open failure gallery wrong"));
    return entries;
}

std::vector<PaletteEntry> matchingEntries(std::span<const PaletteEntry> entries,
                                          std::string_view filter) {
    const std::string low = lowerCase(trimmed(filter));
    const std::vector<std::string> words = io::wordsIn(low);
    std::array<std::vector<PaletteEntry>, static_cast<std::size_t>(Fit::None) + 1> byFit;
    for (const PaletteEntry& each : entries)
        byFit[static_cast<std::size_t>(fitOf(each, low, words))].push_back(each);
    byFit.back().clear();
    std::vector<PaletteEntry> matches;
    for (const auto& list : byFit) matches.insert(matches.end(), list.begin(), list.end());
    return matches;
}

void choose(const PaletteEntry& entry, CommandContext& context) {
    switch (entry.kind) {
        case PaletteEntry::Kind::Action:
            return runCommand(*findCommand(entry.id), context);
        case PaletteEntry::Kind::Panel:
            return actions::openPart(context, entry.id);
        case PaletteEntry::Kind::Scene:
            return context.document.open(isSample(entry.id) ? std::string(entry.id)
                                                            : sceneSource(entry.id));
        case PaletteEntry::Kind::Lesson:
            return context.document.open(std::string(entry.id));
    }
}

}  // namespace se::view
