#include "commands.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "session.h"

namespace se::view {

namespace {

using C = CommandContext;

template <LayerId layer>
void toggle(C& c) {
    toggleLayer(c.ui.settings.layers, layer, c.session.stage());
}

template <ViewPreset preset>
void setView(C& c) {
    c.camera.set(preset);
}

void pause(C& c) { c.playback.pause(); }

void escape(C& c) {
    c.ui.cheatSheet = false;
    c.ui.keyEditor = false;
    c.ui.fileBrowser = false;
    c.ui.palette.open = false;
    c.ui.requests.closePopups = true;
    c.session.select(Selection{});
}

template <MeshStyle style>
void setMeshStyle(C& c) {
    c.ui.settings.meshStyle = style;
}

void nextMeshStyle(C& c) {
    MeshStyle& style = c.ui.settings.meshStyle;
    style = following(style);
    c.session.say("Finished triangles: " + std::string(rowOf(style).title) + ".");
}

void toggleTheme(C& c) {
    Theme& theme = c.ui.settings.theme;
    theme = theme == Theme::Dark ? Theme::Light : Theme::Dark;
}

void home(C& c) {
    if (!c.session.ready()) return;
    const Model& model = c.session.model();
    c.camera.home(model.beginning, model.sample, c.ui.viewAspect);
}

void restart(C& c) {
    pause(c);
    c.session.open(c.session.spec());
}

/// Turns to look from the other side.
void oppositeView(C& c) {
    CameraPose pose = c.camera.pose();
    pose.yawDegrees += 180.0F;
    pose.pitchDegrees = -pose.pitchDegrees;
    c.camera.setPose(pose);
}

constexpr std::array kScales = {0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0};

/// The next size of text and panels on the scale.
template <int direction>
void changeScale(C& c) {
    double chosen = c.ui.scale;
    for (const double scale : kScales) {
        if (direction > 0 && scale > c.ui.scale + 0.01F) {
            chosen = scale;
            break;
        }
        if (direction < 0 && scale < c.ui.scale - 0.01F) chosen = scale;
    }
    c.ui.settings.uiScale = chosen;
}

void toggleBookmarkHere(C& c) {
    if (!c.session.ready()) return;
    if (c.session.event() == nullptr)
        return c.session.say("The start of the run needs no bookmark.");
    const Address here = c.session.address();
    const bool there = toggleBookmark(c.ui.bookmarks, here);
    c.session.say((there ? "Bookmark at " : "No bookmark any more at ") + toString(here) + ".");
}

template <std::size_t place>
void goToBookmark(C& c) {
    if (!c.session.ready()) return;
    if (place >= c.ui.bookmarks.size()) {
        return c.session.say("There is no bookmark " + std::to_string(place + 1) + ".");
    }
    pause(c);
    c.session.goTo(c.ui.bookmarks[place].address);
}

void openBrowser(C& c) {
    c.ui.browser = BrowserTask::Open;
    c.ui.fileBrowser = true;
}

void saveAs(C& c) {
    if (!c.session.ready()) return c.session.say("There is nothing open to save.");
    c.ui.browser = BrowserTask::SaveSession;
    c.ui.fileBrowser = true;
}

void toEnd(C& c) {
    pause(c);
    c.session.toEnd();
}

void toStart(C& c) {
    pause(c);
    c.session.toStart();
}

void toMark(C& c, int direction) {
    pause(c);
    if (!c.session.ready()) return;
    const std::optional<Address> mark = c.session.nextMark(direction);
    const Bookmark* own = nextBookmark(c.ui.bookmarks, c.session.address(), direction);
    // A mark of the run has no number within its stage: it stands at the first.
    const bool ownIsNearer =
        own != nullptr &&
        (!mark || (direction > 0 ? isBefore(own->address, *mark) : isBefore(*mark, own->address)));
    if (ownIsNearer) return c.session.goTo(own->address);
    if (mark) return c.session.goTo(*mark);
    c.session.say(direction > 0
                      ? "There is no split, join, seed, alert or bookmark after this one."
                      : "There is no split, join, seed, alert or bookmark before this one.");
}

void toggleUnit(C& c) { c.playback.setUnit(following(c.playback.unit())); }

void playOrPause(C& c) {
    // A long way to the next event must not go on after the pause.
    if (c.playback.playing() && c.playback.unit() == PlayUnit::Event) c.session.cancelMove();
    c.playback.toggle();
}

void stepByUnit(C& c, int direction) {
    pause(c);
    playSteps(c, direction);
}

void setLoopStart(C& c) {
    if (!c.session.ready()) return;
    c.playback.loop.setFrom(c.session.address());
    c.session.say("Playing begins again at " + toString(c.session.address()) + ".");
}

void setLoopEnd(C& c) {
    if (!c.session.ready()) return;
    c.playback.loop.setTo(c.session.address());
    c.session.say("Playing turns back at " + toString(c.session.address()) + ".");
}

void arrange(C& c, Arrangement arrangement) {
    c.ui.arrangement = arrangement;
    const ArrangementRow& row = rowOf(arrangement);
    c.session.say("Layout " + std::string(row.title) + ". " + std::string(row.help));
}

template <Arrangement arrangement>
void setArrangement(C& c) {
    arrange(c, arrangement);
}

void goToBirth(C& c) {
    if (!c.session.ready()) return;
    const std::optional<std::uint32_t> number = factsOf(c.session, c.session.selection()).number;
    const auto pivot = number ? pivotOfTriangle(c.session.overview(), *number) : std::nullopt;
    pause(c);
    if (pivot) {
        c.session.goToPivot(*pivot);
    } else {
        c.session.say("Select an edge or a triangle first: the pivot that made it is not known.");
    }
}

// Groups in the order of the menu bar.
constexpr auto kCommands = std::to_array<Command>({
    {"file.open", "File", "Open...", "Ctrl+O", "Open a point file or a session.", false,
     openBrowser},
    {"file.save", "File", "Save session", "Ctrl+S",
     "Save input, options, place, camera, layers, bookmarks and notes as a session file.", false,
     [](C& c) { c.ui.requests.saveSession = true; }},
    {"file.saveas", "File", "Save session as...", "Ctrl+Shift+S",
     "Save the session under another name.", false, saveAs},
    {"file.restart", "File", "Reload and restart", "Ctrl+R",
     "Read the input again and go to the start.", false, restart},
    {"file.screenshot", "File", "Save screenshot", "F12", "Save a picture of the window.", false,
     [](C& c) { c.ui.requests.screenshot = true; }},
    {"file.quit", "File", "Quit", "Ctrl+Q", "Leave.", false,
     [](C& c) { c.ui.requests.quit = true; }},

    {"edit.undo", "Edit", "Undo", "Ctrl+Z",
     "Take back a change of layers, camera, selection, bookmarks, notes, layout or looks.", true,
     [](C& c) { c.ui.requests.undo = true; }},
    {"edit.redo", "Edit", "Redo", "Ctrl+Y Ctrl+Shift+Z", "Make it again.", true,
     [](C& c) { c.ui.requests.redo = true; }},

    {"run.play", "Run", "Play or pause", "Space P", "Play by the chosen unit, or pause.", false,
     playOrPause},
    {"run.step", "Run", "One step on", "O", "Go on by one of the unit of playing.", true,
     [](C& c) { stepByUnit(c, 1); }},
    {"run.step.back", "Run", "One step back", "Shift+O", "Go back by one of the unit of playing.",
     true, [](C& c) { stepByUnit(c, -1); }},
    {"run.slower", "Run", "Slower", "-", "Play more slowly.", true,
     [](C& c) { c.playback.slower(); }},
    {"run.faster", "Run", "Faster", "=", "Play faster.", true, [](C& c) { c.playback.faster(); }},
    {"run.unit", "Run", "Change the unit of playing", "U",
     "Play by sub-steps, by pivots or from event to event.", false, toggleUnit},
    {"run.loop.start", "Run", "Loop from here", "A", "Playing begins again here.", false,
     setLoopStart},
    {"run.loop.end", "Run", "Loop to here", "B", "Playing turns back here.", false, setLoopEnd},
    {"run.loop.clear", "Run", "No loop", "Shift+A", "Take the marks of the loop away.", false,
     [](C& c) { c.playback.loop = {}; }},
    {"run.end", "Run", "Run to the end", "F5 End", "Run to the end; the window stays awake.", false,
     toEnd},
    {"run.start", "Run", "Back to the start", "Shift+F5 Home", "Go to where nothing has been done.",
     false, toStart},

    {"step.pivot.next", "Step", "Next pivot", "F10 .", "Go to the end of the next pivot.", true,
     [](C& c) { pause(c), c.session.stepPivot(1); }},
    {"step.pivot.previous", "Step", "Previous pivot", "Shift+F10 ,",
     "Go to the end of the previous pivot.", true, [](C& c) { pause(c), c.session.stepPivot(-1); }},
    {"step.event.next", "Step", "Next sub-step", "F11 Right", "Go on by one decision.", true,
     [](C& c) { pause(c), c.session.stepEvent(1); }},
    {"step.event.previous", "Step", "Previous sub-step", "Left", "Go back by one decision.", true,
     [](C& c) { pause(c), c.session.stepEvent(-1); }},
    {"step.pivot.finish", "Step", "Finish this pivot", "Shift+F11",
     "Go to the last decision of this pivot.", true,
     [](C& c) { pause(c), c.session.finishPivot(); }},
    {"step.mark.next", "Step", "Next split, join, seed, alert or bookmark", "Ctrl+Right",
     "Go to the next thing that changes the rings, to an alert or a bookmark.", true,
     [](C& c) { toMark(c, 1); }},
    {"step.mark.previous", "Step", "Previous split, join, seed, alert or bookmark", "Ctrl+Left",
     "Go to the one before.", true, [](C& c) { toMark(c, -1); }},
    {"step.back", "Step", "Back", "Alt+Left", "Go back to where the last jump began.", true,
     [](C& c) { pause(c), c.session.goBack(); }},
    {"step.forward", "Step", "Forward", "Alt+Right", "Undo going back.", true,
     [](C& c) { pause(c), c.session.goForward(); }},
    {"step.before", "Step", "Before this decision (hold)", "`",
     "Show the state before this decision, as long as the key is held.", false,
     [](C& c) { c.session.showBefore(!c.session.showsBefore()); }},
    {"step.birth", "Step", "Where the selection was made", "",
     "Go to the pivot that made the selected edge or triangle.", false, goToBirth},
    {"step.goto", "Step", "Go to...", "Ctrl+G", "Type 137, 137.sphere.3, +10, 50% or p812.", false,
     [](C& c) { c.ui.goTo.open(); }},

    {"step.copy", "Step", "Copy this place", "Ctrl+C", "Copy address and camera as text.", false,
     [](C& c) { c.ui.requests.copyPlace = true; }},
    {"step.paste", "Step", "Go to the copied place", "Ctrl+V",
     "Go to an address or place on the clipboard.", false,
     [](C& c) { c.ui.requests.pastePlace = true; }},

    {"view.frame", "View", "Frame pivot or selection", "F",
     "Show the selection, or the pivot and its neighbors.", false, frameFocus},
    {"view.all", "View", "Frame all", "Shift+F", "Show everything; the direction stays.", false,
     [](C& c) { c.camera.frame(glm::vec3(0.0F), 1.0F); }},
    {"view.home", "View", "Camera home", "Enter", "Show everything from the first direction.",
     false, home},
    {"view.front", "View", "Front", "1", "Look along +y.", false, setView<ViewPreset::Front>},
    {"view.back", "View", "Back", "", "Look along -y.", false, setView<ViewPreset::Back>},
    {"view.right", "View", "Right", "3", "Look along -x.", false, setView<ViewPreset::Right>},
    {"view.left", "View", "Left", "", "Look along +x.", false, setView<ViewPreset::Left>},
    {"view.top", "View", "Top", "7", "Look down.", false, setView<ViewPreset::Top>},
    {"view.bottom", "View", "Bottom", "", "Look up.", false, setView<ViewPreset::Bottom>},
    {"view.opposite", "View", "The opposite side", "9", "Look from the other side.", false,
     oppositeView},
    {"view.orthographic", "View", "Orthographic", "5", "Without or with perspective.", false,
     [](C& c) { c.camera.toggleOrthographic(); }},
    {"view.fullscreen", "View", "Full screen", "Alt+Enter", "Fill the screen, or not.", false,
     [](C& c) { c.ui.requests.fullScreen = true; }},
    {"view.theme", "View", "Dark or light", "T", "Change between the dark and the light theme.",
     false, toggleTheme},
    {"view.larger", "View", "Larger text", "Ctrl+=", "Enlarge text and panels, up to 3.", true,
     changeScale<1>},
    {"view.smaller", "View", "Smaller text", "Ctrl+-", "Shrink text and panels, down to 0.75.",
     true, changeScale<-1>},
    {"view.monitorscale", "View", "Text as the monitor says", "", "Forget the size chosen here.",
     false, [](C& c) { c.ui.settings.uiScale = 0.0; }},
    {"view.layout.next", "View", "Next layout", "F2", "Debug, Learn, Present.", false,
     [](C& c) { arrange(c, following(c.ui.arrangement)); }},
    {"view.layout.debug", "View", "Layout Debug", "", "All panels.", false,
     setArrangement<Arrangement::Debug>},
    {"view.layout.learn", "View", "Layout Learn", "",
     "The rule beside a large view, the decision in large print.", false,
     setArrangement<Arrangement::Learn>},
    {"view.layout.present", "View", "Layout Present", "", "View, caption and the run alone.", false,
     setArrangement<Arrangement::Present>},
    {"view.mesh.flat", "View", "Mesh: flat", "", "Finished triangles flat gray.", false,
     setMeshStyle<MeshStyle::Flat>},
    {"view.mesh.shaded", "View", "Mesh: smooth", "",
     "Finished triangles shaded as one smooth surface.", false, setMeshStyle<MeshStyle::Shaded>},
    {"view.mesh.wire", "View", "Mesh: edges only", "", "See through the finished triangles.", false,
     setMeshStyle<MeshStyle::Wire>},
    {"view.mesh.birth", "View", "Mesh: by order of birth", "",
     "Color finished triangles from the first to the last one made.", false,
     setMeshStyle<MeshStyle::BirthOrder>},
    {"view.mesh.component", "View", "Mesh: by component", "",
     "Color finished triangles by component.", false, setMeshStyle<MeshStyle::Component>},
    {"view.mesh.next", "View", "Mesh: next style", "M", "Change how finished triangles look.",
     false, nextMeshStyle},
    {"view.legend", "View", "Legend", "", "Show or hide the legend.", false,
     [](C& c) { c.ui.settings.legend = !c.ui.settings.legend; }},
    {"view.drawer", "View", "Fold the drawer", "Ctrl+J",
     "Show the strip RUN alone, or PIVOT and STAGE too.", false,
     [](C& c) { c.ui.navigation.toggleDrawer(); }},

    {"layer.normals", "Layers", "Normals", "N", "Pin normals near the pivot on or off.", false,
     toggle<LayerId::Normals>},
    {"layer.labels", "Layers", "Labels", "L", "Pin labels on or off.", false,
     toggle<LayerId::Labels>},
    {"layer.edges", "Layers", "Mesh edges", "E", "Pin edges of finished triangles on or off.",
     false, toggle<LayerId::MeshEdges>},
    {"layer.spheres", "Layers", "Spheres", "S", "Pin the circumsphere of a test on or off.", false,
     toggle<LayerId::Spheres>},
    {"layer.links", "Layers", "Neighbor links", "G",
     "Pin the neighbor lists of pivot and selection on or off.", false, toggle<LayerId::Links>},
    {"layer.stack", "Layers", "Stacked rings", "K", "Pin the rings on the stack on or off.", false,
     toggle<LayerId::StackedRings>},

    {"notes.bookmark", "Notes", "Bookmark here", "Ctrl+B",
     "Set a bookmark at this decision, or take it away.", false, toggleBookmarkHere},
    {"notes.go.1", "Notes", "Go to bookmark 1", "Ctrl+1", "Go to a bookmark, in their order.",
     false, goToBookmark<0>},
    {"notes.go.2", "Notes", "Go to bookmark 2", "Ctrl+2", "Go to a bookmark, in their order.",
     false, goToBookmark<1>},
    {"notes.go.3", "Notes", "Go to bookmark 3", "Ctrl+3", "Go to a bookmark, in their order.",
     false, goToBookmark<2>},
    {"notes.go.4", "Notes", "Go to bookmark 4", "Ctrl+4", "Go to a bookmark, in their order.",
     false, goToBookmark<3>},
    {"notes.go.5", "Notes", "Go to bookmark 5", "Ctrl+5", "Go to a bookmark, in their order.",
     false, goToBookmark<4>},
    {"notes.go.6", "Notes", "Go to bookmark 6", "Ctrl+6", "Go to a bookmark, in their order.",
     false, goToBookmark<5>},
    {"notes.go.7", "Notes", "Go to bookmark 7", "Ctrl+7", "Go to a bookmark, in their order.",
     false, goToBookmark<6>},
    {"notes.go.8", "Notes", "Go to bookmark 8", "Ctrl+8", "Go to a bookmark, in their order.",
     false, goToBookmark<7>},
    {"notes.go.9", "Notes", "Go to bookmark 9", "Ctrl+9", "Go to a bookmark, in their order.",
     false, goToBookmark<8>},
    {"notes.go.10", "Notes", "Go to bookmark 10", "Ctrl+0", "Go to a bookmark, in their order.",
     false, goToBookmark<9>},

    {"help.palette", "Help", "Find an action...", "Ctrl+P Ctrl+K",
     "Type words of an action and run it.", false, [](C& c) { c.ui.palette.show(); }},
    {"help.keys", "Help", "Keys and mouse", "F1 ?", "Show this list.", false,
     [](C& c) { c.ui.cheatSheet = !c.ui.cheatSheet; }},
    {"help.editkeys", "Help", "Change keys...", "", "Choose other keys for actions.", false,
     [](C& c) { c.ui.keyEditor = !c.ui.keyEditor; }},
    {"help.leave", "Help", "Close popup, clear selection", "Esc", "Never quits.", false, escape},
});

std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t blank = text.find(' ');
        words.push_back(text.substr(0, blank));
        text = blank == std::string_view::npos ? std::string_view{} : text.substr(blank + 1);
    }
    return words;
}

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

namespace {

std::string lowered(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

bool hasAll(const std::string& text, const std::vector<std::string_view>& words) {
    return std::all_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

}  // namespace

std::vector<const Command*> matchingCommands(std::string_view filter) {
    const std::string low = lowered(filter);
    const std::vector<std::string_view> words = wordsOf(low);
    std::vector<const Command*> inTitle;
    std::vector<const Command*> elsewhere;
    for (const Command& command : kCommands) {
        const std::string title = lowered(command.title);
        const std::string all = title + " " + lowered(command.group) + " " + lowered(command.id) +
                                " " + lowered(command.help);
        if (hasAll(title, words)) {
            inTitle.push_back(&command);
        } else if (hasAll(all, words)) {
            elsewhere.push_back(&command);
        }
    }
    inTitle.insert(inTitle.end(), elsewhere.begin(), elsewhere.end());
    return inTitle;
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

void playSteps(CommandContext& context, int count) {
    Session& session = context.session;
    const PlayLoop& loop = context.playback.loop;
    switch (context.playback.unit()) {
        case PlayUnit::SubStep:
            session.stepEvent(count);
            break;
        case PlayUnit::Pivot:
            if (count > 0 && loop.complete() && session.ready()) {
                const auto here = static_cast<long>(session.record().pivot);
                const long rest = static_cast<long>(loop.to->pivot) - here;
                if (rest > 0) count = static_cast<int>(std::min<long>(count, rest));
            }
            session.stepPivot(count);
            break;
        case PlayUnit::Event: {
            const std::optional<Address> mark = session.nextMark(count);
            if (mark) {
                session.playTo(*mark);
            } else if (session.ready() && session.overview().complete) {
                context.playback.pause();
                session.say(count > 0 ? "There is no event after this one."
                                      : "There is no event before this one.");
            }
            break;
        }
    }
}

namespace {

/// Of an edge or a triangle: what is around it, too.
void frameSelection(CommandContext& context) {
    const Model& model = context.session.model();
    const std::span<const Index> corners = context.session.selection().corners();
    glm::vec3 middle(0.0F);
    glm::vec3 normal(0.0F);
    for (const Index p : corners) {
        middle += model.place[p] / static_cast<float>(corners.size());
        normal += model.normal[p];
    }
    float radius = model.spacing;
    for (const Index p : corners) {
        radius = std::max(radius, glm::distance(middle, model.place[p]));
    }
    if (glm::length(normal) > 0.0F) context.camera.face(glm::normalize(normal));
    context.camera.frame(middle, 2.5F * radius);
}

}  // namespace

void frameFocus(CommandContext& context) {
    const Session& session = context.session;
    if (!session.ready()) return;
    const Model& model = session.model();
    const Picture& picture = session.picture();
    if (session.selection().corners().size() > 1) return frameSelection(context);
    Index focus = session.selected();
    if (focus == kNone) focus = picture.pivot;
    if (focus == kNone) focus = picture.underTest;
    if (focus == kNone) {
        context.camera.frame(glm::vec3(0.0F), 1.0F);
        return;
    }
    float radius = 2.0F * model.spacing;
    for (const Index q : model.points.neighbors[focus]) {
        radius = std::max(radius, glm::distance(model.place[focus], model.place[q]));
    }
    // Else one would look at it from within, through the other side of the surface.
    context.camera.face(model.normal[focus]);
    context.camera.frame(model.place[focus], 1.25F * radius);
}

}  // namespace se::view
