/// Text of a lesson: paragraphs and lists with emphasis, code and links.
#pragma once

#include <string>
#include <vector>

#include "panels/panel.h"
#include "teach/lesson_text.h"

namespace se::view {

/// Draws the blocks, as wide as there is room. The target of the link that was clicked; empty if
/// none was.
std::string drawTextBlocks(const PanelContext& context,
                           const std::vector<teach::TextBlock>& blocks);

}  // namespace se::view
