/// What the window shows in its first frame, and in the first one after a change of size. Drawn
/// without a display; skipped where there is no OpenGL.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "application.h"
#include "export_run.h"
#include "offscreen.h"
#include "render/context.h"
#include "run/model.h"

using namespace se;
using namespace se::view;

namespace {

Options openedAt(const std::string& source, const std::string& address) {
    Options options;
    options.input.source = source;
    options.goTo = address;
    options.noConfig = true;
    return options;
}

ViewSettings settingsFor(double scale, Theme theme) {
    ViewSettings settings;
    settings.uiScale = scale;
    settings.theme = theme;
    return settings;
}

/// A window, frame by frame. Its content stays where a frame draws nothing.
class Frames {
  public:
    Frames(const Options& options, glm::ivec2 size, double scale = 1.0, Theme theme = Theme::Dark)
        : size_(size), app_(options, settingsFor(scale, theme)), target_(0) {
        REQUIRE(app_.start(1.0F));
        REQUIRE(app_.waitUntilDone());
    }

    /// The next frame; true if it drew anything.
    bool next() {
        target_.begin(size_);
        app_.poll();
        const bool drawn = app_.frame(size_, 1.0 / 60.0);
        content_ = readPicture(size_);
        target_.end();
        return drawn;
    }
    void next(int count) {
        for (int i = 0; i < count; ++i) next();
    }
    /// As a window of another size: it has no content until it is drawn.
    void resize(glm::ivec2 size) {
        size_ = size;
        app_.redraw();
    }
    void press(int key, int mods = 0) { app_.key({key, mods}, false); }

    Application& app() { return app_; }
    const Picture& content() const { return content_; }
    Color at(glm::ivec2 pixel) const {
        const std::size_t i = 4 * (static_cast<std::size_t>(size_.y - 1 - pixel.y) *
                                       static_cast<std::size_t>(size_.x) +
                                   static_cast<std::size_t>(pixel.x));
        const auto byte = [&](std::size_t k) {
            return static_cast<float>(content_.rgba[i + k]) / 255.0F;
        };
        return {byte(0), byte(1), byte(2), 1.0F};
    }
    /// Share of the pixels of an area for which `is` holds.
    template <typename Is>
    double share(const Rect& area, Is&& is) const {
        int count = 0;
        int all = 0;
        for (int y = static_cast<int>(area.min.y); y < static_cast<int>(area.max().y); ++y) {
            for (int x = static_cast<int>(area.min.x); x < static_cast<int>(area.max().x); ++x) {
                ++all;
                count += is(at({x, y})) ? 1 : 0;
            }
        }
        return all == 0 ? 0.0 : static_cast<double>(count) / all;
    }
    double shareOf(const Rect& area, const Color& color) const {
        return share(area, [&](const Color& c) {
            return std::abs(c.r - color.r) + std::abs(c.g - color.g) + std::abs(c.b - color.b) <
                   0.01F;
        });
    }

  private:
    glm::ivec2 size_;
    Application app_;
    Target target_;
    Picture content_;
};

/// The view has its background, and neither the black nor the white that no theme has.
void checkView(Frames& frames, Theme theme) {
    const Rect& view = frames.app().areas().view;
    CAPTURE(view.size.x);
    CAPTURE(view.size.y);
    CHECK(frames.shareOf(view, paletteOf(theme).background) > 0.05);
    CHECK(frames.shareOf(view, fromHex(0x000000)) < 0.02);
    if (theme == Theme::Dark) CHECK(frames.shareOf(view, fromHex(0xFFFFFF)) < 0.02);
}

/// Share of an area that is not of the color of panels.
double inkOf(const Frames& frames, const Rect& area) {
    return 1.0 - frames.shareOf(area, paletteOf(Theme::Dark).panel);
}

bool sameContent(const Frames& frames, const Picture& before) {
    return frames.content().rgba == before.rgba;
}

constexpr int kF8 = key::kF1 + 7;

}  // namespace

TEST_CASE("Every frame shows the view, from the first one on, whatever changes its size") {
    const auto display = Offscreen::create({64, 64});
    if (!display) return;
    struct Case {
        glm::ivec2 size;
        double scale;
        Theme theme;
        LayoutPreset layout;
    };
    for (const Case& each : {Case{{900, 640}, 1.0, Theme::Dark, LayoutPreset::Debug},
                             Case{{900, 640}, 1.0, Theme::Light, LayoutPreset::Debug},
                             Case{{1280, 800}, 2.0, Theme::Dark, LayoutPreset::Debug},
                             Case{{390, 844}, 1.0, Theme::Dark, LayoutPreset::Debug},
                             Case{{960, 540}, 1.0, Theme::Dark, LayoutPreset::Present}}) {
        CAPTURE(each.size.x);
        CAPTURE(each.scale);
        Options options = openedAt("scene:torus", "137.sphere.3");
        options.layout = each.layout;
        Frames frames(options, each.size, each.scale, each.theme);
        const auto look = [&](const char* what) {
            CAPTURE(what);
            for (int i = 0; i < 3; ++i) {
                CAPTURE(i);
                frames.next();
                checkView(frames, each.theme);
            }
        };
        look("opening");
        frames.press('J', kCtrl | kShift);
        look("fold");
        frames.press(kF8);
        look("fault");
        for (int i = 0; i < 4; ++i) {
            frames.press(key::kPageDown);
            look("event");
        }
        frames.resize(each.size * 4 / 5);
        look("smaller");
        frames.resize(each.size);
        look("larger");
    }
}

TEST_CASE("The first picture of a size is the finished one") {
    const auto display = Offscreen::create({64, 64});
    if (!display) return;
    Options options = openedAt("scene:torus", "137.sphere.3");
    options.picture.viewAlone = true;
    Frames frames(options, {640, 480});
    for (const glm::ivec2 size :
         {glm::ivec2(640, 480), glm::ivec2(500, 460), glm::ivec2(640, 480)}) {
        frames.resize(size);
        CHECK(frames.next());
        const Picture first = frames.content();
        frames.next(20);
        CHECK(sameContent(frames, first));
    }
}

TEST_CASE("Until a picture of the new size is finished, the frame before it stays") {
    const auto display = Offscreen::create({64, 64});
    if (!display) return;
    constexpr int kLate = 3;
    Options options = openedAt("scene:torus", "137.sphere.3");
    options.picture.lateFrames = kLate;
    Frames frames(options, {1280, 800});
    // Nothing was shown before: a window that the desktop wants drawn has the background.
    frames.app().redraw();
    CHECK(frames.next());
    const Rect first = frames.app().areas().view;
    CHECK(frames.shareOf(first, paletteOf(Theme::Dark).background) > 0.75);
    CHECK(frames.shareOf(first, fromHex(0x000000)) < 0.01);
    frames.next(12);
    checkView(frames, Theme::Dark);
    const glm::vec2 size = frames.app().areas().view.size;
    frames.press('J', kCtrl | kShift);
    Picture before;
    bool drawn = true;
    for (int i = 0; i < 9 && frames.app().areas().view.size == size; ++i) {
        before = frames.content();
        drawn = frames.next();
    }
    CHECK(frames.app().areas().view.size != size);
    int waited = 0;
    for (; !drawn && waited < 20; ++waited) {
        CHECK(sameContent(frames, before));
        drawn = frames.next();
    }
    CHECK(waited >= kLate);
    CHECK_FALSE(sameContent(frames, before));
    checkView(frames, Theme::Dark);
    // A resized window is drawn at once: the background alone, not a picture of another size.
    frames.next(8);
    frames.resize({700, 600});
    CHECK(frames.next());
    CHECK(frames.shareOf(frames.app().areas().view, paletteOf(Theme::Dark).background) > 0.7);
    frames.next(12);
    checkView(frames, Theme::Dark);
}

TEST_CASE("Panels have their width in their first frame") {
    const auto display = Offscreen::create({64, 64});
    if (!display) return;
    Frames frames(openedAt("scene:torus", "137.sphere.3"), {1280, 800});
    // Where the values of Inspect are, to the right of their first letters.
    const auto values = [&] {
        const Rect& right = frames.app().areas().column;
        const float em = frames.app().em();
        return Rect{{right.min.x + 10.0F * em, right.min.y + 5.0F * em}, {7.0F * em, 4.0F * em}};
    };
    frames.next();
    const double first = inkOf(frames, values());
    frames.next(6);
    const double later = inkOf(frames, values());
    CHECK(later > 0.02);
    CHECK(first > 0.5 * later);
    // So has the list of keys.
    const Rect window{{100.0F, 100.0F}, {1080.0F, 600.0F}};
    frames.press(key::kF1);
    frames.next(2);
    const double keysFirst = inkOf(frames, window);
    frames.next(6);
    const double keysLater = inkOf(frames, window);
    CHECK(keysFirst > 0.7 * keysLater);
}

namespace {

/// The larger share of the view, in width or height, that the points of the decision span.
double spanOf(Frames& frames) {
    Application& app = frames.app();
    const Session& session = app.session();
    const Rect& view = app.areas().view;
    const CameraMatrices camera = app.camera().matrices(view.size.x / view.size.y);
    glm::vec2 low(1e9F);
    glm::vec2 high(-1e9F);
    for (const Index p : neighborhoodOf(session.picture())) {
        const glm::vec3 at = project(camera, session.shown().place[p], view.size);
        low = glm::min(low, glm::vec2(at));
        high = glm::max(high, glm::vec2(at));
    }
    // All of it is inside of the view.
    if (low.x < 0.0F || low.y < 0.0F || high.x > view.size.x || high.y > view.size.y) return 0.0;
    const glm::vec2 share = (high - low) / view.size;
    return std::max(share.x, share.y);
}

constexpr double kFramed = 0.35;

/// After the window with these options has settled.
double spanAt(const Options& options) {
    Frames frames(options, {900, 640});
    frames.next(4);
    return spanOf(frames);
}
CameraPose poseAt(const Options& options) {
    Frames frames(options, {900, 640});
    frames.next(4);
    return frames.app().camera().pose();
}

}  // namespace

TEST_CASE("An address of the command line opens framed on its decision") {
    const auto display = Offscreen::create({64, 64});
    if (!display) return;
    for (const auto& [source, address] :
         {std::pair{"scene:torus", "137.sphere.3"}, std::pair{"scene:torus", "50%"},
          std::pair{"scene:torus", "p812"}, std::pair{"scene:torus", "400"},
          std::pair{"scene:sphere", "40.sort.1"}, std::pair{"scene:genus-2", "200.ring.1"},
          std::pair{"sample:gyroid,n=800", "90"}}) {
        CAPTURE(source);
        CAPTURE(address);
        CHECK(spanAt(openedAt(source, address)) > kFramed);
    }
    // The end of a run has no decision to frame: the whole mesh is in the view.
    CHECK(poseAt(openedAt("scene:torus", "100%")).distance > 2.0F);
    CHECK(poseAt(openedAt("scene:torus", "137.sphere.3")).distance < 1.5F);
}

TEST_CASE("A camera that is named is kept, a session without one opens framed") {
    const auto display = Offscreen::create({64, 64});
    if (!display) return;
    Options placed = openedAt("scene:torus", "137.sphere.3");
    placed.camera = CameraPose{};
    placed.camera->distance = 2.5F;
    CHECK(poseAt(placed) == *placed.camera);

    Options session = openedAt("scene:torus", "");
    session.session = SessionFile{};
    session.session->input.source = "scene:torus";
    session.session->place.address = "137.sphere.3";
    CHECK(spanAt(session) > kFramed);
    session.session->place.camera = placed.camera;
    CHECK(poseAt(session) == *placed.camera);
    // Another address takes the user there.
    session.goTo = "300";
    CHECK(spanAt(session) > kFramed);
}
