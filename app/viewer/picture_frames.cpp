#include "picture_frames.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "application.h"
#include "panels/ui.h"
#include "render/relief.h"

namespace se::view {

double textScale(glm::ivec2 size) {
    return std::max(1.0, std::min(size.x / 1280.0, size.y / 800.0));
}

glm::ivec2 drawnSize(ViewSettings& settings, const PictureLook& look) {
    const double factor = look.scale * look.supersample;
    if (factor != 1.0)
        settings.uiScale = factor * (settings.uiScale > 0.0 ? settings.uiScale : 1.0);
    const auto pixels = [&](int side) {
        return look.supersample * static_cast<int>(std::lround(look.scale * side));
    };
    return {pixels(settings.width), pixels(settings.height)};
}

namespace {

/// The last of `frames` frames of a window of `size` pixels, or what its tile of `drawn` pixels
/// shows of it, reduced by `factor`.
Picture drawTile(Application& application, Target& target, glm::ivec2 size, glm::ivec2 drawn,
                 int frames, int factor) {
    const auto draw = [&] {
        target.begin(drawn);
        for (int i = 0; i < frames; ++i) {
            application.redraw();
            application.frame(size, 1.0 / 60.0);
        }
        Picture picture = readPicture(drawn);
        target.end();
        return picture;
    };
    if (!application.context().ui.picture.cutOut) return reduced(draw(), factor);
    application.setBackground(fromHex(0x000000));
    const Picture onBlack = draw();
    application.setBackground(fromHex(0xFFFFFF));
    return reduced(cutOut(onBlack, draw()), factor);
}

}  // namespace

Status checkDrawn(glm::ivec2 size, double uiScale, int most) {
    const float em = std::round(kEmPixels * static_cast<float>(uiScale > 0.0 ? uiScale : 1.0));
    const bool whole = std::max(size.x, size.y) <= most;
    if (whole || !tilesOf(size, most, Relief::reach(em), 1).empty()) return success();
    return Error{"this graphics card draws at most " + std::to_string(most) +
                 " pixels a side, too few for text of that size; choose a smaller --scale or "
                 "--supersample"};
}

Picture drawPicture(Application& application, Target& target, glm::ivec2 size, int frames,
                    int most) {
    PictureLook& look = application.context().ui.picture;
    if (std::max(size.x, size.y) <= most)
        return drawTile(application, target, size, size, frames, look.supersample);
    // Only the layout of the whole is needed before its tiles.
    look.tile = PictureTile{glm::ivec2(0), glm::ivec2(1), 0};
    if (frames > 1) drawTile(application, target, size, look.tile->size, frames - 1, 1);
    const int factor = look.supersample;
    Picture whole{size / factor, {}};
    whole.rgba.resize(static_cast<std::size_t>(whole.size.x) *
                      static_cast<std::size_t>(whole.size.y) * 4);
    for (const PictureTile& tile : tilesOf(size, most, Relief::reach(application.em()), factor)) {
        look.tile = tile;
        const glm::ivec2 corner(tile.min.x, size.y - tile.min.y - tile.size.y);
        copyInto(whole, corner / factor, drawTile(application, target, size, tile.size, 1, factor));
    }
    look.tile.reset();
    return whole;
}

}  // namespace se::view
