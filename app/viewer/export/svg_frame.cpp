#include "svg_frame.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstring>
#include <utility>

#include "paint/dial_painter.h"
#include "paint/labels.h"
#include "run/strings.h"
#include "spiraling_edge/base/atomic_file.h"

namespace se::view {

namespace {

/// The bytes of a position: equal ones are the same point.
std::string bytesOf(const glm::vec3& position) {
    std::string bytes(sizeof(position), '\0');
    std::memcpy(bytes.data(), &position, sizeof(position));
    return bytes;
}

}  // namespace

SvgCanvas::SvgCanvas(const FrameShapes& shapes, SvgClasses& classes, std::string prefix)
    : SvgPainter(shapes.theme, shapes.em, classes, std::move(prefix)),
      in_(shapes),
      screen_(shapes.camera, shapes.size),
      depth_(shapes.size),
      dots_(spacingInPixels(shapes.camera, shapes.size.y, shapes.model.spacing)) {
    for (std::size_t p = 0; p < shapes.model.place.size(); ++p)
        points_.emplace(bytesOf(shapes.model.place[p]), static_cast<Index>(p));
}

float SvgCanvas::markZoom() const { return view::markZoom(dots_, em()); }

Index SvgCanvas::pointAt(const glm::vec3& position) const {
    const auto found = points_.find(bytesOf(position));
    return found == points_.end() ? kNone : found->second;
}

namespace {

void drawSvgLabels(SvgCanvas& canvas) {
    canvas.beginGroup("labels");
    drawLabels(canvas, canvas.in().labels, canvas.in().list, canvas.in().other);
    canvas.endGroup();
}

}  // namespace

Result<std::string> svgFrame(const FrameShapes& shapes, SvgClasses& classes,
                             const std::string& prefix) {
    SvgCanvas canvas(shapes, classes, prefix);
    for (const auto draw :
         {drawSvgTriangles, drawSvgPoints, drawSvgLayers, drawSvgMarks, drawSvgLabels}) {
        draw(canvas);
        if (canvas.count() > kMaxShapes)
            return Error{"over " + grouped(kMaxShapes) +
                         " shapes, which programs for SVG draw slowly; use .png"};
    }
    return canvas.take();
}

namespace {

/// The bar above one of two views, and the line between them.
std::string titleBarOf(const FrameShapes& shapes, SvgClasses& classes) {
    SvgPainter painter(shapes.theme, shapes.em, classes, "");
    const Rect& bar = shapes.bar;
    if (shapes.corner.x > 0.0F)
        painter.box({{bar.min.x, bar.max().y}, {painter.px(kDividerEms), shapes.size.y}},
                    painter.ink(&Palette::border));
    drawTitleBar(painter, bar, *shapes.title);
    return painter.take();
}

}  // namespace

std::string svgBackground(const ExportFrame& frame, SvgClasses& classes) {
    const Theme theme = frame.shapes.front().theme;
    const Ink ink(paletteOf(theme).background, paletteOf(otherTheme(theme)).background);
    return "<rect class=\"" + classes.fill(ink) + "\" width=\"100%\" height=\"100%\"/>";
}

Result<std::string> svgViews(const ExportFrame& frame, SvgClasses& classes,
                             const std::string& prefix) {
    std::string out;
    if (frame.dial != nullptr) {
        SvgPainter painter(frame.shapes.front().theme, frame.shapes.front().em, classes, prefix);
        painter.beginGroup("dial");
        drawDialFigure(painter, {frame.dial->dial, frame.dial->names}, frame.dial->area);
        painter.endGroup();
        out = painter.take();
    }
    if (frame.shapes.size() == 1) {
        Result<std::string> drawn = svgFrame(frame.shapes.front(), classes, prefix);
        return drawn ? Result<std::string>(drawn.value() + out) : drawn;
    }
    for (const FrameShapes& shapes : frame.shapes) {
        const std::string id = prefix + "view-" + (&shapes == &frame.shapes.front() ? "a" : "b");
        Result<std::string> drawn = svgFrame(shapes, classes, id + "-");
        if (!drawn) return drawn.error();
        out += fmt::format(
            "<clipPath id=\"{0}-clip\"><rect width=\"{1:.1f}\" height=\"{2:.1f}\"/></clipPath>"
            "<g id=\"{0}\">{3}<g transform=\"translate({4:.1f} {5:.1f})\" "
            "clip-path=\"url(#{0}-clip)\">{6}</g></g>\n",
            id, shapes.size.x, shapes.size.y, titleBarOf(shapes, classes), shapes.corner.x,
            shapes.corner.y, drawn.value());
    }
    return out;
}

// Pictures of shapes, a file per frame: colors are classes of a style sheet, text is text.

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
        return writeFileAtomically(files_.next(frame),
                                   svgDocument(frame.size, target_.captions ? frame.caption : "",
                                               classes.sheet(), background + drawn.value()));
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
