#include "svg_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "run/strings.h"
#include "svg_canvas.h"

namespace se::view {

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

/// Baseline and letters of a title, as shares of an em, and its distances from the edges in em.
constexpr float kTitleBaseline = 0.8F;
constexpr float kTitleLetters = 0.826F;
constexpr float kLetterAt = 0.8F;
constexpr float kNameAt = 2.2F;
constexpr float kNoteAt = 0.7F;
constexpr float kTitleEdge = 0.3F;

/// The bar above one of two views, as the window has it.
std::string titleBarOf(const FrameShapes& shapes, SvgClasses& classes) {
    const float em = shapes.em;
    const Rect& bar = shapes.bar;
    const std::string mark = classes.fill(bothThemes(shapes, shapes.title->color));
    const float y = bar.min.y + 0.5F * (bar.size.y - em) + kTitleBaseline * em;
    const std::string letters =
        fmt::format(" y=\"{:.1f}\" font-size=\"{:.1f}\"", y, kTitleLetters * em);
    const auto box = [&](const std::string& kind, float width) {
        return fmt::format(
            "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
            "height=\"{:.1f}\"/>",
            kind, bar.min.x, bar.min.y, width, bar.size.y);
    };
    std::string out;
    if (shapes.corner.x > 0.0F)
        out = fmt::format(
            "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
            "height=\"{:.1f}\"/>",
            classes.fill(bothThemes(shapes, &Palette::border)), bar.min.x, bar.max().y,
            std::max(1.0F, std::round(kDividerEms * em)), shapes.size.y);
    out += box(classes.fill(bothThemes(shapes, &Palette::panelRaised)), bar.size.x);
    out += box(mark, kTitleEdge * em);
    out += fmt::format("<text class=\"{}\" font-weight=\"600\" x=\"{:.1f}\"{}>{}</text>", mark,
                       bar.min.x + kLetterAt * em, letters, shapes.title->letter);
    out += fmt::format("<text class=\"{}\" x=\"{:.1f}\"{}>{}</text>",
                       classes.fill(bothThemes(shapes, &Palette::text)), bar.min.x + kNameAt * em,
                       letters, escapedXml(shapes.title->name));
    constexpr float kLetterEms = 0.56F;  // About the mean width of a letter.
    const auto letterCount =
        static_cast<float>(shapes.title->name.size() + shapes.title->note.size());
    if (bar.size.x < (kNameAt + kNoteAt + 1.0F + kLetterEms * letterCount) * em) return out;
    out += fmt::format(
        "<text class=\"{}\" xml:space=\"preserve\" text-anchor=\"end\" x=\"{:.1f}\"{}>{}</text>",
        mark, bar.max().x - kNoteAt * em, letters, escapedXml(shapes.title->note));
    return out;
}

}  // namespace

Result<std::string> svgViews(const ExportFrame& frame, SvgClasses& classes,
                             const std::string& prefix) {
    std::string out;
    if (frame.dial != nullptr) {
        SvgCanvas canvas(frame.shapes.front(), classes, prefix);
        drawSvgDial(canvas, *frame.dial);
        out = canvas.take();
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
