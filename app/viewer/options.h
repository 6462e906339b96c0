/// The command line of the viewer.
#pragma once

#include <optional>

#include "document/start_options.h"
#include "panel_state/settings.h"

namespace se::view {

/// Exit codes, the same for all programs of the project.
enum ExitCode : int {
    kExitGood = 0,
    kExitUsage = 2,
    kExitInput = 3,
    kExitNoDisplay = 4,
    kExitInternal = 5,
};

/// Result of parsing: options to go on with, or an exit code.
struct ParsedOptions {
    std::optional<Options> options;
    int exitCode = kExitGood;  ///< Without options.
};

/// Parses the command line; prints help, version, the list of actions or an error itself.
ParsedOptions parseOptions(int argc, const char* const* argv);

/// Reads FILE if it is a session, and takes from it what the command line does not set.
/// Fails with a sentence.
Status adoptSession(Options& options);

/// Reads the file of --start, if there is one. Fails with a sentence.
Status adoptStart(Options& options);

/// Takes FILE as a lesson if it is one.
Status adoptLesson(Options& options);

/// Reads the lesson that FILE names for an export, with the steps to export; without a lesson or a
/// position, the end of the run. Fails with a sentence; `code` is then the exit code.
Status adoptLesson(Options& o, int& code);

/// Reads standard input to its end, into memory, if FILE is `-`, so that it can be opened again.
/// Fails with a sentence.
Status adoptStandardInput(Options& options);

/// Sets Options::with; to be called after adoptSession(). Fails with a sentence.
Status chooseComparison(Options& options);

/// Fails if a file to write is also written under another option, or is one of the files that are
/// read, unless kForceOption was given. Called once the options have been read, before any work.
Status requireInputsKept(const Options& o);

// Settings that a window begins with, and those that are kept after it.

class Application;

/// Settings of the last window, with the usual theme if none has been chosen. Pictures and
/// measurements are equal for everybody.
ViewSettings keptSettings(const Options& options, Theme usual = Theme::Dark);

/// `settings` with what the options say instead.
ViewSettings settingsFor(const Options& options, ViewSettings settings);

/// Settings of the window as it is now, to be kept. Options apply to this run only: what they set
/// is as `before`.
ViewSettings settingsToKeep(const Options& options, const Application& application,
                            const ViewSettings& before);

}  // namespace se::view
