// Animations as GIF, by cgif if the program was built with it.
#include "writers.h"

#ifdef SE_HAS_CGIF

#include <cgif.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gif_palette.h"
#include "spiraling_edge/base/atomic_file.h"

namespace se::view {

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

    /// Rows from the top down.
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
