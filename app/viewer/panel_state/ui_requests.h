/// Requests of commands and panels to the application, and the question before unsaved annotations
/// are left. Plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "run/doctor_fixes.h"
#include "run/model.h"
#include "run/same_position.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

/// Target of the camera once the cursor has arrived.
enum class FrameRequest : std::uint8_t {
    None,
    Home,   ///< All of the input, broadside.
    Focus,  ///< The selection, or the decision.
    Decision,
    Fault,  ///< The chosen place with faults, or alert.
};

/// Requests of a command or panel, carried out by the application in the same frame.
struct UiRequests {
    bool quit = false;    ///< May open a question first.
    bool reload = false;  ///< May open a question first.
    bool screenshot = false;
    bool fullScreen = false;
    bool closePopups = false;
    int walk = 0;  ///< Keyboard focus to the next panel (+1), or to the previous one (-1).
    bool copyPosition = false;
    bool pastePosition = false;
    bool saveSession = false;
    FrameRequest frame = FrameRequest::None;
    bool undo = false;
    bool redo = false;
    std::optional<std::vector<std::string>>
        fixes;  ///< Fixes to open the input with again; empty: the file as it is.
    /// Points of the file to open the input without, by their indices; empty: all of them.
    std::optional<IndexRanges> leftOut;
    std::optional<RunSpec> settings;       ///< The open input with other options.
    std::optional<RunSpec> rules;          ///< Rules of this to re-run with; see withRule().
    Resume resume = Resume::SamePosition;  ///< With `rules`.
    std::string open;                      ///< A path or `scene:ID`; empty: nothing.
    std::string saveSessionAs;             ///< A path; empty: nothing.
    std::string copyText;                  ///< Text for the clipboard; empty: nothing.
    /// An input with its options: prepared in another way, or sampled points.
    std::optional<RunSpec> openSpec;
};

enum class LeaveFor : std::uint8_t { Quit, Open, Reload };
enum class LeaveAnswer : std::uint8_t { None, Save, Discard, Cancel };

/// Destination after the question.
struct Leave {
    LeaveFor what = LeaveFor::Quit;
    std::string path;                            ///< Of LeaveFor::Open: a path or `scene:ID`.
    std::string notice;                          ///< Message on arrival.
    std::optional<RunSpec> spec = std::nullopt;  ///< Input to open, with its options.
};

/// The question, while it is open.
struct LeaveQuestion {
    bool asked = false;
    bool justAsked = false;  ///< The first button gets the keyboard focus.
    Leave leave;
    std::string atStake;                     ///< Unsaved annotations: "bookmarks and watches".
    LeaveAnswer answer = LeaveAnswer::None;  ///< Carried out in the same frame.

    void ask(Leave to, std::string unsaved) {
        *this = {true, true, std::move(to), std::move(unsaved), LeaveAnswer::None};
    }
};

}  // namespace se::view
