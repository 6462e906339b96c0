// Pictures of shapes, a file per frame: colors are classes of a style sheet, text is text.
#include <fmt/format.h>

#include "numbered_files.h"
#include "spiraling_edge/base/atomic_file.h"
#include "svg_frame.h"
#include "writers.h"

namespace se::view {

namespace {

class SvgWriter : public FrameWriter {
  public:
    explicit SvgWriter(const ExportTarget& target) : target_(target), files_(target) {}

    Status add(const ExportFrame& frame) override {
        SvgClasses classes(target_.theme, false);
        const std::string background =
            target_.cutOut ? std::string() : svgBackground(frame, classes) + "\n";
        Result<std::string> drawn = svgViews(frame, classes, "");
        if (!drawn) return Error{target_.path.string() + ": " + drawn.error().message};
        const std::string caption =
            target_.captions ? "<title>" + escapedXml(frame.caption) + "</title>\n" : "";
        return writeFileAtomically(
            files_.next(frame),
            fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
                        "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" {2}>\n"
                        "{3}<style>{4}</style>\n{5}{6}</svg>\n",
                        frame.size.x, frame.size.y, kSvgLook, caption, classes.sheet(), background,
                        drawn.value()));
    }
    Status finish() override { return files_.writeCaptions(); }

  private:
    ExportTarget target_;
    NumberedFiles files_;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> openSvgWriter(const ExportTarget& target) {
    if (const Status made = NumberedFiles(target).makeFolder(); !made) return made.error();
    return std::unique_ptr<FrameWriter>(std::make_unique<SvgWriter>(target));
}

}  // namespace se::view
