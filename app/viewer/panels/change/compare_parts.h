/// Parts of the column in the layout Compare.
#pragma once

#include <string>

#include "panels/panel.h"

namespace se::view {

/// A button that test scripts find as "compare NAME".
bool compareButton(const PanelContext& context, const char* label, const char* name,
                   const std::string& help);
/// The form for the other run.
void drawCompareForm(const PanelContext& context);

}  // namespace se::view
