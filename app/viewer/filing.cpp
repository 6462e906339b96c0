#include "filing.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace se::view {

SessionFile captureSession(const CommandContext& context) {
    const Session& session = context.session;
    SessionFile file;
    file.input = session.spec();
    file.inputHash = session.model().hash;
    file.place.address = session.event() != nullptr ? toString(session.address()) : "";
    file.place.camera = context.camera.pose();
    file.layers = context.ui.settings.layers;
    file.layout = context.ui.arrangement;
    file.selected = session.selection();
    file.bookmarks = context.ui.bookmarks;
    file.notes = context.ui.notes;
    return file;
}

Edits captureEdits(const CommandContext& context) {
    const UiState& ui = context.ui;
    return {ui.settings.theme,           ui.settings.uiScale, ui.settings.legend,
            ui.settings.layers,          ui.arrangement,      context.camera.pose(),
            context.session.selection(), ui.bookmarks,        ui.notes};
}

void applyEdits(const Edits& edits, CommandContext& context) {
    UiState& ui = context.ui;
    ui.settings.theme = edits.theme;
    ui.settings.uiScale = edits.uiScale;
    ui.settings.legend = edits.legend;
    ui.settings.layers = edits.layers;
    ui.arrangement = edits.layout;
    if (context.camera.pose() != edits.camera) context.camera.setPose(edits.camera);
    context.session.select(edits.selected);
    ui.bookmarks = edits.bookmarks;
    ui.notes = edits.notes;
}

void Filing::begin(const Options& options) {
    if (options.session) takeLooks(*options.session, options.sessionPath);
    if (options.layout) c_.ui.arrangement = *options.layout;
    keptLayout_ = c_.ui.arrangement;
    if (options.input.source.empty()) return;
    arrival_.pending = true;
    arrival_.focus = options.focus;
    arrival_.file = options.session ? options.sessionPath : options.input.source;
    if (!options.goTo.empty()) arrival_.goTo = options.goTo;
    if (options.camera) arrival_.camera = options.camera;
    c_.session.open(options.input);
}

void Filing::keepIn(const std::filesystem::path& path, bool resetLayout) {
    kept_ = path;
    const KeptState state = readKeptState(path);
    c_.ui.recent = state.recent;
    keptLayout_ = state.layout;
    if (!resetLayout) c_.ui.arrangement = state.layout;
    if (resetLayout && state.layout != c_.ui.arrangement) keepLayout();
}

void Filing::changeNotebook(const std::string& source) {
    UiState& ui = c_.ui;
    const std::string& before = c_.session.spec().source;
    if (source == before) return;
    Notebook mine{std::move(ui.bookmarks), std::move(ui.notes),        std::move(ui.sessionPath),
                  std::move(original_),    std::move(savedBookmarks_), std::move(savedNotes_)};
    notebooks_[before] = std::move(mine);
    Notebook& other = notebooks_[source];
    ui.bookmarks = other.bookmarks;
    ui.notes = other.notes;
    ui.sessionPath = other.sessionPath;
    original_ = other.original;
    savedBookmarks_ = other.savedBookmarks;
    savedNotes_ = other.savedNotes;
}

void Filing::open(const std::string& path) {
    c_.playback.pause();
    if (!isScene(path) && looksLikeSession(path)) return openSession(path);
    InputSpec spec = c_.session.spec();
    changeNotebook(path);
    spec.source = path;
    arrival_ = {};
    arrival_.pending = true;
    arrival_.file = path;
    c_.session.open(std::move(spec));
}

void Filing::openSession(const std::string& path) {
    const Result<SessionFile> read = readSessionFile(path);
    if (!read) return c_.session.say(read.error().message);
    changeNotebook(read.value().input.source);
    arrival_ = {};
    takeLooks(read.value(), path);
    arrival_.pending = true;
    arrival_.file = path;
    c_.session.open(read.value().input);
}

void Filing::takeLooks(const SessionFile& file, const std::string& path) {
    UiState& ui = c_.ui;
    if (file.layers) ui.settings.layers = *file.layers;
    if (file.layout) ui.arrangement = keptLayout_ = *file.layout;
    ui.bookmarks = file.bookmarks;
    ui.notes = file.notes;
    ui.sessionPath = path;
    original_ = file.original;
    noteSaved();
    arrival_.goTo = file.place.address;
    arrival_.camera = file.place.camera;
    arrival_.selected = file.selected;
    arrival_.expectedHash = file.inputHash;
}

void Filing::poll() {
    const SessionPhase phase = c_.session.phase();
    if (phase == SessionPhase::Failed) arrival_ = {};
    if (arrival_.pending && phase == SessionPhase::Ready && c_.session.ready()) arrive();
    if (c_.ui.arrangement != keptLayout_) keepLayout();
    if (!arrival_.pending && !c_.session.busy()) warn();
}

void Filing::arrive() {
    const bool needsLength = arrival_.goTo.ends_with('%');
    if (needsLength && !c_.session.overview().complete) return;
    arrival_.pending = false;
    note(arrival_.file);
    const std::string& hash = c_.session.model().hash;
    if (!arrival_.expectedHash.empty() && arrival_.expectedHash != hash) {
        warning_ =
            "The input has changed since this session was saved: addresses and bookmarks "
            "may mean other decisions.";
        std::fprintf(stderr, "spiraling-edge-viewer: warning: %s\n", warning_.c_str());
    }
    const auto corners = arrival_.selected.corners();
    const std::size_t count = c_.session.model().points.size();
    if (std::all_of(corners.begin(), corners.end(), [&](Index p) { return p < count; })) {
        c_.session.select(arrival_.selected);
    }
    const bool atStart = arrival_.goTo.empty() || arrival_.goTo == "0";
    if (atStart) return;
    focus_ = arrival_.focus;
    placeStatus_ = c_.session.goToText(arrival_.goTo);
    if (!placeStatus_) c_.session.say(placeStatus_.error().message);
}

void Filing::warn() {
    if (!warning_.empty()) c_.session.say(std::exchange(warning_, {}));
}

void Filing::carryOut(UiRequests& requests) {
    if (!requests.open.empty()) open(std::exchange(requests.open, {}));
    if (std::exchange(requests.saveSession, false)) save();
    if (!requests.saveSessionAs.empty()) saveAs(std::exchange(requests.saveSessionAs, {}));
}

void Filing::save() {
    if (!c_.session.ready()) return c_.session.say("There is nothing open to save.");
    if (c_.ui.sessionPath.empty()) {
        c_.ui.browser = BrowserTask::SaveSession;
        c_.ui.fileBrowser = true;
    } else {
        saveAs(c_.ui.sessionPath);
    }
}

void Filing::saveAs(const std::string& path) {
    if (!c_.session.ready()) return;
    SessionFile file = captureSession(c_);
    file.original = original_;
    const Status written = writeSessionFile(path, file);
    if (!written) return c_.session.say(written.error().message);
    c_.ui.sessionPath = path;
    original_ = sessionToJson(file, std::filesystem::path(path).parent_path());
    noteSaved();
    note(path);
    c_.session.say("Saved " + path + ".");
}

void Filing::noteSaved() {
    savedBookmarks_ = c_.ui.bookmarks;
    savedNotes_ = c_.ui.notes;
}

bool Filing::unsaved() const {
    return c_.ui.bookmarks != savedBookmarks_ || c_.ui.notes != savedNotes_;
}

void Filing::note(const std::string& file) {
    if (kept_.empty() || file.empty()) return;
    // Another window may have noted something since.
    KeptState state = readKeptState(kept_);
    remember(state, file);
    c_.ui.recent = state.recent;
    if (const Status s = writeKeptState(kept_, state); !s) c_.session.say(s.error().message);
}

void Filing::keepLayout() {
    keptLayout_ = c_.ui.arrangement;
    if (kept_.empty()) return;
    KeptState state = readKeptState(kept_);
    state.layout = keptLayout_;
    if (const Status s = writeKeptState(kept_, state); !s) c_.session.say(s.error().message);
}

}  // namespace se::view
