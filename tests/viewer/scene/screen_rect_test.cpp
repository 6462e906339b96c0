#include "scene/screen_rect.h"

#include <doctest/doctest.h>

using namespace se::view;

namespace {

constexpr glm::ivec2 kScreenSize(640, 480);

CameraMatrices lookingAtMiddle() {
    Camera camera;
    return camera.matrices(640.0F / 480.0F);
}

Bounds around(const glm::vec3& place, float radius) {
    Bounds bounds;
    bounds.add(place - radius);
    bounds.add(place + radius);
    return bounds;
}

bool has(const PixelRect& rect, const glm::vec3& at) {
    return rect.min.x <= static_cast<int>(at.x) && static_cast<int>(at.x) < rect.max.x &&
           rect.min.y <= static_cast<int>(at.y) && static_cast<int>(at.y) < rect.max.y;
}

}  // namespace

TEST_CASE("A change covers the pixels of its bounds, and few others") {
    const CameraMatrices camera = lookingAtMiddle();
    for (const glm::vec3& place : {glm::vec3(0.0F), glm::vec3(0.4F, -0.3F, 0.2F)}) {
        const PixelRect rect = pixelsOf(camera, around(place, 0.05F), kScreenSize);
        for (const float x : {-0.05F, 0.05F}) {
            glm::vec3 at = project(camera, place + glm::vec3(x, -x, x), glm::vec2(kScreenSize));
            at.y = static_cast<float>(kScreenSize.y) - at.y;
            CHECK(has(rect, at));
        }
        CHECK(rect.max.x - rect.min.x < 80);
    }
}

TEST_CASE("Nothing covers no pixel, and what reaches the eye covers all") {
    const CameraMatrices camera = lookingAtMiddle();
    CHECK(pixelsOf(camera, {}, kScreenSize).empty());
    CHECK(pixelsOf(camera, around(camera.eye, 0.1F), kScreenSize) ==
          PixelRect{glm::ivec2(0), kScreenSize});
    Camera beside;
    beside.lookAt({40.0F, 0.0F, 0.0F});
    CHECK(pixelsOf(beside.matrices(1.3F), around(glm::vec3(0.0F), 0.1F), kScreenSize).empty());
}

TEST_CASE("A rectangle grows within the picture, and none stays none") {
    const PixelRect rect{{10, 20}, {30, 40}};
    CHECK(rect.grown(15, {40, 400}) == PixelRect{{0, 5}, {40, 55}});
    CHECK(PixelRect{}.grown(15, kScreenSize).empty());
    CHECK(rect.with({}) == rect);
    CHECK(rect.with({{50, 0}, {60, 25}}) == PixelRect{{10, 0}, {60, 40}});
    CHECK_FALSE(rect.meets({{30, 20}, {50, 40}}));
    CHECK(rect.meets({{29, 39}, {50, 60}}));
}

TEST_CASE("Items are drawn in the blocks that the part shows, up to their number") {
    constexpr std::size_t kBlock = BlockBounds::kBlock;
    BlockBounds blocks;
    for (std::size_t i = 0; i < 4 * kBlock; ++i) {
        const float side = i / kBlock % 2 == 0 ? -0.5F : 0.5F;
        blocks.add(i, {side, 0.0F, 0.0F});
    }
    Camera camera;
    camera.set(ViewPreset::Front);
    const CameraMatrices front = camera.matrices(640.0F / 480.0F);
    const PixelRect left{{0, 0}, {320, 480}};
    const PixelRect all{{0, 0}, kScreenSize};
    using Ranges = std::vector<BlockBounds::Range>;
    CHECK(blocks.within(front, kScreenSize, left, 4 * kBlock) ==
          Ranges{{0, kBlock}, {2 * kBlock, 3 * kBlock}});
    CHECK(blocks.within(front, kScreenSize, all, 2 * kBlock + 5) == Ranges{{0, 2 * kBlock + 5}});
    CHECK(blocks.within(front, kScreenSize, all, 0).empty());
    CHECK(blocks.of({3, 3}).empty());
    CHECK(blocks.of({kBlock - 1, kBlock}).high.x == doctest::Approx(-0.5));
    CHECK(blocks.of({kBlock - 1, kBlock + 1}).high.x == doctest::Approx(0.5));
}
