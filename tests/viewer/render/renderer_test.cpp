/// Pictures of small lists, compared with what their geometry says. Drawn without a display;
/// skipped where there is no OpenGL.
#include "render/renderer.h"

#include <EGL/egl.h>
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "offscreen.h"
#include "open_session.h"
#include "scene/camera.h"

using namespace se::view;

namespace {

constexpr glm::ivec2 kDrawnSize(400);
constexpr float kDrawnEm = 16.0F;
const Color kBehind = fromHex(0x000000);
const Color kPureGreen = fromHex(0x00FF00);

/// The pixels of a texture of kDrawnSize.
Picture textureOf(unsigned texture) {
    constexpr unsigned kTexture2d = 0x0DE1;
    constexpr unsigned kRgba = 0x1908;
    constexpr unsigned kBytes = 0x1401;
    using Bind = void (*)(unsigned, unsigned);
    using GetImage = void (*)(unsigned, int, unsigned, unsigned, void*);
    Picture picture{kDrawnSize,
                    std::vector<std::uint8_t>(std::size_t{4} * kDrawnSize.x * kDrawnSize.y)};
    reinterpret_cast<Bind>(eglGetProcAddress("glBindTexture"))(kTexture2d, texture);
    reinterpret_cast<GetImage>(eglGetProcAddress("glGetTexImage"))(kTexture2d, 0, kRgba, kBytes,
                                                                   picture.rgba.data());
    return picture;
}

/// How much a picture on black has of green, pixel by pixel.
struct Green {
    double area = 0.0;       ///< Pixels, as if all were full.
    glm::dvec2 middle{0.0};  ///< From the upper left corner.
    glm::dvec2 low{1e9};     ///< Bounds of what is at least half full.
    glm::dvec2 high{-1e9};
    double strongest = 0.0;

    explicit Green(const Picture& picture) {
        for (int y = 0; y < picture.size.y; ++y) {
            for (int x = 0; x < picture.size.x; ++x) {
                const int row = picture.size.y - 1 - y;
                const std::size_t at = 4 * static_cast<std::size_t>(row * picture.size.x + x);
                const bool green = picture.rgba[at + 1] > picture.rgba[at] + 8;
                const double share = green ? picture.rgba[at + 1] / 255.0 : 0.0;
                area += share;
                middle += share * glm::dvec2(x + 0.5, y + 0.5);
                strongest = std::max(strongest, share);
                if (share < 0.5) continue;
                low = glm::min(low, glm::dvec2(x, y));
                high = glm::max(high, glm::dvec2(x + 1, y + 1));
            }
        }
        if (area > 0.0) middle /= area;
    }
};

/// A view from the front on what a test puts there; x to the right, z up, y away from the eye.
struct DrawnScene {
    std::unique_ptr<Offscreen> display;
    std::unique_ptr<Renderer> renderer;
    std::shared_ptr<const Model> model = test::sphereModel();
    Camera camera;
    DrawList list;

    DrawnScene() {
        auto made = Offscreen::create({64, 64});
        if (!made) return;
        display = std::move(made.value());
        renderer = std::make_unique<Renderer>(Shaders::load({}).value());
        renderer->surface().setModel(*model);
        camera.set(ViewPreset::Front);
        camera.setPose({glm::vec3(0.0F), 4.0F, -90.0F, 0.0F});
        list.cloudVisible = list.meshVisible = false;
    }

    CameraMatrices matrices() const { return camera.matrices(1.0F); }
    Green draw(Finish finish = Finish::Full) {
        SurfaceView view;
        view.camera = matrices();
        view.size = kDrawnSize;
        view.em = kDrawnEm;
        view.background = kBehind;
        renderer->draw(list, view, finish);
        return Green(textureOf(renderer->texture()));
    }
    glm::dvec2 pixelOf(const glm::vec3& place) const {
        return glm::dvec2(project(matrices(), place, glm::vec2(kDrawnSize)));
    }
    /// Marks and lines grow with the distance of the points.
    double zoom() const {
        const float dots = spacingInPixels(matrices(), kDrawnSize.y, model->spacing);
        return std::clamp(dots / kDrawnEm / 1.5F, 0.72F, 1.15F);
    }
    /// A gray wall before everything on the left half.
    void addWall() {
        const Color gray = fromHex(0x808080);
        list.faces.push_back({{glm::vec3(-2, -1.3F, -2), {0, -1.3F, -2}, {0, -1.3F, 2}}, gray});
        list.faces.push_back({{glm::vec3(-2, -1.3F, -2), {0, -1.3F, 2}, {-2, -1.3F, 2}}, gray});
    }
};

}  // namespace

TEST_CASE("A disc is at the place of its point, of its size and color") {
    DrawnScene scene;
    if (!scene.display) return;
    for (const glm::vec3 place : {glm::vec3(0.0F), glm::vec3(0.5F, 0.2F, -0.3F)}) {
        scene.list.sprites.clear();
        scene.list.mark(place, se::view::Shape::Disc, kPureGreen, 1.5F);
        const Green green = scene.draw();
        CHECK(glm::distance(green.middle, scene.pixelOf(place)) < 0.6);
        CHECK(green.strongest == doctest::Approx(1.0));
        const double diameter = 1.5 * kDrawnEm * scene.zoom();
        CHECK(std::abs(green.high.x - green.low.x - diameter) < 3.0);
        CHECK(std::abs(green.high.y - green.low.y - diameter) < 3.0);
        const double width = green.high.x - green.low.x;
        CHECK(green.area == doctest::Approx(std::numbers::pi / 4.0 * width * width).epsilon(0.12));
    }
}

TEST_CASE("A line covers its length and its width") {
    DrawnScene scene;
    if (!scene.display) return;
    const glm::vec3 from(-0.6F, 0.0F, 0.2F);
    const glm::vec3 to(0.7F, 0.0F, 0.2F);
    for (const float width : {0.1F, 0.5F}) {
        scene.list.lines.clear();
        scene.list.line(from, to, kPureGreen, width, Depth::OnTop);
        const Green green = scene.draw();
        const double pixels = std::max(1.0, width * kDrawnEm * scene.zoom());
        const double length = glm::distance(scene.pixelOf(from), scene.pixelOf(to));
        CHECK(std::abs(green.middle.y - scene.pixelOf(from).y) < 0.6);
        CHECK(std::abs(green.low.x - scene.pixelOf(from).x) < pixels + 1.5);
        CHECK(std::abs(green.high.x - scene.pixelOf(to).x) < pixels + 1.5);
        CHECK(green.area / length == doctest::Approx(pixels).epsilon(0.2));
    }
}

TEST_CASE("A wall hides a line, lets it shine through, or lies below it") {
    DrawnScene scene;
    if (!scene.display) return;
    scene.addWall();
    const auto drawn = [&](Depth depth) {
        scene.list.lines.clear();
        scene.list.line({-0.8F, 0.0F, 0.0F}, {0.8F, 0.0F, 0.0F}, kPureGreen, 0.3F, depth);
        return scene.draw();
    };
    const Green tested = drawn(Depth::Tested);
    const Green through = drawn(Depth::XRay);
    const Green above = drawn(Depth::OnTop);
    // The wall ends in the middle of the picture.
    CHECK(std::abs(tested.low.x - 0.5 * kDrawnSize.x) < 3.0);
    CHECK(above.low.x < scene.pixelOf({-0.8F, 0.0F, 0.0F}).x + 3.0);
    CHECK(tested.area == doctest::Approx(0.5 * above.area).epsilon(0.1));
    CHECK(through.area > 1.05 * tested.area);
    CHECK(through.area < 0.9 * above.area);
}

TEST_CASE("Points behind a wall are hidden, those beside it are not") {
    DrawnScene scene;
    if (!scene.display) return;
    scene.list.cloudVisible = true;
    scene.list.cloudStyles.styles[0] = {kPureGreen, 0.5F, se::view::Shape::Disc, false};
    scene.list.cloudStyleOf.resize(scene.model->place.size());
    for (const Finish finish : {Finish::Quick, Finish::Full}) {
        scene.list.faces.clear();
        const Green all = scene.draw(finish);
        scene.addWall();
        const Green right = scene.draw(finish);
        CHECK(all.low.x < 0.5 * kDrawnSize.x - 50.0);
        CHECK(right.low.x > 0.5 * kDrawnSize.x - 5.0);
        CHECK(right.high.x == all.high.x);
        CHECK(right.area == doctest::Approx(0.5 * all.area).epsilon(0.15));
    }
}

TEST_CASE("A new triangle covers as many pixels as its picture has") {
    DrawnScene scene;
    if (!scene.display) return;
    const std::array<glm::vec3, 3> corners = {
        glm::vec3(-0.7F, 0.0F, -0.5F), {0.6F, 0.0F, -0.4F}, {0.1F, 0.0F, 0.7F}};
    scene.list.sheets.push_back({corners, kPureGreen, false});
    const Green green = scene.draw();
    const glm::dvec2 a = scene.pixelOf(corners[0]);
    const glm::dvec2 u = scene.pixelOf(corners[1]) - a;
    const glm::dvec2 v = scene.pixelOf(corners[2]) - a;
    CHECK(green.area == doctest::Approx(0.5 * std::abs(u.x * v.y - u.y * v.x)).epsilon(0.03));
    CHECK(glm::distance(green.middle, a + (u + v) / 3.0) < 1.5);
}
