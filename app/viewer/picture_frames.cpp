#include "picture_frames.h"

#include <cmath>

#include "application.h"
#include "render/context.h"

namespace se::view {

glm::ivec2 drawnSize(ViewSettings& settings, const PictureLook& look) {
    const double factor = look.scale * look.supersample;
    if (factor != 1.0)
        settings.uiScale = factor * (settings.uiScale > 0.0 ? settings.uiScale : 1.0);
    const auto pixels = [&](int side) {
        return look.supersample * static_cast<int>(std::lround(look.scale * side));
    };
    return {pixels(settings.width), pixels(settings.height)};
}

Picture drawPicture(Application& application, Target& target, glm::ivec2 size, int frames) {
    const PictureLook& look = application.commands().ui.picture;
    const auto draw = [&] {
        target.begin(size);
        for (int i = 0; i < frames; ++i) {
            application.redraw();
            application.frame(size, 1.0 / 60.0);
        }
        Picture picture = readPicture(size);
        target.end();
        return picture;
    };
    if (!look.cutOut) return reduced(draw(), look.supersample);
    application.setBackground(fromHex(0x000000));
    const Picture onBlack = draw();
    application.setBackground(fromHex(0xFFFFFF));
    return reduced(cutOut(onBlack, draw()), look.supersample);
}

}  // namespace se::view
