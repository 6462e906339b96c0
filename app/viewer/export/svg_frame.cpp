#include "svg_frame.h"

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

}  // namespace se::view
