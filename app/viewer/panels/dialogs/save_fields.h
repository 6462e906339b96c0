/// The parts of the file browser for saving a mesh (format, points, size), and for an export
/// (format, frames, size, progress).
#pragma once

#include "panels/panel.h"

namespace se::view {

/// The browser is saving a mesh or an export, and waits for an answer or for a thread: input is
/// disabled.
bool saveDialogWaits(const PanelContext& context);
/// Draws the fields below the line with the name; a format may change the extension in `name`.
void drawMeshFields(const PanelContext& context, std::string& name, const std::string& path);
void drawExportFields(const PanelContext& context, std::string& name);

}  // namespace se::view
