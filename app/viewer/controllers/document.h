/// Opening and saving: point files, scenes, session files, and what is remembered of them.
/// Knows neither window nor OpenGL.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "options.h"
#include "panel_state/recent.h"
#include "panel_state/ui_state.h"
#include "session/annotations.h"
#include "session/session.h"
#include "session/undo.h"

namespace se::view {

/// What a session file would hold of what is open. Requires context.session.ready().
SessionFile captureSession(const CommandContext& context);
/// What can be undone, as it is now, and the way back.
Edits captureEdits(const CommandContext& context);
void applyEdits(const Edits& edits, CommandContext& context);

class Filing {
  public:
    explicit Filing(CommandContext& context) : c_(context) {}

    /// Opens what the command line names; without a file nothing, and the start page stays.
    void begin(const Options& options);
    /// Takes recent files and layout from that file and keeps them there from now on; with
    /// `resetLayout` the layout begins anew.
    void keepIn(const std::filesystem::path& path, bool resetLayout);
    /// Opens a point file, `scene:ID`, the line of a SampleSpec or a session file; for a volume the
    /// page with new points.
    void open(const std::string& path);
    /// The same for files that were dropped on the window: the first of them.
    void drop(const std::vector<std::string>& paths);
    /// Carries out what panels and commands asked for.
    void carryOut(UiRequests& requests);
    /// Goes to the place that was asked for as soon as what was asked for is open.
    void poll();

    /// The camera that belongs to what has just been opened, once.
    std::optional<CameraPose> takeCamera() { return std::exchange(arrival_.camera, std::nullopt); }
    /// What is open was opened by a session file: one without a camera of its own has z up.
    bool openedSession() const { return ofSession_; }
    /// The alert that the session which has just been opened looked at, once; empty: none.
    std::string takeAlert() { return std::exchange(alert_, {}); }
    /// What is open was opened at a place that somebody named.
    bool placed() const { return placed_; }
    /// True once, after a place was reached that is to be framed.
    bool takeFocus() { return std::exchange(focus_, false); }
    /// What the session or the command line compares with, once.
    std::optional<CompareWith> takeComparison() { return std::exchange(with_, std::nullopt); }
    /// Why the place of the command line does not exist, if so.
    const Status& placeStatus() const { return placeStatus_; }
    /// What was noted and is in no session file yet, in words: "bookmarks and watches"; else empty.
    std::string unsaved() const;
    /// Says what is odd about the input: it is not the one that the session was saved with.
    void warn();

  private:
    /// What is to be done once what was asked for is open.
    struct Arrival {
        bool pending = false;
        std::uint32_t generation = 0;        ///< Of the session, when it was asked for.
        std::string sessionPath;             ///< Empty: no session file.
        std::optional<SessionFile> session;  ///< Taken up once its input is open.
        std::string notice;                  ///< To be said when it is open.
        std::string goTo;
        std::optional<CameraPose> camera;
        Selection selected;
        std::string alert;
        std::string expectedHash;
        std::string file;  ///< For the list of recent files.
        bool focus = false;
        bool ofSession = false;
    };
    /// What a person noted about an input, and the session file that it belongs to.
    struct Notebook {
        Noted noted;
        Noted saved;
        std::string sessionPath;
        std::string original;
    };

    Noted noted() const;
    void putBack(const Noted& noted);

    /// Goes on at once, or asks first if something would be lost.
    void leave(Leave to);
    void go(const Leave& to);
    void reload();
    void takeCures(Cures cures);
    void takeRules(const RuleSet& rules, Resume resume);
    void openInput(InputSpec spec);
    void aimAtScene(const std::string& source);
    void spreadOver(const std::string& volume);
    /// Opens an input with its options: the present one prepared in another way, or points that
    /// were made here and are looked at already.
    void openSpec(InputSpec spec);
    void answer();
    void openSession(const std::string& path);
    void takeLooks(const SessionFile& file, const std::string& path);
    /// Puts the notes about what is open aside, and takes those about `source` up again.
    void changeNotebook(const std::string& source);
    void takeUp();
    void arrive();
    void save();
    void noteSaved();
    void saveAs(const std::string& path);
    void note(const std::string& file);
    void keepLayout();
    /// To be said when what is being opened is open.
    void sayLater(const std::string& sentence);
    /// The same, and on standard error at once.
    void warnLater(const std::string& warning);

    CommandContext& c_;
    Arrival arrival_;
    std::map<std::string, Notebook> notebooks_;
    std::string notebookOf_;            ///< The source that the notes on the table are about.
    std::string original_;              ///< The session file that is open, as it was read.
    Noted saved_;                       ///< As the session file has it.
    std::string said_;                  ///< Waits until one has arrived.
    std::optional<Leave> afterSaving_;  ///< Where to go once the session is saved.
    std::optional<CompareWith> with_;
    bool focus_ = false;
    bool placed_ = false;
    bool ofSession_ = false;
    std::string alert_;
    Status placeStatus_ = success();
    std::filesystem::path kept_;  ///< Empty: nothing is kept.
    Arrangement keptLayout_ = Arrangement::Debug;
};

}  // namespace se::view
