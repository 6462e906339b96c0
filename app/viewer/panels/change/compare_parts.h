/// What the column of the layout Compare is made of.
#pragma once

#include <string>

#include "panels/panel.h"

namespace se::view {

/// A button that scripts find as "compare NAME".
bool compareButton(const PanelContext& context, const char* label, const char* name,
                   const std::string& help);
/// What the other run is to be.
void drawCompareForm(const PanelContext& context);

}  // namespace se::view
