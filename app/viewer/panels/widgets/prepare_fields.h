/// Fields for what is derived from the points of an input: in File > Prepare, and for the other
/// run in the layout Compare.
#pragma once

#include <string>

#include "panel_state/prepare_form.h"
#include "panels/panel.h"

namespace se::view {

/// True if Enter was pressed in one of them. Test scripts find the items as `prefix` and their
/// names.
bool drawPrepareFields(const PanelContext& context, PrepareForm& form, const std::string& prefix);

/// Six fields in two rows, the lower corner first. True if Enter was pressed in one.
bool drawBoxFields(const PanelContext& context, BoxFields& fields);

}  // namespace se::view
