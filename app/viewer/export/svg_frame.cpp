#include "svg_frame.h"

#include <fmt/format.h>

#include <algorithm>

#include "paint/dial_painter.h"
#include "paint/view_texts.h"
#include "run/strings.h"
#include "svg_canvas.h"

namespace se::view {

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

/// Sizes around the dial, in em: margin, height of the heading, and of the caption.
constexpr float kDialMargin = 0.7F;
constexpr float kDialHeading = 2.4F;
constexpr float kDialCaption = 2.0F;

/// The dial of the pivot on a panel, with a heading and its caption. A second disc is left out: the
/// drawing beside it shows the other point.
void drawFrameDial(SvgPainter& painter, const FrameDial& frame) {
    if (frame.dial.empty()) return;
    const float em = painter.em();
    const Rect& area = frame.area;
    Rect room{area.min + glm::vec2(kDialMargin, kDialHeading) * em,
              area.size - glm::vec2(2.0F * kDialMargin, kDialHeading + kDialCaption) * em};
    room.size.y = std::min(room.size.y, 1.1F * room.size.x);
    const DialPicture picture{frame.dial, frame.names};
    painter.beginGroup("dial");
    painter.box(area, painter.ink(&Palette::panel));
    drawDialDisc(painter, picture, discOf(painter, picture, room), room);
    painter.text(area.min + glm::vec2(kDialMargin, 0.5F) * em,
                 "Tangent plane at " + nameOf(frame.dial.pivot, frame.names),
                 painter.ink(&Palette::textDim), {em});
    painter.text({area.min.x + 0.5F * area.size.x, room.max().y + 0.6F * em}, frame.dial.caption,
                 painter.ink(&Palette::text), {em, Typeface::Text, Align::Middle});
    painter.endGroup();
}

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
        drawFrameDial(painter, *frame.dial);
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

}  // namespace se::view
