// Pictures of pixels, a file per frame.
#include "formats.h"
#include "render/context.h"

namespace se::view {

namespace {

class PngWriter : public FrameWriter {
  public:
    explicit PngWriter(const ExportTarget& target) : files_(target) {}

    Status add(const ExportFrame& frame) override {
        return writePicture(files_.next(frame), frame.pixels);
    }
    Status finish() override { return files_.writeCaptions(); }

  private:
    NumberedFiles files_;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> openPngWriter(const ExportTarget& target) {
    if (const Status made = NumberedFiles(target).makeFolder(); !made) return made.error();
    return std::unique_ptr<FrameWriter>(std::make_unique<PngWriter>(target));
}

}  // namespace se::view
