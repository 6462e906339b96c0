#include "svg_frame.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <utility>

#include "formats.h"
#include "paint/dial_painter.h"
#include "paint/shapes.h"
#include "run/strings.h"
#include "scene/camera.h"
#include "scene/screen_rect.h"
#include "spiraling_edge/base/atomic_file.h"

namespace se::view {

// A triangle covers the pixels whose centers lie within it; its depth is linear on the screen, so
// that no division is needed in the loop.

namespace {

constexpr float kMostDepthPixels = 2048.0F;
constexpr float kFarthestDepth = 2.0F;
constexpr std::uint32_t kNobody = 0xffffffffU;
/// Depth by which a triangle has to be nearer, so that it does not hide what lies on it.
constexpr float kSlack = 2e-5F;

}  // namespace

ScreenSpace::ScreenSpace(const CameraMatrices& camera, glm::vec2 size)
    : camera_(camera), toClip_(camera.viewProjection()), size_(size) {}

glm::vec3 ScreenSpace::toEye(const glm::vec3& position) const {
    if (camera_.orthographic) return glm::vec3(glm::row(camera_.view, 2));
    return glm::normalize(camera_.eye - position);
}

glm::vec3 ScreenSpace::right() const { return glm::vec3(glm::row(camera_.view, 0)); }

glm::vec3 ScreenSpace::up() const { return glm::vec3(glm::row(camera_.view, 1)); }

std::optional<glm::vec3> ScreenSpace::at(const glm::vec3& position, float bias) const {
    const glm::vec3 moved = bias == 0.0F ? position : position + bias * toEye(position);
    const glm::vec4 clip = toClip_ * glm::vec4(moved, 1.0F);
    if (clip.w < 1e-4F) return std::nullopt;
    const glm::vec3 ndc = glm::vec3(clip) / clip.w;
    return glm::vec3((0.5F * ndc.x + 0.5F) * size_.x, (0.5F - 0.5F * ndc.y) * size_.y, ndc.z);
}

DepthPicture::DepthPicture(glm::vec2 size)
    : scale_(std::min(1.0F, kMostDepthPixels / std::max(size.x, size.y))),
      size_(glm::ivec2(glm::ceil(size * scale_))) {
    const auto count = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    depth_.assign(count, kFarthestDepth);
    number_.assign(count, kNobody);
}

void DepthPicture::add(const std::array<glm::vec3, 3>& corners, std::uint32_t number) {
    std::array<glm::vec2, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = scale_ * glm::vec2(corners[i]) - glm::vec2(0.5F);
    const float area = crossOf(p[1] - p[0], p[2] - p[0]);
    if (!(std::abs(area) > 1e-6F)) return;
    const glm::vec2 low = glm::min(p[0], glm::min(p[1], p[2]));
    const glm::vec2 high = glm::max(p[0], glm::max(p[1], p[2]));
    const glm::vec2 most = glm::vec2(size_ - 1);
    const glm::ivec2 from(glm::ceil(glm::clamp(low, glm::vec2(0.0F), most)));
    const glm::ivec2 to(glm::floor(glm::clamp(high, glm::vec2(-1.0F), most)));
    for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
            const glm::vec2 at(x, y);
            const float a = crossOf(p[1] - at, p[2] - at) / area;
            const float b = crossOf(p[2] - at, p[0] - at) / area;
            const float c = 1.0F - a - b;
            if (a < 0.0F || b < 0.0F || c < 0.0F) continue;
            const float depth = a * corners[0].z + b * corners[1].z + c * corners[2].z;
            const auto place = static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                               static_cast<std::size_t>(x);
            // Of two in a plane the later one is seen, as on the graphics card.
            if (depth > depth_[place] + kSlack) continue;
            depth_[place] = std::min(depth, depth_[place]);
            number_[place] = number;
        }
    }
}

bool DepthPicture::hides(const glm::vec3& place) const {
    const glm::ivec2 at(glm::floor(scale_ * glm::vec2(place)));
    if (at.x < 0 || at.y < 0 || at.x >= size_.x || at.y >= size_.y) return false;
    const auto index = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size_.x) +
                       static_cast<std::size_t>(at.x);
    return depth_[index] < place.z - kSlack;
}

std::vector<std::uint32_t> DepthPicture::visible() const {
    std::vector<std::uint32_t> seen;
    for (std::size_t i = 0; i < number_.size(); ++i) {
        const bool fresh = i == 0 || number_[i] != number_[i - 1];
        if (fresh && number_[i] != kNobody) seen.push_back(number_[i]);
    }
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    return seen;
}

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

float SvgCanvas::markZoom() const { return std::clamp(dots_ / em() / 1.5F, 0.72F, 1.15F); }

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
