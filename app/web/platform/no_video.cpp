// A page cannot run the program that makes videos.
#include "export/writers.h"

namespace se::view {

Status mp4Possible() { return Error{"is not possible in a browser; .html is"}; }
Result<std::unique_ptr<FrameWriter>> openMp4Writer(const ExportTarget&) {
    return mp4Possible().error();
}

}  // namespace se::view
