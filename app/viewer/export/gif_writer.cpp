// Animations as GIF, by cgif if the program was built with it.

#include <algorithm>
#include <cmath>

#include "formats.h"
#include "scene/mesh_style.h"

#ifdef SE_HAS_CGIF

#include <cgif.h>

#include <utility>

#include "spiraling_edge/base/atomic_file.h"

namespace se::view {

namespace {

/// Shades of the mesh, from none to full light; of other lit surfaces.
constexpr int kMeshShades = 72;
constexpr int kFaceShades = 10;
constexpr std::size_t kComponents = 6;
constexpr std::size_t kMostColors = 255;

class PaletteBuilder {
  public:
    void add(const Color& color) {
        if (bytes_.size() >= 3 * kMostColors) return;
        for (const float each : {color.r, color.g, color.b})
            bytes_.push_back(
                static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(each, 0.0F, 1.0F))));
    }
    /// Adds the blends from the first color, itself left out, to the second.
    void addBlends(const Color& from, const Color& to, int count) {
        for (int i = 1; i <= count; ++i)
            add(mix(from, to, static_cast<float>(i) / static_cast<float>(count)));
    }
    void addShades(const Color& color, int count) { addBlends({0.0F, 0.0F, 0.0F}, color, count); }
    std::vector<std::uint8_t> take() { return std::move(bytes_); }

  private:
    std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<std::uint8_t> gifPalette(Theme theme) {
    const Palette& p = paletteOf(theme);
    PaletteBuilder colors;
    colors.add(p.background);
    colors.add(p.panel);
    for (const Color& each :
         {p.pivot, p.used, p.first, p.last, p.test, p.rejected, p.unused, p.done, p.text})
        colors.addBlends(p.background, each, 5);
    colors.addBlends(p.panel, p.text, 5);
    colors.addBlends(p.background, p.textDim, 3);
    colors.addBlends(p.mesh, p.meshEdge, 4);
    colors.addShades(p.mesh, kMeshShades);
    for (const Color& each :
         {p.test, mix(p.mesh, p.test, 0.5F), mix(p.mesh, p.test, 0.25F), mix(p.mesh, p.used, 0.5F)})
        colors.addShades(each, kFaceShades);
    for (int i = 0; i <= 16; ++i) colors.add(viridis(static_cast<float>(i) / 16.0F));
    for (std::size_t i = 0; i < kComponents; ++i) colors.addShades(componentColor(i), 5);
    return colors.take();
}

NearestColor::NearestColor(std::span<const std::uint8_t> palette)
    : palette_(palette), known_(std::size_t{1} << 18U, -1) {}

std::uint8_t NearestColor::of(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    const std::size_t key = (static_cast<std::size_t>(red >> 2U) << 12U) |
                            (static_cast<std::size_t>(green >> 2U) << 6U) |
                            static_cast<std::size_t>(blue >> 2U);
    std::int16_t& known = known_[key];
    if (known >= 0) return static_cast<std::uint8_t>(known);
    int least = 1 << 30;
    for (std::size_t i = 0; i < palette_.size() / 3; ++i) {
        const int r = palette_[3 * i] - red;
        const int g = palette_[3 * i + 1] - green;
        const int b = palette_[3 * i + 2] - blue;
        // The eye is most sensitive to green.
        const int away = 2 * r * r + 4 * g * g + 3 * b * b;
        if (away >= least) continue;
        least = away;
        known = static_cast<std::int16_t>(i);
    }
    return static_cast<std::uint8_t>(known);
}

namespace {

constexpr double kLeastDelay = 2.0;  // hundredths of a second; viewers take less for a mistake
constexpr double kMostDelay = 65535.0;

int appendBytes(void* text, const std::uint8_t* bytes, std::size_t count) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
    return 0;
}

class GifWriter : public FrameWriter {
  public:
    explicit GifWriter(const ExportTarget& target)
        : target_(target), palette_(gifPalette(target.theme)), nearest_(palette_) {
        CGIF_Config config{};
        config.pGlobalPalette = palette_.data();
        config.numGlobalPaletteEntries = static_cast<std::uint16_t>(palette_.size() / 3);
        config.attrFlags = CGIF_ATTR_IS_ANIMATED;
        config.width = static_cast<std::uint16_t>(target.size.x);
        config.height = static_cast<std::uint16_t>(target.size.y);
        config.pWriteFn = appendBytes;
        config.pContext = &bytes_;
        gif_ = cgif_newgif(&config);
    }
    ~GifWriter() override {
        if (gif_ != nullptr) cgif_close(gif_);
    }
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;

    Status add(const ExportFrame& frame) override {
        std::vector<std::uint8_t> indices = indicesOf(frame.pixels);
        const double delay = std::round(100.0 / target_.perSecond);
        CGIF_FrameConfig config{};
        config.pImageData = indices.data();
        config.delay = static_cast<std::uint16_t>(std::clamp(delay, kLeastDelay, kMostDelay));
        config.genFlags = CGIF_FRAME_GEN_USE_TRANSPARENCY | CGIF_FRAME_GEN_USE_DIFF_WINDOW;
        return gif_ != nullptr && cgif_addframe(gif_, &config) == CGIF_OK ? success() : failure();
    }

    Status finish() override {
        CGIF* gif = std::exchange(gif_, nullptr);
        if (gif == nullptr || cgif_close(gif) != CGIF_OK) return failure();
        return writeFileAtomically(target_.path, bytes_);
    }

  private:
    Status failure() const { return Error{"Cannot make a GIF of " + target_.path.string() + "."}; }

    /// The colors of the pixels as indices of the palette, rows from the top down.
    std::vector<std::uint8_t> indicesOf(const Picture& picture) {
        std::vector<std::uint8_t> indices;
        indices.reserve(picture.rgba.size() / 4);
        const auto width = static_cast<std::size_t>(picture.size.x);
        for (auto y = static_cast<std::size_t>(picture.size.y); y-- > 0;) {
            for (std::size_t x = 0; x < width; ++x) {
                const std::uint8_t* pixel = &picture.rgba[4 * (y * width + x)];
                indices.push_back(nearest_.of(pixel[0], pixel[1], pixel[2]));
            }
        }
        return indices;
    }

    ExportTarget target_;
    std::vector<std::uint8_t> palette_;
    NearestColor nearest_;
    std::string bytes_;
    CGIF* gif_ = nullptr;
};

}  // namespace

Status gifPossible() { return success(); }

Result<std::unique_ptr<FrameWriter>> openGifWriter(const ExportTarget& target) {
    return std::unique_ptr<FrameWriter>(std::make_unique<GifWriter>(target));
}

}  // namespace se::view

#else

namespace se::view {

Status gifPossible() {
    return Error{
        "this program was built without libcgif-dev (apt-get install libcgif-dev, and build it "
        "again); .html needs nothing"};
}

Result<std::unique_ptr<FrameWriter>> openGifWriter(const ExportTarget&) {
    return gifPossible().error();
}

}  // namespace se::view

#endif
