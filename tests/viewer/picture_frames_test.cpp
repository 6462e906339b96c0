/// Pictures in tiles, drawn without a display. Skipped where there is no OpenGL.
#include "export_run.h"

#include <doctest/doctest.h>

#include <cstdlib>

#include "application.h"
#include "offscreen.h"
#include "open_session.h"

using namespace se::view;

namespace {

/// A picture of a decision in which no side of what is drawn exceeds `most` pixels.
Picture pictureOf(const Options& options, int most) {
    ViewSettings settings;
    settings.width = 640;
    settings.height = 480;
    const glm::ivec2 size = drawnSize(settings, options.picture);
    Application application(options, settings);
    REQUIRE(application.start(1.0F));
    REQUIRE(application.waitUntilDone());
    Target target(0);
    return drawPicture(application, target, size, 4, most);
}

/// Number of bytes that differ by more than `least`; colors as strong as they are opaque.
int differences(const Picture& a, const Picture& b, int least) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const bool alpha = i % 4 == 3;
        const int mine = a.rgba[i] * (alpha ? 255 : a.rgba[i - i % 4 + 3]);
        const int theirs = b.rgba[i] * (alpha ? 255 : b.rgba[i - i % 4 + 3]);
        count += std::abs(mine - theirs) > 255 * least ? 1 : 0;
    }
    return count;
}

Options optionsFor(const char* scene, const char* address) {
    Options options;
    options.input.source = scene;
    options.goTo = address;
    options.noConfig = true;
    options.screenshot = "a.png";
    options.picture.viewAlone = options.picture.caption = true;
    return options;
}

}  // namespace

TEST_CASE("A picture in tiles equals the whole one, across all seams") {
    const auto display = Offscreen::create({64, 64});
    if (!display) return;
    // Hatched triangles, labels and lines; shaded surfaces; points too close for shapes.
    for (const auto& [scene, address] :
         {std::pair{"scene:figure-8", "9.emit.2"}, std::pair{"scene:torus", "50%"},
          std::pair{"scene:linked-tori", "100%"}}) {
        for (const int factor : {1, 2}) {
            CAPTURE(scene);
            CAPTURE(factor);
            Options options = optionsFor(scene, address);
            options.focus = options.goTo != "100%";
            options.picture.supersample = factor;
            options.picture.pointLabels = factor == 2;
            options.picture.cutOut = factor == 2;
            const Picture whole = pictureOf(options, 4096);
            const Picture tiled = pictureOf(options, 300 * factor);
            CHECK(whole.size == glm::ivec2(640, 480));
            REQUIRE(tiled.size == whole.size);
            // Rounding where a line or a letter fades out.
            CHECK(differences(whole, tiled, 2) < 20);
            CHECK(differences(whole, tiled, 40) == 0);
        }
    }
}

TEST_CASE("Text too large for the tiles of a card is refused") {
    CHECK(checkDrawn({20000, 3000}, 1.0, 4096));
    CHECK(checkDrawn({300, 300}, 20.0, 300));
    CHECK(
        checkDrawn({301, 300}, 20.0, 300).error().message.starts_with("this graphics card draws"));
}
