/// The part of the file browser for an export: format, frames, size, progress.
#pragma once

#include "panels/panel.h"

namespace se::view {

/// The browser is for an export, which is in progress: input is disabled.
bool exportDialogWaits(const PanelContext& context);
/// Draws the fields below the line with the name; a format may change the extension in `name`.
void drawExportFields(const PanelContext& context, std::string& name);

}  // namespace se::view
