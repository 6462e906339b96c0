/// Opening and saving: point files, scenes, session files, and their recent state.
/// Independent of window and OpenGL.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "context.h"
#include "edit_history.h"
#include "panel_state/settings.h"
#include "session/session.h"
#include "session/session_file.h"
#include "start_options.h"
#include "ui_state.h"

namespace se::view {

/// The session file of the open input. Requires context.session.ready().
SessionFile captureSession(const CommandContext& context);
/// Resets the options that were chosen for the points of another input.
void resetInputOptions(RunSpec& spec);

/// The open input with its annotations and session file: opened, run again, left and saved.
class Document {
  public:
    explicit Document(CommandContext& context) : c_(context) {}

    /// Opens the input of the command line; without one the start page stays.
    void begin(const Options& options);
    /// Reads recent files and layout from that file and keeps them there from now on; with
    /// `resetLayout` the layout is the default.
    void keepIn(const std::filesystem::path& path, bool resetLayout);

    // Actions of the user. An input with unsaved annotations or settings is left only after a
    // question.
    /// Opens a point file, `scene:ID`, the line of a SampleSpec, a session file or a lesson; for a
    /// volume the page with new points. `notice`: shown on arrival.
    void open(const std::string& source, const std::string& notice = {});
    /// Opens an input with its options: the current one prepared in another way, or points that
    /// were sampled here and are shown already.
    void openSpec(RunSpec spec);
    /// Opens what a link names, at its place. Requires an input, a lesson or a session.
    void openLink(Options link);
    void reload();
    void quit();
    /// Opens files that were dropped on the window: the first of them.
    void drop(const std::vector<std::string>& paths);
    void answer(LeaveAnswer answer);

    // Other runs of the open input; annotations stay.
    /// Runs by the rules of that spec.
    void rerun(const RunSpec& rules, Resume resume = Resume::SamePosition);
    /// Runs with these options: shown at the end, or where `resume` says if only rules differ.
    void run(const RunSpec& spec, Resume resume = Resume::SamePosition);
    /// Runs to the end with other fixes of the input, and without these points of the file.
    void runWithFixes(std::vector<std::string> fixes);
    void runWithout(IndexRanges leftOut);

    /// Saves the session to its file, or opens the dialog for a name.
    void save();
    void saveAs(const std::string& path);

    /// Opens the input of a step of the open lesson at an address.
    void openStep(RunSpec spec, const std::string& address);
    /// Queues a message for when the input is open that is being opened.
    void sayOnArrival(const std::string& sentence) { arrival_.notice = sentence; }
    /// The requested input is not open yet.
    bool arriving() const { return arrival_.pending; }
    /// Adds a file to the list of recent ones.
    void note(const std::string& file);
    /// State that survives a restart.
    const KeptFile& kept() const { return kept_; }
    /// Changes that file. A failure is shown as a message.
    void keep(const std::function<void(KeptState&)>& change);
    /// Goes to the requested position as soon as the requested input is open.
    void poll();

    /// The camera for the newly opened input, once.
    std::optional<CameraPose> takeCamera() {
        return std::exchange(arrival_.named.camera, std::nullopt);
    }
    /// The input was opened by a session file: one without a camera of its own has z up.
    bool openedSession() const { return ofSession_; }
    /// The alert of the newly opened session, once; empty: none.
    std::string takeAlert() { return std::exchange(alert_, {}); }
    /// The input was opened at a named position.
    bool placed() const { return placed_; }
    /// Error if the position of the command line does not exist.
    const Status& placeStatus() const { return placeStatus_; }
    /// Annotations in no session file yet, in words: "bookmarks and watches"; otherwise empty.
    std::string unsaved() const;
    /// Work that leaving would lose, in words: unsaved annotations, settings of the run; else
    /// empty.
    std::string atStake() const;
    /// Takes layout, colors and styles that a link names.
    void applyLooks(const Options& link);
    /// The looks of the last link. They belong to the link and are not stored in the settings.
    const Looks& linkedLooks() const { return linkedLooks_; }
    /// Says so once the open run ends in another state than the one of a link.
    void expectEnd(std::optional<std::uint64_t> stateHash);
    /// Seconds in which the newly opened input is to be played, once; 0: it is not.
    double takePlay() {
        return arrival_.pending ? 0.0 : std::exchange(arrival_.named.playSeconds, 0.0);
    }
    /// Marks the settings of the run as saved, for example with its mesh.
    void keepSettings();
    /// Shows the queued notices.
    void warn();
    /// Queues a notice for when the input is open, and prints it on standard error at once.
    void warnLater(const std::string& warning);

  private:
    /// Actions to take once the requested input is open.
    struct Arrival {
        bool pending = false;
        std::uint32_t generation = 0;  ///< Of the session, at the time of the request.
        LinkOptions named;             ///< Session, place, alert and end, by a link or otherwise.
        std::string sessionPath;       ///< Empty: no session file.
        std::string notice;            ///< Notice to show when the input is open.
        Selection selected;
        std::string expectedHash;
        std::optional<CompareWith> with;
        std::string file;     ///< For the list of recent files.
        bool framed = false;  ///< The decision at `named.goTo` is to be framed.
        bool toEnd = false;   ///< Of the run: of an input that was changed.
        bool ofSession = false;
    };
    /// The user's annotations of an input, and the session file that they belong to.
    struct AnnotationRecord {
        Annotations annotations;
        Annotations saved;
        std::string sessionPath;
        std::string original;
    };

    /// The run has other settings than when its input was opened or saved.
    bool hasNewSettings() const;
    /// Leaves at once, or asks first if something would be lost.
    void askToLeave(Leave to);
    void leave(Leave to);
    void openNow(const std::string& source);
    void openNow(RunSpec spec);
    void openLinkNow(const Options& link);
    void reloadNow();
    /// Waits for another input; `file` goes to the list of recent files.
    void expectArrival(const std::string& file);
    void openInput(RunSpec spec);
    void aimAt(const LinkOptions& named);
    void aimAtScene(const std::string& source);
    void compareWithTrace(const std::string& path);
    void openSession(const std::string& path);
    void takeLooks(const SessionFile& file, const std::string& path);
    /// Stores the annotations of the open input, and restores those of `source`.
    void switchAnnotations(const std::string& source);
    void takeUp();
    void arrive();
    void checkEnd();
    void keepLayout();
    /// Queues a notice for when the input is open.
    void sayLater(const std::string& sentence);

    CommandContext& c_;
    Arrival arrival_;
    std::map<std::string, AnnotationRecord> records_;
    std::string annotatedSource_;       ///< The source of the current annotations.
    std::string original_;              ///< The open session file, as it was read.
    Annotations saved_;                 ///< Annotations in the session file.
    RunSpec keptSpec_;                  ///< The settings when the input was opened or saved.
    std::string said_;                  ///< Waits until the input is open.
    std::optional<Leave> afterSaving_;  ///< Destination after the session is saved.
    Looks linkedLooks_;
    std::optional<std::uint64_t> endOfLink_;  ///< Expected state hash at the end, from a link.
    std::uint32_t linked_ = 0;                ///< Generation of the session with that end.
    bool placed_ = false;
    bool ofSession_ = false;
    std::string alert_;
    Status placeStatus_ = success();
    KeptFile kept_;
    LayoutPreset keptLayout_ = LayoutPreset::Debug;
};

}  // namespace se::view
