/// Settings that a window begins with, and those that are kept after it.
#pragma once

#include "document/start_options.h"
#include "panel_state/settings.h"

namespace se::view {

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
