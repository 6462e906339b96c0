/// The writers of the table of formats, each in a file of its own.
#pragma once

#include "formats.h"

namespace se::view {

Result<std::unique_ptr<FrameWriter>> openPngWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openSvgWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openPageWriter(const ExportTarget& target);

}  // namespace se::view
