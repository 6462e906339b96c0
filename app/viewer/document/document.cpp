// Opening takes several frames, and cursor, camera, selection and notices can be set only after
// it. They wait in Arrival until arrive(); a failed or cancelled opening discards them.
// Annotations are kept per input (records_), so that they return when the input is opened again.
#include "document.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "actions.h"
#include "compare/compared_runs.h"
#include "lesson/lesson_player.h"
#include "new_points.h"
#include "run/model.h"
#include "run/packed_file.h"
#include "run/strings.h"
#include "session/playback.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::view {

void resetInputOptions(RunSpec& spec) {
    spec.leftOut = {};
    spec.piece = {};
    spec.normals = NormalSource::AsGiven;
    spec.walls = {};
    spec.scanner.reset();
    spec.start = {};
    spec.rim = false;
}

SessionFile captureSession(const CommandContext& context) {
    const Session& session = context.session;
    SessionFile file;
    assert(session.ready());
    file.input = session.input().spec();
    file.inputHash = session.model().hash;
    file.place.address = session.event() != nullptr ? toString(session.address()) : "";
    file.place.camera = context.camera.pose();
    file.layers = context.ui.settings.layers;
    file.layout = context.ui.layoutPreset;
    file.selected = session.selection();
    if (session.alerts().chosen())
        file.alert = alertName(session.alerts(), *session.alerts().chosen());
    file.annotations = annotationsOf(context.ui);
    file.query = context.ui.query.typed;
    if (context.ui.compare.now != nullptr) file.with = context.ui.compare.now->with();
    return file;
}

void Document::begin(const Options& options) {
    if (options.session) {
        takeLooks(*options.session, options.sessionPath);
        const std::string difference = differenceText(options.session->input, options.input);
        if (difference != kNoDifference)
            warnLater("Opened with other options than the session has (" + difference +
                      "): addresses and bookmarks may refer to other decisions.");
    }
    if (options.with) c_.compare.beginWith(*options.with);
    if (options.layout) c_.ui.layoutPreset = *options.layout;
    if (options.lessons) c_.ui.column.choose(Task::Lesson);
    keptLayout_ = c_.ui.layoutPreset;
    if (options.input.source.empty()) {
        if (options.with && options.with->kind == CompareWith::Kind::Trace)
            compareWithTrace(options.with->path);
        return;
    }
    arrival_.pending = true;
    arrival_.generation = c_.session.generation();
    annotatedSource_ = options.input.source;
    arrival_.file = options.session ? options.sessionPath : options.input.source;
    if (!options.goTo.empty()) arrival_.named.goTo = options.goTo;
    if (options.camera) arrival_.named.camera = options.camera;
    arrival_.named.stateHash = options.stateHash;
    aimAt(options);
    c_.session.open(options.input);
}

/// Frames the position that is named without a camera. A scene with nothing named opens at its
/// decision.
void Document::aimAt(const LinkOptions& named) {
    if (!named.goTo.empty()) arrival_.framed = !named.camera;
    arrival_.framed = arrival_.framed || named.focus;
    if (named.goTo.empty() && named.alert.empty() && !named.camera && !named.session &&
        !named.atDifference)
        aimAtScene(named.input.source);
}

/// A scene opens at the decision that it demonstrates, framed.
void Document::aimAtScene(const std::string& source) {
    const std::string_view address = openingAddress(source);
    if (address.empty()) return;
    arrival_.named.goTo = address;
    arrival_.framed = true;
}

void Document::keepIn(const std::filesystem::path& path, bool resetLayout) {
    kept_.open(path);
    const std::string complaint = kept_.complaint();
    if (!complaint.empty()) c_.ui.settings.complaints.push_back(complaint);
    const KeptState state = kept_.read();
    c_.ui.recent = state.recent;
    keptLayout_ = state.layout;
    if (!resetLayout) c_.ui.layoutPreset = state.layout;
    if (resetLayout && state.layout != c_.ui.layoutPreset) keepLayout();
}

void Document::switchAnnotations(const std::string& source) {
    UiState& ui = c_.ui;
    if (source == annotatedSource_) return;
    records_[std::exchange(annotatedSource_, source)] = {annotationsOf(ui), saved_, ui.sessionPath,
                                                         original_};
    const AnnotationRecord& other = records_[source];
    putBack(other.annotations, ui);
    saved_ = other.saved;
    ui.sessionPath = other.sessionPath;
    original_ = other.original;
}

void Document::expectArrival(const std::string& file) {
    arrival_ = {};
    arrival_.pending = true;
    arrival_.generation = c_.session.generation();
    arrival_.file = file;
}

/// The page with new points is closed for the input that is opened.
void Document::openInput(RunSpec spec) {
    if (c_.ui.growth.open) c_.sampling.leave();
    spec.maxBytes = std::max(spec.maxBytes, c_.session.input().opening().maxBytes);
    c_.session.open(std::move(spec));
}

/// A trace is no input: it is compared with the open run, or with that which is opened next.
void Document::compareWithTrace(const std::string& path) {
    actions::enterCompare(c_);
    if (c_.session.ready()) return c_.compare.begin(CompareWith::otherTrace(path));
    c_.compare.beginWith(CompareWith::otherTrace(path));
    sayLater(std::filesystem::path(path).filename().string() +
             " is a trace: open the points that it is of.");
    actions::openBrowser(c_, BrowserTask::Open);
}

void Document::openNow(const std::string& path) {
    c_.playback.pause();
    if (isLesson(path)) return c_.lesson.open(path);
    // A volume has no points yet: they are spread over it first.
    if (isVolumePath(path)) return c_.sampling.openVolume(path);
    if (isTraceFile(path)) return compareWithTrace(path);
    const bool named = isScene(path) || isSample(path);
    if (!named && looksLikeSession(path)) return openSession(path);
    c_.lesson.closeForOther();
    const Session& session = c_.session;
    RunSpec spec = session.ready() ? session.input().spec() : session.input().opening();
    spec.fixes.clear();
    spec.leftOut = {};
    spec.piece = {};
    if (std::exchange(spec.source, path) != path) {
        resetInputOptions(spec);
        spec.points = nullptr;
        spec.whatIf.clear();
    }
    expectArrival(path);
    aimAtScene(path);
    openInput(std::move(spec));
}

void Document::openNow(RunSpec spec) {
    c_.playback.pause();
    const Session& session = c_.session;
    expectArrival(spec.source);
    if (c_.ui.growth.open) arrival_.named.camera = c_.camera.pose();
    const bool same = session.ready() && session.input().spec().source == spec.source;
    if (!same) c_.lesson.closeForOther();
    if (same) arrival_.selected = session.selection();
    openInput(std::move(spec));
}

void Document::applyLooks(const Options& link) {
    UiState& ui = c_.ui;
    if (link.layout && link.layout != ui.layoutPreset) actions::applyLayoutPreset(c_, *link.layout);
    if (link.lessons) ui.column.choose(Task::Lesson);
    const auto take = [](const auto& from, auto& linked, auto& to) {
        if (from) linked = to = *from;
    };
    take(link.theme, linkedLooks_.theme, ui.settings.theme);
    take(link.meshStyle, linkedLooks_.meshStyle, ui.settings.meshStyle);
    take(link.pointTint, linkedLooks_.pointTint, ui.settings.pointTint);
}

void Document::openLinkNow(const Options& link) {
    c_.playback.pause();
    applyLooks(link);
    if (!link.lesson.empty()) return c_.lesson.open(link.lesson, link.lessonStep);
    if (isVolumePath(link.input.source) && !isSample(link.input.source))
        return c_.sampling.openVolume(link.input.source);
    std::optional<CompareWith> other;
    if (!link.withText.empty()) {
        Result<CompareWith> with = compareWithFromText(link.withText, link.input);
        if (!with) return c_.session.messages().say(with.error().message);
        other = std::move(with.value());
    }
    c_.lesson.closeForOther();
    expectArrival(link.session ? std::string{} : link.input.source);
    arrival_.with = std::move(other);
    if (link.atDifference) arrival_.notice = "Press D for the first difference.";
    arrival_.named = link;
    aimAt(link);
    openInput(link.input);
}

void Document::openStep(RunSpec spec, const std::string& address) {
    expectArrival({});
    arrival_.named.goTo = address;
    openInput(std::move(spec));
}

void Document::openSession(const std::string& path) {
    const Result<SessionFile> read = readSessionFile(path);
    if (!read) return c_.session.messages().say(read.error().message);
    c_.lesson.closeForOther();
    expectArrival(path);
    arrival_.sessionPath = path;
    arrival_.named.session = read.value();
    openInput(read.value().input);
}

void Document::takeLooks(const SessionFile& file, const std::string& path) {
    UiState& ui = c_.ui;
    if (file.layers) ui.settings.layers = *file.layers;
    if (file.layout) ui.layoutPreset = keptLayout_ = *file.layout;
    if (file.lessons) ui.column.choose(Task::Lesson);
    putBack(file.annotations, ui);
    ui.query.typed = file.query;
    ui.sessionPath = path;
    original_ = file.original;
    saved_ = annotationsOf(c_.ui);
    if (file.with.kind != CompareWith::Kind::Nothing) c_.compare.beginWith(file.with);
    if (!file.leftOut.empty()) warnLater(file.leftOut);
    arrival_.ofSession = true;
    arrival_.named.goTo = file.place.address;
    arrival_.named.camera = file.place.camera;
    arrival_.framed = !file.place.camera;
    arrival_.selected = file.selected;
    arrival_.named.alert = file.alert;
    arrival_.expectedHash = file.inputHash;
}

void Document::poll() {
    const SessionPhase phase = c_.session.input().phase();
    if (arrival_.pending && phase != SessionPhase::Loading) {
        const bool opened = c_.session.generation() != arrival_.generation;
        // The opening failed, or was cancelled: the open input stays unchanged.
        if (!opened) arrival_ = {};
        if (opened && phase == SessionPhase::Ready) arrive();
    }
    // A lesson chooses the layout for itself.
    if (c_.ui.layoutPreset != keptLayout_ && !c_.ui.lesson.walk.isOpen()) keepLayout();
    if (!arrival_.pending && !c_.session.moves().busy()) warn();
    checkEnd();
    // No file was named: the session stays open.
    if (!c_.ui.fileBrowser) afterSaving_.reset();
}

/// Switches to the annotations and looks of the input that is open now.
void Document::takeUp() {
    const std::optional<SessionFile> session = std::exchange(arrival_.named.session, std::nullopt);
    switchAnnotations(c_.session.input().spec().source);
    if (session) takeLooks(*session, arrival_.sessionPath);
    if (!arrival_.notice.empty()) sayLater(std::exchange(arrival_.notice, {}));
}

void Document::expectEnd(std::optional<std::uint64_t> stateHash) {
    endOfLink_ = stateHash;
    linked_ = c_.session.generation();
}

/// Says once if the run ends otherwise than the one of a link.
void Document::checkEnd() {
    // With other settings it may.
    if (linked_ != c_.session.generation()) endOfLink_.reset();
    const auto end = endOfLink_ ? c_.session.runEnd() : nullptr;
    if (!end || std::exchange(endOfLink_, std::nullopt) == end->stateHash) return;
    warnLater(
        "The link is from another version of the program or of the points: there the run ends "
        "differently, and its addresses may refer to other decisions.");
}

void Document::arrive() {
    takeUp();
    // Other settings of the same input are the user's change, of another one its beginning.
    const std::string& source = c_.session.input().spec().source;
    if (arrival_.ofSession || !arrival_.file.empty() || source != keptSpec_.source) keepSettings();
    arrival_.pending = false;
    alert_ = std::exchange(arrival_.named.alert, {});
    if (arrival_.with) c_.compare.beginWith(*std::exchange(arrival_.with, std::nullopt));
    placed_ = !arrival_.named.goTo.empty() || arrival_.named.camera;
    ofSession_ = arrival_.ofSession;
    note(arrival_.file);
    expectEnd(arrival_.named.stateHash);
    const std::string& hash = c_.session.model().hash;
    if (!arrival_.expectedHash.empty() && arrival_.expectedHash != hash) {
        warnLater(
            "The input has changed since this session was saved: addresses and bookmarks "
            "may refer to other decisions.");
    }
    const auto corners = arrival_.selected.corners();
    const std::size_t count = c_.session.model().points.size();
    if (std::all_of(corners.begin(), corners.end(), [&](Index p) { return p < count; })) {
        c_.session.select(arrival_.selected);
    }
    if (arrival_.toEnd) {
        sayLater(changesText(c_.session.model()));
        return c_.session.moves().toEnd();
    }
    const bool atStart = arrival_.named.goTo.empty() || arrival_.named.goTo == "0";
    if (atStart) return;
    if (arrival_.framed) c_.ui.frame = FrameRequest::Decision;
    placeStatus_ = c_.session.moves().goToText(arrival_.named.goTo);
    if (!placeStatus_) c_.session.messages().say(placeStatus_.error().message);
}

void Document::warnLater(const std::string& warning) {
    printLines(stderr, "spiraling-edge-viewer: warning: " + printable(warning) + "\n");
    sayLater(warning);
}

void Document::sayLater(const std::string& sentence) {
    if (sentence.empty()) return;
    said_ += (said_.empty() ? "" : " ") + sentence;
}

void Document::warn() {
    if (!said_.empty()) c_.session.messages().say(std::exchange(said_, {}));
}

void Document::open(const std::string& source, const std::string& notice) {
    const auto go = [this, source, notice] {
        openNow(source);
        arrival_.notice = notice;
    };
    askToLeave({LeaveFor::Open, go, isVolumePath(source) || isTraceFile(source)});
}

void Document::openSpec(RunSpec spec) {
    const bool same = c_.session.ready() && c_.session.input().spec().source == spec.source;
    askToLeave({same ? LeaveFor::Reload : LeaveFor::Open,
                [this, spec = std::move(spec)] { openNow(spec); }});
}

void Document::openLink(Options link) {
    askToLeave({LeaveFor::Open, [this, link = std::move(link)] { openLinkNow(link); }});
}

void Document::reload() {
    askToLeave({LeaveFor::Reload, [this] { reloadNow(); }});
}

void Document::quit() {
    askToLeave({LeaveFor::Quit, [this] { c_.ui.quitting = true; }});
}

void Document::askToLeave(Leave to) {
    c_.ui.betweenFrames([this, to = std::move(to)] { leave(to); });
}

void Document::leave(Leave to) {
    if (c_.ui.leaving.asked) return;
    const std::string lost = to.what == LeaveFor::Reload ? unsaved() : atStake();
    if (lost.empty() || to.keeps) return to.go();
    c_.playback.pause();
    c_.ui.leaving.ask(std::move(to), lost);
}

void Document::reloadNow() {
    const Session& session = c_.session;
    const bool failed = session.input().phase() == SessionPhase::Failed || !session.ready();
    const RunSpec spec = failed ? session.input().opening() : session.input().spec();
    if (!spec.source.empty()) c_.session.open(spec);
}

void Document::run(const RunSpec& spec, Resume resume) {
    c_.ui.betweenFrames([this, spec, resume] {
        const Session& session = c_.session;
        if (!session.ready()) return;
        if (withRulesOf(session.input().spec(), spec) == spec) return rerun(spec, resume);
        if (session.input().phase() == SessionPhase::Loading) return;
        c_.playback.pause();
        expectArrival({});
        arrival_.toEnd = true;
        openInput(spec);
    });
}

void Document::rerun(const RunSpec& rules, Resume resume) {
    c_.ui.betweenFrames([this, rules, resume] {
        const RunSpec now = c_.session.input().rules();
        if (!c_.session.ready() || withRulesOf(now, rules) == now) return;
        c_.playback.pause();
        c_.session.rerun(rules, resume);
    });
}

void Document::runWithFixes(std::vector<std::string> fixes) {
    RunSpec spec = c_.session.input().spec();
    spec.fixes = std::move(fixes);
    run(spec);
}

void Document::runWithout(IndexRanges leftOut) {
    RunSpec spec = c_.session.input().spec();
    spec.leftOut = std::move(leftOut);
    // What-ifs name points by their numbers, which change.
    spec.whatIf.clear();
    run(spec);
}

void Document::answer(LeaveAnswer answer) {
    LeaveQuestion& question = c_.ui.leaving;
    if (!std::exchange(question.asked, false)) return;
    if (answer == LeaveAnswer::Save) {
        afterSaving_ = question.leave;
        save();
    }
    if (answer != LeaveAnswer::Discard) return;
    c_.ui.betweenFrames([this, to = question.leave] {
        putBack(saved_, c_.ui);
        to.go();
    });
}

namespace {

/// The points of a session are among the files.
bool hasPointsOfSession(const std::vector<std::string>& paths, const std::string& session) {
    const Result<SessionFile> read = readSessionFile(session);
    if (!read) return false;
    const std::filesystem::path points = read.value().input.source;
    return std::any_of(paths.begin(), paths.end(), [&points](const std::filesystem::path& path) {
        return path.filename() == points.filename();
    });
}

}  // namespace

void Document::drop(const std::vector<std::string>& paths) {
    // Points that are dropped with their session are opened by it.
    const auto session = std::find_if(paths.begin(), paths.end(), [&paths](const auto& path) {
        return path.ends_with(kSessionExtension) && hasPointsOfSession(paths, path);
    });
    const std::string& path = session != paths.end() ? *session : paths.front();
    const std::size_t together = session != paths.end() ? 2 : 1;
    if (paths.size() <= together) return open(path);
    open(path, std::to_string(paths.size()) + " files were dropped; only one was opened: " +
                   std::filesystem::path(path).filename().string() + ".");
}

void Document::save() {
    if (!c_.session.ready()) return c_.session.messages().say("There is nothing open to save.");
    if (isStandardInput(c_.session.input().spec().source))
        return c_.session.messages().say(
            "A session refers to a file, but these points came from standard input. Save them to a "
            "file first.");
    if (c_.ui.sessionPath.empty()) return actions::openBrowser(c_, BrowserTask::SaveSession);
    saveAs(c_.ui.sessionPath);
}

void Document::saveAs(const std::string& path) {
    if (!c_.session.ready()) return;
    SessionFile file = captureSession(c_);
    file.original = original_;
    const Status written = writeSessionFile(path, file);
    if (!written) {
        afterSaving_.reset();
        return c_.session.messages().say(written.error().message);
    }
    c_.ui.sessionPath = path;
    original_ = sessionToJson(file, std::filesystem::path(path).parent_path());
    saved_ = annotationsOf(c_.ui);
    keepSettings();
    note(path);
    c_.session.messages().say("Saved " + path + ".");
    if (!afterSaving_) return;
    c_.ui.betweenFrames(std::exchange(afterSaving_, std::nullopt)->go);
}

std::string Document::atStake() const {
    const std::string annotations = unsaved();
    if (!hasNewSettings()) return annotations;
    return annotations.empty() ? "settings of the run" : "settings of the run, " + annotations;
}

std::string Document::unsaved() const { return differenceOf(annotationsOf(c_.ui), saved_); }

void Document::keepSettings() { keptSpec_ = c_.session.input().spec(); }

bool Document::hasNewSettings() const {
    if (!c_.session.ready()) return false;
    RunSpec now = c_.session.input().spec();
    // A lesson has settings of its own, and those of other inputs come with them.
    if (c_.ui.lesson.walk.isOpen() || now.source != keptSpec_.source) return false;
    now.points = keptSpec_.points;
    now.maxBytes = keptSpec_.maxBytes;
    return !(now == keptSpec_);
}

void Document::note(const std::string& file) {
    if (!kept_.isOpen() || file.empty() || isStandardInput(file) || isPacked(file)) return;
    if (c_.ui.hostFiles.apart() && !isScene(file) && !isSample(file)) return;  // gone by then
    keep([&](KeptState& state) {
        remember(state, file);
        c_.ui.recent = state.recent;
    });
}

void Document::keepLayout() {
    keptLayout_ = c_.ui.layoutPreset;
    keep([this](KeptState& state) { state.layout = keptLayout_; });
}

void Document::keep(const std::function<void(KeptState&)>& change) {
    if (const Status s = kept_.change(change); !s) c_.session.messages().say(s.error().message);
}

}  // namespace se::view
