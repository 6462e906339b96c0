/// The writers of the table of formats, each in a file of its own.
#pragma once

#include "formats.h"

namespace se::view {

Result<std::unique_ptr<FrameWriter>> openPngWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openSvgWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openPageWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openGifWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openMp4Writer(const ExportTarget& target);
/// The reason why this machine cannot write them.
Status gifPossible();
Status mp4Possible();

}  // namespace se::view
