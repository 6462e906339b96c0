// What a page leaves out: videos, since it cannot run the program that makes them, and the state
// for tests, which look at the page instead.
#include "application.h"
#include "export/formats.h"

namespace se::view {

Status mp4Possible() { return Error{"cannot be written in a browser; .html can"}; }
Result<std::unique_ptr<FrameWriter>> openMp4Writer(const ExportTarget&) {
    return mp4Possible().error();
}

Status Application::writeState(const InputProgress&) { return success(); }

}  // namespace se::view
