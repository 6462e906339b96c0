/// Opening and saving: point files, scenes, session files, and what is remembered of them.
/// Knows neither window nor OpenGL.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "options.h"
#include "recent.h"
#include "session.h"
#include "ui_state.h"
#include "undo.h"

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
    /// Opens a point file, `scene:ID` or a session file.
    void open(const std::string& path);
    /// Carries out what panels and commands asked for.
    void carryOut(UiRequests& requests);
    /// Goes to the place that was asked for as soon as what was asked for is open.
    void poll();

    /// The camera that belongs to what has just been opened, once.
    std::optional<CameraPose> takeCamera() { return std::exchange(arrival_.camera, std::nullopt); }
    /// True once, after a place was reached that is to be framed.
    bool takeFocus() { return std::exchange(focus_, false); }
    /// Why the place of the command line does not exist, if so.
    const Status& placeStatus() const { return placeStatus_; }
    /// There are bookmarks or notes that no session file holds yet.
    bool unsaved() const;
    /// Says what is odd about the input: it is not the one that the session was saved with.
    void warn();

  private:
    /// What is to be done once what was asked for is open.
    struct Arrival {
        bool pending = false;
        std::string goTo;
        std::optional<CameraPose> camera;
        Selection selected;
        std::string expectedHash;
        std::string file;  ///< For the list of recent files.
        bool focus = false;
    };
    /// What a person noted about an input.
    struct Notebook {
        Bookmarks bookmarks;
        std::string notes;
        std::string sessionPath;
        std::string original;
        Bookmarks savedBookmarks;
        std::string savedNotes;
    };

    void openSession(const std::string& path);
    void takeLooks(const SessionFile& file, const std::string& path);
    /// Puts the notes about what is open aside, and takes those about `source` up again.
    void changeNotebook(const std::string& source);
    void arrive();
    void save();
    void noteSaved();
    void saveAs(const std::string& path);
    void note(const std::string& file);
    void keepLayout();

    CommandContext& c_;
    Arrival arrival_;
    std::map<std::string, Notebook> notebooks_;
    std::string original_;      ///< The session file that is open, as it was read.
    Bookmarks savedBookmarks_;  ///< As the session file has them.
    std::string savedNotes_;
    std::string warning_;
    bool focus_ = false;
    Status placeStatus_ = success();
    std::filesystem::path kept_;  ///< Empty: nothing is kept.
    Arrangement keptLayout_ = Arrangement::Debug;
};

}  // namespace se::view
