// A page cannot run the program that makes videos.
#include "export/writers.h"

namespace se::view {

Status mp4Possible() { return Error{"cannot be written in a browser; .html can"}; }
Result<std::unique_ptr<FrameWriter>> openMp4Writer(const ExportTarget&) {
    return mp4Possible().error();
}

}  // namespace se::view
